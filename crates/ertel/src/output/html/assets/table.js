// The points of a curve or study: a sortable table, and two plots linked to it.

// Maximum number of printed rows: larger tables are for the screen or for the CSV file next to the page.
const PRINTED_ROWS = 25;

// A table of comma-separated values, quoted as in RFC 4180.
function parseCsv(text) {
  const rows = [];
  let [row, cell, quoted] = [[], "", false];
  for (let i = 0; i < text.length; i++) {
    const c = text[i];
    if (quoted) {
      if (c === '"' && text[i + 1] === '"') { cell += '"'; i++; } else if (c === '"') quoted = false; else cell += c;
    } else if (c === '"') quoted = true;
    else if (c === ",") { row.push(cell); cell = ""; } else if (c === "\n") { row.push(cell); rows.push(row); [row, cell] = [[], ""]; } else if (c !== "\r") cell += c;
  }
  return rows;
}

const SUFFIXES = [["_kg_per_m3", "kg/m^3"], ["_m_per_s", "m/s"], ["_N_per_m", "N/m"], ["_W_per_m", "W/m"], ["_N_m", "N m"], ["_million_revolutions", "million revolutions"], ["_Pa_s", "Pa.s"], ["_rad_per_s", "rad/s"], ["_1_per_s", "1/s"], ["_per_s", "1/s"], ["_1_per_Pa", "1/Pa"], ["_1_per_K", "1/K"], ["_W_per_(m_K)", "W/(m K)"], ["_J_per_(kg_K)", "J/(kg K)"], ["_J", "N m"], ["_degC", "°C"], ["_Pa", "Pa"], ["_rad", "rad"], ["_m", "m"], ["_N", "N"], ["_W", "W"], ["_K", "K"], ["_s", "s"]];
// Figures of transient runs.
const OVER_TIME = ["film_central_lowest_m", "film_minimum_lowest_m", "amplitude_ratio_last", "traction_coefficient_highest", "traction_coefficient_mean", "pressure_maximum_highest_Pa", "film_temperature_maximum_highest_K"];
const PLAIN = [...OVER_TIME, "film_central_m", "film_minimum_m", "pressure_central_Pa", "traction_coefficient", "friction_total", "lambda_minimum", "film_temperature_maximum_K", "friction_torque_N_m", "friction_power_W", "friction_power_W_per_m", "mesh_loss", "scuffing_safety", "micropitting_safety", "static_safety_factor", "modified_rating_life_million_revolutions", "converged"];
// Figures shown first for the contacts of a machine.
const OF_MACHINES = ["name", "load_N", "load_N_per_m", "hertz_pressure_Pa", "load_share", "contact_angle_rad", "spin_speed_rad_per_s", "entrainment_speed_m_per_s", "slide_to_roll_ratio", "film_central_m", "film_minimum_m", "lambda_minimum", "specific_film", "flash_temperature_K", "contact_temperature_K", "traction_coefficient", "friction_total", "friction_power_W", "friction_power_W_per_m", "film_temperature_maximum_K"];

// Figures drawn first for whole machines.
const OF_WHOLE_MACHINES = ["friction_torque_N_m", "mesh_loss", "friction_power_W"];

const WORDS = {
  film_central_lowest: "lowest central film", film_central_highest: "highest central film", film_central_last: "central film at the end", film_minimum_lowest: "lowest minimum film", film_minimum_last: "minimum film at the end",
  pressure_maximum_highest: "highest pressure", traction_coefficient_highest: "highest traction coefficient", traction_coefficient_mean: "mean traction coefficient", friction_power_mean: "mean friction power", film_temperature_maximum_highest: "highest film temperature",
  amplitude_ratio_lowest: "lowest amplitude ratio", amplitude_ratio_highest: "highest amplitude ratio", amplitude_ratio_last: "amplitude ratio at the end", mass_error_highest: "largest mass error of a step",
  contact: "no.", name: "contact", film_central: "central film", film_minimum: "minimum film", pressure_maximum: "largest pressure", pressure_central: "smooth pressure maximum", hertz_pressure: "Hertz pressure",
  friction_total: "friction coefficient", lambda_minimum: "lambda ratio", film_temperature_maximum: "largest film temperature",
  shear_stress_maximum: "largest shear stress",
};

function describeColumn(title) {
  const last = title.split(".").pop();
  const found = SUFFIXES.find(([suffix]) => last.endsWith(suffix));
  const name = found ? last.slice(0, -found[0].length) : last;
  return { title, name, unit: found ? found[1] : "", words: WORDS[name] ?? name.replaceAll("_", " ").replace("slide to roll", "slide-to-roll"), isError: name.endsWith("_error") };
}

