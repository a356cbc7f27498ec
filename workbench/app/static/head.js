// The verdict and the guard: keeps the inputs in the browser, saves files, and says when the kernel is gone.
const KEY = "workbench-session";
const inVoila = () => Boolean(document.body.dataset.voila);

function stored() {
  try { return JSON.parse(sessionStorage.getItem(KEY) ?? "null"); } catch { return null; }
}

function keep(model) {
  if (!inVoila()) return;
  const query = model.get("permalink");
  try { sessionStorage.setItem(KEY, JSON.stringify({ query, state: model.get("state") })); } catch { /* full or forbidden */ }
  if (query) history.replaceState(null, "", `${location.pathname}?${query}`);
}

function initialize({ model }) {
  const session = stored();
  const query = location.search.replace(/^\?/, "");
  if (inVoila()) {
    const same = session && (session.query === query || !query);
    model.send({ type: "hello", query: same ? "" : query, state: same ? session.state : "", height: window.innerHeight });
  }
  model.on("msg:custom", (content, buffers) => {
    if (content.type !== "file") return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([buffers[0]], { type: content.mime }));
    link.download = content.name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  });
}

function render({ model, el }) {
  el.classList.add("wb-head-holder");
  el.innerHTML = `
    <div class="wb-lost" role="alert" hidden>
      <span>The computation behind this page has stopped. Your inputs are kept in this browser.</span>
      <button type="button" class="wb-button">Reload with the same inputs</button>
    </div>
    <header class="wb-head">
      <div class="wb-brand"><h1></h1><span class="wb-version"></span></div>
      <div class="wb-verdict"><p aria-live="polite"></p>
        <div class="wb-status">
          <div class="wb-progress" role="progressbar" aria-label="Computation" aria-valuemin="0" aria-valuemax="100"><i></i></div>
          <span class="wb-task" aria-live="polite"></span>
          <button type="button" class="wb-button wb-action"></button>
        </div>
      </div>
    </header>`;
  const part = (selector) => el.querySelector(selector);
  part(".wb-lost button").addEventListener("click", () => location.reload());
  part(".wb-action").addEventListener("click", () => model.send({ type: model.get("action") }));
  const labels = { stop: "Stop", resume: "Compute", refine: "Refine with the panel method" };
  function idle(blocked, tone, origin) {
    if (blocked) return "Mend the marked input; what is shown below belongs to former inputs.";
    return tone === "old" ? "What is shown below belongs to former inputs." : `Up to date with the inputs${origin ? `, ${origin}` : ""}.`;
  }

  function update() {
    part("h1").textContent = model.get("title");
    part(".wb-version").textContent = model.get("version");
    const problems = model.get("problems");
    const error = model.get("error");
    const verdict = part(".wb-verdict");
    verdict.dataset.tone = error ? "bad" : problems.length ? "blocked" : model.get("tone");
    const sentence = error || problems.join(" ") || model.get("verdict") || "The first results are being computed.";
    if (part(".wb-verdict p").textContent !== sentence) part(".wb-verdict p").textContent = sentence;
    const busy = model.get("busy");
    const percent = Math.round(100 * model.get("progress"));
    const bar = part(".wb-progress");
    bar.setAttribute("aria-valuenow", percent);
    bar.firstElementChild.style.width = percent ? `${percent}%` : "";
    bar.classList.toggle("wb-unknown", !percent);
    bar.hidden = !busy;
    const words = model.get("task") || [model.get("remark"), idle(problems.length > 0, model.get("tone"), model.get("origin"))].filter(Boolean).join(" ");
    if (part(".wb-task").textContent !== words) part(".wb-task").textContent = words;
    const action = model.get("action");
    part(".wb-action").hidden = !action;
    part(".wb-action").textContent = labels[action] ?? "";
  }
  const names = ["title", "version", "verdict", "tone", "remark", "origin", "busy", "progress", "task", "action", "problems", "error"];
  for (const name of names) model.on(`change:${name}`, update);
  for (const name of ["state", "permalink"]) model.on(`change:${name}`, () => keep(model));
  model.on("comm_live_update", () => { part(".wb-lost").hidden = false; document.body.classList.add("wb-dead"); });
  window.__wb = { lost: () => !part(".wb-lost").hidden };
  const watch = new ResizeObserver(() => {
    document.documentElement.style.setProperty("--wb-head", `${el.offsetHeight + 10}px`);
  });
  watch.observe(el);
  update();
  return () => watch.disconnect();
}

export default { initialize, render };
