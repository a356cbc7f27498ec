// Curves of heave, pitch and the worst point against time, with the slams and a cursor.
import { curveAt, digitsOf, shown, slamList } from "./data.js";

const PAGE = 60; // [s] shown at once
const LEFT = 44;
const RIGHT = 14;
const HEAD = 22;
const FOOT = 34;
const INK = "#22303a";
const COLOURS = ["#0b6fa4", "#8a4b08", "#3c6e1f"];

export class Strip {
  constructor(host, onSeek) {
    this.host = host;
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.cursor = document.createElement("div");
    this.cursor.className = "sv-cursor";
    this.values = document.createElement("div");
    this.values.className = "sv-values";
    host.append(this.canvas, this.cursor, this.values);
    host.addEventListener("pointerdown", (event) => {
      host.setPointerCapture(event.pointerId);
      this.dragging = true;
      onSeek(this.#timeAt(event));
    });
    host.addEventListener("pointermove", (event) => this.dragging && onSeek(this.#timeAt(event)));
    host.addEventListener("pointerup", () => (this.dragging = false));
    host.addEventListener("pointercancel", () => (this.dragging = false));
  }

  setScene(scene) {
    this.scene = scene;
    this.slams = slamList(scene);
    this.rows = scene.facts.curves.map((curve, row) => ({ ...curve, row })).filter(({ key }) => key !== "largest_pressure");
    this.values.replaceChildren(...this.rows.map(() => document.createElement("span")));
    const names = this.rows.map(({ label }) => label.toLowerCase()).join("; ");
    this.canvas.setAttribute("aria-label", `Curves against time: ${names}`);
    this.page = null;
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
    this.ratio = Math.max(1, window.devicePixelRatio || 1);
    this.canvas.width = Math.round(width * this.ratio);
    this.canvas.height = Math.round(height * this.ratio);
    this.page = null;
  }

  #window(time) {
    const { start } = this.scene.facts;
    const { end } = this.scene;
    if (end - start <= PAGE * 1.2) return [start, end];
    const first = start + Math.floor((time - start) / PAGE) * PAGE;
    return first + PAGE > end ? [end - PAGE, end] : [first, first + PAGE];
  }

  #x(time) {
    const [a, b] = this.shown;
    return LEFT + ((time - a) / (b - a)) * (this.width - LEFT - RIGHT);
  }

  #timeAt(event) {
    const [a, b] = this.shown;
    const x = event.clientX - this.host.getBoundingClientRect().left;
    return Math.min(Math.max(a + ((x - LEFT) / (this.width - LEFT - RIGHT)) * (b - a), a), b);
  }

