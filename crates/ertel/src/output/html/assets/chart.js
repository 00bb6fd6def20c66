// Lines by uPlot, in the colours of the page.

const charts = new Map();

function colour(name) { return getComputedStyle(document.documentElement).getPropertyValue(name).trim(); }

function colours() { return [0, 1, 2, 3, 4, 5].map((i) => colour(`--c${i}`)); }

// Ticks of a logarithmic axis: at 1, 2 and 5 times powers of ten, over many decades at powers of ten alone.
function logTicks(u, splits) {
  const known = splits.filter((v) => v != null && v > 0);
  const decades = Math.log10(Math.max(...known) / Math.min(...known));
  const every = Math.max(1, Math.ceil(decades / 8));
  return splits.map((v) => {
    if (v == null) return null;
    const power = Math.floor(Math.log10(v) + 1e-9);
    const mantissa = v / 10 ** power;
    const is = (m) => Math.abs(mantissa - m) < 1e-6;
    if (decades > 4) return is(1) && power % every === 0 ? v : null;
    return is(1) || (decades <= 2.5 && (is(2) || is(5))) ? v : null;
  });
}

function logLabels(u, splits) { return splits.map((v) => (v == null ? "" : v >= 1e4 || v < 1e-3 ? v.toExponential(0).replace("e+", "e") : digits(v, 1))); }

function plainLabels(u, splits) {
  const text = tickText(splits.filter((v) => v != null));
  return splits.map((v) => (v == null ? "" : text(v)));
}

// Room for the longest label of a vertical axis.
function roomFor(u, labels) { return 16 + 7.2 * Math.max(3, ...(labels ?? []).map((t) => t.length)); }

function errorBars(spec) {
  return (u) => {
    const ctx = u.ctx;
    ctx.save();
    ctx.beginPath();
    ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    ctx.clip();
    ctx.lineWidth = devicePixelRatio;
    spec.series.forEach((series, s) => {
      if (!series.errors || !u.series[s + 1].show) return;
      ctx.strokeStyle = series.colour;
      series.errors.forEach((error, i) => {
        const value = series.data[i];
        if (!(error > 0) || !Number.isFinite(value)) return;
        const x = u.valToPos(spec.x.data[i], "x", true);
        const [low, high] = [value - error, value + error].map((v) => u.valToPos(v, series.scale ?? "y", true));
        if (![low, high].every(Number.isFinite)) return;
        const cap = 3 * devicePixelRatio;
        ctx.beginPath();
        ctx.moveTo(x, low); ctx.lineTo(x, high);
        ctx.moveTo(x - cap, low); ctx.lineTo(x + cap, low);
        ctx.moveTo(x - cap, high); ctx.lineTo(x + cap, high);
        ctx.stroke();
      });
    });
    ctx.restore();
  };
}

// Ends of an axis that hold all values with their error bars; of a logarithmic one with a little room, not whole decades.
function endsOf(spec, scale, log) {
  let [low, high] = [Infinity, -Infinity];
  for (const s of spec.series) {
    if ((s.scale ?? "y") !== scale) continue;
    s.data.forEach((v, i) => {
      if (!Number.isFinite(v) || (log && v <= 0)) return;
      const e = s.errors?.[i] > 0 ? s.errors[i] : 0;
      low = Math.min(low, log ? Math.max(v - e, v / 3) : v - e);
      high = Math.max(high, log ? Math.min(v + e, 3 * v) : v + e);
    });
  }
  if (!(low <= high)) return null;
  if (log) { const room = Math.max(1.1, (high / low) ** 0.04); return [low / room, high * room]; }
  const room = 0.05 * (high - low || Math.abs(high) || 1);
  return [low - room, high + room];
}

function cursorLine(spec) {
  return (u) => {
    if (spec.mark == null || !Number.isFinite(spec.mark)) return;
    const x = u.valToPos(spec.mark, "x", true);
    if (x < u.bbox.left || x > u.bbox.left + u.bbox.width) return;
    u.ctx.save();
    u.ctx.strokeStyle = colour("--soft");
    u.ctx.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
    u.ctx.beginPath();
    u.ctx.moveTo(x, u.bbox.top); u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
    u.ctx.stroke();
    u.ctx.restore();
  };
}

