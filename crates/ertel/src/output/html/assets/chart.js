// Line charts with uPlot in the colours of the page.

const charts = new Map();

function colour(name) { return getComputedStyle(document.documentElement).getPropertyValue(name).trim(); }

function colours() { return [0, 1, 2, 3, 4, 5].map((i) => colour(`--c${i}`)); }

// Ticks and labels of an axis for uPlot. `long` is the length of the axis in pixels.
function ticksFor(log, across, long) {
  let drawn = { values: [], labels: [] };
  return {
    splits: (u, axis, low, high) => {
      drawn = { low, high, ...ticksOver(low, high, long(u), { log, across }) };
      return drawn.values;
    },
    values: () => drawn.labels,
    // For programs, which cannot read the axis from the picture.
    drawn: () => drawn,
    // uPlot's own filter of logarithmic axes would drop some labels.
    filter: (u, splits) => splits,
  };
}

// Room for the longest label of a vertical axis.
function roomFor(u, labels) { return 18 + 7.2 * Math.max(3, ...(labels ?? []).map((t) => t.length)); }

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

// Limits of an axis that cover all values, and their error bars within limits: a bar counts up to half its value or half the range of
// all values, on a logarithmic axis from a third to three times its value, and not below zero if all values are positive.
function endsOf(spec, scale, log) {
  const points = spec.series.filter((s) => (s.scale ?? "y") === scale).flatMap((s) => Array.from(s.data, (v, i) => [v, s.errors?.[i] > 0 ? s.errors[i] : 0]));
  const known = points.filter(([v]) => Number.isFinite(v) && !(log && v <= 0));
  if (!known.length) return axisEnds(NaN, NaN, log);
  const over = (pick, of) => known.reduce((end, [v, e]) => pick(end, of(v, e)), of(...known[0]));
  const [least, most] = [Math.min, Math.max].map((pick) => over(pick, (v) => v));
  const bar = (v, e) => Math.min(e, Math.max(0.5 * Math.abs(v), 0.5 * (most - least)));
  const low = over(Math.min, (v, e) => (log ? Math.max(v - e, v / 3) : v - bar(v, e)));
  const high = over(Math.max, (v, e) => (log ? Math.min(v + e, 3 * v) : v + bar(v, e)));
  return withRoom(least >= 0 && !log ? Math.max(0, low) : low, high, log);
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

// Draws a chart into the element with this id and replaces its content. `spec`: x {label, data, log, range}, y and right {label, log, range},
// series [{label, data, errors, colour, scale, dash, points}], mark, describe, onPoint, height. `range` of an axis is a function of the
// limits of the values and replaces the automatic limits.
function lineChart(id, spec) {
  const host = document.getElementById(id);
  charts.get(id)?.chart.destroy();
  host.replaceChildren();
  const palette = colours();
  spec.series.forEach((s, i) => { s.colour = s.colour ?? palette[(s.ink ?? i) % palette.length]; });
  const ink = colour("--ink");
  const axis = (label, extra, grid = {}) => ({
    stroke: ink, label, labelSize: 24, labelGap: 4, labelFont: "13px system-ui, sans-serif", font: "12px system-ui, sans-serif",
    grid: { stroke: colour("--grid"), width: 1, ...grid }, ticks: { stroke: colour("--rule"), width: 1 }, size: roomFor, ...extra,
  });
  const wide = Math.max(240, host.clientWidth);
  const height = spec.height ?? 300;
  const upright = (about) => ticksFor(about?.log, false, () => height - 60);
  const axes = [
    axis(spec.x.label, { size: 36, ...ticksFor(spec.x.log, true, () => wide - (spec.right ? 130 : 80)) }),
    axis(spec.y.label, { scale: "y", ...upright(spec.y) }),
  ];
  if (spec.right) axes.push(axis(spec.right.label, { scale: "right", side: 1, ...upright(spec.right) }, { show: false }));
  // Limits are drawable for any data.
  const scaled = (log, range) => ({ ...(log ? { distr: 3, log: 10 } : {}), range: (u, low, high) => axisEnds(...range(low, high), log) });
  const fit = (scale, about) => {
    const log = Boolean(about?.log);
    if (about?.range) return scaled(log, about.range);
    const ends = spec.series.some((s) => s.errors) ? endsOf(spec, scale, log) : null;
    return scaled(log, (low, high) => ends ?? withRoom(low, high, log));
  };
  const along = spec.x.range ?? ((low, high) => (spec.x.log ? withRoom(low, high, true, 0.02) : [low, high]));
  const options = {
    width: wide, height,
    padding: [12, spec.right ? 4 : 16, 0, 0],
    cursor: { drag: { x: true, y: false } },
    scales: { x: { time: false, ...scaled(spec.x.log, along) }, y: fit("y", spec.y), right: fit("right", spec.right) },
    axes,
    series: [
      { label: spec.x.label, value: (u, v) => (v == null ? "–" : digits(v, 5)) },
      ...spec.series.map((s) => ({
        label: s.label, scale: s.scale ?? "y", stroke: s.colour, width: s.line === false ? 0 : 2, dash: s.dash, spanGaps: false,
        points: { show: s.points ?? false, size: 7, fill: s.colour },
        value: (u, v) => (v == null ? "–" : digits(v, 5)),
      })),
    ],
    hooks: {
      draw: [errorBars(spec), cursorLine(spec), () => { host.dataset.axes = JSON.stringify(axes.map((a) => a.drawn())); }],
      setCursor: spec.onPoint ? [(u) => spec.onPoint(u.cursor.idx)] : [],
    },
  };
  // A logarithmic axis omits values that are not positive.
  const shown = (log) => (v) => (v === undefined || (Number.isFinite(v) && !(log && v <= 0)) ? v : null);
  const logOf = (s) => (s.scale === "right" ? spec.right : spec.y)?.log;
  const data = [Array.from(spec.x.data), ...spec.series.map((s) => Array.from(s.data, shown(logOf(s))))];
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
