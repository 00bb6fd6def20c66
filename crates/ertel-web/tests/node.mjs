// The module in node against the native program: figures to 1e-9 on equal meshes, messages to the letter, times, size.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { start } from "../page/ertel.js";
import { ROOT, TARGET, agreed, nativeMessage, nativeResult } from "./native.mjs";

const bytes = readFileSync(join(TARGET, "web/ertel.wasm"));
console.log(`ertel.wasm: ${bytes.length} bytes, ${gzipSync(bytes, { level: 9 }).length} compressed`);
const module = await WebAssembly.compile(bytes);

/** Solves a case in the module and in the program. */
async function both(name, text) {
  const ertel = await start(module);
  let iterations = 0;
  const [began, before] = [performance.now(), process.cpuUsage()];
  const answer = ertel.solve(text, ({ event }) => { iterations += event === "iteration"; });
  const wall = (performance.now() - began) / 1000;
  // On a busy machine time of the processor says more.
  const seconds = Math.min(wall, process.cpuUsage(before).user / 1e6);
  assert(answer.ok, JSON.stringify(answer.error));
  const file = (wanted) => answer.files.find((one) => one.name === wanted).text;
  assert(file("report.txt").includes("central film thickness"));
  assert.equal(file("case.toml"), text);
  assert(iterations > 3);
  const [own, native] = [JSON.parse(file("result.json")), nativeResult(text)];
  console.log(`${name}: ${wall.toFixed(2)} s in WebAssembly (${seconds.toFixed(2)} s of a processor), ${native.stats.wall_seconds.toFixed(2)} s in the program; ` +
    `${iterations} Newton iterations; ${(ertel.memory() / 1e6).toFixed(0)} MB`);
  return { own, native, seconds };
}

function inTime(name, seconds, allowed) {
  if (process.env.ERTEL_WEB_TIMES) assert(seconds < allowed, `${name} took ${seconds} s, and ${allowed} are allowed`);
}

const read = (name) => readFileSync(join(ROOT, `cases/${name}.toml`), "utf8");
{
  const { own, native, seconds } = await both("roller", read("roller"));
  console.log(`  ${agreed(own, native)}`);
  inTime("roller", seconds, 1);
}
{
  // On a mesh that is laid down: every figure.
  const { own, native } = await both("ball-on-disc on the mesh of a preset", `${read("ball-on-disc")}\n[mesh]\npreset = "normal"\n[solver]\nmethod = "finite-elements"\nerror_estimate = false\n`);
  console.log(`  ${agreed(own, native)}`);
}
{
  // Refined where adjoints of the films ask for it: the same elements.
  const { own, native } = await both("ball-on-disc by finite elements", `${read("ball-on-disc")}\n[solver]\nmethod = "finite-elements"\n`);
  console.log(`  ${agreed(own, native)}`);
}
{
  // By finite volumes, the default method of this case.
  const { own, native, seconds } = await both("ball-on-disc", read("ball-on-disc"));
  console.log(`  ${agreed(own, native)}`);
  inTime("ball-on-disc", seconds, 10);
}

/** Names and texts of the cases that the program must refuse: files, and the base case of `cases.txt` with its changes. */
function badCases(folder) {
  const files = readdirSync(folder).filter((name) => name.endsWith(".toml"));
  const cases = files.map((name) => [name, readFileSync(join(folder, name), "utf8")]);
  const [base, ...others] = readFileSync(join(folder, "cases.txt"), "utf8").split("\n== ").slice(1);
  for (const [name, ...changes] of others.map((other) => other.split("\n"))) {
    const lines = base.split("\n").slice(1).filter((line) => line !== "");
    let at = lines.length;
    for (const change of changes) {
      const text = change.slice(2);
      if (change.startsWith("- ")) lines.splice((at = lines.indexOf(text)), 1);
      else if (change.startsWith("@ ")) at = lines.indexOf(text) + 1;
      else if (change.startsWith("+ ")) lines.splice(at++, 0, text);
    }
    cases.push([name, `${lines.join("\n")}\n`]);
  }
  return cases;
}

// The page refuses the same cases as the program, with the same words. Files next to the case do not exist in a browser.
const folder = join(ROOT, "crates/ertel-cli/tests/bad");
const ertel = await start(module);
let compared = 0;
const others = [];
for (const [name, text] of badCases(folder)) {
  const native = nativeMessage(text);
  const { ok, error } = ertel.check(text);
  if (native === "" && ok) continue;
  if (/\.(csv|toml|sdf|x3p|txt|xyz)"/.test(text)) continue;
  compared += 1;
  if (ok || error.text !== native) others.push(`${name}\n  program: ${native}\n  module:  ${ok ? "takes it" : error.text}`);
}
console.log(`${compared} bad case files: ${compared - others.length} with the words of the program`);
assert(compared > 100 && others.length === 0, others.join("\n"));