// Draws a chart into the element of an id, in place of what it holds. `spec`: x {label, data, log}, y and right {label, log},
// series [{label, data, errors, colour, scale, dash, points}], mark, describe, onPoint, height.
function lineChart(id, spec) {
  const host = document.getElementById(id);
  charts.get(id)?.chart.destroy();
  host.replaceChildren();
  const palette = colours();
  spec.series.forEach((s, i) => { s.colour = s.colour ?? palette[(s.ink ?? i) % palette.length]; });
  const ink = colour("--ink");
  const axis = (label, extra) => ({
    stroke: ink, label, labelSize: 24, labelFont: "13px system-ui, sans-serif", font: "12px system-ui, sans-serif",
    grid: { stroke: colour("--grid"), width: 1 }, ticks: { stroke: colour("--rule"), width: 1 }, size: roomFor, values: plainLabels, ...extra,
  });
  const logAxis = (log, grid = {}) => (log ? { values: logLabels, filter: logTicks, grid: { stroke: colour("--grid"), width: 1, filter: logTicks, ...grid }, ticks: { stroke: colour("--rule"), width: 1, filter: logTicks } } : {});
  const axes = [axis(spec.x.label, { size: 36, ...logAxis(spec.x.log) }), axis(spec.y.label, { scale: "y", ...logAxis(spec.y.log) })];
  if (spec.right) axes.push(axis(spec.right.label, { scale: "right", side: 1, grid: { show: false }, ...logAxis(spec.right.log, { show: false }) }));
  const distr = (log) => (log ? { distr: 3, log: 10 } : {});
  const fit = (scale, about) => {
    const ends = about?.log || spec.series.some((s) => s.errors) ? endsOf(spec, scale, about?.log) : null;
    return { ...distr(about?.log), ...(ends ? { range: () => ends } : {}), ...about?.range };
  };
  const options = {
    width: Math.max(240, host.clientWidth), height: spec.height ?? 300,
    padding: [12, spec.right ? 4 : 16, 0, 0],
    cursor: { drag: { x: true, y: false } },
    scales: { x: { time: false, ...(spec.x.log ? { ...distr(true), range: (u, low, high) => [low / 1.05, high * 1.05] } : {}) }, y: fit("y", spec.y), right: fit("right", spec.right) },
    axes,
    series: [
      { label: spec.x.label, value: (u, v) => (v == null ? "–" : digits(v, 5)) },
      ...spec.series.map((s) => ({
        label: s.label, scale: s.scale ?? "y", stroke: s.colour, width: s.line === false ? 0 : 2, dash: s.dash, spanGaps: false,
        points: { show: s.points ?? false, size: 7, fill: s.colour },
        value: (u, v) => (v == null ? "–" : digits(v, 5)),
      })),
    ],
    hooks: { draw: [errorBars(spec), cursorLine(spec)], setCursor: spec.onPoint ? [(u) => spec.onPoint(u.cursor.idx)] : [] },
  };
  const finite = (v) => (v === undefined || Number.isFinite(v) ? v : null);
  const data = [Array.from(spec.x.data), ...spec.series.map((s) => Array.from(s.data, finite))];
  const chart = new uPlot(options, data, host);
  chart.root.querySelector(".u-wrap").setAttribute("role", "img");
  chart.root.querySelector(".u-wrap").setAttribute("aria-label", spec.describe ?? spec.series.map((s) => s.label).join(", "));
  charts.set(id, { chart, spec });
  return chart;
}

// The points of a chart as CSV.
function chartCsv(id) {
  const found = charts.get(id);
  if (!found) return "";
  const { spec } = found;
  const quote = (t) => `"${String(t).replaceAll('"', '""')}"`;
  const head = [spec.x.label, ...spec.series.map((s) => (s.unit ? `${s.label} (${s.unit})` : s.label))];
  const rows = Array.from(spec.x.data, (x, i) => [x, ...spec.series.map((s) => (Number.isFinite(s.data[i]) ? s.data[i] : ""))].join(","));
  return `${head.map(quote).join(",")}\n${rows.join("\n")}\n`;
}

function redrawCharts() {
  for (const [id, { spec }] of [...charts]) {
    spec.series.forEach((s) => { s.colour = undefined; });
    if (document.getElementById(id)?.offsetParent) lineChart(id, spec);
  }
}
