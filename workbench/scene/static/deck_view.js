// Pressure over the wet deck in time: the deck in plan, force and wetted area. Drawn on two canvases, without any library.
const REPORT = 500; // ms between reports of the time to the kernel
const CALM_PAUSE = 600; // ms between the still pictures that take the place of a film for those who want less motion
const SPEEDS = [1, 2, 5, 10, 20, 50];
const LIMITS = [1, 0.5, 0.2, 0.1]; // of the largest pressure, to which the colours reach
const LINKED = "wet-deck-time"; // event by which a film and this view tell each other the time
const TALLEST = 340; // px of the plan
const PLOT = 92; // px of one plot of the histories
const INK = "#1d2b35", SOFT = "#55666f", GRID = "#dde4e8", NOTHING = [226, 232, 236], MARK = "#e8590c";
const COLOURS = ["#0b6393", "#5b7a1e"];
const FONT = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
const MARGIN = { left: 62, right: 100, top: 12, bottom: 44 };

let numberOfViews = 0;

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "text") made.textContent = value;
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value != null) made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

// Significant figures, without exponent where the number can be read without.
function words(value, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(Number(value.toPrecision(digits)))));
  if (size < -4 || size > 6) return value.toExponential(digits - 1);
  return value.toFixed(Math.max(0, Math.min(digits - 1 - size, 4))).replace("-", "−");
}

function ticks(low, high, wanted) {
  const raw = Math.max(high - low, 1e-12) / wanted, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 2.5, 5, 10].find((factor) => factor * power >= raw * 0.999);
  const decimals = Math.max(0, Math.min(4, Math.ceil(-Math.log10(step) - 1e-9) + (Math.abs(step / power - 2.5) < 1e-6 ? 1 : 0)));
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) {
    found.push([k * step, (Math.abs(k * step) < 1e-12 ? 0 : k * step).toFixed(decimals).replace("-", "−")]);
  }
  return found;
}

function typed(block, Type) {
  if (!block?.byteLength) return new Type(0);
  const { buffer, byteOffset } = ArrayBuffer.isView(block) ? block : { buffer: block, byteOffset: 0 };
  return new Type(buffer.slice(byteOffset, byteOffset + block.byteLength));
}

// Edges of equal cells about their centres.
function edges(centres) {
  const step = (centres.at(-1) - centres[0]) / (centres.length - 1);
  return [centres[0] - step / 2, centres.at(-1) + step / 2, step];
}

// For each pixel the cells on both sides, held at the edges, and the share of the second.
function between(count, cells) {
  const first = new Int32Array(count), share = new Float32Array(count);
  for (let k = 0; k < count; k += 1) {
    const place = Math.min(Math.max(((k + 0.5) / count) * cells - 0.5, 0), cells - 1);
    first[k] = Math.min(Math.floor(place), cells - 2);
    share[k] = place - first[k];
  }
  return [first, share];
}

