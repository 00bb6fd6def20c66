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
    execFileSync(PROGRAM, ["solve", "case.toml", "--quiet", "--no-cache", "--output", output], { cwd: folder });
    return JSON.parse(readFileSync(join(output, "result.json"), "utf8"));
  });
}

/** What the program says of a case that it refuses; empty where it takes it. */
export function nativeMessage(text) {
  return inFolder(text, (folder) => {
    const { status, stderr } = spawnSync(PROGRAM, ["solve", "--check", "case.toml"], { cwd: folder, encoding: "utf8" });
    return status === 0 ? "" : stderr.slice(stderr.indexOf("error: ") + "error: ".length).trimEnd();
  });
}

/** Figures of a result that must agree: all but those of the effort. */
const EFFORT = new Set(["stats", "history"]);

/**
 * The largest difference between two results, relative, but for numbers that are themselves small differences (balances and error
 * bars): these are compared beside the figure that they belong to.
 */
export function difference(one, other, path = "", scale = 0) {
  if (typeof one === "number" && typeof other === "number") {
    const size = Math.max(Math.abs(one), Math.abs(other), scale);
    return { value: size === 0 ? 0 : Math.abs(one - other) / size, path };
  }
  if (one !== null && other !== null && typeof one === "object" && typeof other === "object") {
    const keys = new Set([...Object.keys(one), ...Object.keys(other)]);
    let worst = { value: 0, path };
    for (const key of keys) {
      if (path === "" && EFFORT.has(key)) continue;
      const own = Math.abs(typeof one.value === "number" ? one.value : 0);
      const beside = /balance_error$/.test(key) ? 1 : own;
      const found = difference(one[key], other[key], `${path}.${key}`, beside);
      if (!(found.value <= worst.value)) worst = found;
    }
    return worst;
  }
  return { value: Object.is(one, other) ? 0 : Infinity, path };
}
