// The water: a grid displaced in the vertex shader, by a sum of components or between two frames of a film.
import * as THREE from "three";

const MOST_IN_UNIFORMS = 180; // every WebGL 2 has room for 256 vectors

const VERTEX = /* glsl */ `
  #ifdef COMPONENTS
    // a, kx, ky and the phase at this instant
    #ifdef IN_UNIFORMS
      uniform vec4 table[COMPONENTS];
      #define COMPONENT(j) table[j]
    #else
      uniform sampler2D table;
      #define COMPONENT(j) texelFetch(table, ivec2(j, 0), 0)
    #endif
  #else
    uniform isampler2D before;
    uniform isampler2D after;
    uniform float blend;
    uniform float unit;
    uniform vec2 spacing;
    uniform ivec2 size;
    float level(ivec2 cell) {
      cell = clamp(cell, ivec2(0), size - 1);
      ivec2 texel = ivec2(cell.y, cell.x);
      float a = float(texelFetch(before, texel, 0).r);
      float b = float(texelFetch(after, texel, 0).r);
      return unit * mix(a, b, blend);
    }
  #endif
  attribute float edge;
  varying vec3 vWorld;
  varying vec2 vSlope;
  varying float vEdge;
  void main() {
    vec3 p = position;
    vec2 slope = vec2(0.0);
    #ifdef COMPONENTS
      for (int j = 0; j < COMPONENTS; j++) {
        vec4 c = COMPONENT(j);
        float angle = c.y * p.x + c.z * p.y + c.w;
        p.z += c.x * cos(angle);
        slope -= c.x * sin(angle) * c.yz;
      }
    #else
      ivec2 cell = ivec2(gl_VertexID / size.y, gl_VertexID % size.y);
      p.z = level(cell);
      slope = vec2(level(cell + ivec2(1, 0)) - level(cell - ivec2(1, 0)),
                   level(cell + ivec2(0, 1)) - level(cell - ivec2(0, 1))) / (2.0 * spacing);
    #endif
    vWorld = p;
    vSlope = slope;
    vEdge = edge;
    gl_Position = projectionMatrix * viewMatrix * vec4(p, 1.0);
  }`;

const FRAGMENT = /* glsl */ `
  uniform float opacity;
  uniform float crest;
  uniform vec3 sun;
  uniform vec2 drift;   // advance of the ship: ripples stay with the water, not with the frame
  uniform float scale;
  varying vec3 vWorld;
  varying vec2 vSlope;
  varying float vEdge;
  void main() {
    vec3 v = cameraPosition - vWorld;
    float distance = length(v);
    v /= distance;
    // ripples are shading only: they show the grain and the advance of the water, not its height
    vec2 p = (vWorld.xy + drift) / scale;
    vec2 q = p + 0.6 * sin(p.yx * 0.37 + vec2(1.3, 0.4));
    vec2 ripple = vec2(cos(2.1 * q.x + 0.8 * q.y) + 0.7 * cos(4.3 * q.x - 2.6 * q.y),
                       cos(1.7 * q.y - 1.1 * q.x) + 0.7 * cos(3.9 * q.y + 2.3 * q.x));
    vec2 slope = vSlope + 0.045 * ripple * (1.0 - smoothstep(40.0, 170.0, distance / scale));
    vec3 n = normalize(vec3(-slope, 1.0));
    float above = gl_FrontFacing ? 1.0 : 0.0;
    if (!gl_FrontFacing) n = -n;
    float facing = clamp(dot(n, v), 0.0, 1.0);
    float light = clamp(dot(vec3(-slope, 1.0), sun) / length(vec3(slope, 1.0)), 0.0, 1.0);
    float rise = clamp(0.5 + 0.5 * vWorld.z / crest, 0.0, 1.0);
    vec3 body = mix(vec3(0.055, 0.235, 0.345), vec3(0.275, 0.565, 0.655), rise * rise * 0.8 + 0.1);
    vec3 colour = body * (0.30 + 0.98 * light);
    float mirror = 0.03 + 0.62 * pow(1.0 - facing, 4.0);
    colour = mix(colour, vec3(0.80, 0.88, 0.93), mirror * above);
    vec3 h = normalize(sun + v);
    colour += above * 0.20 * pow(clamp(dot(n, h), 0.0, 1.0), 90.0);
    float fade = 1.0 - smoothstep(0.55, 1.0, vEdge);
    gl_FragColor = vec4(colour, opacity * fade);
  }`;

