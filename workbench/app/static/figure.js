// A figure: picture, its own choices, notes, and saving it.
function save(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function bytes(value) {
  return value ? new Uint8Array(value.buffer ?? value, value.byteOffset ?? 0, value.byteLength) : new Uint8Array();
}

function render({ model, el }) {
  el.classList.add("wb-figure-holder");
  const id = `wb-figure-${model.get("name")}`;
  el.innerHTML = `
    <figure class="wb-figure" aria-labelledby="${id}">
      <div class="wb-figure-head"><h2 id="${id}"></h2><div class="wb-figure-choices"></div>
        <div class="wb-save"><span>Save</span><button type="button" class="wb-link" data-kind="png">PNG</button><button type="button" class="wb-link" data-kind="svg">SVG</button></div></div>
      <div class="wb-picture"><img alt=""><div class="wb-old">out of date</div><div class="wb-wait">being drawn…</div></div>
      <ul class="wb-notes"></ul>
    </figure>`;
  const part = (selector) => el.querySelector(selector);
  const image = part("img");
  let url = "";

  function draw() {
    const data = bytes(model.get("picture"));
    if (url) URL.revokeObjectURL(url);
    url = data.length ? URL.createObjectURL(new Blob([data], { type: "image/png" })) : "";
    if (url) image.src = url;
    image.hidden = !url;
    part(".wb-wait").hidden = Boolean(url);
    image.dataset.revision = String(Number(image.dataset.revision ?? 0) + 1);
  }
  function update() {
    part("h2").textContent = model.get("title");
    image.alt = model.get("words");
    el.firstElementChild.classList.toggle("wb-is-old", model.get("old"));
    el.classList.toggle("wb-wide", model.get("wide"));
    part(".wb-notes").replaceChildren(...model.get("notes").map((note) => {
      const item = document.createElement("li");
      item.textContent = note;
      return item;
    }));
  }
  function choose() {
    part(".wb-figure-choices").replaceChildren(...model.get("choices").map(([name, label, options]) => {
      const select = document.createElement("select");
      select.setAttribute("aria-label", label);
      select.title = label;
      for (const [value, words] of options) select.append(new Option(words, value));
      select.value = model.get("chosen")[name] ?? options[0][0];
      select.addEventListener("change", () => model.send({ type: "choose", name, value: select.value }));
      return select;
    }));
  }
  for (const button of el.querySelectorAll(".wb-link")) {
    button.setAttribute("aria-label", `Save as ${button.dataset.kind.toUpperCase()}: ${model.get("title")}`);
    button.addEventListener("click", () => {
      const data = bytes(model.get("picture"));
      if (button.dataset.kind === "svg") model.send({ type: "svg" });
      else if (data.length) save(`${model.get("name")}.png`, new Blob([data], { type: "image/png" }));
    });
  }
  const received = (content, buffers) => {
    if (content.type === "file") save(content.name, new Blob([buffers[0]], { type: content.mime }));
  };
  model.on("msg:custom", received);
  model.on("change:picture", draw);
  model.on("change:choices", choose);
  for (const name of ["title", "words", "notes", "old", "wide"]) model.on(`change:${name}`, update);
  choose();
  update();
  draw();
  return () => {
    model.off("msg:custom", received);
    model.off("change:picture", draw);
    if (url) URL.revokeObjectURL(url);
  };
}

export default { render };
