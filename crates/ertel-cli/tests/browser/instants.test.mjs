// The slider of a case in time: it shows the films of transient.json, by pointer, keyboard and on its own, and prints the last instant.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { CASES, ERTEL, SCREENSHOTS, checkPlots, launch, openPage } from "./pages.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const folder = mkdtempSync(join(tmpdir(), "ertel-instants-"));

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

const shownTime = (page) => page.$eval("#instant-time", (e) => e.textContent);
// The film in the middle as the chart has it, in its unit.
const middle = (page) => page.evaluate(() => {
  let text = "";
  Object.defineProperty(navigator, "clipboard", { value: { writeText: (t) => { text = t; return Promise.resolve(); } }, configurable: true });
  document.querySelector('[data-copy="instant-profile"]').click();
  const rows = text.trim().split("\n").slice(1).map((row) => row.split(",").map(Number));
  return rows.reduce((best, row) => (Math.abs(row[0]) < Math.abs(best[0]) ? row : best))[1];
});

for (const [name, settings] of [["waves", ["mesh.target_error=5 %"]], ["speed-ramp", ["mesh.target_error=10 %"]]]) {
  describe(name, () => {
    let output;
    let result;
    before(() => {
      output = join(folder, name);
      const set = settings.flatMap((one) => ["--set", one]);
      execFileSync(ERTEL, ["solve", join(CASES, `${name}.toml`), "--output", output, "--quiet", "--accept-unresolved", ...set], { stdio: "ignore" });
      result = JSON.parse(readFileSync(join(output, "transient.json"), "utf8"));
    });
    const page = (look) => openPage(browser, join(output, "report.html"), look);

    test("looks right and is accessible", async () => {
      assert.ok(statSync(join(output, "report.html")).size < 2e6);
      for (const width of [1280, 390]) {
        for (const dark of [false, true]) {
          const own = await page({ width, dark });
          await checkPlots(own, `${name} at ${width}`);
          assert.deepEqual(own.troubles, []);
          const overflow = await own.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
          assert.ok(overflow <= 0, `${overflow} px too wide`);
          await own.evaluate(axe);
          const found = await own.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
          assert.deepEqual(found.violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(" "))}`), []);
          await own.screenshot({ path: join(SCREENSHOTS, `${name}-${width}${dark ? "-dark" : ""}.png`), fullPage: true });
          await own.close();
        }
      }
    });

    test("shows the films of each instant by keyboard", async () => {
      const own = await page();
      const last = result.instants.at(-1);
      const films = (instant) => instant.figures.film_central.value * 1e9;
      assert.ok(Math.abs(parseFloat(await shownTime(own)) / (last.time * (/ms/.test(await shownTime(own)) ? 1e3 : 1e6)) - 1) < 1e-3);
      // To 1 %: a figure is read between the nodes that the page has.
      assert.ok(Math.abs(await middle(own) / films(last) - 1) < 0.01, `${await middle(own)} is not ${films(last)}`);
      await own.focus("#instant");
      await own.keyboard.press("Home");
      assert.match(await shownTime(own), /^0 /);
      assert.ok(Math.abs(await middle(own) / films(result.instants[0]) - 1) < 0.01);
      await own.keyboard.press("ArrowRight");
      assert.doesNotMatch(await shownTime(own), /^0 /);
      assert.equal(await own.$eval("#instant", (e) => e.getAttribute("aria-valuetext")), await shownTime(own));
      assert.match(await own.$eval("#instant-caption", (e) => e.textContent), new RegExp(`t = ${await shownTime(own)}`));
      await own.close();
    });

    test("plays, stops, and prints the last instant", async () => {
      const own = await page();
      const last = await shownTime(own);
      await own.focus("#play");
      await own.keyboard.press("Enter");
      await own.waitForFunction(() => Number(document.getElementById("instant").value) > 1);
      await own.keyboard.press("Enter");
      const at = await shownTime(own);
      assert.notEqual(at, last);
      await new Promise((done) => setTimeout(done, 800));
      assert.equal(await shownTime(own), at);
      assert.equal(await own.$eval("#play", (e) => e.textContent), "Play");
      await own.evaluate(() => dispatchEvent(new Event("beforeprint")));
      assert.equal(await shownTime(own), last);
      await own.evaluate(() => dispatchEvent(new Event("afterprint")));
      assert.equal(await shownTime(own), at);
      assert.deepEqual(own.troubles, []);
      await own.close();
    });
  });
}