export class Sea {
  constructor(scene, length, sun, software) {
    this.scene = scene;
    this.components = scene.facts.water.kind === "components";
    this.uniforms = {
      opacity: { value: 0.9 },
      crest: { value: this.#crest() },
      sun: { value: sun },
      drift: { value: new THREE.Vector2() },
      scale: { value: length / 36 },
    };
    const defines = {};
    if (this.components) {
      const count = Math.max(scene.facts.water.count, 1);
      defines.COMPONENTS = count;
      this.values = new Float32Array(4 * count);
      if (count <= MOST_IN_UNIFORMS) {
        defines.IN_UNIFORMS = 1;
        this.uniforms.table = { value: this.values };
      } else {
        this.table = new THREE.DataTexture(this.values, count, 1, THREE.RGBAFormat, THREE.FloatType);
        this.uniforms.table = { value: this.table };
      }
    } else {
      const [nx, ny] = scene.facts.water.size;
      const { seaX, seaY } = scene;
      this.frames = [0, 1].map(() => {
        const texture = new THREE.DataTexture(new Int16Array(nx * ny), ny, nx, THREE.RedIntegerFormat, THREE.ShortType);
        texture.internalFormat = "R16I";
        texture.unpackAlignment = 1;
        return texture;
      });
      this.loaded = [-1, -1];
      Object.assign(this.uniforms, {
        before: { value: this.frames[0] },
        after: { value: this.frames[1] },
        blend: { value: 0 },
        unit: { value: scene.facts.water.unit },
        size: { value: new Int32Array([nx, ny]) },
        spacing: {
          value: new THREE.Vector2((seaX.at(-1) - seaX[0]) / (nx - 1 || 1), (seaY.at(-1) - seaY[0]) / (ny - 1 || 1)),
        },
      });
    }
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: this.uniforms,
      defines,
      transparent: true,
      side: THREE.DoubleSide,
      forceSinglePass: true,
    });
    this.mesh = new THREE.Mesh(this.#grid(length, software), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 2;
    this.mesh.layers.set(1);
  }

  // Height of a high crest [m]: two standard deviations.
  #crest() {
    const { water, facts } = this.scene;
    let square = 0;
    if (this.components) {
      for (let j = 0; j < water.length; j += 5) square += water[j] ** 2 / 2;
      return Math.max(2 * Math.sqrt(square), 0.05);
    }
    for (let i = 0; i < water.length; i += 7) square += water[i] ** 2;
    return Math.max(2 * facts.water.unit * Math.sqrt((7 * square) / (water.length || 1)), 0.05);
  }

  #grid(length, software) {
    let xs = this.scene.seaX;
    let ys = this.scene.seaY;
    if (this.components) {
      const count = software ? 100 : 176;
      const stretched = Float32Array.from({ length: count }, (_, i) => {
        const s = (2 * i) / (count - 1) - 1;
        return length * (1.0 * s + 1.4 * s ** 3);
      });
      xs = stretched;
      ys = stretched;
    }
    const [nx, ny] = [xs.length, ys.length];
    const position = new Float32Array(3 * nx * ny);
    const edge = new Float32Array(nx * ny);
    const [cx, cy] = [(xs[0] + xs[nx - 1]) / 2, (ys[0] + ys[ny - 1]) / 2];
    for (let i = 0, k = 0; i < nx; i++) {
      for (let j = 0; j < ny; j++, k++) {
        position[3 * k] = xs[i];
        position[3 * k + 1] = ys[j];
        const u = Math.abs((xs[i] - cx) / (xs[nx - 1] - cx));
        const v = Math.abs((ys[j] - cy) / (ys[ny - 1] - cy));
        edge[k] = this.components ? Math.hypot(u, v) : Math.max(0, 1 - 5 * (1 - Math.max(u, v)));
      }
    }
    const index = new Uint32Array(6 * (nx - 1) * (ny - 1));
    let n = 0;
    for (let i = 0; i < nx - 1; i++) {
      for (let j = 0; j < ny - 1; j++) {
        const a = i * ny + j;
        if (Math.min(edge[a], edge[a + 1], edge[a + ny], edge[a + ny + 1]) >= 1) continue;
        index.set([a, a + ny, a + ny + 1, a, a + ny + 1, a + 1], n);
        n += 6;
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(position, 3));
    geometry.setAttribute("edge", new THREE.BufferAttribute(edge, 1));
    geometry.setIndex(new THREE.BufferAttribute(index.slice(0, n), 1));
    return geometry;
  }

  setTime(time, { index, fraction }) {
    this.uniforms.drift.value.x = this.scene.facts.speed * time;
    if (this.components) {
      const { water } = this.scene;
      for (let j = 0, k = 0; j < water.length; j += 5, k += 4) {
        const [amplitude, frequency, kx, ky, phase] = water.subarray(j, j + 5);
        // phase reduced here, in double precision: long films stay exact
        this.values.set([amplitude, kx, ky, (phase - frequency * time) % (2 * Math.PI)], k);
      }
      if (this.table) this.table.needsUpdate = true;
      return;
    }
    const wanted = [index, index + 1];
    if (this.loaded[1] === wanted[0]) {
      this.frames.reverse();
      this.loaded.reverse();
    }
    const [nx, ny] = this.scene.facts.water.size;
    for (let k = 0; k < 2; k++) {
      if (this.loaded[k] === wanted[k]) continue;
      this.frames[k].image.data.set(this.scene.water.subarray(wanted[k] * nx * ny, (wanted[k] + 1) * nx * ny));
      this.frames[k].needsUpdate = true;
      this.loaded[k] = wanted[k];
    }
    this.uniforms.before.value = this.frames[0];
    this.uniforms.after.value = this.frames[1];
    this.uniforms.blend.value = fraction;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.table?.dispose();
    this.frames?.forEach((texture) => texture.dispose());
  }
}
