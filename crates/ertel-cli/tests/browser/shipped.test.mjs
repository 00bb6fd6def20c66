// The page of every shipped case, curve and study: each plot has lines, true ticks and values under the cursor.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { after, before, describe, test } from "node:test";
import { CASES, ERTEL, SCREENSHOTS, checkPlots, launch, openPage } from "./pages.mjs";

const folder = mkdtempSync(join(tmpdir(), "ertel-shipped-"));
const cases = join(folder, "cases");

// The cases as shipped, but for what takes time: meshes are coarse, and of curves three points are left, of the axes of studies two, the
// ends among them, so that plots have the same axes.
const COARSE = ["mesh.target_error=10 %", "output.sensitivities=false"];

function thin(text) {
  const isStudy = kindOf(text) === "study";
  const ends = (_, head, list) => {
    const values = list.split(",").map((v) => v.trim());
    return `${head}[${[values[0], ...(isStudy ? [] : [values[values.length >> 1]]), values[values.length - 1]].join(", ")}]`;
  };
  return text.replace(/^(key = "mesh\.target_error"\s+values\s*=\s*)\[[^\]]*\]/gm, "$1[0.1]").replace(/^(values\s*=\s*)\[((?:[^,\]]*,){3,}[^\]]*)\]/gm, ends).replace(/^(points\s*=\s*)\d+/gm, isStudy ? "$12" : "$13");
}

function kindOf(text) {
  if (/^\[\[axis\]\]/m.test(text)) return "study";
  // A case in time has a table of its instants.
  if (/^\[(curve|transient)\]/m.test(text)) return "curve";
  // A whole machine has a table of its contacts.
  return /^(designation|position = "path"|angle = "turn")/m.test(text) ? "machine" : "contact";
}

// The coarse settings that a case, or the base of a study, accepts: an axis over one of them has its own, and a mesh by a preset has no target.
function coarse(own) {
  const base = /^case = "([^"]+)"/m.exec(own);
  const text = base ? `${own}\n${readFileSync(join(cases, base[1]), "utf8")}` : own;
  if (/^preset/m.test(text)) return COARSE.slice(1);
  // Finite volumes alone solve for time and reliefs, and know no error of the pressure.
  if (/^\[transient\]|^\[\[surface\]\]/m.test(text)) return [COARSE[0], COARSE[1]];
  return /^key = "mesh\.target_error"/m.test(text) ? COARSE.slice(1) : COARSE;
}

cpSync(CASES, cases, { recursive: true });
const files = ["", "machine"].flatMap((under) => readdirSync(join(cases, under)).filter((f) => f.endsWith(".toml")).map((f) => join(under, f)));
for (const file of files) writeFileSync(join(cases, file), thin(readFileSync(join(cases, file), "utf8")));

// Sheets of paper that the pages of a circle, an ellipse at an angle, and a line take at most.
const SHEETS = { "ball-on-disc": 2, "ball-in-groove": 2, roller: 2, "machine/cam-and-flat-tappet": 2 };

let browser;
before(async () => { browser = await launch(); });
after(() => browser?.close());

function run(...args) {
  try {
    execFileSync(ERTEL, args, { stdio: ["ignore", "ignore", "pipe"], timeout: 600e3 });
  } catch (e) {
    // A point of a study may not converge on a coarse mesh: its page is there all the same.
    assert.equal(e.status, 3, `ertel ${args.join(" ")}: ${e.stderr}`);
  }
}

