// The native program, to compare with.

import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("../../../", import.meta.url));
export const TARGET = process.env.CARGO_TARGET_DIR ?? join(ROOT, "target");
const PROGRAM = process.env.ERTEL ?? join(TARGET, "release/ertel");

function inFolder(text, action) {
  const folder = mkdtempSync(join(tmpdir(), "ertel-web-"));
  try {
    writeFileSync(join(folder, "case.toml"), text);
    return action(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** result.json of the program. */
export function nativeResult(text) {
  return inFolder(text, (folder) => {
    const output = join(folder, "result");
    execFileSync(PROGRAM, ["solve", "case.toml", "--quiet", "--output", output], { cwd: folder, stdio: ["ignore", "ignore", "ignore"] });
    return JSON.parse(readFileSync(join(output, "result.json"), "utf8"));
  });
}

/** The program's message about a refused case; empty if it is accepted. */
export function nativeMessage(text) {
  return inFolder(text, (folder) => {
    const { status, stderr } = spawnSync(PROGRAM, ["solve", "--check", "case.toml"], { cwd: folder, encoding: "utf8" });
    return status === 0 ? "" : stderr.slice(stderr.indexOf("error: ") + "error: ".length).trimEnd();
  });
}

/** Parts of a result that may differ more, relative. All others agree to 1e-9. */
const CLASSES = [
  // Times and iterations.
  { name: "effort", of: (path) => /^\.(stats|history)\b/.test(path), tolerance: Infinity },
  // Distances of places on two meshes, the coarser of which is not solved to the end: 7e-6 of the half-width was seen.
  { name: "error bars of places", of: (path) => /\.place_error$/.test(path), scale: (result) => result.hertz.half_width, tolerance: 1e-4 },
  // Adjoints that weigh errors are solved to 1e-4, and what they weigh are small differences: 6.8e-3 was seen.
  { name: "error bars", of: (path) => /error$/.test(path) && !/balance_error$|^\.checks\b/.test(path), tolerance: 2e-2 },
  // Small differences of large numbers: compared with 1. The mass balance is the remainder of Newton's method: 3.6e-9 was seen.
  { name: "balances", of: (path) => /balance_error$|^\.checks\.(power|rolling)\.error$|^\.formulas\.\d+\.difference_|^\.film_reduction\..*\.value$/.test(path), scale: () => 1, tolerance: 1e-8 },
  // Where a film or pressure is extreme it is flat: 1e-15 of the value is 3e-8 of the half-width.
  { name: "places", of: (path) => /^\.(summary|figures)\..*\.[xyz]$/.test(path), scale: (result) => result.hertz.half_width, tolerance: 1e-6 },
  // By linear solves with their own tolerance; relative to 1, a power law. 3e-5 was seen.
  { name: "sensitivities", of: (path) => /^\.sensitivities(_per_kelvin)?\b/.test(path), scale: () => 1, tolerance: 2e-4 },
  // At the edge of the steepest rise of pressure, what Newton's method leaves (a residual of 1e-8) is largest: 1.6e-9 was seen; it counts in what
  // finite volumes dissipate, 1.3e-9 was seen.
  { name: "extremes", of: (path) => /^\.checks\.power\.other$|^\.(summary|figures)\.pressure_spike\.value$|^\.(traction|figures)\.shear_stress_maximum\.value$/.test(path), tolerance: 1e-8 },
  { name: "figures", of: () => true, tolerance: 1e-9 },
];

/** The largest difference between two results in each class: `{ name: { value, path, tolerance } }`. */
export function differences(one, other) {
  const worst = Object.fromEntries(CLASSES.map(({ name, tolerance }) => [name, { value: 0, path: "", tolerance }]));
  const visit = (a, b, path) => {
    const both = [a, b];
    if (both.every((side) => side !== null && typeof side === "object")) {
      for (const key of new Set(both.flatMap(Object.keys))) visit(a[key], b[key], `${path}.${key}`);
      return;
    }
    const { name, scale } = CLASSES.find(({ of }) => of(path));
    let value = Object.is(a, b) ? 0 : Infinity;
    if (value > 0 && both.every((side) => typeof side === "number")) {
      value = Math.abs(a - b) / Math.max(scale ? scale(other) : 0, Math.abs(a), Math.abs(b));
    }
    if (!(value <= worst[name].value)) Object.assign(worst[name], { value, path });
  };
  visit(one, other, "");
  return worst;
}

/** Differences in words, and an error where one is too large. */
export function agreed(one, other) {
  const found = Object.entries(differences(one, other)).filter(([name]) => name !== "effort");
  const words = found.map(([name, { value, path }]) => `${name} ${value.toExponential(1)}${value > 0 ? ` (${path.slice(1)})` : ""}`).join(", ");
  for (const [name, { value, path, tolerance }] of found) {
    if (!(value <= tolerance)) throw new Error(`${name}: ${path} differs by ${value}, and ${tolerance} is allowed\n${words}`);
  }
  return words;
}
