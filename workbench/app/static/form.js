// Draws the form and tells the kernel each change; a field being touched is not overwritten by the echo.
const PAUSE = 60; // ms between values sent while a slider is dragged
const HOLD = 900; // ms during which the reader's own value is not overwritten

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

const number = (value) => Number(String(value).replace(",", "."));

function render({ model, el }) {
  el.classList.add("wb-form-holder");
  const form = element("form", { class: "wb-form", "aria-label": "Inputs", novalidate: true });
  el.append(form);
  const parts = {};
  const touched = {};
  const open = {};
  const timers = {};

  const tell = (name, value) => model.send({ type: "set", name, value });
  function tellSoon(name, value, pause = PAUSE) {
    const timer = (timers[name] ||= { last: 0 });
    clearTimeout(timer.id);
    const wait = Math.max(0, pause - (performance.now() - timer.last));
    timer.id = setTimeout(() => { timer.last = performance.now(); tell(name, value); }, wait);
  }
  const touch = (name) => { touched[name] = performance.now(); };

  function numberField(field) {
    const id = `wb-${field.name}`;
    const box = element("input", { type: "text", inputmode: "decimal", id, class: "wb-box", autocomplete: "off", "aria-describedby": `${id}-note ${id}-problem` });
    const row = element("div", { class: "wb-row" }, element("label", { for: id, text: field.label }), box);
    const part = { row, box };
    box.addEventListener("input", () => {
      touch(field.name);
      clearTimeout(part.typing);
      part.typing = setTimeout(() => tell(field.name, box.value), 450);
    });
    box.addEventListener("change", () => { touch(field.name); clearTimeout(part.typing); tell(field.name, box.value); });
    box.addEventListener("keydown", (event) => {
      const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      if (!step || field.step == null || !Number.isFinite(number(box.value))) return;
      event.preventDefault();
      const decimals = Math.max(0, -Math.floor(Math.log10(field.step) + 1e-9));
      box.value = String(Number((number(box.value) + step * field.step).toFixed(decimals + 1)));
      if (part.slider) part.slider.value = box.value;
      touch(field.name);
      tellSoon(field.name, box.value);
    });
    const block = element("div", { class: "wb-field", "data-name": field.name }, row);
    if (field.low != null && field.high != null) {
      const slider = element("input", { type: "range", class: "wb-slider", min: field.low, max: field.high, step: field.step, "aria-label": `${field.label}, slider` });
      slider.addEventListener("input", () => {
        touch(field.name);
        box.value = String(Number(Number(slider.value).toPrecision(6)));
        tellSoon(field.name, box.value);
      });
      part.slider = slider;
      block.append(slider);
    }
    return finish(field, part, block, id);
  }

  function choiceField(field) {
    const id = `wb-${field.name}`;
    const box = element("select", { id, class: "wb-choice", "aria-describedby": `${id}-note ${id}-problem` });
    for (const [value, words] of field.choices) box.append(element("option", { value, text: words }));
    box.addEventListener("change", () => { touch(field.name); tell(field.name, box.value); });
    const block = element("div", { class: "wb-field", "data-name": field.name },
      element("label", { for: id, text: field.label }), box);
    return finish(field, { box }, block, id);
  }

  function textField(field) {
    const id = `wb-${field.name}`;
    const box = element("textarea", { id, class: "wb-text", rows: "6", spellcheck: "false", "aria-describedby": `${id}-note ${id}-problem` });
    const part = { box };
    box.addEventListener("input", () => {
      touch(field.name);
      clearTimeout(part.typing);
      part.typing = setTimeout(() => tell(field.name, box.value), 700);
    });
    box.addEventListener("change", () => { touch(field.name); clearTimeout(part.typing); tell(field.name, box.value); });
    const file = element("input", { type: "file", accept: ".csv,.txt,text/plain", hidden: true, "aria-label": `${field.label}, file` });
    file.addEventListener("change", async () => {
      const chosen = file.files[0];
      if (!chosen) return;
      box.value = chosen.size > 1e6 ? "#".repeat(100000) : await chosen.text();
      file.value = "";
      touch(field.name);
      tell(field.name, box.value);
    });
    const load = element("button", { type: "button", class: "wb-button", text: "Load a CSV file…" });
    load.addEventListener("click", () => file.click());
    const block = element("div", { class: "wb-field", "data-name": field.name },
      element("label", { for: id, text: field.label }), box, element("div", { class: "wb-buttons" }, load), file);
    return finish(field, part, block, id);
  }

  function finish(field, part, block, id) {
    part.note = element("div", { class: "wb-note", id: `${id}-note` });
    part.problem = element("div", { class: "wb-problem", id: `${id}-problem`, role: "alert" });
    block.append(part.note, part.problem);
    part.block = block;
    part.field = field;
    parts[field.name] = part;
    return block;
  }

  function designField() {
    const select = element("select", { id: "wb-design", class: "wb-choice", "aria-describedby": "wb-design-problem" });
    for (const [name, title] of model.get("designs")) select.append(element("option", { value: name, text: title }));
    select.value = model.get("design");
    select.addEventListener("change", () => tell("design", select.value));
    const file = element("input", { type: "file", accept: ".toml,text/plain", hidden: true, "aria-label": "Design file" });
    file.addEventListener("change", async () => {
      const chosen = file.files[0];
      if (!chosen) return;
      const text = chosen.size > 5e6 ? "#".repeat(5000002) : await chosen.text();
      file.value = "";
      model.send({ type: "load", name: chosen.name, text });
    });
    const load = element("button", { type: "button", class: "wb-button", text: "Load a design file…" });
    load.addEventListener("click", () => file.click());
    const undo = element("button", { type: "button", class: "wb-button", text: "Undo my changes to it" });
    undo.addEventListener("click", () => model.send({ type: "undo" }));
    const note = element("div", { class: "wb-note" });
    const problem = element("div", { class: "wb-problem", id: "wb-design-problem", role: "alert" });
    parts.design = { box: select, note, problem, undo, block: element("div", { class: "wb-field" },
      element("label", { for: "wb-design", text: "Ship" }), select, element("div", { class: "wb-buttons" }, load, undo), file, note, problem) };
    return parts.design.block;
  }

  function build() {
    for (const details of form.querySelectorAll("details")) open[details.dataset.key] = details.open;
    const focused = form.contains(document.activeElement) ? document.activeElement.id : "";
    form.replaceChildren();
    for (const name of Object.keys(parts)) delete parts[name];
    const fields = model.get("fields");
    for (const [key, heading, isOpen] of model.get("groups")) {
      const own = fields.filter((field) => field.group === key);
      if (!own.length && key !== "design") continue;
      const details = element("details", { class: "wb-group", "data-key": key, open: open[key] ?? isOpen },
        element("summary", { text: heading }));
      if (key === "design") details.append(designField());
      const kinds = { choice: choiceField, text: textField };
      for (const field of own) details.append((kinds[field.kind] ?? numberField)(field));
      form.append(details);
    }
    if (focused) document.getElementById(focused)?.focus();
    update();
  }

  function update() {
    const values = model.get("values");
    const now = performance.now();
    for (const [name, part] of Object.entries(parts)) {
      if (name !== "design" && name in values && !(now - (touched[name] ?? -1e9) < HOLD)) {
        const shown = String(values[name]);
        const typing = document.activeElement === part.box && number(part.box.value) === number(shown);
        if (part.box.value !== shown && !typing) part.box.value = shown;
        if (part.slider) part.slider.value = shown;
      }
      const rules = part.field?.shown_if ?? [];
      part.block.hidden = !rules.every(([other, allowed]) => allowed.includes(String(values[other])));
      part.note.textContent = model.get("notes")[name] ?? "";
      const problem = model.get("problems")[name] ?? "";
      if (part.problem.textContent !== problem) part.problem.textContent = problem;
      part.box.setAttribute("aria-invalid", problem ? "true" : "false");
      if (problem) part.block.closest("details").open = true;
    }
    if (parts.design) {
      parts.design.box.value = model.get("design");
      parts.design.undo.hidden = !model.get("changed");
    }
  }

  let later;
  const updateSoon = () => { clearTimeout(later); update(); later = setTimeout(update, HOLD + 50); };
  form.addEventListener("submit", (event) => event.preventDefault());
  model.on("change:fields", build);
  model.on("change:designs", build);
  for (const name of ["values", "notes", "problems", "design", "changed"]) model.on(`change:${name}`, updateSoon);
  build();
}

export default { render };
