// Assembles the page.

const data = JSON.parse(document.getElementById("ertel-data").textContent);
const element = (id) => document.getElementById(id);
const reveal = (id) => { element(id).hidden = false; };

function makeCard(title, value, more) {
  const card = document.createElement("div");
  card.className = "card";
  const heading = document.createElement("h3");
  heading.textContent = title;
  const figure = document.createElement("p");
  figure.className = "value";
  figure.textContent = value;
  card.append(heading, figure);
  for (const text of more) {
    const line = document.createElement("p");
    line.className = "more";
    line.textContent = text;
    card.append(line);
  }
  return card;
}

// Place of a figure: along the motion for a line contact; on either side for symmetric halves.
function placeText({ a, data, mesh }, { x, y }) {
  const at = (v) => (v / a).toFixed(3).replace(/^-0\.0*$/, "0.000").replace("-", "−");
  if (data.kind === "line") return `at x/a ${at(x)}`;
  return `at x/a ${at(x)}, y/a ${mesh?.mirrored && at(y) !== "0.000" ? `±${at(Math.abs(y))}` : at(y)}`;
}

function showCards(results) {
  const host = element("cards");
  const first = results[0];
  // Figures with a symbol are shown large; the report below and the table to copy have all figures.
  for (const figure of first.figures.filter((f) => f.symbol)) {
    const more = [];
    if (figure.uncertainty != null) more.push(`inputs: ± ${digits(100 * figure.uncertainty / Math.abs(figure.value), 2)} % (95 %)`);
    if (results.length === 1 && figure.x != null && figure.place_error !== undefined && figure.place_resolved !== false) {
      more.push(placeText(first, figure));
    }
    const own = results.map((r) => r.figures.find((f) => f.name === figure.name));
    if (results.length > 1) {
      own.slice(1).forEach((f, i) => {
        if (!f) return;
        const change = figure.unit === "K" ? `${digits(f.value - figure.value, 3)} K` : `${digits(100 * (f.value / figure.value - 1), 3)} %`;
        const known = figure.value !== 0 ? ` (${change.startsWith("-") ? "" : "+"}${change})` : "";
        more.push(`${i + 2}: ${figureText(f)}${known}`);
      });
    }
    host.append(makeCard(`${capital(figure.words)} ${figure.symbol}`, (results.length > 1 ? "1: " : "") + figureText(figure), more));
  }
  if (results.length > 1) element("bars").prepend(`Results: ${results.map((r, i) => `${i + 1} ${r.name}`).join(", ")}. In brackets the difference from the first. `);
}

function figuresCsv(results) {
  const head = ["figure", "unit", ...results.flatMap((r, i) => { const n = results.length > 1 ? `_${i + 1}` : ""; return [`value${n}`, `error${n}`, `resolved${n}`, `x_m${n}`, `y_m${n}`]; })];
  const rows = results[0].figures.map((f) => [f.name, f.unit, ...results.flatMap((r) => {
    const own = r.figures.find((g) => g.name === f.name) ?? {};
    return [own.value, own.error, own.resolved, own.x, own.y].map((v) => v ?? "");
  })]);
  return [head, ...rows].map((r) => r.join(",")).join("\n") + "\n";
}

// Largest residual in the plot of iterations.
const LARGEST_RESIDUAL = 1e12;

