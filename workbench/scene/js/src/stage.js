// The drawing surface: renderer, cameras, plan view in a corner, and a pixel ratio that keeps the film fluent.
import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Sea } from "./sea.js";
import { Ship } from "./ship.js";
import { sampleAt } from "./data.js";

export const CAMERAS = {
  quarter: { name: "Quarter", from: [-0.62, -0.68, 0.58] },
  bow: { name: "Bow", from: [0.80, 0.52, 0.46] },
  under: { name: "Under the deck", from: [0.17, -0.60, -0.78] },
  side: { name: "Side", from: [-0.06, -1, 0.13] },
};

const BACKGROUND = 0xeaf1f6;
const SUN = new THREE.Vector3(-0.35, -0.62, 0.70).normalize();
const SLOWEST = 1000 / 20; // [ms] between frames
const FASTEST = 1000 / 40;

// 'gpu', 'software' or null without WebGL.
export function graphics() {
  try {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) return null;
    const info = gl.getExtension("WEBGL_debug_renderer_info");
    const renderer = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer) ? "software" : "gpu";
  } catch {
    return null;
  }
}

export class Stage {
  constructor(canvas, kind, onOrbit) {
    this.canvas = canvas;
    this.software = kind === "software";
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !this.software, powerPreference: "high-performance" });
    this.renderer.setClearColor(BACKGROUND, 1);
    this.renderer.autoClear = false;
    this.ratios = this.software ? [0.35, 0.85] : [0.6, Math.min(window.devicePixelRatio || 1, 2)];
    this.ratio = this.ratios[1];
    this.ceiling = this.ratios[1];
    this.intervals = [];
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(28, 1.6, 0.5, 5000);
    this.camera.up.set(0, 0, 1);
    this.camera.layers.enable(1);
    this.plan = new THREE.OrthographicCamera(-1, 1, 1, -1, 1, 2000);
    this.plan.up.set(0, 1, 0);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.enableZoom = false; // the wheel scrolls the page until the picture has been touched
    this.controls.addEventListener("start", () => {
      this.controls.enableZoom = true;
      this.preset = null;
      onOrbit();
    });
    this.onBlur = () => (this.controls.enableZoom = false);
    canvas.addEventListener("blur", this.onBlur);
    this.size = [1, 1];
    this.margins = { top: 0, right: 0, bottom: 0, left: 0 };
    this.planBox = null;
    this.preset = "quarter";
  }

  setScene(scene) {
    this.sea?.dispose();
    this.ship?.dispose();
    this.world.clear();
    this.scene = scene;
    this.ship = new Ship(scene, SUN);
    this.sea = new Sea(scene, Math.max(this.ship.size.x, this.ship.size.y, 1), SUN, this.software);
    this.world.add(this.ship.group, this.sea.mesh);
    const reach = this.ship.size.x;
    this.camera.near = reach / 100;
    this.camera.far = reach * 12;
    this.controls.minDistance = reach * 0.15;
    this.controls.maxDistance = reach * 4;
    this.#aim();
    this.#aimPlan();
  }

  // Room taken by labels over the picture [px]: the ship is framed within the rest.
  layout(width, height, margins, planBox) {
    this.size = [width, height];
    this.margins = margins;
    this.planBox = planBox;
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    if (!this.scene) return;
    if (this.preset) this.#aim();
    else this.#project();
    this.#aimPlan();
  }

  setCamera(name) {
    if (!CAMERAS[name]) return;
    this.preset = name;
    if (this.scene) this.#aim();
  }

  #project() {
    const [width, height] = this.size;
    const { top, right, bottom, left } = this.margins;
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, (right - left) / 2, (bottom - top) / 2, width, height);
  }

  // Places the camera so that the ship fills the free part of the picture.
  #aim() {
    const [width, height] = this.size;
    const { top, right, bottom, left } = this.margins;
    const free = [Math.max(width - left - right, 80) / width, Math.max(height - top - bottom, 80) / height];
    this.camera.aspect = width / height;
    this.camera.clearViewOffset();
    const from = new THREE.Vector3(...CAMERAS[this.preset].from).normalize();
    const target = this.ship.box.getCenter(new THREE.Vector3());
    let distance = this.ship.size.x * 2;
    for (let round = 0; round < 8; round++) {
      this.camera.position.copy(target).addScaledVector(from, distance);
      this.camera.lookAt(target);
      this.camera.updateMatrixWorld();
      this.camera.updateProjectionMatrix();
      const seen = this.ship.outline.map((point) => point.clone().project(this.camera));
      const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
      const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
      const shift = new THREE.Vector3((x0 + x1) / 2, (y0 + y1) / 2, target.clone().project(this.camera).z);
      target.copy(shift.unproject(this.camera));
      distance *= Math.max((x1 - x0) / 2 / (0.93 * free[0]), (y1 - y0) / 2 / (0.88 * free[1]));
    }
    this.camera.position.copy(target).addScaledVector(from, distance);
    this.camera.lookAt(target);
    this.controls.target.copy(target);
    this.controls.update();
    this.#project();
  }

  #aimPlan() {
    if (!this.planBox) return;
    const { min, max } = this.ship.box;
    const aspect = this.planBox.width / this.planBox.height;
    let [w, h] = [(max.x - min.x) * 1.05, Math.max((max.y - min.y) * 1.1, 1e-3)];
    if (w / h < aspect) w = h * aspect;
    else h = w / aspect;
    Object.assign(this.plan, { left: -w / 2, right: w / 2, top: h / 2, bottom: -h / 2, near: 1, far: 800 });
    this.plan.position.set((min.x + max.x) / 2, (min.y + max.y) / 2, 400);
    this.plan.lookAt(this.plan.position.x, this.plan.position.y, 0);
    this.plan.updateProjectionMatrix();
  }

  setField(name) {
    this.ship.setField(name);
  }

  draw(time) {
    const { renderer } = this;
    if (this.settled) {
      this.settled = false;
      renderer.setPixelRatio(this.ratio);
    }
    this.ship.setTime(time);
    this.sea.setTime(time, sampleAt(this.scene.facts, time));
    const depth = -this.camera.position.z;
    this.sea.uniforms.opacity.value = depth > 0 ? 0.18 : 0.93;
    const [width, height] = this.size;
    renderer.setViewport(0, 0, width, height);
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.render(this.world, this.camera);
    if (!this.planBox) return;
    const { left, bottom, width: w, height: h } = this.planBox;
    renderer.setViewport(left, bottom, w, h);
    renderer.setScissor(left, bottom, w, h);
    renderer.setScissorTest(true);
    renderer.setClearColor(0xffffff, 1);
    renderer.clear();
    // the plan stays with the ship: only heave and roll are seen
    const { x, y } = this.ship.group.position;
    const { min, max } = this.ship.box;
    this.plan.position.x = x + (min.x + max.x) / 2;
    this.plan.position.y = y + (min.y + max.y) / 2;
    renderer.render(this.world, this.plan);
    renderer.setClearColor(BACKGROUND, 1);
    renderer.setScissorTest(false);
  }

  // Fewer pixels when frames come too slowly, more when there is time to spare.
  adapt(interval) {
    if (interval > 1000) return;
    this.intervals.push(interval);
    if (this.intervals.length < 10) return;
    const middle = this.intervals.sort((a, b) => a - b)[5];
    this.intervals = [];
    let wanted = this.ratio;
    if (middle > SLOWEST) {
      this.ceiling = Math.max(this.ratio * 0.95, this.ratios[0]);
      wanted = Math.max(this.ratio * (middle > 1.5 * SLOWEST ? 0.75 : 0.88), this.ratios[0]);
    } else if (middle < FASTEST) {
      wanted = Math.min(this.ratio * 1.1, this.ceiling);
    }
    if (Math.abs(wanted - this.ratio) < 0.01) return;
    this.ratio = wanted;
    this.renderer.setPixelRatio(wanted);
  }

  // One frame in full resolution, for a picture that stands still.
  settle(time) {
    const full = Math.max(1, Math.min(window.devicePixelRatio || 1, 2));
    if (this.ratio >= full) return;
    this.renderer.setPixelRatio(full);
    this.draw(time);
    this.settled = true;
  }

  // The picture as a canvas in full resolution.
  snapshot(time) {
    const kept = this.ratio;
    this.renderer.setPixelRatio(Math.max(2, window.devicePixelRatio || 1));
    this.draw(time);
    const copy = document.createElement("canvas");
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    copy.getContext("2d").drawImage(this.canvas, 0, 0);
    this.renderer.setPixelRatio(kept);
    return copy;
  }

  dispose() {
    this.canvas.removeEventListener("blur", this.onBlur);
    this.controls.dispose();
    this.sea?.dispose();
    this.ship?.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
