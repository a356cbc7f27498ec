// The blocks of a packed scene as typed arrays, and values between two samples.

function typed(block, Type) {
  if (!block || !block.byteLength) return new Type(0);
  const { buffer, byteOffset } = ArrayBuffer.isView(block) ? block : { buffer: block, byteOffset: 0 };
  const length = block.byteLength / Type.BYTES_PER_ELEMENT;
  if (byteOffset % Type.BYTES_PER_ELEMENT === 0) return new Type(buffer, byteOffset, length);
  return new Type(buffer.slice(byteOffset, byteOffset + block.byteLength));
}

export const GEOMETRY = ["hull_vertices", "hull_faces", "deck"];
export const WATER = ["water", "water_grid"];

export function readScene(get) {
  const facts = get("scene");
  const film = facts.water.kind === "film";
  const [nx, ny] = facts.deck;
  const deck = typed(get("deck"), Float32Array);
  const grid = typed(get("water_grid"), Float32Array);
  const fields = {};
  for (const field of facts.fields) fields[field.name] = typed(get(field.name), Uint8Array);
  return {
    facts,
    end: facts.start + facts.step * (facts.count - 1),
    pose: typed(get("pose"), Float32Array),
    water: typed(get("water"), film ? Int16Array : Float32Array),
    seaX: film ? grid.subarray(0, facts.water.size[0]) : grid,
    seaY: film ? grid.subarray(facts.water.size[0]) : grid,
    hullVertices: typed(get("hull_vertices"), Float32Array),
    hullFaces: typed(get("hull_faces"), Uint32Array),
    deck: { nx, ny, x: deck.subarray(0, nx), y: deck.subarray(nx, nx + ny), height: deck.subarray(nx + ny) },
    fields,
    slams: typed(get("slams"), Float32Array),
    curves: typed(get("curves"), Float32Array),
  };
}

// Sample before the time and the fraction of a step that has passed since.
export function sampleAt(facts, time) {
  const exact = Math.min(Math.max((time - facts.start) / facts.step, 0), facts.count - 1);
  const index = Math.min(Math.floor(exact), facts.count - 2);
  return { index, fraction: exact - index };
}

// Cubic (Catmull-Rom) between samples: motions stay smooth at coarse sampling.
export function smoothSample(series, stride, column, count, { index, fraction: f }) {
  const at = (i) => series[Math.min(Math.max(i, 0), count - 1) * stride + column];
  const [a, b, c, d] = [at(index - 1), at(index), at(index + 1), at(index + 2)];
  return b + 0.5 * f * (c - a + f * (2 * a - 5 * b + 4 * c - d + f * (3 * (b - c) + d - a)));
}

export function curveAt(scene, key, time) {
  const row = scene.facts.curves.findIndex((curve) => curve.key === key);
  if (row < 0) return null;
  const { index, fraction } = sampleAt(scene.facts, time);
  const first = row * scene.facts.count + index;
  return scene.curves[first] * (1 - fraction) + scene.curves[first + 1] * fraction;
}

export function largestOf(scene, key) {
  const row = scene.facts.curves.findIndex((curve) => curve.key === key);
  if (row < 0) return null;
  let largest = -Infinity;
  for (let i = 0; i < scene.facts.count; i++) largest = Math.max(largest, scene.curves[row * scene.facts.count + i]);
  return largest;
}

export function slamList(scene) {
  const list = [];
  for (let i = 0; i < scene.slams.length; i += 5) {
    const [time, x, y, velocity, pressure] = scene.slams.subarray(i, i + 5);
    list.push({ time, x, y, velocity, pressure });
  }
  return mainSlams(list, 0.2 * Math.abs(scene.deck.x.at(-1) - scene.deck.x[0]));
}

// One slam per place and moment, the hardest: neighbouring points that enter together count as one on the screen.
function mainSlams(slams, reach) {
  const kept = [];
  for (const slam of [...slams].sort((a, b) => b.pressure - a.pressure)) {
    const near = ({ time, x, y }) => Math.abs(time - slam.time) < 1.0 && Math.hypot(x - slam.x, y - slam.y) < reach;
    if (!kept.some(near)) kept.push(slam);
  }
  return kept.sort((a, b) => a.time - b.time);
}

// Height of the wet deck at a point, bilinear, held at the edges.
export function deckHeightAt(deck, x, y) {
  const [i, u] = bracket(deck.x, x);
  const [j, v] = bracket(deck.y, y);
  const at = (k, l) => deck.height[Math.min(k, deck.nx - 1) * deck.ny + Math.min(l, deck.ny - 1)];
  return (
    (1 - u) * ((1 - v) * at(i, j) + v * at(i, j + 1)) + u * ((1 - v) * at(i + 1, j) + v * at(i + 1, j + 1))
  );
}

function bracket(values, value) {
  let i = 0;
  while (i < values.length - 2 && values[i + 1] < value) i++;
  if (values.length < 2) return [0, 0];
  return [i, Math.min(Math.max((value - values[i]) / (values[i + 1] - values[i]), 0), 1)];
}

export function shown(value, digits) {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? (0).toFixed(digits) : text).replace("-", "\u2212");
}

// Digits that tell steps of this size apart.
export function digitsOf(step) {
  return Math.max(0, Math.min(4, -Math.floor(Math.log10(Math.abs(step) || 1) + 1e-9) + (isRoundStep(step) ? 0 : 1)));
}

function isRoundStep(step) {
  const mantissa = step / 10 ** Math.floor(Math.log10(Math.abs(step) || 1) + 1e-9);
  return Math.abs(mantissa - Math.round(mantissa)) < 1e-6;
}
