// Entry for the HTML file: data stand in the page itself and state goes nowhere.
import { createView } from "./view.js";

function bytes(base64) {
  const text = atob(base64);
  const array = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) array[i] = text.charCodeAt(i);
  return array;
}

const packed = JSON.parse(document.getElementById("sea-view-scene").textContent);
const state = { scene: packed.scene, field: packed.field, time: packed.scene.start, playing: true, camera: "quarter" };
for (const [name, text] of Object.entries(packed.blocks)) state[name] = bytes(text);

createView(document.getElementById("sea-view"), {
  get: (name) => state[name],
  set(name, value) {
    state[name] = value;
  },
  on() {},
}, { height: 0 });