function render({ model, el }) {
  const id = `dk-${++numberOfViews}`;
  const part = build(id);
  el.classList.add("dk-holder");
  el.append(part.root);
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  let facts = {}, pressure = new Uint16Array(0), curves = new Float32Array(0);
  let time = model.get("time"), playing = false, slow = 10, shows = "now", limit = 1;
  let largest = new Uint16Array(0), largestAt = -1, panel = null, pinned = false;
  let box = null, image = null, last = 0, reported = 0, request = 0, asked = 0, spoken = 0, drawn = 0;

  // ---- data
  const ready = () => (facts.count ?? 0) > 1;
  const end = () => facts.start + facts.step * (facts.count - 1);
  const index = () => Math.min(Math.max(Math.round((time - facts.start) / facts.step), 0), facts.count - 1);
  const cells = () => facts.x.length * facts.y.length;
  const value = (stored) => facts.stored[0] + (stored / 65535) * (facts.stored[1] - facts.stored[0]);
  const kilo = (stored) => value(stored) * facts.field.factor;
  const curve = (row, k = index()) => curves[row * facts.count + k];
  const digits = () => (facts.step < 0.02 ? 3 : facts.step < 0.1 ? 2 : 1);
  const instant = (moment = time) => (moment - facts.origin).toFixed(digits()).replace("-", "−");
  const linked = () => model.get("link");
  const top = () => facts.field.low + limit * (facts.field.high - facts.field.low);
  const round = (number) => Number(number.toPrecision(6)).toString().replace("-", "−");

  function read() {
    facts = model.get("facts") ?? {};
    pressure = typed(model.get("pressure"), Uint16Array);
    curves = typed(model.get("curves"), Float32Array);
    largest = new Uint16Array(ready() ? cells() : 0);
    largestAt = -1;
    slow = facts.slow ?? slow;
  }

  // Largest pressure of every panel up to the instant.
  function soFar() {
    const now = index(), n = cells();
    if (now < largestAt) { largest.fill(0); largestAt = -1; }
    for (let k = largestAt + 1; k <= now; k += 1) {
      const from = k * n;
      for (let i = 0; i < n; i += 1) if (pressure[from + i] > largest[i]) largest[i] = pressure[from + i];
    }
    largestAt = now;
    return largest;
  }

  const present = () => pressure.subarray(index() * cells(), (index() + 1) * cells());

  function greatest(values) {
    let at = 0;
    for (let i = 1; i < values.length; i += 1) if (values[i] > values[at]) at = i;
    return at;
  }

  // ---- drawing
  function prepare(canvas, tall) {
    canvas.style.height = `${tall}px`;
    const ratio = Math.max(1, window.devicePixelRatio || 1), width = canvas.clientWidth;
    const [across, down] = [Math.round(width * ratio), Math.round(tall * ratio)];
    if (canvas.width !== across) canvas.width = across;
    if (canvas.height !== down) canvas.height = down;
    const c = canvas.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, tall);
    c.font = `12px ${FONT}`;
    c.textBaseline = "middle";
    c.lineJoin = "round";
    return [c, width, tall];
  }

  function line(c, x0, y0, x1, y1, colour = GRID, width = 1) {
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.beginPath();
    c.moveTo(x0, y0);
    c.lineTo(x1, y1);
    c.stroke();
  }

  function text(c, words_, x, y, align = "left", colour = INK) {
    c.textAlign = align;
    c.fillStyle = colour;
    c.fillText(words_, x, y);
  }

  // Place of the plan on the canvas, equal scales along and across where the card has room for it.
  function place() {
    const width = part.plan.clientWidth, [aft, fore] = edges(facts.x), [low, high] = edges(facts.y);
    const room = width - MARGIN.left - MARGIN.right;
    const scale = Math.min(room / (fore - aft), TALLEST / (high - low));
    const [wide, tall] = [Math.max((fore - aft) * scale, 40), Math.max((high - low) * scale, 60)];
    return { left: MARGIN.left, top: MARGIN.top, wide, tall, aft, fore, low, high,
      X: (x) => MARGIN.left + ((x - aft) / (fore - aft)) * wide, Y: (y) => MARGIN.top + ((high - y) / (high - low)) * tall };
  }

  // Bands of the pressure; grey where a panel has none.
  function paintField(values) {
    const [wide, tall] = [Math.round(box.wide), Math.round(box.tall)], [nx, ny] = [facts.x.length, facts.y.length];
    if (!image || image.wide !== wide || image.tall !== tall || image.nx !== nx || image.ny !== ny) {
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [wide, tall];
      const c = canvas.getContext("2d");
      image = { canvas, c, wide, tall, nx, ny, pixels: c.createImageData(wide, tall), along: between(wide, nx), across: between(tall, ny) };
    }
    const { low, colours } = facts.field, high = top(), bands = colours.map((one) => [1, 3, 5].map((k) => parseInt(one.slice(k, k + 2), 16)));
    const pixels = image.pixels.data, [iFirst, iShare] = image.along, [jFirst, jShare] = image.across;
    const row = new Float32Array(nx), there = new Float32Array(nx), nought = Math.round((-facts.stored[0] / (facts.stored[1] - facts.stored[0])) * 65535);
    const scale = bands.length / (high - low);
    let to = 0;
    for (let down = 0; down < tall; down += 1) {
      const j = jFirst[tall - 1 - down], b = jShare[tall - 1 - down]; // port is up
      for (let i = 0; i < nx; i += 1) {
        const p = values[i * ny + j], q = values[i * ny + j + 1];
        row[i] = (value(p) * (1 - b) + value(q) * b - low) * scale;
        there[i] = (p !== nought) * (1 - b) + (q !== nought) * b;
      }
      for (let k = 0; k < wide; k += 1, to += 4) {
        const i = iFirst[k], a = iShare[k];
        const band = Math.min(Math.max(Math.floor(row[i] + a * (row[i + 1] - row[i])), 0), bands.length - 1);
        const colour = there[i] + a * (there[i + 1] - there[i]) >= 0.5 ? bands[band] : NOTHING;
        pixels[to] = colour[0];
        pixels[to + 1] = colour[1];
        pixels[to + 2] = colour[2];
        pixels[to + 3] = 255;
      }
    }
    image.c.putImageData(image.pixels, 0, 0);
  }

  function paintPlan() {
    box = place();
    const [c, width] = prepare(part.plan, box.tall + MARGIN.top + MARGIN.bottom);
    const { left, top, wide, tall, X, Y } = box, [nx, ny] = [facts.x.length, facts.y.length];
    paintField(shows === "largest" ? soFar() : present());
    c.imageSmoothingEnabled = false;
    c.drawImage(image.canvas, left, top, wide, tall);
    c.globalAlpha = 0.16;
    for (let i = 1; i < nx; i += 1) line(c, left + (i * wide) / nx, top, left + (i * wide) / nx, top + tall, "#7d8f9b", 0.8);
    for (let j = 1; j < ny; j += 1) line(c, left, top + (j * tall) / ny, left + wide, top + (j * tall) / ny, "#7d8f9b", 0.8);
    c.globalAlpha = 1;
    c.strokeStyle = SOFT;
    c.lineWidth = 1;
    c.strokeRect(left, top, wide, tall);
    for (const [at, label] of ticks(box.aft, box.fore, Math.max(3, wide / 90))) {
      line(c, X(at), top + tall, X(at), top + tall + 4, SOFT);
      text(c, label, X(at), top + tall + 12, "center");
    }
    for (const [at, label] of ticks(box.low, box.high, Math.max(2, tall / 40))) {
      line(c, left - 4, Y(at), left, Y(at), SOFT);
      text(c, label, left - 7, Y(at), "right");
    }
    text(c, wide < 380 ? "x, forward [m]" : "x, forward of amidships [m]", left + wide / 2, top + tall + 30, "center");
    text(c, "bow ▶", left + wide, top + tall + 30, "right", INK);
    text(c, "◀ stern", left, top + tall + 30, "left", SOFT);
    c.save();
    c.translate(14, top + tall / 2);
    c.rotate(-Math.PI / 2);
    text(c, "y, to port [m]", 0, 0, "center");
    c.restore();
    paintBar(c, Math.min(left + wide + 18, width - MARGIN.right + 18));
    paintForce(c);
    if (panel) {
      const [i, j] = panel, [across, down] = [wide / nx, tall / ny];
      c.strokeStyle = "#fff";
      c.lineWidth = 4;
      c.strokeRect(left + i * across, top + (ny - 1 - j) * down, across, down);
      c.strokeStyle = INK;
      c.lineWidth = 2;
      c.strokeRect(left + i * across, top + (ny - 1 - j) * down, across, down);
    }
  }

  function paintBar(c, left) {
    const { colours, low, factor, unit } = facts.field, wide = 14, bottom = box.top + box.tall, upper = box.top + 20;
    const each = (bottom - upper) / colours.length;
    c.font = `600 12px ${FONT}`;
    text(c, `p [${unit}]`, left, box.top + 5);
    c.font = `12px ${FONT}`;
    colours.forEach((colour, k) => {
      c.fillStyle = colour;
      c.fillRect(left, bottom - (k + 1) * each, wide, each + 0.5);
    });
    c.strokeStyle = SOFT;
    c.lineWidth = 1;
    c.strokeRect(left, upper, wide, bottom - upper);
    const every = bottom - upper > 110 ? 2 : bottom - upper > 60 ? 3 : 6;
    for (let k = 0; k <= colours.length; k += every) {
      const at = (low + (k / colours.length) * (top() - low)) * factor, beyond = k === colours.length && limit < 1 ? "≥ " : "";
      text(c, beyond + round(at), left + wide + 6, bottom - k * each);
    }
  }

  // Centre of the force, as large as the force; nothing where it is a hundredth of the largest.
  function paintForce(c) {
    let most = 0;
    for (let k = 0; k < facts.count; k += 1) most = Math.max(most, curves[k]);
    const [x, y] = [curve(2), curve(3)];
    if (!(curve(0) > 0.01 * most) || !Number.isFinite(x) || x < box.aft || x > box.fore || y < box.low || y > box.high) return;
    const [at, down] = [box.X(x), box.Y(y)];
    for (const [colour, width] of [["#fff", 5], [MARK, 2.4]]) {
      c.strokeStyle = colour;
      c.lineWidth = width;
      c.beginPath();
      c.arc(at, down, 8, 0, 2 * Math.PI);
      c.moveTo(at - 13, down);
      c.lineTo(at + 13, down);
      c.moveTo(at, down - 13);
      c.lineTo(at, down + 13);
      c.stroke();
    }
  }

  function paintPlots() {
    const [c, width, tall] = prepare(part.plots, 2 * PLOT + 40);
    const left = MARGIN.left, right = width - MARGIN.right, first = facts.start - facts.step / 2, last = end() + facts.step / 2;
    const X = (moment) => left + ((moment - first) / (last - first)) * (right - left);
    part.plots.span = [left, right, first, last];
    const rows = [["Force", facts.force.unit, 0, facts.force.scale], ["Wetted area", "m²", 1, 1]];
    rows.forEach(([title, unit, row, scale], number) => {
      const top = number * PLOT + 22, bottom = (number + 1) * PLOT - 2;
      let [low, high] = [0, 0];
      for (let k = 0; k < facts.count; k += 1) { low = Math.min(low, curve(row, k) / scale); high = Math.max(high, curve(row, k) / scale); }
      if (high === low) high = low + 1;
      high += 0.04 * (high - low);
      const Y = (one) => bottom - ((one - low) / (high - low)) * (bottom - top);
      for (const [at, label] of ticks(low, high, 3)) {
        line(c, left, Y(at), right, Y(at), GRID);
        text(c, label, left - 6, Y(at), "right");
      }
      c.font = `600 12px ${FONT}`;
      text(c, `${title} [${unit}]`, left, number * PLOT + 11);
      text(c, `${words(curve(row) / scale)} ${unit}`, right + 8, Y(curve(row) / scale), "left", COLOURS[number]);
      c.font = `12px ${FONT}`;
      line(c, left, bottom, right, bottom, SOFT);
      c.strokeStyle = COLOURS[number];
      c.lineWidth = 1.6;
      c.beginPath();
      for (let k = 0; k < facts.count; k += 1) c.lineTo(X(facts.start + k * facts.step), Y(curve(row, k) / scale));
      c.stroke();
      line(c, X(time), top - 4, X(time), bottom, INK, 1);
      c.fillStyle = COLOURS[number];
      c.beginPath();
      c.arc(X(time), Y(curve(row) / scale), 3.6, 0, 2 * Math.PI);
      c.fill();
    });
    const base = 2 * PLOT - 2;
    for (const [at, label] of ticks(first - facts.origin, last - facts.origin, Math.max(3, (right - left) / 90))) {
      line(c, X(at + facts.origin), base, X(at + facts.origin), base + 4, SOFT);
      text(c, label, X(at + facts.origin), base + 12, "center");
    }
    text(c, facts.origin ? "time after the slam begins [s]" : "time [s]", (left + right) / 2, base + 29, "center");
  }

  // ---- words
  function say() {
    const now = greatest(present()), far = soFar(), most = greatest(far), ny = facts.y.length, { unit } = facts.field;
    const at = (cell) => `x ${words(facts.x[Math.floor(cell / ny)])} m, y ${words(facts.y[cell % ny])} m`;
    const pressureNow = kilo(present()[now]);
    const told = pressureNow > 0 ? `largest pressure ${words(pressureNow)} ${unit} at ${at(now)}` : "the deck is dry";
    const before = kilo(far[most]) > 0 ? `; so far ${words(kilo(far[most]))} ${unit} at ${at(most)}` : "";
    const sentence = `${instant()} s: ${told}${before}.`;
    part.clock.textContent = `${instant()} of ${instant(end())} s`;
    part.range.setAttribute("aria-valuetext", sentence);
    if (Math.abs(Number(part.range.value) - time) > 1e-9) part.range.value = String(time);
    part.play.textContent = playing ? "❚❚ Pause" : "▶ Play";
    const moment = performance.now();
    part.status.setAttribute("aria-live", playing ? "off" : "polite");
    if (!playing || moment - spoken > 100) {
      spoken = moment;
      if (part.status.textContent !== sentence) part.status.textContent = sentence;
      sayPanel();
    }
    part.root.dataset.time = String(time);
    part.root.dataset.drawn = String(++drawn);
  }

  function sayPanel() {
    let sentence = "Point at a panel, or use the arrow keys, to read its pressure.";
    if (panel) {
      const [i, j] = panel, cell = i * facts.y.length + j, { unit } = facts.field;
      sentence = `Panel at x ${words(facts.x[i])} m, y ${words(facts.y[j])} m: ${words(kilo(present()[cell]))} ${unit} now, `
        + `largest so far ${words(kilo(soFar()[cell]))} ${unit}.`;
    }
    if (part.panel.textContent !== sentence) part.panel.textContent = sentence;
  }

  // ---- time
  function paint() {
    if (!ready() || !part.plan.clientWidth) return;
    paintPlan();
    paintPlots();
    say();
  }

  // A film in step asks in every frame: what was asked for stays, so that it comes to be painted.
  const paintSoon = () => { asked ||= requestAnimationFrame(() => { asked = 0; paint(); }); };

  function report(force) {
    const now = performance.now();
    if (!force && now - reported < REPORT) return;
    reported = now;
    if (model.get("time") !== time) { model.set("time", time); model.save_changes(); }
  }

  function tell(detail) {
    if (linked()) window.dispatchEvent(new CustomEvent(LINKED, { detail: { link: linked(), from: "deck", ...detail } }));
  }

  function goTo(moment, force = true) {
    if (!ready()) return;
    time = Math.min(Math.max(moment, facts.start), end());
    tell({ time });
    if (!linked()) report(force);
    paintSoon();
  }

  function step(now) {
    if (!playing || linked()) return;
    const pause = calm.matches ? CALM_PAUSE : 0;
    if (now - last >= pause) {
      const passed = Math.min(now - last, 1000) / 1e3 / slow;
      last = now;
      time = time >= end() ? facts.start : Math.min(time + passed, end());
      report(false);
      if (part.plan.offsetParent) paint();
    }
    request = requestAnimationFrame(step);
  }

  function play(wanted, itself = true) {
    if (wanted === playing || !ready()) return;
    if (linked() && itself) { tell({ playing: wanted }); return; }
    playing = wanted;
    cancelAnimationFrame(request);
    if (!linked()) {
      if (playing) { last = performance.now(); request = requestAnimationFrame(step); } else report(true);
      if (model.get("playing") !== playing) { model.set("playing", playing); model.save_changes(); }
    }
    paintSoon();
  }

  // ---- pointer and keys
  const stop = () => { if (!linked()) play(false); };
  part.play.addEventListener("click", () => play(!playing));
  part.range.addEventListener("input", () => { stop(); goTo(Number(part.range.value), false); });
  part.range.addEventListener("change", () => goTo(Number(part.range.value)));
  part.speed.addEventListener("change", () => { slow = Number(part.speed.value); });
  part.limit.addEventListener("change", () => { limit = Number(part.limit.value); paintSoon(); });
  part.shows.addEventListener("change", () => { shows = part.shows.value; paintSoon(); });
  part.save.addEventListener("click", save);

  part.root.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT" || !ready()) return;
    if (event.key === " " && event.target.tagName === "BUTTON") return;
    const small = facts.step * (event.shiftKey ? 10 : 1);
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    if (event.target === part.plan && event.key in arrows) moved(...arrows[event.key]);
    else if (event.target === part.plan && event.key === "Escape") { panel = null; pinned = false; paintSoon(); }
    else if (event.key === " ") play(!playing);
    else if (event.key === "ArrowLeft" || event.key === "ArrowDown") { stop(); goTo(time - small); }
    else if (event.key === "ArrowRight" || event.key === "ArrowUp") { stop(); goTo(time + small); }
    else if (event.key === "Home") { stop(); goTo(facts.start); }
    else if (event.key === "End") { stop(); goTo(end()); }
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  function moved(along, across) {
    const [nx, ny] = [facts.x.length, facts.y.length];
    if (!panel) { const most = greatest(soFar()); panel = [Math.floor(most / ny), most % ny]; }
    else panel = [Math.min(Math.max(panel[0] + along, 0), nx - 1), Math.min(Math.max(panel[1] + across, 0), ny - 1)];
    pinned = true;
    paintSoon();
  }

  function panelAt(event) {
    const i = Math.floor(((event.offsetX - box.left) / box.wide) * facts.x.length);
    const j = facts.y.length - 1 - Math.floor(((event.offsetY - box.top) / box.tall) * facts.y.length);
    return i >= 0 && i < facts.x.length && j >= 0 && j < facts.y.length ? [i, j] : null;
  }
  part.plan.addEventListener("pointermove", (event) => {
    if (pinned || !box || event.pointerType === "touch") return;
    panel = panelAt(event);
    paintSoon();
  });
  part.plan.addEventListener("pointerdown", (event) => {
    if (!box) return;
    const found = panelAt(event), same = pinned && panel && found && found[0] === panel[0] && found[1] === panel[1];
    pinned = Boolean(found) && !same;
    panel = found;
    paintSoon();
  });
  part.plan.addEventListener("pointerleave", () => { if (!pinned) { panel = null; paintSoon(); } });
  const plotTime = (event) => {
    if (event.type === "pointermove" && !(event.buttons & 1)) return;
    if (event.type === "pointerdown") part.plots.setPointerCapture(event.pointerId);
    const [left, right, first, last] = part.plots.span;
    stop();
    goTo(first + ((event.offsetX - left) / (right - left)) * (last - first), event.type === "pointerdown");
  };
  part.plots.addEventListener("pointerdown", plotTime);
  part.plots.addEventListener("pointermove", plotTime);

  function save() {
    const ratio = Math.max(1, window.devicePixelRatio || 1), head = 56, picture = document.createElement("canvas");
    picture.width = part.plan.width;
    picture.height = part.plan.height + part.plots.height + head * ratio;
    const c = picture.getContext("2d");
    c.fillStyle = "#fff";
    c.fillRect(0, 0, picture.width, picture.height);
    c.drawImage(part.plan, 0, head * ratio);
    c.drawImage(part.plots, 0, head * ratio + part.plan.height);
    c.scale(ratio, ratio);
    c.textBaseline = "middle";
    c.font = `600 15px ${FONT}`;
    text(c, facts.title, 12, 18);
    c.font = `13px ${FONT}`;
    text(c, `${part.shows.selectedOptions[0].text}. ${part.range.getAttribute("aria-valuetext")}`, 12, 40);
    picture.toBlob((blob) => {
      const link = element("a", { href: URL.createObjectURL(blob), download: `wet-deck-pressure-${(time - facts.origin).toFixed(3)}-s.png` });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    }, "image/png");
  }

  // ---- what the kernel and the film say
  function choose() {
    part.choices.replaceChildren(...model.get("choices").map(([name, label, options]) => {
      const select = element("select", { "aria-label": label, title: label, "data-name": name });
      for (const [own, shown] of options) select.append(new Option(shown, own));
      select.value = model.get("chosen")[name] ?? options[0][0];
      select.addEventListener("change", () => { model.set("chosen", { ...model.get("chosen"), [name]: select.value }); model.save_changes(); });
      return select;
    }));
  }

  function update() {
    const message = model.get("message") || (ready() ? "" : "Nothing is shown yet.");
    part.title.textContent = (!message && facts.title) || "Pressure over the wet deck";
    part.message.textContent = message;
    part.message.hidden = !message;
    for (const one of [part.body, part.footer, part.line]) one.hidden = Boolean(message);
    part.root.classList.toggle("dk-old", model.get("old"));
    part.notes.replaceChildren(...model.get("notes").map((note) => element("li", { text: note })));
    part.speedChoice.hidden = Boolean(linked());
    part.follows.hidden = !linked();
  }

  function renew() {
    read();
    if (ready()) {
      time = Math.min(Math.max(model.get("time"), facts.start), end());
      Object.assign(part.range, { min: facts.start, max: end(), step: "any" });
      if (![...part.speed.options].some((one) => Number(one.value) === slow)) part.speed.append(new Option(`${slow} × slower`, slow));
      part.speed.value = String(slow);
      const { high, factor, unit } = facts.field;
      part.limit.replaceChildren(...LIMITS.map((share) => new Option(`colours to ${round(share * high * factor)} ${unit}`, share)));
      part.limit.value = String(limit);
      if (panel && (panel[0] >= facts.x.length || panel[1] >= facts.y.length)) { panel = null; pinned = false; }
    }
    update();
    paint();
    if (linked()) tell({ asks: true });
  }

  function heard({ detail }) {
    if (!linked() || detail.link !== linked() || detail.from === "deck" || !ready()) return;
    if (typeof detail.playing === "boolean") play(detail.playing, false);
    if (typeof detail.time === "number" && Math.abs(detail.time - time) > 1e-9) {
      time = Math.min(Math.max(detail.time, facts.start), end());
      if (part.plan.offsetParent) paintSoon();
    }
  }
  window.addEventListener(LINKED, heard);

  const listeners = [
    ["change:revision", renew],
    ["change:choices", choose],
    ["change:chosen", choose],
    ["change:notes", update],
    ["change:message", update],
    ["change:old", update],
    ["change:link", renew],
    ["change:time", () => { if (!playing && ready() && model.get("time") !== time) goTo(model.get("time"), false); }],
    ["change:playing", () => play(model.get("playing"), false)],
  ];
  for (const [event, listener] of listeners) model.on(event, listener);
  const size = new ResizeObserver(() => {
    part.root.classList.toggle("dk-narrow", part.root.clientWidth < 640);
    paintSoon();
  });
  size.observe(part.root);
  choose();
  renew();
  if (model.get("playing") && !calm.matches) play(true);

  return () => {
    playing = false;
    cancelAnimationFrame(request);
    cancelAnimationFrame(asked);
    size.disconnect();
    window.removeEventListener(LINKED, heard);
    for (const [event, listener] of listeners) model.off(event, listener);
    part.root.remove();
  };
}