// Merges several tables; the first column after the point number names the result. Columns are matched by
// their titles; an axis of any table is an axis of the merged one.
function joinTables(tables) {
  const parsed = tables.map((t) => parseCsv(t.csv));
  const axes = [...new Set(tables.flatMap((t, i) => parsed[i][0].slice(1, 1 + t.n_axes)))];
  const figures = [...new Set(parsed.flatMap(([head]) => head.slice(1)))].filter((title) => !axes.includes(title));
  const titles = [...axes, ...figures];
  const rows = parsed.flatMap(([head, ...body], i) => body.map((cells) => {
    const of = (title) => cells[head.indexOf(title)] ?? "";
    return [cells[0], `${i + 1}: ${tables[i].name}`, ...titles.map(of)];
  }));
  return { rows: [["point", "result", ...titles], ...rows], nAxes: 1 + axes.length, leftOut: tables.reduce((n, t) => n + t.left_out, 0) };
}

class TableView {
  constructor({ rows: [head, ...rows], nAxes, leftOut }) {
    this.columns = head.map(describeColumn);
    this.nAxes = nAxes;
    this.plain = head.includes("solved_as") ? OF_MACHINES : PLAIN;
    this.rows = rows.map((cells, i) => ({ cells, i }));
    const numbers = (c) => this.rows.map((r) => (r.cells[c] === "" ? NaN : Number(r.cells[c])));
    this.columns.forEach((column, c) => {
      column.numbers = numbers(c);
      const known = column.numbers.filter(Number.isFinite);
      column.isNumber = known.length > 0 && this.rows.every((r) => r.cells[c] === "" || Number.isFinite(Number(r.cells[c])));
      column.shown = column.isNumber ? unitOf(column.unit, Math.max(...known.map(Math.abs))) : null;
      column.errors = head.indexOf(this.errorTitle(column));
    });
    // Both films of a point have the same unit.
    const films = this.columns.filter((c) => ["film_central", "film_minimum"].includes(c.name) && c.isNumber);
    const thickest = Math.max(...films.flatMap((c) => c.numbers.filter(Number.isFinite).map(Math.abs)));
    for (const film of films) film.shown = unitOf(film.unit, thickest);
    if (leftOut) document.getElementById("rows-left-out").textContent = ` To limit its size, the table of this page ends here; the CSV file next to this page has ${leftOut} more points.`;
    this.sort = { column: 0, down: false };
    this.setUp();
    this.showTable();
    this.showPlots();
  }

  errorTitle({ title, unit }) {
    const suffix = SUFFIXES.find(([s, u]) => u === unit && title.endsWith(s))?.[0] ?? "";
    return `${title.slice(0, title.length - suffix.length)}_error${suffix}`;
  }

  setUp() {
    const numeric = this.columns.map((c, i) => [c, i]).filter(([c]) => c.isNumber && !c.isError);
    const distinct = (c) => new Set(this.rows.map((r) => r.cells[c])).size;
    const axes = Array.from({ length: this.nAxes }, (_, i) => i + 1);
    const numericAxes = axes.filter((c) => this.columns[c].isNumber);
    const x = numericAxes.sort((p, q) => distinct(q) - distinct(p))[0] ?? 0;
    const fill = (id, list, value) => {
      const select = document.getElementById(id);
      for (const [text, key] of list) select.add(new Option(text, key));
      select.value = value;
      select.addEventListener("change", () => this.showPlots());
    };
    const named = numeric.map(([c, i]) => [capital(c.words), i]);
    fill("table-x", named, x);
    // A curve has at least two points.
    const by = axes.filter((c) => c !== x && distinct(c) > 1 && distinct(c) <= 12 && 2 * distinct(c) <= this.rows.length);
    fill("table-by", [["one curve", ""], ...by.map((c) => [this.columns[c].words, c])], by[0] ?? "");
    const find = (names) => names.map((n) => this.columns.findIndex((c) => c.title === n && c.isNumber)).find((i) => i >= 0) ?? (numeric.find(([, i]) => i > this.nAxes) ?? numeric[0])[1];
    fill("table-y1", [["Central and minimum film", "films"], ...named], this.columns.some((c) => c.title === "film_central_m" && c.isNumber) ? "films" : find(["film_central_lowest_m"]));
    const slides = this.columns.find((c) => c.title === "traction_coefficient")?.numbers.some((v) => Math.abs(v) > 1e-9);
    fill("table-y2", [["Central and minimum film", "films"], ...named], find([...(slides ? ["friction_total", "traction_coefficient"] : ["pressure_central_Pa", "pressure_maximum_Pa"]), ...OF_WHOLE_MACHINES, "amplitude_ratio_last", ...OVER_TIME.slice(3)]));
    const positive = this.columns[x].numbers.filter((v) => v > 0);
    const box = document.getElementById("table-log");
    box.checked = positive.length > 2 && positive.length === this.rows.length && Math.max(...positive) > 8 * Math.min(...positive);
    box.addEventListener("change", () => this.showPlots());
    document.getElementById("all-columns").addEventListener("change", () => this.showTable());
  }

