// The page elements around the picture: named, reachable by keyboard, readable by a screen reader.
import { CAMERAS } from "./stage.js";
import { digitsOf, shown } from "./data.js";

export const SPEEDS = [0.25, 0.5, 1, 2, 4];

let numberOfViews = 0;

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "text") made.textContent = value;
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

export function buildControls(root) {
  const id = `sv-${++numberOfViews}`;
  const part = {};
  part.title = element("h2", { class: "sv-title", id: `${id}-title` });
  part.field = element("select", { id: `${id}-field` });
  part.fieldLabel = element("label", { for: `${id}-field`, text: "Deck shows" });
  part.cameras = element("div", { class: "sv-cameras", role: "group", "aria-label": "Camera" });
  for (const [name, { name: words }] of Object.entries(CAMERAS)) {
    part.cameras.append(element("button", { type: "button", "data-camera": name, "aria-pressed": "false", text: words }));
  }
  const header = element(
    "div", { class: "sv-header" },
    part.title, element("span", { class: "sv-choice" }, part.fieldLabel, part.field), part.cameras,
  );

  part.canvas = element("canvas", {
    class: "sv-canvas", tabindex: "0", role: "img",
    "aria-label": "Ship in waves with its wet deck coloured; drag to turn the view",
  });
  part.readout = element("div", { class: "sv-readout" });
  part.instant = element("div", { class: "sv-instant" });
  part.pressure = element("div", {});
  part.slam = element("div", { class: "sv-slam" });
  part.readout.append(part.instant, part.pressure, part.slam);
  part.bar = element("div", { class: "sv-bar" });
  part.plan = element("div", { class: "sv-plan" }, element("div", { class: "sv-plan-label", text: "Wet deck from above, bow to the right" }));
  part.message = element("div", { class: "sv-message", role: "status" });
  part.stage = element("div", { class: "sv-stage" }, part.canvas, part.readout, part.bar, part.plan, part.message);
  part.strip = element("div", { class: "sv-strip" });
  const body = element("div", { class: "sv-body" }, part.stage, part.strip);

  part.play = element("button", { type: "button", class: "sv-play" });
  part.next = element("button", { type: "button", class: "sv-next", text: "Next slam" });
  part.range = element("input", { type: "range", class: "sv-range", "aria-label": "Time", step: "any" });
  part.ticks = element("canvas", { class: "sv-ticks", "aria-hidden": "true" });
  part.clock = element("span", { class: "sv-clock" });
  part.speed = element("select", { id: `${id}-speed` });
  for (const speed of SPEEDS) {
    const option = element("option", { value: String(speed), text: `${speed}\u00d7` });
    option.selected = speed === 1;
    part.speed.append(option);
  }
  part.picture = element("button", { type: "button", class: "sv-picture", text: "Save picture" });
  const footer = element(
    "div", { class: "sv-footer" },
    part.play, part.next, element("div", { class: "sv-track" }, part.ticks, part.range), part.clock,
    element("span", { class: "sv-choice" }, element("label", { for: `${id}-speed`, text: "Speed" }), part.speed), part.picture,
  );

  part.reload = element("button", { type: "button", text: "Reload the page" });
  part.banner = element("div", { class: "sv-banner", role: "alert", hidden: "" }, "The calculation engine has stopped. ", part.reload);

  root.setAttribute("role", "group");
  root.setAttribute("tabindex", "-1");
  root.setAttribute("data-lm-suppress-shortcuts", "true");
  root.setAttribute("aria-labelledby", part.title.id);
  root.append(part.banner, header, body, footer);
  return part;
}

// Colour bar of a field: twelve bands, round numbers between them, a unit.
export function fillBar(bar, field) {
  bar.replaceChildren();
  if (!field) return;
  bar.append(element("div", { class: "sv-bar-label", text: barTitle(field) }));
  const bands = element("div", { class: "sv-bands", "aria-hidden": "true" });
  for (const colour of field.colours) {
    const band = element("i");
    band.style.background = colour;
    bands.append(band);
  }
  const scale = element("div", { class: "sv-scale" });
  for (const { place, text } of barNumbers(field)) {
    const number = element("span", { text });
    number.style.left = `${100 * place}%`;
    scale.append(number);
  }
  bar.append(bands, scale);
}

export function barTitle(field) {
  return field.unit && field.unit !== "1" ? `${field.label} [${field.unit}]` : field.label;
}

export function barNumbers(field) {
  const [low, high] = [field.low * field.factor, field.high * field.factor];
  const every = (high - low) / 4;
  return [0, 1, 2, 3, 4].map((k) => ({
    place: k / 4,
    text: shown(low + k * every, digitsOf(Number(every.toPrecision(6)))),
  }));
}

// Slams as ticks above the range, taller for higher pressure.
export function paintTicks(canvas, slams, start, end) {
  const ratio = Math.max(1, window.devicePixelRatio || 1);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const c = canvas.getContext("2d");
  c.scale(ratio, ratio);
  const largest = Math.max(...slams.map(({ pressure }) => pressure), 1e-9);
  const thumb = 8; // half the width of the range's thumb [px]
  c.fillStyle = "#d6006e";
  for (const { time, pressure } of slams) {
    const x = thumb + ((time - start) / (end - start)) * (width - 2 * thumb);
    const tall = height * (0.4 + 0.6 * Math.sqrt(pressure / largest));
    c.fillRect(x - 1, height - tall, 2, tall);
  }
}
