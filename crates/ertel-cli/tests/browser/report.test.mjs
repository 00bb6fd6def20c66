// The pages of results in a real browser: they load nothing, say nothing on the console, are accessible, and read what result.json holds.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { CASES, ERTEL, SCREENSHOTS, checkPlots, launch, openPage } from "./pages.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const folder = mkdtempSync(join(tmpdir(), "ertel-pages-"));
const MOST_BYTES = 2e6;

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

function run(...args) { return execFileSync(ERTEL, args, { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }); }

function solve(name, command = "solve", settings = []) {
  const output = join(folder, name);
  const set = settings.flatMap((one) => ["--set", one]);
  // Some points of the study slide without a limit of stress: their traction is not resolved.
  run(command, join(CASES, `${name}.toml`), "--output", output, "--quiet", "--accept-unresolved", ...set);
  return output;
}

const open = (file, look) => openPage(browser, file, look);

async function violations(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  return found.violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(" ")).join("; ")}`);
}

// A page at both widths, light and dark.
async function lookAt(name, file) {
  assert.ok(statSync(file).size < MOST_BYTES, `${name}: ${statSync(file).size} bytes`);
  for (const width of [1280, 390]) {
    for (const dark of [false, true]) {
      const page = await open(file, { width, dark });
      await checkPlots(page, `${name} at ${width}`);
      assert.deepEqual(page.troubles, [], name);
      // No table is cut off where the page is narrow.
      const cut = await page.$$eval(".scroll", (boxes) => boxes.filter((b) => b.scrollWidth > b.clientWidth + 1).map((b) => b.ariaLabel));
      assert.ok(width > 390 || cut.length === 0, `${name} at ${width}: ${cut}`);
      // Nor is one of sensitivities or formulas on a wide one.
      const inner = await page.$$eval("#sensitivities .scroll, #results .scroll, #formulas .scroll", (all) => all.filter((b) => b.scrollWidth > b.clientWidth + 1).length);
      assert.equal(inner, 0, `${name} at ${width}: ${inner} tables are cut off`);
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.ok(overflow <= 0, `${name} at ${width}: ${overflow} px too wide`);
      assert.deepEqual(await violations(page), [], `${name} at ${width}, ${dark ? "dark" : "light"}`);
      await page.screenshot({ path: join(SCREENSHOTS, `${name}-${width}${dark ? "-dark" : ""}.png`), fullPage: true });
      await page.close();
    }
  }
}

function close(actual, expected, tolerance, what) {
  assert.ok(Math.abs(actual / expected - 1) < tolerance, `${what}: ${actual} is not ${expected}`);
}

// Values at the cursor, and the card of the figure.
async function reads(page, figure, field, value, tolerance) {
  await page.click(`button[data-figure="${figure}"]`);
  const read = await page.$eval("#reading", (e) => JSON.parse(e.dataset.values)[0]);
  close(read[field], value, tolerance, `${figure} under the cursor`);
}

// The shipped ellipse is at an angle and takes minutes.
const COARSE = ["mesh.target_error=2 %", "contact.entrainment_angle=0 deg"];
for (const [name, kind, settings] of [["ball-on-disc", "circular", []], ["ball-in-groove", "elliptical", COARSE], ["squalane-thermal", "thermal"]]) {
  describe(kind, () => {
    let output;
    let result;
    before(() => {
      output = solve(name, "solve", settings);
      result = JSON.parse(readFileSync(join(output, "result.json"), "utf8"));
    });
    test("looks right and is accessible", () => lookAt(kind, join(output, "report.html")));
    test("the cursor reads the figures of result.json", async () => {
      const page = await open(join(output, "report.html"));
      const { summary } = result;
      await reads(page, "film_central", "film_thickness", summary.film_central.value, 1e-6);
      // The page draws finite volumes by lines between nodes, and the figure is the vertex of parabolas through them.
      const { value, error } = summary.film_minimum;
      await reads(page, "film_minimum", "film_thickness", value, result.stats.method === "finite-volumes" ? Math.max(error / value, 5e-3) : 1e-6);
      // On the flank of the pressure ridge a coordinate in single precision counts for more.
      await reads(page, "pressure_maximum", "pressure", summary.pressure_maximum.value, 1e-4);
      assert.deepEqual(page.troubles, []);
      await page.close();
    });
    test("arrow keys move the cursor, and profiles can be copied", async () => {
      const page = await open(join(output, "report.html"));
      await page.click('button[data-figure="film_central"]');
      await page.focus(".map canvas");
      await page.keyboard.press("ArrowRight");
      // Slender contacts lie on their side: y to the right.
      const cursor = await page.$$eval("#cursor-x, #cursor-y", (inputs) => inputs.map((e) => e.value));
      assert.deepEqual(cursor.sort(), ["0", "0.01"]);
      const csv = await page.evaluate(() => {
        let text = "";
        Object.defineProperty(navigator, "clipboard", { value: { writeText: (t) => { text = t; return Promise.resolve(); } } });
        document.querySelector('[data-copy="along"]').click();
        return text;
      });
      const [head, ...rows] = csv.trim().split("\n");
      assert.match(head, /^"x\/a"/);
      assert.equal(rows.length, 801);
      await page.close();
    });
  });
}

describe("figures", () => {
  // The same pairs as in the tests of the program's own report (output/figure.rs).
  test("have the digits that their bars leave certain", () => {
    const source = readFileSync(join(CASES, "../crates/ertel/src/output/html/assets/units.js"), "utf8");
    const withBar = new Function(`${source}; return withBar;`)();
    for (const [value, error, text] of [
      [249.19, 0.34, "249.19 ± 0.34"], [1.0623, 0.05, "1.06 ± 0.05"], [1.2345, 0.0123, "1.234 ± 0.012"],
      [1.0623, 0.097, "1.06 ± 0.10"], [12345, 2345, "12300 ± 2300"], [12345, 678, "12300 ± 700"],
    ]) assert.equal(withBar(value, error, ""), text);
  });
});

describe("line", () => {
  let output;
  before(() => { output = solve("roller"); });
  test("looks right and is accessible", () => lookAt("line", join(output, "report.html")));
  test("has profiles and no map", async () => {
    const page = await open(join(output, "report.html"));
    assert.equal(await page.$eval("#contact", (e) => e.hidden), true);
    assert.equal(await page.$eval("#profile canvas", (e) => e.width > 300), true);
    await page.close();
  });
});

for (const [name, command] of [["ball-on-disc-speeds", "solve"], ["speeds-and-loads", "sweep"]]) {
  describe(command === "solve" ? "curve" : "study", () => {
    let output;
    before(() => { output = solve(name, command); });
    test("looks right and is accessible", () => lookAt(command === "solve" ? "curve" : "study", join(output, "report.html")));
    test("the table sorts, and holds every point", async () => {
      const page = await open(join(output, "report.html"));
      const table = readFileSync(join(output, command === "solve" ? "curve.csv" : "results.csv"), "utf8").trim().split("\n");
      const film = table[0].split(",").indexOf("film_central_m");
      const films = table.slice(1).map((row) => Number(row.split(",")[film])).sort((p, q) => q - p);
      const shown = () => page.$$eval("#table tbody tr", (rows) => rows.map((r) => Number(r.dataset.row)));
      assert.equal((await shown()).length, films.length);
      const button = await page.evaluateHandle(() => [...document.querySelectorAll("#table thead button")].find((b) => b.textContent.startsWith("Central film")));
      await button.click();
      const again = await page.evaluateHandle(() => [...document.querySelectorAll("#table thead button")].find((b) => b.textContent.startsWith("Central film")));
      await again.click();
      const order = await shown();
      assert.deepEqual(order.map((i) => Number(table[i + 1].split(",")[film])), films);
      await page.close();
    });
  });
}

describe("several results", () => {
  test("are shown side by side with their differences", async () => {
    const results = ["ball-on-disc", "ball-in-groove"].map((name) => join(folder, name));
    const file = join(folder, "view.html");
    run("view", ...results, "--output", file, "--no-browser");
    await lookAt("view", file);
    const page = await open(file);
    assert.equal((await page.$$(".map")).length, 3);
    await page.close();
  });
  test("are equal to themselves", async () => {
    const file = join(folder, "same.html");
    const one = join(folder, "ball-on-disc");
    run("view", one, one, "--output", file, "--no-browser");
    const page = await open(file);
    const [a, b] = await page.$eval("#reading", (e) => JSON.parse(e.dataset.values));
    assert.deepEqual(a, b);
    await page.close();
  });
});