  shownColumns() {
    const all = document.getElementById("all-columns").checked;
    // Values common to all points are in the case.
    const varies = (i) => this.rows.length < 2 || new Set(this.rows.map((r) => r.cells[i])).size > 1;
    return this.columns.map((c, i) => [c, i]).filter(([c, i]) => all || (i <= this.nAxes && varies(i)) || (this.plain.includes(c.title) && this.rows.some((r) => this.says(c, r.cells[i]))));
  }

  // Whether a cell needs a column: zeros and converged flags do not.
  says(column, text) { return column.title === "converged" ? text === "false" : text !== "" && Number(text) !== 0; }

  cell(column, row) {
    const text = row.cells[this.columns.indexOf(column)];
    if (!column.isNumber || text === "" || column.title === "point") return text;
    const uncertain = this.columns.findIndex((c) => c.title === "uncertain_figures");
    if (uncertain >= 0 && column.name !== "" && row.cells[uncertain].split(" ").includes(column.name) && !document.getElementById("all-columns").checked) return "not resolved";
    const value = column.shown.show(Number(text));
    // Varied inputs have no error bar.
    if (this.columns.indexOf(column) <= this.nAxes) return exactly(value);
    const error = column.errors >= 0 ? Number(row.cells[column.errors]) * column.shown.factor : NaN;
    return error > 0 && !document.getElementById("all-columns").checked ? withBar(value, error, "") : digits(value, 5);
  }

  showTable() {
    const table = document.getElementById("table");
    const columns = this.shownColumns();
    const { column, down } = this.sort;
    const key = (r) => (this.columns[column].isNumber ? this.columns[column].numbers[r.i] : r.cells[column]);
    const order = (p, q) => { const [a, b] = [key(p), key(q)]; return (a > b) - (a < b) || (Number.isNaN(a) ? 1 : 0) - (Number.isNaN(b) ? 1 : 0) || p.i - q.i; };
    this.sorted = [...this.rows].sort((p, q) => (down ? -1 : 1) * order(p, q));
    const head = document.createElement("tr");
    for (const [c, i] of columns) {
      const th = document.createElement("th");
      th.scope = "col";
      th.ariaSort = i === column ? (down ? "descending" : "ascending") : "none";
      const button = document.createElement("button");
      button.type = "button";
      const unit = c.shown?.name ? ` (${c.shown.name})` : "";
      button.textContent = `${capital(c.words)}${unit}${i === column ? (down ? " ▼" : " ▲") : ""}`;
      button.addEventListener("click", () => {
        this.sort = { column: i, down: this.sort.column === i && !this.sort.down };
        this.showTable();
        table.querySelectorAll("thead button")[columns.findIndex(([, k]) => k === i)]?.focus();
      });
      th.append(button);
      head.append(th);
    }
    const body = document.createElement("tbody");
    const converged = this.columns.findIndex((c) => c.title === "converged");
    for (const row of this.sorted) {
      const tr = document.createElement("tr");
      tr.dataset.row = row.i;
      tr.classList.toggle("failed", converged >= 0 && row.cells[converged] === "false");
      columns.forEach(([c], k) => {
        const td = document.createElement(k === 0 ? "th" : "td");
        if (k === 0) td.scope = "row";
        td.textContent = this.cell(c, row);
        // In the stacked layout, each cell has a label.
        td.dataset.label = `${capital(c.words)}${c.shown?.name ? ` (${c.shown.name})` : ""}`;
        tr.append(td);
      });
      tr.addEventListener("pointerenter", () => this.mark(row.i, false));
      body.append(tr);
    }
    const thead = document.createElement("thead");
    thead.append(head);
    table.replaceChildren(thead, body);
    for (const tr of [...body.children].slice(PRINTED_ROWS)) tr.classList.add("unprinted");
    document.getElementById("rows-printed").textContent = this.sorted.length > PRINTED_ROWS ? `The first ${PRINTED_ROWS} of ${this.sorted.length} rows are printed; the CSV file next to this page has all of them.` : "";
  }

