// The page in Chromium, by the DevTools protocol over a pipe: nothing to install except the browser.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { createServer } from "node:http";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { ROOT, TARGET, agreed, nativeMessage, nativeResult } from "./native.mjs";

// Another folder with the page: of a release.
const PAGE = process.env.ERTEL_WEB ?? join(TARGET, "web");
const PICTURES = join(TARGET, "web-pictures");
const CHROMIUM = process.env.CHROMIUM ?? "chromium";
// As a static host that knows nothing of WebAssembly.
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };

const requests = [];
const server = createServer((request, response) => {
  const name = request.url === "/" ? "index.html" : request.url.slice(1);
  requests.push(name);
  try {
    const body = readFileSync(join(PAGE, name));
    response.writeHead(200, { "content-type": TYPES[extname(name)] ?? "application/octet-stream" }).end(body);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
const address = `http://127.0.0.1:${server.address().port}/`;

const profile = mkdtempSync(join(tmpdir(), "ertel-chromium-"));
const downloads = mkdtempSync(join(tmpdir(), "ertel-downloads-"));
const options = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--disable-extensions",
  "--disable-background-networking", "--hide-scrollbars", "--remote-debugging-pipe", `--user-data-dir=${profile}`, "about:blank"];
const chromium = spawn(CHROMIUM, options, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
// Processes of a browser that has ended may write into its profile for a while; what stays then is no error of the page.
const remove = async (folder) => {
  for (let trial = 0; trial < 50; trial++) {
    try {
      return rmSync(folder, { recursive: true, force: true });
    } catch {
      await new Promise((done) => setTimeout(done, 100));
    }
  }
  console.log(`${folder} could not be removed`);
};
const waiting = new Map();
const problems = [];
const foreign = [];
let rest = "";
let number = 0;
chromium.stdio[4].on("data", (data) => {
  const parts = (rest + data).split("\0");
  rest = parts.pop();
  for (const message of parts.map((part) => JSON.parse(part))) {
    if (message.id) {
      const { resolve, reject } = waiting.get(message.id);
      waiting.delete(message.id);
      if (message.error) reject(new Error(message.error.message));
      else resolve(message.result);
    } else if (message.method === "Runtime.exceptionThrown") {
      problems.push(message.params.exceptionDetails.exception?.description ?? message.params.exceptionDetails.text);
    } else if (message.method === "Runtime.consoleAPICalled" && ["error", "warning"].includes(message.params.type)) {
      problems.push(JSON.stringify(message.params.args.map((one) => one.value ?? one.description)));
    } else if (message.method === "Log.entryAdded" && ["error", "warning"].includes(message.params.entry.level)) {
      problems.push(`${message.params.entry.text} ${message.params.entry.url ?? ""}`);
    } else if (message.method === "Network.requestWillBeSent" && !/^(data|blob):/.test(message.params.request.url) && !message.params.request.url.startsWith(address)) {
      foreign.push(message.params.request.url);
    }
  }
});

function send(method, params = {}, sessionId = undefined) {
  number += 1;
  const id = number;
  chromium.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
  return new Promise((resolve, reject) => waiting.set(id, { resolve, reject }));
}

const { targetId } = await send("Target.createTarget", { url: "about:blank" });
const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
const tab = (method, params) => send(method, params, sessionId);
await Promise.all(["Runtime", "Log", "Page", "Network"].map((part) => tab(`${part}.enable`)));

async function run(expression) {
  const { result, exceptionDetails } = await tab("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
  assert(!exceptionDetails, exceptionDetails?.exception?.description);
  return result.value;
}

async function until(expression, seconds = 60) {
  const end = Date.now() + 1000 * seconds;
  while (Date.now() < end) {
    const value = await run(expression);
    if (value) return value;
    await new Promise((next) => setTimeout(next, 50));
  }
  throw new Error(`not within ${seconds} s: ${expression}`);
}

async function show(width, { dark = false } = {}) {
  await tab("Emulation.setDeviceMetricsOverride", { width, height: 900, deviceScaleFactor: 1, mobile: width < 600 });
  await tab("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }] });
}

/** A picture of the page from its top, or from an element on. */
async function picture(name, from = "body") {
  const { cssContentSize } = await tab("Page.getLayoutMetrics");
  const y = await run(`Math.max(0, document.querySelector(${JSON.stringify(from)}).getBoundingClientRect().top + scrollY - 10)`);
  const clip = { x: 0, y, width: cssContentSize.width, height: Math.min(cssContentSize.height - y, 1800), scale: 1 };
  const { data } = await tab("Page.captureScreenshot", { format: "png", captureBeyondViewport: true, clip });
  writeFileSync(join(PICTURES, `${name}.png`), Buffer.from(data, "base64"));
}

/** Types into the element as a user does: the value, then the event. */
const type = (element, value, event = "input") => run(`(() => {
  const input = ${element};
  input.value = ${JSON.stringify(value)};
  input.dispatchEvent(new Event(${JSON.stringify(event)}, { bubbles: true }));
})()`);
const field = (key) => `document.querySelector('.field[data-key="${key}"]:not([hidden]) :is(input, select)')`;
const text = () => run("document.getElementById('case').value");

async function solve() {
  await run("delete document.documentElement.dataset.solved; document.getElementById('solve').click()");
  return until("document.documentElement.dataset.solved", 600);
}

/** A file of the last result, downloaded by its link as a user does. */
async function file(name) {
  const path = join(downloads, name);
  rmSync(path, { force: true });
  await run(`[...document.querySelectorAll('.files a')].find((one) => one.download === ${JSON.stringify(name)}).click()`);
  for (let i = 0; i < 200; i += 1) {
    if (existsSync(path)) return readFileSync(path, "utf8");
    await new Promise((next) => setTimeout(next, 50));
  }
  throw new Error(`${name} was not downloaded`);
}

try {
  mkdirSync(PICTURES, { recursive: true });
  await send("Browser.setDownloadBehavior", { behavior: "allow", downloadPath: downloads });
  await show(1280);
  await tab("Page.navigate", { url: address });
  await until("document.documentElement?.dataset.ready");
  await picture("start-1280");

  // The roller, from the list of examples: the figures of the native program.
  await type("document.getElementById('example')", "1", "change");
  const roller = readFileSync(join(ROOT, "cases/roller.toml"), "utf8");
  assert.equal(await text(), roller);
  assert.equal(await run(`${field("contact.kind")}.value`), "line");
  assert.match(await run(`${field("contact.radius")}.title`), /^reduced radius of curvature R/);
  assert.equal(await run(`${field("contact.kind")}.options.length`), 4);
  assert.equal(await run(`${field("contact.load")}.value`), "100 kN/m");
  assert.equal(await solve(), "yes");
  const agreement = agreed(JSON.parse(await file("result.json")), nativeResult(roller));
  const state = await run("document.getElementById('status').textContent");
  console.log(`roller in the page: ${state} ${agreement}`);
  assert((await run("document.getElementById('iterations').rows.length")) > 3);
  await picture("roller-1280");

  // From the form into the file, with its comments; and from the file into the form.
  await type("document.getElementById('example')", "0", "change");
  await type(field("contact.radius"), "20 mm");
  const disc = readFileSync(join(ROOT, "cases/ball-on-disc.toml"), "utf8");
  assert.equal(await text(), disc.replace('"16 mm"', '"20 mm"'));
  await type("document.getElementById('case')", disc.replace('"0.8 m/s"', '"1.25 m/s"'));
  await until(`${field("motion.entrainment_speed")}.value === "1.25 m/s"`);
  assert.equal(await run(`${field("contact.radius")}.value`), "16 mm");
  await type(field("motion.slide_to_roll_ratio"), "0.5");
  assert((await text()).includes("slide_to_roll_ratio = 0.5 "));

  // Another kind, materials, oil and heat by the form: each is a case that can be solved.
  const fine = () => run("!document.getElementById('solve').disabled");
  for (const kind of ["line", "elliptical", "roller", "circular"]) {
    await type(field("contact.kind"), kind, "change");
    assert(await fine(), `${kind}\n${await text()}`);
  }
  const choose = async (label, value) => {
    const box = `[...document.querySelectorAll('.field:not([hidden])')].find((one) => one.querySelector('label').textContent === ${JSON.stringify(label)}).querySelector('select')`;
    await type(box, value, "change");
    assert(await fine(), `${label} ${value}\n${await text()}\n${await run("document.getElementById('case-state').textContent")}`);
  };
  for (const oil of ["squalane-pip", "sheet:", "own:"]) await choose("Lubricant", oil);
  for (const way of ["speeds", "entrainment"]) await choose("Given by", way);
  for (const load of ["hertz_pressure", "load"]) await choose("Load given by", load);
  for (const material of ["glass", ""]) await choose("Body 1 (plane, disc)", material);

  // Bad input: the words of the program, at the field.
  await type("document.getElementById('example')", "0", "change");
  const bad = [
    ["contact.radius", "16", '"16 mm"', '"16"'],
    ["contact.load", "100 mm", '"100 N"', '"100 mm"'],
    ["motion.slide_to_roll_ratio", "much", "= 0.0 ", '= "much" '],
    ["lubricant.viscosity.mu_0", "-40 mPa.s", '"40 mPa.s"', '"-40 mPa.s"'],
  ];
  for (const [key, value, from, to] of bad) {
    await type("document.getElementById('case')", disc);
    await until(`${field("contact.radius")}.value === "16 mm" && !document.getElementById('solve').disabled`);
    await type(field(key), value);
    assert.equal(await text(), disc.replace(from, to));
    const native = nativeMessage(disc.replace(from, to));
    assert.equal(await run("document.querySelector('#case-state .message').textContent"), `error: ${native}`);
    const shown = await run(`document.querySelector('.field[data-key="${key}"] .error:not([hidden])')?.textContent`);
    assert.equal(shown?.split("\n")[0], native.split("\n")[0], `${key}: ${shown}`);
    assert.equal(await run(`${field(key)}.getAttribute('aria-invalid')`), "true");
    assert(!(await fine()));
    if (key === "contact.radius") await picture("bad-1280");
  }
  console.log(`${bad.length} bad values: the words of the program at the field`);

  // Stopped in the middle, and solved again.
  await type("document.getElementById('case')", disc);
  await until("!document.getElementById('solve').disabled");
  await run("document.getElementById('solve').click()");
  await until("document.getElementById('iterations').rows.length > 0", 600);
  await run("document.getElementById('stop').click()");
  assert.equal(await run("document.getElementById('status').textContent"), "Stopped; nothing was kept.");
  assert.equal(await solve(), "yes");
  console.log(`ball on disc in the page: ${await run("document.getElementById('status').textContent")}`);
  await picture("ball-1280", ".actions");
  await show(390);
  await until("document.querySelector('#plot svg').viewBox.baseVal.width < 390");
  assert((await run("document.documentElement.scrollWidth")) <= 390, "wider than 390 pixels");
  await picture("form-390");
  await picture("ball-390", ".actions");
  await show(390, { dark: true });
  await picture("dark-390", ".actions");
  await show(1280, { dark: true });
  await picture("dark-1280");

  // Every field has a label; nothing was asked of any other place, and nothing was said on the console.
  const unnamed = await run("[...document.querySelectorAll('input:not([hidden]), select, textarea')].filter((one) => one.labels.length === 0).map((one) => one.id)");
  assert.deepEqual(unnamed, []);
  const known = new Set(["index.html", "frame.html", "style.css", "page.js", "form.js", "fields.js", "progress.js", "result.js", "ertel.js", "worker.js", "ertel.wasm"]);
  assert.deepEqual(requests.filter((name) => !known.has(name)), []);
  assert.deepEqual(foreign, []);
  assert.deepEqual(problems, []);
  console.log(`no errors on the console, ${requests.length} requests, all for the page itself; pictures in ${PICTURES}`);
} finally {
  const ended = new Promise((done) => chromium.once("exit", done));
  chromium.kill();
  await ended;
  server.close();
  for (const folder of [profile, downloads]) await remove(folder);
}
