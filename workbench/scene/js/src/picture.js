// The present picture as a PNG file, with the labels that stand over it on the page.
import { barNumbers, barTitle } from "./controls.js";
import { shown } from "./data.js";

export function savePicture({ stage, scene, time, part }) {
  const view = stage.snapshot(time);
  const scale = view.width / part.stage.clientWidth;
  const head = 40;
  const picture = document.createElement("canvas");
  picture.width = view.width;
  picture.height = view.height + head * scale;
  const c = picture.getContext("2d");
  c.scale(scale, scale);
  c.fillStyle = "#ffffff";
  c.fillRect(0, 0, part.stage.clientWidth, head);
  c.drawImage(view, 0, head, part.stage.clientWidth, part.stage.clientHeight);
  c.fillStyle = "#1d2b35";
  c.textBaseline = "middle";
  c.font = "600 15px system-ui, sans-serif";
  c.fillText(part.title.textContent, 10, head / 2);
  c.font = "13px system-ui, sans-serif";
  c.textAlign = "right";
  c.fillText(`Time ${shown(time, 2)} s`, part.stage.clientWidth - 10, head / 2);
  c.textAlign = "left";
  const field = scene.facts.fields.find(({ name }) => name === part.field.value);
  if (field) paintBar(c, field, part.bar, head);
  const frame = part.plan;
  if (frame.offsetWidth) {
    c.strokeStyle = "#8b9ba6";
    c.strokeRect(frame.offsetLeft, frame.offsetTop + head, frame.offsetWidth, frame.offsetHeight);
    c.fillStyle = "#1d2b35";
    c.fillText(frame.firstChild.textContent, frame.offsetLeft, frame.offsetTop + head - 10);
  }
  picture.toBlob((blob) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `wet-deck-${time.toFixed(1)}-s.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }, "image/png");
}

function paintBar(c, field, bar, head) {
  const [left, top, width] = [bar.offsetLeft, bar.offsetTop + head, bar.offsetWidth];
  c.fillStyle = "rgba(255,255,255,0.86)";
  c.fillRect(left, top, width, bar.offsetHeight);
  c.fillStyle = "#1d2b35";
  c.fillText(barTitle(field), left + 8, top + 14);
  const each = (width - 36) / field.colours.length;
  field.colours.forEach((colour, i) => {
    c.fillStyle = colour;
    c.fillRect(left + 18 + i * each, top + 25, each + 0.5, 14);
  });
  c.strokeStyle = "#55666f";
  c.strokeRect(left + 18, top + 25, width - 36, 14);
  c.fillStyle = "#1d2b35";
  c.textAlign = "center";
  for (const { place, text } of barNumbers(field)) c.fillText(text, left + 18 + place * (width - 36), top + 49);
  c.textAlign = "left";
}