  showPlots() {
    const chosen = (id) => document.getElementById(id).value;
    const x = this.columns[Number(chosen("table-x"))];
    const by = chosen("table-by") === "" ? null : Number(chosen("table-by"));
    const log = document.getElementById("table-log").checked;
    const groups = by == null ? [null] : [...new Set(this.rows.map((r) => r.cells[by]))];
    // Points that differ in more than the drawn quantities, such as random samples, are not joined by lines.
    const distinct = (of) => new Set(this.rows.map(of)).size;
    const xs = this.columns.indexOf(x);
    // In a grid, an axis that changes with the drawn one is not a separate axis.
    const goesAlong = (i) => 2 * distinct((r) => r.cells[xs]) <= this.rows.length && [(r) => r.cells[i], (r) => `${r.cells[i]}|${r.cells[xs]}`].every((of) => distinct(of) === distinct((r) => r.cells[xs]));
    const varied = this.columns.filter((c, i) => i >= 1 && i <= this.nAxes && i !== by && c !== x && distinct((r) => r.cells[i]) > 1 && !goesAlong(i));
    const label = (c) => `${capital(c.words)}${c.shown.name ? ` (${c.shown.name})` : ""}`;
    const order = [...this.rows].sort((p, q) => x.numbers[p.i] - x.numbers[q.i]).filter((r) => Number.isFinite(x.numbers[r.i]));
    const xLog = log && order.every((r) => x.numbers[r.i] > 0);
    this.plots = [["plot-1", chosen("table-y1")], ["plot-2", chosen("table-y2")]].map(([id, y]) => {
      const names = y === "films" ? ["film_central_m", "film_minimum_m"].map((n) => this.columns.find((c) => c.title === n)) : [this.columns[Number(y)]];
      const unit = names[0].shown;
      const series = [];
      groups.forEach((g, k) => names.forEach((c, n) => {
        // uPlot joins points over `undefined` and leaves a gap at `null`: a gap marks a failed point of the same curve.
        const of = (list, show) => order.map((r) => (g === null || r.cells[by] === g ? show(list[r.i]) : undefined));
        const errors = c.errors >= 0 ? of(this.columns[c.errors].numbers, (e) => e * unit.factor) : null;
        const group = g === null ? "" : this.groupText(by, g);
        const name = c.words;
        series.push({
          label: [names.length > 1 || g === null ? name : "", group].filter(Boolean).join(", "),
          unit: unit.name, data: of(c.numbers, unit.show), errors, points: true, line: varied.length === 0, ink: groups.length > 1 ? k : n, dash: n ? [6, 4] : undefined,
        });
      }));
      const values = series.flatMap((s) => s.data.filter(Number.isFinite));
      const yLog = xLog && values.length > 0 && values.every((v) => v > 0) && Math.max(...values) > 4 * Math.min(...values);
      const title = y === "films" ? `Film thickness (${unit.name})` : label(names[0]);
      const chart = lineChart(id, {
        x: { label: label(x), data: order.map((r) => x.shown.show(x.numbers[r.i])), log: xLog, range: (low, high) => withRoom(low, high, xLog, 0.03) }, y: { label: title, log: yLog },
        series, height: 320,
        describe: `${title} over ${label(x)}, ${order.length} points`,
        onPoint: (idx) => { if (idx != null && order[idx] && this.hovering !== order[idx].i) this.mark(order[idx].i, true); },
      });
      return { chart, order };
    });
  }

  groupText(column, text) {
    const c = this.columns[column];
    return c.isNumber ? `${c.words} ${exactly(c.shown.show(Number(text)))} ${c.shown.name}`.trim() : text;
  }

  mark(i, scroll) {
    if (this.hovering === i) return;
    this.hovering = i;
    for (const tr of document.querySelectorAll("#table tr.marked")) tr.classList.remove("marked");
    const tr = document.querySelector(`#table tr[data-row="${i}"]`);
    tr?.classList.add("marked");
    if (scroll && tr) {
      const box = document.querySelector("#points .high");
      box.scrollTop = tr.offsetTop - box.clientHeight / 2;
    }
    const row = this.rows[i];
    const text = this.shownColumns().slice(1, 8).map(([c]) => `${c.words} ${this.cell(c, row)} ${c.shown?.name ?? ""}`.trim());
    const reading = document.getElementById("point-reading");
    reading.textContent = `Point ${row.cells[0]}: ${text.join(", ")}`;
    if (!scroll) {
      for (const { chart, order } of this.plots) {
        const at = order.findIndex((r) => r.i === i);
        if (at >= 0) chart.setCursor({ left: chart.valToPos(chart.data[0][at], "x"), top: chart.over.clientHeight / 2 }, false);
      }
    }
  }

  csv() {
    const quote = (t) => (/[",\n]/.test(t) ? `"${t.replaceAll('"', '""')}"` : t);
    return [this.columns.map((c) => c.title), ...this.sorted.map((r) => r.cells)].map((r) => r.map(quote).join(",")).join("\n") + "\n";
  }
}
