// The ship: hulls, wet deck with contour bands, and marks where it has just slammed.
import * as THREE from "three";
import { mergeVertices, toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { deckHeightAt, sampleAt, slamList, smoothSample } from "./data.js";

const HULL_VERTEX = /* glsl */ `
  varying vec3 vNormal;
  varying vec3 vBody;
  varying vec3 vWorld;
  void main() {
    vBody = position;
    vNormal = mat3(modelMatrix) * normal;
    vec4 world = modelMatrix * vec4(position, 1.0);
    vWorld = world.xyz;
    gl_Position = projectionMatrix * viewMatrix * world;
  }`;

const HULL_FRAGMENT = /* glsl */ `
  uniform vec3 sun;
  uniform float line;
  varying vec3 vNormal;
  varying vec3 vBody;
  varying vec3 vWorld;
  void main() {
    vec3 n = normalize(vNormal);
    vec3 v = normalize(cameraPosition - vWorld);
    if (dot(n, v) < 0.0) n = -n;
    float light = 0.5 + 0.5 * dot(n, sun);
    float sky = 0.5 + 0.5 * n.z;
    vec3 paint = vec3(0.93, 0.95, 0.965);
    float w = max(fwidth(vBody.z), 1e-4);
    paint = mix(vec3(0.55, 0.235, 0.20), paint, smoothstep(-w, w, vBody.z));
    paint = mix(vec3(0.13, 0.17, 0.21), paint, smoothstep(line - w, line + w, abs(vBody.z - line)));
    float rim = pow(1.0 - abs(dot(n, v)), 4.0);
    vec3 colour = paint * (0.54 + 0.28 * light + 0.23 * sky) * vec3(0.985, 0.995, 1.0) + 0.05 * rim;
    gl_FragColor = vec4(colour, 1.0);
  }`;

const DECK_VERTEX = /* glsl */ `
  varying vec3 vNormal;
  varying vec2 vUv;
  void main() {
    vUv = uv;
    vNormal = mat3(modelMatrix) * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const DECK_FRAGMENT = /* glsl */ `
  uniform sampler2D field;   // r: value 0 to 1 times weight, g: weight, 0 where there is no value
  uniform vec3 bands[12];
  uniform float zero;        // where the value is nought, or -1
  uniform vec3 sun;
  varying vec3 vNormal;
  varying vec2 vUv;
  void main() {
    vec2 texel = texture2D(field, vUv).rg;
    float value = clamp(texel.r / max(texel.g, 1e-3), 0.0, 1.0);
    float position = value * 12.0;
    vec3 colour = bands[int(min(position, 11.0))];
    float w = max(fwidth(position), 1e-4);
    float near = abs(position - floor(position + 0.5)) / w;
    float inner = step(0.5, position) * step(position, 11.5);
    colour = mix(colour, colour * 0.62, inner * (1.0 - smoothstep(0.35, 1.1, near)) * clamp(1.5 - w, 0.0, 1.0));
    if (zero >= 0.0) {
      float gap = abs(value - zero) / max(fwidth(value), 1e-5);
      colour = mix(colour, vec3(0.05), 0.85 * (1.0 - smoothstep(0.9, 1.8, gap)));
    }
    if (texel.g < 0.5) colour = vec3(0.72);
    float light = 0.93 + 0.07 * abs(dot(normalize(vNormal), sun));
    gl_FragColor = vec4(colour * light, 1.0);
  }`;

const MARK_VERTEX = /* glsl */ `
  attribute float age;
  varying float vAge;
  varying vec2 vPlace;
  void main() {
    vAge = age;
    vPlace = position.xy;
    gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  }`;

const MARK_FRAGMENT = /* glsl */ `
  varying float vAge;
  varying vec2 vPlace;
  void main() {
    float r = length(vPlace);
    float ring = 0.45 + 0.45 * vAge;
    float w = max(fwidth(r), 0.02);
    float inside = 1.0 - smoothstep(0.10 - w, 0.10 + w, abs(r - ring));
    float halo = 1.0 - smoothstep(0.17 - w, 0.17 + w, abs(r - ring));
    float strength = 1.0 - smoothstep(0.6, 1.0, vAge);
    if (halo * strength < 0.02) discard;
    gl_FragColor = vec4(mix(vec3(1.0), vec3(0.88, 0.0, 0.42), inside), halo * strength);
  }`;

const MARKS = 128;
const MARK_DURATION = 1.0;

export class Ship {
  constructor(scene, sun) {
    this.scene = scene;
    this.sun = sun;
    this.group = new THREE.Group();
    this.group.rotation.order = "ZYX";
    const hull = this.#hull();
    const deck = this.#deck();
    this.group.add(hull, deck, this.#rim(), this.#marks());
    this.box = new THREE.Box3().setFromObject(hull);
    this.deckBox = new THREE.Box3().setFromObject(deck);
    this.box.union(this.deckBox);
    this.box.getSize((this.size = new THREE.Vector3()));
    this.outline = this.#outline(hull.geometry, deck.geometry);
  }

  #hull() {
    let geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(this.scene.hullVertices.slice(), 3));
    geometry.setIndex(new THREE.BufferAttribute(this.scene.hullFaces.slice(), 1));
    geometry.computeBoundingBox();
    const size = geometry.boundingBox.getSize(new THREE.Vector3());
    geometry = mergeVertices(geometry, 1e-5 * size.length());
    geometry.setIndex([...geometry.index.array, ...lids(geometry)]);
    const creased = toCreasedNormals(geometry, 0.6);
    geometry.dispose();
    const material = new THREE.ShaderMaterial({
      vertexShader: HULL_VERTEX,
      fragmentShader: HULL_FRAGMENT,
      uniforms: { sun: { value: this.sun }, line: { value: 0.0025 * size.x } },
      side: THREE.DoubleSide,
    });
    return new THREE.Mesh(creased, material);
  }

  // Points enough to frame the ship by.
  #outline(...geometries) {
    const points = [];
    for (const { attributes: { position } } of geometries) {
      const step = Math.max(1, Math.floor(position.count / 30000));
      for (let i = 0; i < position.count; i += step) points.push(new THREE.Vector3().fromBufferAttribute(position, i));
    }
    return points;
  }

  #deck() {
    const { nx, ny, x, y, height } = this.scene.deck;
    const [mx, my] = [nx + 2, ny + 2]; // points are centres of cells: the deck reaches half a cell further
    const xs = reached(x);
    const ys = reached(y);
    const position = new Float32Array(3 * mx * my);
    const uv = new Float32Array(2 * mx * my);
    const index = [];
    const texel = (i, n) => Math.min(Math.max((i - 0.5) / n, 0), 1);
    for (let i = 0, k = 0; i < mx; i++) {
      for (let j = 0; j < my; j++, k++) {
        const near = Math.min(Math.max(i - 1, 0), nx - 1) * ny + Math.min(Math.max(j - 1, 0), ny - 1);
        position.set([xs[i], ys[j], height[near]], 3 * k);
        uv.set([texel(j, ny), texel(i, nx)], 2 * k);
        if (i + 1 < mx && j + 1 < my) index.push(k, k + my, k + my + 1, k, k + my + 1, k + 1);
      }
    }
    this.deckPosition = position;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("uv", new THREE.BufferAttribute(uv, 2));
    geometry.setIndex(index);
    geometry.computeVertexNormals();
    this.fieldTexture = new THREE.DataTexture(
      new Uint16Array(2 * nx * ny), ny, nx, THREE.RGFormat, THREE.HalfFloatType,
    );
    this.fieldTexture.minFilter = this.fieldTexture.magFilter = THREE.LinearFilter;
    this.deckUniforms = {
      field: { value: this.fieldTexture },
      bands: { value: Array.from({ length: 12 }, () => new THREE.Vector3(0.75, 0.78, 0.8)) },
      zero: { value: -1 },
      sun: { value: this.sun },
    };
    const material = new THREE.ShaderMaterial({
      vertexShader: DECK_VERTEX,
      fragmentShader: DECK_FRAGMENT,
      uniforms: this.deckUniforms,
      side: THREE.DoubleSide,
    });
    return new THREE.Mesh(geometry, material);
  }

  #rim() {
    const [nx, ny] = [this.scene.deck.nx + 2, this.scene.deck.ny + 2];
    const points = [];
    const add = (i, j) => points.push(new THREE.Vector3().fromArray(this.deckPosition, 3 * (i * ny + j)));
    for (let i = 0; i < nx; i++) add(i, 0);
    for (let j = 1; j < ny; j++) add(nx - 1, j);
    for (let i = nx - 2; i >= 0; i--) add(i, ny - 1);
    for (let j = ny - 2; j > 0; j--) add(0, j);
    const geometry = new THREE.BufferGeometry().setFromPoints(points);
    return new THREE.LineLoop(geometry, new THREE.LineBasicMaterial({ color: 0x26323b }));
  }

  #marks() {
    const { deck } = this.scene;
    this.slams = slamList(this.scene);
    const radius = 0.05 * Math.max(deck.x.at(-1) - deck.x[0], 1e-3);
    const material = new THREE.ShaderMaterial({
      vertexShader: MARK_VERTEX,
      fragmentShader: MARK_FRAGMENT,
      transparent: true,
      depthTest: false,
      depthWrite: false,
      side: THREE.DoubleSide,
      forceSinglePass: true,
    });
    const geometry = new THREE.PlaneGeometry(2.2, 2.2);
    this.ages = new THREE.InstancedBufferAttribute(new Float32Array(MARKS), 1);
    geometry.setAttribute("age", this.ages);
    this.marks = new THREE.InstancedMesh(geometry, material, MARKS);
    this.marks.frustumCulled = false;
    this.marks.renderOrder = 3;
    this.marks.count = 0;
    this.markMatrices = this.slams.map(({ x, y }) =>
      new THREE.Matrix4().makeScale(radius, radius, 1).setPosition(x, y, deckHeightAt(deck, x, y)),
    );
    return this.marks;
  }

  setField(name) {
    this.field = this.scene.facts.fields.find((field) => field.name === name) ?? null;
    this.values = this.field ? this.scene.fields[name] : null;
    const colours = this.field?.colours ?? Array(12).fill("#c3ccd3");
    colours.forEach((hex, i) => {
      const number = parseInt(hex.slice(1), 16);
      this.deckUniforms.bands.value[i].set((number >> 16) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255);
    });
    const { low = 0, high = 1 } = this.field ?? {};
    this.deckUniforms.zero.value = low < 0 && high > 0 ? -low / (high - low) : -1;
  }

  setTime(time) {
    const { facts, pose } = this.scene;
    const sample = sampleAt(facts, time);
    const motion = [0, 1, 2, 3, 4, 5].map((mode) => smoothSample(pose, 6, mode, facts.count, sample));
    this.group.position.set(motion[0], motion[1], motion[2]);
    this.group.rotation.set(motion[3], motion[4], motion[5], "ZYX");
    this.#colour(sample);
    this.#mark(time);
  }

  #colour({ index, fraction }) {
    const { data } = this.fieldTexture.image;
    const count = data.length / 2;
    const half = THREE.DataUtils.toHalfFloat;
    const one = half(1);
    for (let k = 0; k < count; k++) {
      const a = this.values ? this.values[index * count + k] : 255;
      const b = this.values ? this.values[(index + 1) * count + k] : 255;
      const value = a === 255 ? b : b === 255 ? a : a + fraction * (b - a);
      data[2 * k] = value === 255 ? 0 : half(value / 254);
      data[2 * k + 1] = value === 255 && this.field ? 0 : one;
    }
    this.fieldTexture.needsUpdate = true;
  }

  #mark(time) {
    let count = 0;
    for (let i = 0; i < this.slams.length && count < MARKS; i++) {
      const age = (time - this.slams[i].time) / MARK_DURATION;
      if (age < 0 || age > 1) continue;
      this.marks.setMatrixAt(count, this.markMatrices[i]);
      this.ages.array[count] = age;
      count++;
    }
    this.marks.count = count;
    if (!count) return;
    this.marks.instanceMatrix.needsUpdate = true;
    this.ages.needsUpdate = true;
  }

  dispose() {
    this.group.traverse((part) => {
      part.geometry?.dispose();
      part.material?.dispose();
    });
    this.marks.dispose();
    this.fieldTexture.dispose();
  }
}

// Coordinates with the outer edges of the first and the last cell.
function reached(values) {
  const [a, b] = [values[0], values.at(-1)];
  return [a - (values[1] - a) / 2, ...values, b + (b - values.at(-2)) / 2];
}

// Triangles that close the open upper edges of a surface: the decks of the hulls.
function lids(geometry) {
  const index = geometry.index.array;
  const position = geometry.attributes.position;
  const next = new Map();
  const edges = new Map();
  for (let k = 0; k < index.length; k += 3) {
    for (let e = 0; e < 3; e++) {
      const [a, b] = [index[k + e], index[k + ((e + 1) % 3)]];
      if (a === b) continue;
      const key = a < b ? `${a},${b}` : `${b},${a}`;
      edges.set(key, (edges.get(key) ?? 0) + 1);
    }
  }
  const join = (a, b) => (next.get(a) ?? next.set(a, []).get(a)).push(b);
  for (const [key, count] of edges) {
    if (count !== 1) continue;
    const [a, b] = key.split(",").map(Number);
    join(a, b);
    join(b, a);
  }
  const seen = new Set();
  const triangles = [];
  for (const start of next.keys()) {
    if (seen.has(start)) continue;
    const loop = [start];
    seen.add(start);
    for (let at = start; ; ) {
      at = next.get(at).find((vertex) => !seen.has(vertex));
      if (at === undefined) break;
      seen.add(at);
      loop.push(at);
    }
    if (loop.length < 3 || !loop.some((vertex) => position.getZ(vertex) > 0)) continue;
    const outline = loop.map((vertex) => new THREE.Vector2(position.getX(vertex), position.getY(vertex)));
    for (const [a, b, c] of THREE.ShapeUtils.triangulateShape(outline, [])) {
      triangles.push(loop[a], loop[b], loop[c]);
    }
  }
  return triangles;
}
