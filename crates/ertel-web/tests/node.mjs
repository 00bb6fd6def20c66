// The module in node against the native program: figures to 1e-9, messages to the letter, times, size.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { start } from "../page/ertel.js";
import { ROOT, TARGET, difference, nativeMessage, nativeResult } from "./native.mjs";

const TOLERANCE = 1e-9;
/** Seconds that a case may take. */
const CASES = [["roller", 1], ["ball-on-disc", 10]];

const bytes = readFileSync(join(TARGET, "web/ertel.wasm"));
console.log(`ertel.wasm: ${bytes.length} bytes, ${gzipSync(bytes, { level: 9 }).length} compressed`);
const module = await WebAssembly.compile(bytes);

for (const [name, allowed] of CASES) {
  const text = readFileSync(join(ROOT, `cases/${name}.toml`), "utf8");
  const ertel = await start(module);
  let iterations = 0;
  const began = performance.now();
  const answer = ertel.solve(text, ({ event }) => { iterations += event === "iteration"; });
  const seconds = (performance.now() - began) / 1000;
  assert(answer.ok, JSON.stringify(answer.error));
  const file = (wanted) => answer.files.find((one) => one.name === wanted).text;
  const result = JSON.parse(file("result.json"));
  const native = nativeResult(text);
  const worst = difference(result, native);
  const megabytes = (ertel.memory() / 1e6).toFixed(0);
  console.log(`${name}: ${seconds.toFixed(2)} s in WebAssembly, ${native.stats.wall_seconds.toFixed(2)} s native; ${iterations} Newton iterations; ` +
    `${megabytes} MB; largest difference ${worst.value.toExponential(1)} at ${worst.path}`);
  assert(iterations > 3);
  assert(worst.value <= TOLERANCE, `${name}: ${worst.path} differs by ${worst.value}`);
  assert(file("report.txt").includes("central film thickness"));
  assert(file("case.toml") === text);
  if (!process.env.ERTEL_WEB_ANY_TIME) assert(seconds < allowed, `${name} took ${seconds} s`);
}

// What the program refuses, the page refuses with the same words. Files beside the case are not there in a browser.
const folder = join(ROOT, "crates/ertel-cli/tests/bad");
const ertel = await start(module);
let compared = 0;
const others = [];
for (const name of readdirSync(folder).filter((one) => one.endsWith(".toml"))) {
  const text = readFileSync(join(folder, name), "utf8");
  const native = nativeMessage(text);
  const { ok, error } = ertel.check(text);
  if (native === "" && ok) continue;
  if (/\.(csv|toml)"/.test(text)) continue;
  compared += 1;
  if (ok || error.text !== native) others.push(`${name}\n  program: ${native}\n  module:  ${ok ? "takes it" : error.text}`);
}
console.log(`${compared} bad case files: ${compared - others.length} with the words of the program`);
assert(compared > 100 && others.length === 0, others.join("\n"));

// A panic stops a module, not the page: the message comes back.
assert.equal((await start(module)).check("[contact]\nkind = ").ok, false);
