// A section entering the water: pressure, water and histories by theory. Drawn on two canvases, without any library.
const FILM = 6; // seconds that the film lasts
const FLAT = 15; // px below which heights are drawn taller
const REPORT = 500; // ms between reports of the time to the kernel
const INK = "#1d2b35", SOFT = "#55666f", GRID = "#dde4e8", WATER = "#dcebf5", BODY = "#eef0f1";
const FONT = 'system-ui, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';

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

const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

// Three significant figures without exponent, or a dash.
function words(value, digits = 3) {
  if (!isNumber(value)) return "–";
  if (value === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(Number(value.toPrecision(digits)))));
  if (size < -4 || size > 6) return value.toExponential(digits - 1);
  return value.toFixed(Math.max(0, digits - 1 - size)).replace("-", "−");
}

function roundStep(span, wanted) {
  const raw = Math.max(span, 1e-12) / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  for (const factor of [1, 2, 5, 10]) if (factor * power >= raw * 0.999) return factor * power;
  return 10 * power;
}

function ticks(low, high, wanted) {
  const step = roundStep(high - low, wanted);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) {
    found.push([k * step, (k * step).toFixed(decimals).replace("-", "−")]);
  }
  return found;
}

function render({ model, el }) {
  const id = `sec-${++numberOfViews}`;
  const part = build(id);
  el.classList.add("sec-holder");
  el.append(part.root);
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  let scene, curves, time = model.get("time"), playing = false, pointer = null, last = 0, reported = 0, request = 0;
  let mapping = null, drawn = 0, close = false;

  // ---- data
  const theories = () => scene.theories ?? [];
  const isShown = (theory) => model.get("shown").includes(theory.name);
  const live = () => theories().filter((theory) => theory.status === "ready" && isShown(theory));
  const end = () => scene.times[scene.times.length - 1];

  function read() {
    scene = model.get("scene");
    const bytes = model.get("curves");
    const raw = bytes?.byteLength ? bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) : new ArrayBuffer(0);
    curves = new Float32Array(raw);
  }

  // Instants on both sides of the time, and the share of the later one.
  function between() {
    const times = scene.times, n = times.length;
    const place = Math.min(Math.max((time / end()) * n - 1, 0), n - 1);
    const i = Math.min(Math.floor(place), Math.max(n - 2, 0));
    return [i, Math.min(i + 1, n - 1), place - i];
  }

  function history(theory, name) {
    const values = theory.histories?.[name];
    if (!values) return null;
    const [i, j, share] = between();
    return isNumber(values[i]) && isNumber(values[j]) ? values[i] + share * (values[j] - values[i]) : null;
  }

  function motion(name) {
    const [i, j, share] = between();
    const values = scene.motion[name];
    return values[i] + share * (values[j] - values[i]);
  }

  // Curve of a theory at the time: [positions, values].
  function curve(theory, kind) {
    const count = kind === "pressure" ? theory.points : theory.surface_points;
    if (!count) return null;
    const stride = 2 * (theory.points + theory.surface_points);
    const start = theory.offset + (kind === "pressure" ? 0 : 2 * theory.points);
    const [i, j, share] = between();
    const mix = (k) => {
      const a = curves[start + i * stride + k], b = curves[start + j * stride + k];
      return a + share * (b - a);
    };
    const positions = new Float64Array(count), values = new Float64Array(count);
    for (let k = 0; k < count; k += 1) { positions[k] = mix(k); values[k] = mix(count + k); }
    return [positions, values];
  }

  function pressureAt(theory, y) {
    const found = curve(theory, "pressure");
    if (!found) return null;
    const [positions, values] = found, n = positions.length;
    if (y > positions[n - 1]) return 0;
    for (let k = 1; k < n; k += 1) {
      if (positions[k] >= y) {
        const width = positions[k] - positions[k - 1];
        return width > 0 ? values[k - 1] + ((y - positions[k - 1]) / width) * (values[k] - values[k - 1]) : values[k];
      }
    }
    return 0;
  }

  function heightAt(y) {
    const { y: ys, z: zs } = scene.outline;
    for (let k = 1; k < ys.length; k += 1) {
      if (ys[k] >= y) return zs[k - 1] + ((y - ys[k - 1]) / (ys[k] - ys[k - 1])) * (zs[k] - zs[k - 1]);
    }
    return null;
  }

  // ---- drawing
  function prepare(canvas) {
    const ratio = Math.max(1, window.devicePixelRatio || 1);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
    if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
    const c = canvas.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    c.lineJoin = "round";
    c.font = `12px ${FONT}`;
    c.textBaseline = "middle";
    return [c, width, height];
  }

  function style(c, theory) {
    c.strokeStyle = theory.colour;
    c.fillStyle = theory.colour;
    c.lineWidth = theory.width;
    c.setLineDash(theory.dash.map((one) => one * theory.width));
  }

  function plain(c, colour = GRID, width = 1) {
    c.strokeStyle = colour;
    c.lineWidth = width;
    c.setLineDash([]);
  }

  function stroke(c, xs, ys, count = xs.length) {
    c.beginPath();
    for (let k = 0; k < count; k += 1) k ? c.lineTo(xs(k), ys(k)) : c.moveTo(xs(k), ys(k));
    c.stroke();
  }

  function text(c, words_, x, y, align = "left", colour = INK, background = "") {
    c.textAlign = align;
    if (background) {
      const wide = c.measureText(words_).width;
      c.fillStyle = background;
      c.fillRect(align === "left" ? x - 2 : x - wide - 2, y - 8, wide + 4, 16);
    }
    c.fillStyle = colour;
    c.fillText(words_, x, y);
  }

  function clipped(c, x, y, width, height, draw) {
    c.save();
    c.beginPath();
    c.rect(x, y, width, height);
    c.clip();
    draw();
    c.restore();
  }

  // Frame of the whole section, the same over the film; equal scales in y and z but for what is all but flat.
  function whole(plot, most) {
    let reach = scene.reach, scale = plot / (2 * reach);
    if ((scene.high - scene.low) * scale > most) {
      scale = most / (scene.high - scene.low);
      reach = plot / (2 * scale);
    }
    const flat = (scene.high - scene.low) * scale;
    const taller = flat < FLAT ? [50, 20, 10, 5, 2].find((factor) => flat * factor <= 100) ?? 1 : 1;
    const tall = Math.max(flat * taller, Math.min(120, most));
    const spare = (tall - flat * taller) / (scale * taller);
    return { scale, taller, tall, from: -reach, to: reach, low: scene.low - 0.4 * spare, high: scene.high + 0.6 * spare };
  }

  // Frame about the edge of the wetted part, which it follows.
  function nearRoot(plot, most, shown) {
    const root = ["wagner", "logvinovich", "generalised-wagner", "nonlinear", "similarity", "von-karman"]
      .map((name) => shown.find((one) => one.name === name)).map((one) => one && history(one, "half_breadth")).find(isNumber) ?? scene.reach / 2;
    const scale = plot / (0.5 * root), tall = most;
    const middle = (heightAt(root) ?? scene.high) - motion("penetration");
    return { scale, taller: 1, tall, from: 0.8 * root, to: 1.3 * root, low: middle - (0.55 * tall) / scale, high: middle + (0.45 * tall) / scale };
  }

  function paintMain() {
    const [c, width, height] = prepare(part.main);
    const shown = live();
    const left = 58, right = width - 14, rows = shown.filter((one) => isNumber(history(one, "half_breadth")));
    const plot = right - left;
    const bottom = height - 42 - 13 * Math.max(rows.length, 1);
    const most = Math.min(0.55 * height, bottom - 190);
    const { scale, taller, from, to, low, high, tall } = close ? nearRoot(plot, most, shown) : whole(plot, most);
    const reach = Math.max(Math.abs(from), Math.abs(to)), far = 4 * reach;
    const sectionTop = bottom - tall, pressureTop = 24, pressureBottom = sectionTop - 14;
    const X = (y) => left + (y - from) * scale;
    const Z = (z) => bottom - (z - low) * scale * taller;
    const top = (scene.tops.pressure || 1) / 1e3;
    const P = (kPa) => pressureBottom - (kPa / top) * (pressureBottom - pressureTop);
    mapping = { left, right, from, scale };

    // pressure axes
    for (const [value, label] of ticks(0, top, Math.max(2, (pressureBottom - pressureTop) / 45))) {
      plain(c);
      stroke(c, (k) => [left, right][k], () => P(value), 2);
      text(c, label, left - 7, P(value), "right");
    }
    c.font = `600 12px ${FONT}`;
    text(c, "Pressure on the section [kPa]", left + 2, 11, "left", INK);
    c.font = `12px ${FONT}`;

    // section in the water
    const depth = motion("penetration");
    const ys = scene.outline.y, zs = scene.outline.z, n = ys.length;
    const leading = ["nonlinear", "similarity", "generalised-wagner", "wagner", "logvinovich", "von-karman"]
      .map((name) => shown.find((one) => one.name === name && one.surface_points)).find(Boolean);
    clipped(c, left, sectionTop, plot, tall, () => {
      c.fillStyle = WATER;
      const found = leading && curve(leading, "surface");
      c.beginPath();
      if (found) {
        const [py, pz] = found, m = py.length;
        c.moveTo(X(-reach), Z(low));
        c.lineTo(X(-reach), Z(0));
        for (let k = m - 1; k >= 0; k -= 1) c.lineTo(X(-Math.min(py[k], far)), Z(pz[k]));
        c.lineTo(X(0), Z(-depth));
        for (let k = 0; k < m; k += 1) c.lineTo(X(Math.min(py[k], far)), Z(pz[k]));
        c.lineTo(X(reach), Z(0));
        c.lineTo(X(reach), Z(low));
      } else {
        c.rect(left, Z(0), plot, Z(low) - Z(0));
      }
      c.fill();
      c.beginPath();
      for (let k = n - 1; k >= 0; k -= 1) c.lineTo(X(-ys[k]), Z(zs[k] - depth));
      for (let k = 0; k < n; k += 1) c.lineTo(X(ys[k]), Z(zs[k] - depth));
      c.lineTo(X(ys[n - 1]), Z(high) - 5);
      c.lineTo(X(-ys[n - 1]), Z(high) - 5);
      c.closePath();
      c.fillStyle = BODY;
      c.fill();
      plain(c, SOFT, 1);
      c.setLineDash([2, 4]);
      stroke(c, (k) => [left, right][k], () => Z(0), 2);
      for (const theory of shown) {
        const surface = curve(theory, "surface");
        if (!surface) continue;
        const [py, pz] = surface;
        style(c, theory);
        for (const side of [-1, 1]) stroke(c, (k) => X(side * Math.min(py[k], far)), (k) => Z(pz[k]), py.length);
      }
      plain(c, INK, 2);
      c.beginPath();
      for (let k = n - 1; k >= 0; k -= 1) c.lineTo(X(-ys[k]), Z(zs[k] - depth));
      for (let k = 0; k < n; k += 1) c.lineTo(X(ys[k]), Z(zs[k] - depth));
      c.stroke();
      if (scene.panel) {
        plain(c, "#f0a30a", 6);
        const inner = scene.panel[0], outer = Math.min(scene.panel[1], ys[n - 1]);
        const along = Array.from({ length: 25 }, (_, k) => inner + (k / 24) * (outer - inner));
        if (outer > inner) for (const side of [-1, 1]) stroke(c, (k) => X(side * along[k]), (k) => Z(heightAt(along[k]) - depth) - 4, 25);
      }
    });
    for (const [value, label] of ticks(low, high, Math.max(3, tall / 26))) {
      plain(c, SOFT);
      stroke(c, (k) => [left - 4, left][k], () => Z(value), 2);
      if (Z(value) > sectionTop + 20 && Z(value) < bottom - 3) text(c, label, left - 7, Z(value), "right");
    }
    text(c, "z [m]", left - 7, sectionTop + 8, "right", INK);
    if (Z(0) > sectionTop && Z(0) < bottom - 16) text(c, "calm water", right - 4, Z(0) + 9, "right", SOFT);
    if (taller > 1) text(c, `heights drawn ${taller} times taller`, left + 6, bottom - 9, "left", INK);
    plain(c, SOFT);
    c.strokeRect(left, sectionTop, plot, tall);
    stroke(c, () => left, (k) => [pressureTop - 4, pressureBottom][k], 2);
    stroke(c, (k) => [left, right][k], () => pressureBottom, 2);

    // pressure
    clipped(c, left, pressureTop - 6, plot, pressureBottom - pressureTop + 7, () => {
      if (scene.panel) {
        c.fillStyle = "rgba(240,163,10,.13)";
        for (const side of [-1, 1]) {
          const [a, b] = [X(side * scene.panel[0]), X(side * scene.panel[1])];
          c.fillRect(Math.min(a, b), pressureTop, Math.abs(b - a), pressureBottom - pressureTop);
        }
      }
      for (const theory of shown) {
        style(c, theory);
        const found = curve(theory, "pressure");
        if (found) {
          const [py, pp] = found;
          for (const side of [-1, 1]) stroke(c, (k) => X(side * py[k]), (k) => Math.max(P(pp[k] / 1e3), -1e4), py.length);
          const mean = history(theory, "panel");
          if (isNumber(mean) && scene.panel) {
            c.lineWidth = 3;
            c.setLineDash([]);
            c.globalAlpha = 0.6;
            stroke(c, (k) => X(scene.panel[k]), () => P(mean / 1e3), 2);
            c.globalAlpha = 1;
          }
          const [place, peak] = [history(theory, "peak_place"), history(theory, "peak")];
          if (isNumber(place) && isNumber(peak)) {
            for (const side of [-1, 1]) {
              c.beginPath();
              c.arc(X(side * place), P(peak / 1e3), 3.4, 0, 2 * Math.PI);
              c.fill();
            }
          }
        } else {
          const peak = history(theory, "peak");
          if (isNumber(peak)) stroke(c, (k) => [left, right][k], () => P(peak / 1e3), 2);
        }
      }
      if (pointer) {
        plain(c, SOFT);
        stroke(c, () => X(pointer.y), (k) => [pressureTop, pressureBottom][k], 2);
      }
    });

    // axis of y and wetted breadths
    plain(c, SOFT);
    for (const [value, label] of ticks(from, to, Math.max(4, plot / 70))) {
      stroke(c, () => X(value), (k) => [bottom, bottom + 4][k], 2);
      text(c, label, X(value), bottom + 12, "center");
    }
    text(c, "distance from the centreline y [m]", (left + right) / 2, bottom + 27, "center", INK);
    clipped(c, left - 1, bottom + 34, plot + 15, height - bottom, () => rows.forEach((theory, row) => {
      const half = history(theory, "half_breadth"), at = bottom + 43 + 13 * row;
      style(c, theory);
      stroke(c, (k) => X([-half, half][k]), () => at, 2);
      c.setLineDash([]);
      for (const side of [-1, 1]) stroke(c, () => X(side * half), (k) => [at - 4, at + 4][k], 2);
      const wide = `${words(2 * half)} m`;
      const tip = Math.min(X(half), right), room = right - tip > 64;
      text(c, wide, room ? tip + 7 : tip - 7, at, room ? "left" : "right", INK, "#fff");
    }));
    if (rows.length) {
      c.textAlign = "left";
      text(c, "wetted", 6, bottom + 41, "left", SOFT);
      text(c, "breadth", 6, bottom + 55, "left", SOFT);
    }
    if (!shown.length) text(c, "No theory is shown: tick one above.", (left + right) / 2, (pressureTop + pressureBottom) / 2, "center", SOFT);
  }

  function paintSide() {
    const [c, width, height] = prepare(part.side);
    const shown = live();
    const plots = [
      ["Force per length [kN/m]", "force", 1e3, scene.tops.force],
      ["Peak pressure [kPa]", "peak", 1e3, scene.tops.pressure],
      scene.panel ? ["Average over the panel [kPa]", "panel", 1e3, scene.tops.panel] : ["k = peak over ρV²/2 [-]", "k", 1, scene.tops.k],
    ];
    const left = 50, right = width - 12, each = (height - 34) / plots.length;
    const inMs = end() < 2, factor = inMs ? 1e3 : 1;
    const X = (t) => left + (t / end()) * (right - left);
    part.side.span = [left, right];
    plots.forEach(([title, name, unit, limit], row) => {
      const top = row * each + 22, bottom = (row + 1) * each - 6, most = (limit || 1) / unit;
      const Y = (value) => bottom - (value / most) * (bottom - top);
      for (const [value, label] of ticks(0, most, Math.max(2, (bottom - top) / 36))) {
        plain(c);
        stroke(c, (k) => [left, right][k], () => Y(value), 2);
        text(c, label, left - 6, Y(value), "right");
      }
      plain(c, SOFT);
      stroke(c, () => left, (k) => [top, bottom][k], 2);
      stroke(c, (k) => [left, right][k], () => bottom, 2);
      c.font = `600 12px ${FONT}`;
      text(c, title, 4, row * each + 9, "left", INK);
      c.font = `12px ${FONT}`;
      clipped(c, left, top - 2, right - left, bottom - top + 4, () => {
        for (const theory of shown) {
          const values = theory.histories[name];
          if (!values) continue;
          style(c, theory);
          const there = values.map((value, k) => [scene.times[k], value]).filter(([, value]) => isNumber(value));
          if (there.length) stroke(c, (k) => X(there[k][0]), (k) => Math.max(Y(there[k][1] / unit), -1e4), there.length);
        }
        plain(c, INK, 1);
        stroke(c, () => X(time), (k) => [top, bottom][k], 2);
      });
      for (const theory of shown) {
        const value = history(theory, name);
        if (!isNumber(value) || value / unit > most) continue;
        style(c, theory);
        c.beginPath();
        c.arc(X(time), Y(value / unit), 3.2, 0, 2 * Math.PI);
        c.fill();
      }
      if (row === plots.length - 1) {
        plain(c, SOFT);
        for (const [value, label] of ticks(0, end() * factor, Math.max(2, (right - left) / 70))) {
          stroke(c, () => X(value / factor), (k) => [bottom, bottom + 4][k], 2);
          text(c, label, Math.min(X(value / factor), right - 6), bottom + 12, "center");
        }
        text(c, `time after first contact [${inMs ? "ms" : "s"}]`, (left + right) / 2, bottom + 28, "center", INK);
      }
    });
  }

  // ---- words
  const clock = () => (end() < 2 ? `${(1e3 * time).toFixed(time < 0.1 ? 1 : 0)} ms` : `${time.toFixed(2)} s`);

  function ratios(theory) {
    const depth = motion("penetration"), speed = motion("velocity"), rho = scene.density;
    const scaled = (name, size) => {
      const value = history(theory, name);
      return isNumber(value) ? value / size : null;
    };
    return [
      scaled("k", 1), scaled("peak_height", depth), scaled("force", rho * speed * speed * depth), scaled("rate", speed),
      ...(scene.panel ? [scaled("panel", (rho * speed * speed) / 2)] : []),
    ];
  }

  function fillTable() {
    const heads = ["Theory", "Peak k [-]", "Peak height z/h [-]", "Force F/(ρV²h) [-]", "Wetted rate ċ/V [-]", ...(scene.panel ? ["Panel k [-]"] : []), "What to trust"];
    part.head.replaceChildren(element("tr", {}, ...heads.map((one) => element("th", { scope: "col", text: one }))));
    part.cells = {};
    part.body.replaceChildren(...theories().map((theory) => {
      const name = element("th", { scope: "row" }, swatch(theory), document.createTextNode(theory.label));
      const row = element("tr", { "data-theory": theory.name, class: `sec-${theory.status}` }, name);
      if (theory.status !== "ready") {
        row.append(element("td", { colspan: String(heads.length - 1), text: theory.sentence }));
        return row;
      }
      part.cells[theory.name] = ratios(theory).map(() => element("td"));
      row.append(...part.cells[theory.name], element("td", { class: "sec-trust", text: theory.warnings.join(" ") || "In its range." }));
      return row;
    }));
  }

  function updateTable() {
    for (const theory of theories()) {
      const cells = part.cells[theory.name];
      if (!cells) continue;
      ratios(theory).forEach((value, k) => {
        const shown = words(value);
        if (cells[k].textContent !== shown) cells[k].textContent = shown;
      });
    }
  }

  function swatch(theory) {
    const wide = 34, made = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    made.setAttribute("width", wide);
    made.setAttribute("height", 10);
    made.setAttribute("aria-hidden", "true");
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    for (const [name, value] of Object.entries({
      x1: 1, x2: wide - 1, y1: 5, y2: 5, stroke: theory.colour, "stroke-width": theory.width + 0.4,
      "stroke-dasharray": theory.dash.map((one) => one * theory.width).join(" "),
    })) line.setAttribute(name, value);
    made.append(line);
    return made;
  }

  function fillLegend() {
    const focused = part.legend.contains(document.activeElement) ? document.activeElement.value : "";
    part.legend.replaceChildren(element("legend", { text: "Theories" }), ...theories().map((theory) => {
      const box = element("input", { type: "checkbox", value: theory.name, disabled: theory.status !== "ready" });
      box.checked = isShown(theory) && theory.status === "ready";
      box.addEventListener("change", () => {
        const others = model.get("shown").filter((name) => name !== theory.name);
        model.set("shown", box.checked ? [...others, theory.name] : others);
        model.save_changes();
      });
      const state = { refused: " (see below)", waiting: theory.on_request ? " (not computed)" : " …" }[theory.status] ?? "";
      return element("label", { class: `sec-${theory.status}`, title: theory.sentence ?? "" }, box, swatch(theory), element("span", { text: theory.label + state }));
    }));
    if (focused) part.legend.querySelector(`[value="${focused}"]`)?.focus();
  }

  function say() {
    const sentence = `${clock()} after first contact, ${words(motion("penetration"))} m deep, ${words(motion("velocity"))} m/s`;
    part.instant.textContent = sentence;
    part.range.setAttribute("aria-valuetext", sentence);
    if (document.activeElement !== part.range || playing) part.range.value = String(time);
    else if (Math.abs(Number(part.range.value) - time) > 1e-9 * end()) part.range.value = String(time);
    part.play.textContent = playing ? "❚❚ Pause" : "▶ Play";
    part.root.dataset.time = String(time);
    part.root.dataset.drawn = String(++drawn);
    updateTable();
    sayPointer();
  }

  function sayPointer() {
    part.tip.hidden = !pointer;
    if (!pointer) return;
    const lines = live().map((theory) => [theory, pressureAt(theory, Math.abs(pointer.y))]).filter(([, p]) => isNumber(p));
    part.tip.replaceChildren(
      element("b", { text: `y = ${words(pointer.y)} m` }),
      ...lines.map(([theory, p]) => element("div", {}, swatch(theory), document.createTextNode(`${theory.label} ${words(p / 1e3)} kPa`))),
    );
    const wide = part.tip.offsetWidth || 220, room = part.main.clientWidth;
    part.tip.style.left = `${pointer.x + 14 + wide > room ? Math.max(pointer.x - wide - 14, 2) : pointer.x + 14}px`;
    part.tip.style.top = "26px";
  }

  // ---- time
  function paint() {
    if (!scene.times) return;
    paintMain();
    paintSide();
    say();
  }

  let asked = 0;
  const paintSoon = () => { cancelAnimationFrame(asked); asked = requestAnimationFrame(paint); };

  function report(force) {
    const now = performance.now();
    if (!force && now - reported < REPORT) return;
    reported = now;
    if (model.get("time") !== time) { model.set("time", time); model.save_changes(); }
  }

  function goTo(value, force = true) {
    time = Math.min(Math.max(value, scene.times[0]), end());
    report(force);
    paintSoon();
  }

  function step(now) {
    if (!playing) return;
    const pause = calm.matches ? 600 : 0; // reduced motion: a few still pictures instead of a film
    if (now - last >= pause) {
      const share = Math.min((now - last) / 1e3, 1) / FILM;
      last = now;
      time = time >= end() ? scene.times[0] : Math.min(time + share * end(), end());
      report(false);
      paint();
    }
    request = requestAnimationFrame(step);
  }

  function play(wanted) {
    if (wanted === playing) return;
    playing = wanted;
    cancelAnimationFrame(request);
    if (playing) { last = performance.now(); request = requestAnimationFrame(step); } else report(true);
    if (model.get("playing") !== playing) { model.set("playing", playing); model.save_changes(); }
    paintSoon();
  }

  part.play.addEventListener("click", () => play(!playing));
  part.close.addEventListener("click", () => {
    close = !close;
    part.close.setAttribute("aria-pressed", String(close));
    paintSoon();
  });
  part.range.addEventListener("input", () => { play(false); goTo(Number(part.range.value), false); });
  part.range.addEventListener("change", () => goTo(Number(part.range.value)));
  part.root.addEventListener("keydown", (event) => {
    const small = end() / scene.times.length;
    const jumps = { ArrowLeft: time - small, ArrowDown: time - small, ArrowRight: time + small, ArrowUp: time + small, Home: scene.times[0], End: end() };
    const target = event.target.tagName;
    if (event.key === " " && target !== "BUTTON" && event.target.type !== "checkbox") play(!playing);
    else if (event.key in jumps && event.target.type !== "checkbox") { play(false); goTo(jumps[event.key]); }
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  part.main.addEventListener("pointermove", (event) => {
    if (!mapping) return;
    const x = event.offsetX;
    pointer = x < mapping.left || x > mapping.right ? null : { x, y: (x - mapping.left) / mapping.scale + mapping.from };
    paintSoon();
  });
  part.main.addEventListener("pointerleave", () => { pointer = null; paintSoon(); });
  const sideTime = (event) => {
    if (event.type === "pointermove" && !(event.buttons & 1)) return;
    const [left, right] = part.side.span;
    play(false);
    goTo(((event.offsetX - left) / (right - left)) * end(), event.type === "pointerdown");
  };
  part.side.addEventListener("pointerdown", sideTime);
  part.side.addEventListener("pointermove", sideTime);

  function renew() {
    read();
    if (!scene.times) return;
    time = Math.min(Math.max(model.get("time"), scene.times[0]), end());
    part.title.textContent = scene.title;
    part.range.min = String(scene.times[0]);
    part.range.max = String(end());
    part.range.step = "any";
    fillLegend();
    fillTable();
    paint();
  }

  const listeners = [
    ["change:revision", renew],
    ["change:shown", () => { fillLegend(); paintSoon(); }],
    ["change:time", () => { if (!playing && scene.times && model.get("time") !== time) { time = model.get("time"); paintSoon(); } }],
    ["change:playing", () => play(model.get("playing"))],
    ["change:old", () => part.root.classList.toggle("sec-old", model.get("old"))],
  ];
  for (const [event, listener] of listeners) model.on(event, listener);
  const size = new ResizeObserver(() => {
    part.root.classList.toggle("sec-narrow", part.root.clientWidth < 720);
    if (scene?.times) paintSoon();
  });
  size.observe(part.root);
  renew();
  if (model.get("playing") && !calm.matches) play(true);

  return () => {
    playing = false;
    cancelAnimationFrame(request);
    cancelAnimationFrame(asked);
    size.disconnect();
    for (const [event, listener] of listeners) model.off(event, listener);
    part.root.remove();
  };
}

function build(id) {
  const part = {};
  part.title = element("h2", { id: `${id}-title`, class: "sec-title" });
  part.instant = element("div", { class: "sec-instant" });
  part.legend = element("fieldset", { class: "sec-legend" });
  part.main = element("canvas", { class: "sec-main", tabindex: "0", role: "img", "aria-label": "Section in the water with its pressure, by theory; the table below holds the figures, the arrow keys step in time" });
  part.tip = element("div", { class: "sec-tip", hidden: true });
  part.side = element("canvas", { class: "sec-side", role: "img", "aria-label": "Force and pressure against time, by theory" });
  part.play = element("button", { type: "button", class: "sec-play" });
  part.range = element("input", { type: "range", id: `${id}-time`, class: "sec-range" });
  part.close = element("button", { type: "button", class: "sec-close", "aria-pressed": "false", text: "Look at the spray root" });
  part.head = element("thead");
  part.body = element("tbody");
  part.root = element("div", { class: "sec", role: "group", "aria-labelledby": `${id}-title`, "data-lm-suppress-shortcuts": "true" },
    element("div", { class: "sec-header" }, part.title, part.instant),
    part.legend,
    element("div", { class: "sec-body" }, element("div", { class: "sec-stage" }, part.main, part.tip), part.side),
    element("div", { class: "sec-footer" }, part.play, element("label", { for: `${id}-time`, text: "Time" }), part.range, part.close),
    element("div", { class: "sec-scroll" }, element("table", { class: "sec-table" }, element("caption", { text: "At the instant shown, theory by theory" }), part.head, part.body)));
  return part;
}

export default { render };