  #rowBox(i) {
    const pitch = (this.height - FOOT) / this.rows.length;
    const head = this.rows[i].place ? 2 * HEAD - 4 : HEAD;
    return { head: i * pitch, top: i * pitch + head, bottom: (i + 1) * pitch - 6 };
  }

  setTime(time) {
    if (!this.width || this.width < 80) return;
    const span = this.#window(time);
    if (this.page !== span[0]) {
      this.shown = span;
      this.page = span[0];
      this.#paint();
    }
    this.cursor.style.transform = `translateX(${this.#x(time).toFixed(1)}px)`;
  }

  setValues(time) {
    this.rows.forEach((row, i) => {
      const value = curveAt(this.scene, row.key, time);
      this.values.children[i].textContent = `${shown(value, 2)} ${row.unit}`;
      this.values.children[i].style.top = `${this.#rowBox(i).head + 2}px`;
    });
  }

  #paint() {
    const c = this.canvas.getContext("2d");
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.width, this.height);
    c.textBaseline = "middle";
    c.font = "13px system-ui, sans-serif";
    this.rows.forEach((row, i) => this.#paintRow(c, row, i));
    this.#paintTime(c);
  }

  #paintRow(c, row, i) {
    const { head, top, bottom } = this.#rowBox(i);
    const right = this.width - RIGHT;
    const { facts, curves } = this.scene;
    const series = curves.subarray(row.row * facts.count, (row.row + 1) * facts.count);
    let [low, high] = [Math.min(0, row.line ?? 0), Math.max(0, row.line ?? 0)];
    for (const value of series) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
    const pad = 0.08 * (high - low || 1);
    [low, high] = [low - pad, high + pad];
    const y = (value) => bottom - ((value - low) / (high - low)) * (bottom - top);
    c.fillStyle = "#f6f9fb";
    c.fillRect(LEFT, top, right - LEFT, bottom - top);
    c.fillStyle = INK;
    c.textAlign = "left";
    c.fillText(fitted(c, `${row.label} [${row.unit}]`, this.width - 8 - 76), 6, head + 12);
    if (row.place) {
      const [x, y] = row.place;
      c.fillText(fitted(c, `worst point: x ${shown(x, 1)} m, y ${shown(y, 1)} m`, this.width - 12), 6, head + 29);
    }
    const step = roundStep((high - low) / Math.max(1, Math.floor((bottom - top) / 20)));
    c.textAlign = "right";
    for (let n = Math.ceil(low / step); n * step <= high; n++) {
      const level = Math.round(y(n * step)) + 0.5;
      line(c, LEFT, level, right, level, n === 0 ? "#9fb0bc" : "#e0e8ee");
      if (level > top + 4 && level < bottom - 3) c.fillText(shown(n * step, digitsOf(step)), LEFT - 6, level);
    }
    for (const slam of this.slams) {
      const x = this.#x(slam.time);
      if (x >= LEFT && x <= right && row.line !== undefined) line(c, x, top, x, bottom, "rgba(214,0,110,0.35)");
    }
    if (row.line !== undefined) {
      c.setLineDash([5, 4]);
      line(c, LEFT, y(row.line), right, y(row.line), "#b3003f", 1.5);
      c.setLineDash([]);
      c.fillStyle = "#b3003f";
      c.textAlign = "left";
      c.fillText("deck", LEFT + 4, y(row.line) + (y(row.line) - top > 16 ? -9 : 10));
      c.fillStyle = INK;
    }
    c.save();
    c.beginPath();
    c.rect(LEFT, top, right - LEFT, bottom - top);
    c.clip();
    c.beginPath();
    const [a, b] = this.shown;
    const first = Math.max(0, Math.floor((a - facts.start) / facts.step) - 1);
    const last = Math.min(facts.count - 1, Math.ceil((b - facts.start) / facts.step) + 1);
    for (let k = first; k <= last; k++) c.lineTo(this.#x(facts.start + k * facts.step), y(series[k]));
    c.strokeStyle = COLOURS[i % COLOURS.length];
    c.lineWidth = 1.6;
    c.lineJoin = "round";
    c.stroke();
    c.restore();
  }

  #paintTime(c) {
    const [a, b] = this.shown;
    const base = this.height - FOOT;
    const step = roundStep((b - a) / Math.max(2, Math.floor((this.width - LEFT) / 60)));
    c.textAlign = "center";
    c.fillStyle = INK;
    for (let n = Math.ceil(a / step - 1e-9); n * step <= b + 1e-9; n++) {
      line(c, this.#x(n * step), base - 6, this.#x(n * step), base - 2, "#7d8f9b");
      c.fillText(shown(n * step, digitsOf(step)), Math.min(this.#x(n * step), this.width - 2 - c.measureText(shown(n * step, digitsOf(step))).width / 2), base + 6);
    }
    c.fillText("Time [s]", (LEFT + this.width - RIGHT) / 2, base + 23);
    // the cursor is interrupted where words stand
    const stops = this.rows.flatMap((_, i) => {
      const { head, top, bottom } = this.#rowBox(i);
      return [`transparent ${head}px ${top}px`, `currentColor ${top}px ${bottom}px`, `transparent ${bottom}px`];
    });
    this.cursor.style.background = `linear-gradient(${stops.join(", ")})`;
  }
}

export function roundStep(least) {
  const decade = 10 ** Math.floor(Math.log10(least || 1));
  return decade * [1, 2, 2.5, 5, 10].find((n) => n * decade >= least * (1 - 1e-9));
}

function line(c, x0, y0, x1, y1, colour, width = 1) {
  c.strokeStyle = colour;
  c.lineWidth = width;
  c.beginPath();
  c.moveTo(x0, y0);
  c.lineTo(x1, y1);
  c.stroke();
}

function fitted(c, text, width) {
  if (c.measureText(text).width <= width) return text;
  let short = text;
  while (short.length > 4 && c.measureText(`${short}\u2026`).width > width) short = short.slice(0, -1);
  return `${short}\u2026`;
}
