// The ticks of the axes of a page, over many ranges: they end, lie on the axis, and their labels say where they are.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { readLabel } from "./pages.mjs";

const ASSETS = join(process.env.CASES, "../crates/ertel/src/output/html/assets");
const source = readFileSync(join(ASSETS, "axis.js"), "utf8");
const { axisEnds, axisTicks, ticksOver, withRoom } = new Function(`${source}; return { axisEnds, axisTicks, ticksOver, withRoom };`)();

function check({ values, labels }, low, high, log, most = 12) {
  const what = `${log ? "log" : "linear"} ${low} to ${high}: ${labels}`;
  assert.ok(values.length >= 2 && values.length <= most, what);
  assert.equal(values.length, labels.length);
  values.forEach((v, i) => {
    assert.ok(Number.isFinite(v) && v >= low && v <= high, what);
    assert.ok(i === 0 || v > values[i - 1], what);
    assert.equal(readLabel(labels[i]), v, what);
  });
  assert.equal(new Set(labels).size, labels.length, what);
}

// Random numbers that are the same in every run (mulberry32).
function generator(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

describe("axes", () => {
  const random = generator(35);
  const between = (low, high) => low + (high - low) * random();
  test("linear ticks of 20,000 ranges", () => {
    for (let n = 0; n < 20000; n++) {
      const middle = (random() < 0.5 ? -1 : 1) * 10 ** between(-200, 200) * (random() < 0.2 ? 0 : 1);
      const length = middle === 0 ? 10 ** between(-200, 200) : Math.abs(middle) * 10 ** between(-9, 3);
      const [low, high] = [middle - length * random(), middle + length * between(0.01, 1)];
      check(axisTicks(low, high), low, high, false);
    }
  });
  test("logarithmic ticks of 20,000 ranges", () => {
    for (let n = 0; n < 20000; n++) {
      const low = 10 ** between(-200, 200);
      const high = low * 10 ** (10 ** between(-8, 1.7));
      check(axisTicks(low, high, { log: true }), low, high, true);
    }
  });
  // The range of a shipped curve: an axis from 0.1 over 1.05, and the like.
  test("logarithmic axes that begin at round numbers over a little room", () => {
    for (let power = -12; power <= 12; power++) {
      for (const lead of [1, 2, 5]) {
        for (const room of [1, 1.05, 1.1]) {
          for (const ratio of [1.001, 2, 10, 60, 1e3, 1e9]) {
            const [low, high] = [lead * 10 ** power / room, lead * 10 ** power * ratio * room];
            if (high > low) check(axisTicks(low, high, { log: true }), low, high, true);
          }
        }
      }
    }
  });
  test("whatever the ends are, there is an axis", () => {
    const odd = [NaN, Infinity, -Infinity, undefined, null, 0, -0, 5e-324, -5e-324, 1e308, -1e308, 1, -1, 1 + 1e-15, 3, "a"];
    for (const log of [false, true]) {
      for (const p of odd) {
        for (const q of odd) {
          for (const [low, high] of [axisEnds(p, q, log), withRoom(p, q, log)]) {
            assert.ok(Number.isFinite(low) && Number.isFinite(high) && low < high && (!log || low > 0), `${p} to ${q}: ${low} to ${high}`);
            check(axisTicks(low, high, { log }), low, high, log);
          }
          axisTicks(p, q, { log });
        }
      }
    }
  });
  test("ends in the wrong order are put in order", () => {
    assert.deepEqual(axisEnds(3, -2), [-2, 3]);
    assert.deepEqual(axisTicks(3, -2), axisTicks(-2, 3));
  });
  test("ticks are the round numbers that one draws by hand", () => {
    assert.deepEqual(axisTicks(0, 1.1, { most: 6 }).labels, ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    assert.deepEqual(axisTicks(-1, 1, { most: 5 }).labels, ["−1.0", "−0.5", "0", "0.5", "1.0"]);
    assert.deepEqual(axisTicks(0, 2.4e7, { most: 6 }).labels, ["0", "5·10⁶", "10⁷", "1.5·10⁷", "2·10⁷"]);
    assert.deepEqual(axisTicks(0.095, 63, { log: true }).labels, ["0.1", "0.2", "0.5", "1", "2", "5", "10", "20", "50"]);
    assert.deepEqual(axisTicks(1e-12, 3, { log: true, most: 7 }).labels, ["10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "1"]);
  });
  test("labels keep apart on narrow plots", () => {
    for (let n = 0; n < 3000; n++) {
      const log = random() < 0.5;
      const low = log ? 10 ** between(-6, 6) : between(-1e4, 1e4);
      const high = log ? low * 10 ** between(0.01, 8) : low + 10 ** between(-3, 4);
      const pixels = between(180, 900);
      const { values, labels } = ticksOver(low, high, pixels, { log });
      const at = (v) => pixels * (log ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low));
      if (values.length > 2) for (let i = 1; i < values.length; i++) assert.ok(at(values[i]) - at(values[i - 1]) > 3.5 * (labels[i].length + labels[i - 1].length), labels.join(" "));
      check({ values, labels }, low, high, log);
    }
  });
  test("values have room, and axes begin at zero where the values do", () => {
    assert.deepEqual(withRoom(0, 1), [0, 1.05]);
    assert.deepEqual(withRoom(-2, 0), [-2.1, 0]);
    assert.ok(withRoom(3, 3)[0] < 3 && withRoom(3, 3)[1] > 3);
  });
});

// Names of columns: without the unit of the title.
describe("columns", () => {
  const read = (name) => readFileSync(join(ASSETS, name), "utf8");
  const { describeColumn, unitOf } = new Function(`${read("units.js")}${read("table.js")}; return { describeColumn, unitOf };`)();
  for (const [title, words, unit, shown] of [
    ["lubricant.viscosity.alpha_1_per_Pa", "alpha", "1/Pa", "1/GPa"],
    ["lubricant.density.beta_1_per_K", "beta", "1/K", "1/K"],
    ["lubricant.thermal_conductivity_W_per_(m_K)", "thermal conductivity", "W/(m K)", "W/(m K)"],
    ["shear_rate_1_per_s", "shear rate", "1/s", "1/s"],
    ["film_central_m", "central film", "m", "nm"],
  ]) {
    test(title, () => {
      const column = describeColumn(title);
      assert.deepEqual([column.words, column.unit, unitOf(column.unit, 2e-8).name], [words, unit, shown]);
    });
  }
});
