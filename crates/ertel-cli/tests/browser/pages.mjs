// Pages of results in a headless browser, and what their plots show.
import assert from "node:assert/strict";
import puppeteer from "puppeteer-core";

export const { ERTEL, CASES, CHROMIUM, SCREENSHOTS } = process.env;

export const launch = () => puppeteer.launch({ executablePath: CHROMIUM, args: ["--no-sandbox"] });

// Opens a page; whatever it reports or asks for is kept.
export async function openPage(browser, file, { width = 1280, dark = false } = {}) {
  const page = await browser.newPage();
  page.troubles = [];
  page.on("console", (m) => { if (["error", "warn"].includes(m.type())) page.troubles.push(`console: ${m.text()}`); });
  page.on("pageerror", (e) => page.troubles.push(`error: ${e.message}`));
  page.on("request", (r) => { if (!/^(file|data|blob):/.test(r.url())) page.troubles.push(`request: ${r.url()}`); });
  await page.setViewport({ width, height: 900 });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }]);
  await page.goto(`file://${file}`);
  await page.waitForFunction(() => document.querySelector("#contents a"));
  // Profiles are drawn with the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page;
}

// The number that a label of a tick says, read as a person does.
export function readLabel(label) {
  const plain = label.replaceAll("−", "-");
  const [, sign, lead, raised] = plain.match(/^(-?)(?:([\d.]+)·)?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/) ?? [];
  if (raised == null) { assert.match(plain, /^-?\d+(\.\d+)?$/, label); return Number(plain); }
  const power = [...raised].map((c) => (c === "⁻" ? "-" : "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c))).join("");
  return Number(`${sign}${lead ?? 1}e${power}`);
}

function checkAxes(axes, what) {
  assert.ok(axes.length >= 2, `${what}: ${axes.length} axes`);
  for (const { low, high, values, labels } of axes) {
    const all = `${what}: ${low} to ${high}: ${labels}`;
    assert.ok(Number.isFinite(low) && low < high && values.length >= 2 && values.length <= 12, all);
    values.forEach((v, i) => assert.ok(v >= low && v <= high && readLabel(labels[i]) === v, all));
  }
}

// Every plot of a page has lines (or dots alone, if `scattered`) or colours inside its axes, ticks that are true, and a value under
// the cursor.
export async function checkPlots(page, what, { scattered = false } = {}) {
  const charts = await page.$$(".chart .uplot");
  for (const chart of charts) {
    const id = await chart.evaluate((e) => e.parentElement.id);
    const name = `${what}, ${id}`;
    await chart.scrollIntoView();
    checkAxes(await chart.evaluate((e) => JSON.parse(e.parentElement.dataset.axes)), name);
    // Lines have the colours of the palette, axes and grid are grey.
    const ink = await chart.evaluate((e) => {
      const [canvas, over] = [e.querySelector("canvas"), e.querySelector(".u-over")];
      const ratio = canvas.width / canvas.clientWidth;
      const box = [over.offsetLeft, over.offsetTop, over.clientWidth, over.clientHeight].map((v) => Math.round(v * ratio));
      const { data } = canvas.getContext("2d").getImageData(...box);
      const columns = new Set();
      let pixels = 0;
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b, alpha] = data.slice(i, i + 4);
        if (alpha > 100 && Math.max(r, g, b) - Math.min(r, g, b) > 60) { pixels += 1; columns.add((i / 4) % box[2]); }
      }
      return { pixels, columns: columns.size, width: box[2] };
    });
    assert.ok(ink.pixels > 100 && (scattered || ink.columns > 0.4 * ink.width), `${name}: ${JSON.stringify(ink)}`);
    const over = await (await chart.$(".u-over")).boundingBox();
    const read = [];
    for (const share of [0.1, 0.5, 0.9]) {
      await page.mouse.move(over.x + share * over.width, over.y + over.height / 2);
      read.push(...await chart.$$eval(".u-series .u-value", (values) => values.slice(1).map((v) => v.textContent)));
    }
    assert.ok(read.some((text) => /\d/.test(text)), `${name} under the cursor: ${read}`);
  }
  const maps = await page.$$(".map");
  for (const map of maps) {
    const name = `${what}, map`;
    await map.scrollIntoView();
    checkAxes(await map.evaluate((e) => JSON.parse(e.dataset.axes)), name);
    const ink = await map.evaluate((e) => {
      const canvas = e.querySelector("canvas");
      const { data } = canvas.getContext("2d").getImageData(...JSON.parse(e.dataset.frame));
      const colours = new Set();
      let painted = 0;
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b, alpha] = data.slice(i, i + 4);
        if (alpha === 255) painted += 1;
        if (Math.max(r, g, b) - Math.min(r, g, b) > 40) colours.add((r << 16) + (g << 8) + b);
      }
      return { colours: colours.size, share: painted / (data.length / 4), isDifference: e.textContent.includes("Difference") };
    });
    // Differences may be zero, which is white, and are shown only where both films are thin. Maps side by side have the window of the larger contact.
    const least = maps.length > 1 ? 0.2 : 0.5;
    assert.ok(ink.isDifference ? ink.share > 0.03 : ink.colours > 50 && ink.share > least, `${name}: ${JSON.stringify(ink)}`);
  }
  if (await page.$("#contact:not([hidden])")) {
    const all = await page.$eval("#reading", (e) => JSON.parse(e.dataset.values));
    for (const values of all) assert.ok(values.pressure > 0 && values.film_thickness > 0, `${what}: ${JSON.stringify(values)}`);
  }
  assert.ok(charts.length + maps.length > 0, `${what} has no plot`);
  return { charts: charts.length, maps: maps.length };
}
