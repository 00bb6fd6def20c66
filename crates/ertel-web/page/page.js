// The page: form and case file in step, a worker that solves, progress and result.

import { start } from "./ertel.js";
import { Form } from "./form.js";
import { Progress } from "./progress.js";
import { showResult } from "./result.js";

const find = (id) => document.getElementById(id);
const caseText = find("case");
const status = find("status");

let module;
let ertel;
let form;
let worker = null;
let timer = 0;
/** The case file of the result that is shown. */
let solvedText = null;

/** Begins with the module: without it there is nothing to do. */
async function begin() {
  try {
    const response = await fetch(new URL("ertel.wasm", import.meta.url));
    if (!response.ok) throw new Error(`ertel.wasm: ${response.status} ${response.statusText}`);
    // Not compileStreaming: some static hosts do not know the media type of WebAssembly.
    module = await WebAssembly.compile(await response.arrayBuffer());
    ertel = await start(module);
  } catch (error) {
    const banner = find("banner");
    banner.textContent = `The solver cannot be loaded: ${error.message}. The page needs a current browser with WebAssembly SIMD and a web server (not file://).`;
    banner.hidden = false;
    status.textContent = "";
    return;
  }
  const database = ertel.database();
  find("version").textContent = database.version;
  form = new Form(find("form"), database, change);
  const examples = find("example");
  database.examples.forEach(({ name }, i) => examples.add(new Option(name, String(i))));
  examples.addEventListener("change", () => {
    const chosen = database.examples[examples.value];
    if (chosen) setText(chosen.text);
  });
  if (!caseText.value) caseText.value = database.examples[0].text;
  status.textContent = "";
  document.documentElement.dataset.ready = "yes";
  refresh();
}

function setText(text) {
  caseText.value = text;
  refresh();
}

/** A field of the form was changed: the same change in the case file. */
function change(changes) {
  const edited = ertel.edit(caseText.value, changes);
  if (edited.ok) caseText.value = edited.text;
  refresh();
}

/** Shows the case file in the form, and what is wrong with it at the field and under the file. */
function refresh() {
  clearTimeout(timer);
  const text = caseText.value;
  const checked = ertel.check(text);
  form.show(ertel.form(text), checked);
  showState(checked);
  find("solve").disabled = !checked.ok || worker !== null;
  find("outdated").hidden = text === solvedText;
}

function showState(checked) {
  const state = find("case-state");
  const locate = find("locate");
  caseText.setAttribute("aria-invalid", String(!checked.ok));
  state.replaceChildren();
  locate.hidden = true;
  if (!checked.ok) {
    const message = document.createElement("pre");
    message.className = "message";
    message.textContent = `error: ${checked.error.text}`;
    message.tabIndex = 0;
    state.append(message);
    if (checked.error.line) {
      locate.hidden = false;
      locate.textContent = `Show line ${checked.error.line}`;
      locate.onclick = () => selectLine(checked.error.line);
    }
    return;
  }
  if (checked.warnings.length > 0) {
    const list = document.createElement("ul");
    list.className = "warnings";
    list.append(...checked.warnings.map((warning) => Object.assign(document.createElement("li"), { textContent: warning })));
    state.append(list);
  }
  const fine = document.createElement("p");
  fine.className = "fine";
  fine.textContent = checked.points ? `The case can be solved: a curve of ${checked.points} points.` : "The case can be solved.";
  state.append(fine);
}

function selectLine(line) {
  const lines = caseText.value.split("\n");
  const from = lines.slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
  caseText.focus();
  caseText.setSelectionRange(from, from + lines[line - 1].length);
}

/** Solves the case in a separate worker. */
function solve() {
  const text = caseText.value;
  worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
  const began = performance.now();
  const seconds = () => `${((performance.now() - began) / 1000).toFixed(1)} s`;
  find("result").hidden = true;
  const progress = new Progress(find("progress"), (line) => { status.textContent = line; });
  status.textContent = "Building the mesh and the elastic operator…";
  find("solve").disabled = true;
  find("stop").disabled = false;
  worker.addEventListener("message", ({ data }) => {
    if (data.event) {
      progress.add(data.event);
      return;
    }
    end();
    status.textContent = data.answer.ok ? `Solved in ${seconds()}.` : "Not solved.";
    find("result").hidden = false;
    solvedText = text;
    find("outdated").hidden = text === caseText.value;
    showResult(find("answer"), data.answer);
    document.documentElement.dataset.solved = data.answer.ok ? "yes" : "no";
  });
  worker.addEventListener("error", (event) => {
    end();
    status.textContent = `The worker failed: ${event.message ?? "it cannot be loaded"}.`;
  });
  worker.postMessage({ module, text });
}

/** The worker has nothing more to do. */
function end() {
  worker?.terminate();
  worker = null;
  find("stop").disabled = true;
  find("solve").disabled = !ertel.check(caseText.value).ok;
}

find("form").addEventListener("submit", (event) => {
  event.preventDefault();
  if (!find("solve").disabled) solve();
});
find("stop").addEventListener("click", () => {
  end();
  status.textContent = "Stopped; nothing was kept.";
  find("solve").focus();
});
caseText.addEventListener("input", () => {
  clearTimeout(timer);
  timer = setTimeout(refresh, 150);
});
find("open").addEventListener("click", () => find("file").click());
find("file").addEventListener("change", async ({ target }) => {
  const [file] = target.files;
  if (file) setText(await file.text());
  target.value = "";
});
find("save").addEventListener("click", () => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([caseText.value], { type: "text/plain" }));
  link.download = "case.toml";
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
});

begin();
