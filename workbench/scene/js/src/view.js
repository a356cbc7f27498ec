// One view: data and state come from a source, the film runs here without asking anybody.
import styles from "./style.css";
import { buildControls, fillBar, paintTicks } from "./controls.js";
import { curveAt, GEOMETRY, largestOf, readScene, shown, slamList, WATER } from "./data.js";
import { savePicture } from "./picture.js";
import { CAMERAS, graphics, Stage } from "./stage.js";
import { Strip } from "./strip.js";

const SYNC_INTERVAL = 500; // [ms] between reports of the time
const TEXT_INTERVAL = 100; // [ms] between changes of the numbers
const SETTLE = 250; // [ms] of standing still before the picture is sharpened
const SLAM_SHOWN = 1.0; // [s]
const LINKED = "wet-deck-time"; // event by which views of the same film tell each other the time
const NO_WEBGL = "This browser cannot draw the 3-D view because WebGL is switched off; switch hardware acceleration on, "
  + "or ask for the film of this scene instead. The curves, the time and the pressure below are still shown.";

export function createView(host, source, { height }) {
  const root = document.createElement("div");
  root.className = "sv";
  root.style.height = height ? `${height}px` : "100%";
  const sheet = document.createElement("style");
  sheet.textContent = styles;
  root.append(sheet);
  host.append(root);
  const part = buildControls(root);
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;

  let scene;
  let slams = [];
  let time = source.get("time");
  let playing = source.get("playing") && !calm;
  let rate = 1;
  let stale = true; // the picture does not show the present state
  let visible = true;
  let lastFrame = 0;
  let lastText = 0;
  let lastSync = 0;
  let quietSince = 0;
  let frame = 0;
  const probe = { frames: 0, ms: 0, time, playing, ratio: 0 };
  window.__sv = probe;

  const kind = graphics();
  let stage = null;
  if (kind) {
    try {
      stage = new Stage(part.canvas, kind, () => showCamera(""));
    } catch {
      stage = null;
    }
  }
  if (!stage) part.message.textContent = NO_WEBGL;
  const strip = new Strip(part.strip, (moment) => seek(moment));

  function seek(moment, report = true) {
    time = Math.min(Math.max(moment, scene.facts.start), scene.end);
    stale = true;
    if (report && !playing) reportTime(performance.now(), true);
  }

  // Views that share the name of this film follow its time, and may lead it, without asking the kernel.
  const shared = {};
  function tell() {
    const link = source.get("link");
    if (!link || (shared.time === time && shared.playing === playing)) return;
    Object.assign(shared, { time, playing });
    window.dispatchEvent(new CustomEvent(LINKED, { detail: { link, from: "film", time, playing } }));
  }
  function heard({ detail }) {
    if (!scene || !detail.link || detail.link !== source.get("link") || detail.from === "film") return;
    if (detail.asks) shared.time = undefined;
    if (typeof detail.time === "number") seek(detail.time);
    if (typeof detail.playing === "boolean") setPlaying(detail.playing);
    tell();
  }
  window.addEventListener(LINKED, heard);

  let late = 0;
  function reportTime(now, soon = false) {
    clearTimeout(late);
    if (now - lastSync >= SYNC_INTERVAL) {
      lastSync = now;
      source.set("time", time);
    } else if (soon) {
      late = setTimeout(() => reportTime(performance.now(), true), SYNC_INTERVAL - (now - lastSync));
    }
  }

  function setPlaying(wanted, report = true) {
    if (wanted && time >= scene.end) time = scene.facts.start;
    playing = wanted;
    lastFrame = 0;
    stale = true;
    part.play.textContent = playing ? "\u275a\u275a Pause" : "\u25b6 Play";
    if (!report) return;
    source.set("playing", playing);
    reportTime(performance.now(), true);
  }

  function setField(name) {
    const field = scene.facts.fields.find((one) => one.name === name);
    part.field.value = field ? name : "";
    fillBar(part.bar, field);
    stage?.setField(name);
    stale = true;
  }

  function showCamera(name) {
    for (const button of part.cameras.children) button.setAttribute("aria-pressed", String(button.dataset.camera === name));
    source.set("camera", name);
    stale = true;
  }

  function setCamera(name) {
    if (!CAMERAS[name]) return;
    stage?.setCamera(name);
    showCamera(name);
  }

  let known = {};
  function load() {
    scene = readScene(source.get);
    slams = slamList(scene);
    const { facts } = scene;
    const names = [...GEOMETRY, ...WATER, "pose", "slams", ...facts.fields.map(({ name }) => name)];
    const changed = !known.scene || names.some((name) => known[name] !== source.get(name)) || known.scene !== source.get("scene");
    known = Object.fromEntries(["scene", ...names].map((name) => [name, source.get(name)]));
    part.title.textContent = facts.title || "Wet deck in waves";
    part.title.title = part.title.textContent;
    part.range.min = facts.start;
    part.range.max = scene.end;
    part.next.hidden = slams.length === 0;
    part.field.parentElement.hidden = facts.fields.length === 0;
    part.field.replaceChildren(...facts.fields.map(({ name, label }) => new Option(label, name)));
    time = Math.min(Math.max(time, facts.start), scene.end);
    if (changed) stage?.setScene(scene);
    strip.setScene(scene);
    setField(source.get("field"));
    resize();
  }

  function resize() {
    const width = root.clientWidth;
    if (!width || !scene) return;
    const narrow = width < 700;
    root.classList.toggle("sv-narrow", narrow);
    root.style.setProperty("--strip", `${Math.round(Math.min(420, Math.max(250, 0.26 * width)))}px`);
    if (height) root.style.height = `${narrow ? height + 280 : height}px`;
    const stageBox = part.stage.getBoundingClientRect();
    const planWidth = Math.round(Math.min(420, Math.max(240, 0.40 * stageBox.width)));
    const planHeight = Math.round(Math.min(130, Math.max(64, 0.19 * stageBox.height)));
    part.plan.style.width = `${planWidth}px`;
    part.plan.style.height = `${planHeight}px`;
    const plan = narrow ? null : { left: stageBox.width - planWidth - 9, bottom: 11, width: planWidth - 2, height: planHeight - 2 };
    const bottom = narrow ? 70 : planHeight + 34;
    stage?.layout(stageBox.width, stageBox.height, { top: 26, right: 8, bottom, left: 8 }, plan);
    strip.resize(part.strip.clientWidth, part.strip.clientHeight);
    paintTicks(part.ticks, slams, scene.facts.start, scene.end);
    stale = true;
  }

  function words(now) {
    if (now - lastText < TEXT_INTERVAL && playing) return;
    lastText = now;
    part.range.value = time;
    part.clock.textContent = `${shown(time, 1)} of ${shown(scene.end, 1)} s`;
    part.instant.textContent = `Time ${shown(time, 1)} s`;
    const pressure = curveAt(scene, "largest_pressure", time);
    const film = largestOf(scene, "largest_pressure");
    const told = pressure === null ? "" : `Largest pressure ${shown(pressure, 0)} kPa (whole film ${shown(film, 0)} kPa)`;
    part.pressure.textContent = told;
    part.range.setAttribute("aria-valuetext", `${shown(time, 1)} seconds of ${shown(scene.end, 1)}${told ? `. ${told}` : ""}`);
    const recent = slams.filter((slam) => time >= slam.time && time - slam.time < SLAM_SHOWN);
    const worst = recent.reduce((a, b) => (a && a.pressure >= b.pressure ? a : b), null);
    part.slam.textContent = worst
      ? `Slam at x ${shown(worst.x, 1)} m, y ${shown(worst.y, 1)} m: ${shown(worst.velocity, 1)} m/s, ${shown(worst.pressure / 1000, 0)} kPa`
      : "";
    strip.setValues(time);
  }

  function tick(now) {
    frame = requestAnimationFrame(tick);
    if (!visible || !scene) return;
    if (playing) {
      const interval = lastFrame ? now - lastFrame : 0;
      lastFrame = now;
      time += rate * Math.min(interval, 250) / 1000;
      if (time >= scene.end) time = scene.facts.start;
      if (interval) stage?.adapt(interval);
      reportTime(performance.now());
    } else if (!stale) {
      if (stage && quietSince && now - quietSince > SETTLE) {
        quietSince = 0;
        stage.settle(time);
      }
      return;
    }
    quietSince = now;
    stale = false;
    const begun = performance.now();
    stage?.draw(time);
    strip.setTime(time);
    words(now);
    tell();
    const ms = performance.now() - begun;
    probe.frames += 1;
    probe.ms = probe.frames === 1 ? ms : 0.9 * probe.ms + 0.1 * ms;
    Object.assign(probe, { time, playing, ratio: stage?.ratio ?? 0 });
  }

  part.play.addEventListener("click", () => setPlaying(!playing));
  part.next.addEventListener("click", () => {
    const ahead = slams.find((slam) => slam.time > time + 1.2) ?? slams[0];
    seek(ahead.time - 1);
  });
  part.range.addEventListener("input", () => seek(Number(part.range.value)));
  part.speed.addEventListener("change", () => (rate = Number(part.speed.value)));
  part.field.addEventListener("change", () => {
    setField(part.field.value);
    source.set("field", part.field.value);
  });
  part.cameras.addEventListener("click", (event) => setCamera(event.target.dataset.camera));
  part.picture.addEventListener("click", () => stage && savePicture({ stage, scene, time, root, part }));
  part.reload.addEventListener("click", () => window.location.reload());
  part.picture.hidden = !stage;

  root.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") return;
    if (event.key === " " && event.target.tagName === "BUTTON") return;
    const step = event.shiftKey ? 1 : scene.facts.step;
    const actions = {
      " ": () => setPlaying(!playing),
      ArrowLeft: () => seek(time - step),
      ArrowRight: () => seek(time + step),
      Home: () => seek(scene.facts.start),
      End: () => seek(scene.end),
    };
    if (!actions[event.key]) return;
    actions[event.key]();
    event.preventDefault();
    event.stopPropagation();
  });
  part.canvas.addEventListener("pointermove", (event) => event.buttons && (stale = true));
  part.canvas.addEventListener("wheel", () => (stale = true), { passive: true });
  part.canvas.addEventListener("pointerdown", () => part.canvas.focus({ preventScroll: true }));

  // one message of the kernel may change many blocks: read them together
  let pending = false;
  source.on("revision", () => {
    if (pending) return;
    pending = true;
    queueMicrotask(() => {
      pending = false;
      load();
    });
  });
  source.on("time", () => {
    const wanted = source.get("time");
    if (scene && Math.abs(wanted - time) > 1e-6 && !justReported(wanted)) seek(wanted, false);
  });
  source.on("playing", () => source.get("playing") !== playing && setPlaying(source.get("playing"), false));
  source.on("field", () => scene && setField(source.get("field")));
  source.on("camera", () => {
    if (stage && source.get("camera") !== (stage.preset ?? "")) setCamera(source.get("camera"));
  });
  let alive = true;
  source.on("kernel", () => {
    alive = !alive;
    part.banner.hidden = alive;
    resize();
  });

  function justReported(wanted) {
    return playing && Math.abs(time - wanted) <= (2 * SYNC_INTERVAL * rate) / 1000;
  }

  load();
  setCamera(source.get("camera") || "quarter");
  setPlaying(playing, false);
  const sizes = new ResizeObserver(resize);
  sizes.observe(root);
  const sight = new IntersectionObserver(([entry]) => {
    visible = entry.isIntersecting;
    lastFrame = 0;
    stale = true;
  });
  sight.observe(root);
  source.set("status", stage ? (kind === "software" ? "ready-software" : "ready") : "nowebgl");
  frame = requestAnimationFrame(tick);

  return () => {
    cancelAnimationFrame(frame);
    clearTimeout(late);
    window.removeEventListener(LINKED, heard);
    sizes.disconnect();
    sight.disconnect();
    stage?.dispose();
    root.remove();
    if (window.__sv === probe) delete window.__sv;
  };
}