async function look(name, file, expected, how, sheets) {
  const page = await openPage(browser, file);
  const found = await checkPlots(page, name, how);
  assert.deepEqual(page.troubles, [], name);
  assert.ok(found.charts >= expected.charts && found.maps >= expected.maps, `${name}: ${JSON.stringify(found)}`);
  // Angles in degrees, speeds in rpm, torques in N m: no heading has the unit of a column of the file in it, and no plot the numbers of the points.
  const said = await page.$$eval("#table thead button, #plot-1 .u-legend, #plot-2 .u-legend", (all) => all.map((e) => e.textContent));
  for (const text of said) assert.doesNotMatch(text, /\b(rad|J)\b|^Point\b.*:/, `${name}: ${text}`);
  const second = await page.$$eval("#table-y2", (all) => all.map((e) => e.selectedOptions[0]?.textContent));
  for (const text of second) assert.notEqual(text, "Point", name);
  // Colours of a film belong to the contact, not to the gap around it: the largest film in it is not far above the central one.
  for (const ends of await page.$$eval("#contact .map", (all) => all.map((map) => JSON.parse(map.dataset.axes).at(-1)))) {
    const [low, high] = [ends.low, ends.high];
    assert.ok(high < 6 * low, `${name}: a map from ${low} to ${high}`);
  }
  if (sheets) {
    const printed = Buffer.from(await page.pdf({ format: "A4", printBackground: true })).toString("latin1");
    const n = printed.match(/\/Type\s*\/Page\b/g).length;
    assert.ok(n <= sheets, `${name} prints on ${n} sheets`);
  }
  await page.screenshot({ path: join(SCREENSHOTS, `shipped-${name.replaceAll("/", "-")}.png`), fullPage: true });
  await page.close();
}

describe("shipped cases", () => {
  for (const file of files) {
    const name = file.replace(/\.toml$/, "");
    const text = readFileSync(join(cases, file), "utf8");
    const kind = kindOf(text);
    test(name, async () => {
      const output = join(folder, name.replaceAll("/", "-"));
      const set = coarse(text).flatMap((one) => ["--set", one]);
      run(kind === "study" ? "sweep" : "solve", join(cases, file), "--output", output, "--quiet", "--accept-unresolved", ...set);
      const isLine = kind === "contact" && JSON.parse(readFileSync(join(output, "result.json"), "utf8")).kind === "line";
      const expected = kind === "contact" ? { charts: isLine ? 2 : 4, maps: isLine ? 0 : 1 } : { charts: 2, maps: 0 };
      // Half of the elements of a bearing carry nothing: their lines have gaps.
      await look(name, join(output, "report.html"), expected, { scattered: kind === "machine" }, SHEETS[name]);
    });
  }
  test("samples of uncertain inputs", async () => {
    const output = join(folder, "samples");
    run("solve", join(cases, "roller-uncertain.toml"), "--output", output, "--quiet", "--accept-unresolved", "--monte-carlo", "3", ...COARSE.flatMap((one) => ["--set", one]));
    await look("samples", join(`${output}-monte-carlo`, "report.html"), { charts: 2, maps: 0 }, { scattered: true });
  });
  test("points of a comparison", async () => {
    const table = readFileSync(join(cases, "measured-films.csv"), "utf8").split("\n");
    const first = table.findIndex((line) => !line.startsWith("#"));
    writeFileSync(join(cases, "few.csv"), [...table.slice(0, first + 3), table.filter((line) => line).pop()].join("\n") + "\n");
    const output = join(folder, "comparison");
    const coarse = '\n[mesh]\ntarget_error = "10 %"\n';
    writeFileSync(join(cases, "coarse-films.toml"), readFileSync(join(cases, "measured-films.toml"), "utf8") + coarse);
    run("compare", join(cases, "coarse-films.toml"), join(cases, "few.csv"), "--output", output, "--quiet", "--accept-unresolved");
    const points = readdirSync(output, { recursive: true }).find((f) => basename(f) === "report.html" && f !== "report.html");
    assert.ok(points && existsSync(join(output, points)), "the points of a comparison have a page");
    await look("comparison", join(output, points), { charts: 2, maps: 0 }, { scattered: true });
    // Its own page has a picture, and each row of the table.
    const page = await openPage(browser, join(output, "report.html"));
    const [width, rows] = await page.evaluate(() => [document.querySelector(".picture img").naturalWidth, document.querySelectorAll("#results table.cells tbody tr").length]);
    assert.ok(width > 0 && rows === 3, `${width}, ${rows} rows`);
    const cut = await page.$$eval("#results .scroll", (all) => all.filter((e) => e.scrollWidth > e.clientWidth).length);
    assert.equal(cut, 0, "tables with columns beyond the page");
    assert.deepEqual(page.troubles, []);
    await page.close();
  });
});