function build(id) {
  const part = {};
  part.title = element("h2", { id: `${id}-title`, class: "dk-title" });
  part.choices = element("span", { class: "dk-choices" });
  part.shows = element("select", { "aria-label": "Pressure drawn", title: "Pressure drawn" });
  part.shows.append(new Option("pressure now", "now"), new Option("largest so far", "largest"));
  part.limit = element("select", { "aria-label": "Pressure that the colours reach to", title: "Pressure that the colours reach to" });
  part.status = element("div", { class: "dk-status", role: "status" });
  part.line = element("div", { class: "dk-line" }, part.status, part.shows, part.limit);
  part.plan = element("canvas", { class: "dk-plan", tabindex: "0", role: "img", "aria-label": "Wet deck from above with its pressure in bands, bow to the right; the arrow keys move from panel to panel" });
  part.panel = element("div", { class: "dk-panel", "aria-live": "polite" });
  part.plots = element("canvas", { class: "dk-plots", role: "img", "aria-label": "Force on the deck and wetted area against time; drag to move in time" });
  part.body = element("div", { class: "dk-body" }, part.plan, part.panel, part.plots);
  part.message = element("p", { class: "dk-message" });
  part.play = element("button", { type: "button", class: "dk-play" });
  part.range = element("input", { type: "range", id: `${id}-time`, class: "dk-range" });
  part.clock = element("span", { class: "dk-clock" });
  part.speed = element("select", { id: `${id}-speed` });
  for (const slow of SPEEDS) part.speed.append(new Option(slow === 1 ? "real time" : `${slow} × slower`, slow));
  part.speedChoice = element("span", { class: "dk-choice" }, element("label", { for: `${id}-speed`, text: "Speed" }), part.speed);
  part.follows = element("span", { text: "In step with the film above" });
  part.save = element("button", { type: "button", text: "Save picture" });
  part.footer = element("div", { class: "dk-footer" }, part.play, element("label", { for: `${id}-time`, text: "Time" }), part.range, part.clock, part.speedChoice, part.follows, part.save);
  part.notes = element("ul", { class: "dk-notes" });
  part.root = element("div", { class: "dk", role: "group", "aria-labelledby": `${id}-title`, "data-lm-suppress-shortcuts": "true" },
    element("div", { class: "dk-header" }, part.title, part.choices), part.line, part.message, part.body, part.footer, part.notes);
  return part;
}

export default { render };