function showIterations(result) {
  const history = result.data.history;
  if (!history.length) return;
  reveal("convergence");
  const stages = [...new Set(history.map((r) => r.stage))];
  // A diverged step would hide the others.
  const isShown = (residual) => residual > 0 && residual < LARGEST_RESIDUAL;
  const count = history.map((_, i) => i + 1);
  const series = stages.map((stage, k) => ({
    label: `stage ${stage}`, ink: k, points: true,
    data: history.map((r) => (r.stage === stage && isShown(r.residual) ? r.residual : NaN)),
  }));
  const { tolerance, heat_tolerance: heatTolerance } = result.data;
  if (heatTolerance) {
    // Film and heat are solved in turn, each only to a fraction of the other's change: the change per round is what converges.
    series.push({ label: "film and heat, change per round", ink: 5, points: true, data: history.map((r) => r.heat_change ?? NaN) });
  }
  const end = heatTolerance ?? tolerance;
  // Finite volumes stop at a tolerance of the step, not of the residual.
  if (end) series.push({ label: heatTolerance ? "tolerance of that change" : "tolerance", ink: 4, dash: [6, 4], data: history.map(() => end) });
  lineChart("iterations", {
    x: { label: "Newton iteration", data: count }, y: { label: "Residual", log: true }, series, height: 280,
    describe: `Residual over ${history.length} Newton iterations on ${stages.length} meshes`,
  });
}

async function copy(text, button) {
  let done = true;
  try { await navigator.clipboard.writeText(text); } catch {
    const area = document.createElement("textarea");
    area.value = text;
    area.setAttribute("aria-label", "Text to copy");
    document.body.append(area);
    area.select();
    done = document.execCommand("copy");
    area.remove();
    button.focus();
  }
  element("status").textContent = done ? `Copied ${text.split("\n").length - 1} lines.` : "The browser does not allow copying.";
}

const view = {};

function setUp() {
  const results = (data.results ?? []).map((d, i) => new Result(d, d.name ?? d.title ?? `result ${i + 1}`));
  if (results.length) {
    reveal("figures");
    showCards(results);
    reveal("centreline");
    view.centreline = new CentrelineView(results);
    if (results.every((r) => r.mesh)) {
      reveal("contact");
      view.contact = new ContactView(results);
    }
    if (results.length === 1) showIterations(results[0]);
  }
  if (data.instants) {
    reveal("instants");
    view.instants = new InstantsView(data.instants);
  }
  if (data.table || data.tables) {
    reveal("points");
    const { table } = data;
    view.table = new TableView(table ? { rows: parseCsv(table.csv), nAxes: table.n_axes, leftOut: table.left_out } : joinTables(data.tables));
  }
  const nav = element("contents");
  for (const section of document.querySelectorAll("main section[id]:not([hidden])")) {
    const link = document.createElement("a");
    link.href = `#${section.id}`;
    link.textContent = section.querySelector("h2").textContent;
    nav.append(link);
  }
  const texts = {
    figures: () => figuresCsv(results), along: () => chartCsv("along"), across: () => chartCsv("across"), profile: () => chartCsv("profile"), "instant-profile": () => chartCsv("instant-profile"),
    table: () => view.table.csv(), "case-file": () => element("case-file").textContent,
  };
  for (const button of document.querySelectorAll("button[data-copy]")) button.addEventListener("click", () => copy(texts[button.dataset.copy](), button));
}

// Minimum width of a picture with several panels, pixels.
const WIDE_PICTURE = 700;

for (const image of document.querySelectorAll(".picture img")) image.decode().then(() => image.closest(".picture").classList.toggle("wide", image.naturalWidth > WIDE_PICTURE), () => {});

function redraw() {
  view.contact?.show();
  view.instants?.redraw();
  redrawCharts();
}

function theme(dark) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  element("theme").setAttribute("aria-pressed", String(dark));
}

theme(matchMedia("(prefers-color-scheme: dark)").matches);
setUp();
element("theme").addEventListener("click", () => { theme(document.documentElement.dataset.theme !== "dark"); redraw(); });
element("print").addEventListener("click", () => print());
let timer = 0;
let width = innerWidth;
addEventListener("resize", () => { if (innerWidth === width) return; width = innerWidth; clearTimeout(timer); timer = setTimeout(redraw, 120); });
const before = { dark: false };
addEventListener("beforeprint", () => { before.dark = document.documentElement.dataset.theme === "dark"; if (before.dark) { theme(false); redraw(); } });
addEventListener("afterprint", () => { if (before.dark) { theme(true); redraw(); } });
