// Axes of plots and maps: drawable limits for any data, round ticks, and exact tick labels.

// Maximum number of ticks of an axis.
const MOST_TICKS = 12;
// Largest drawable magnitude, and the smallest axis length relative to the magnitude of its limits: beyond these, ticks cannot be distinguished.
const [SMALLEST, LARGEST, LEAST_LENGTH] = [1e-280, 1e280, 1e-11];

// Drawable limits from any two numbers: in order, distinct, and positive on a logarithmic axis.
function axisEnds(low, high, log = false) {
  const clamp = (v) => Math.max(-LARGEST, Math.min(LARGEST, v));
  const usable = (v) => typeof v === "number" && !Number.isNaN(v) && (!log || v > 0);
  let ends = [low, high].filter(usable).map(clamp).sort((p, q) => p - q);
  if (!ends.length) ends = log ? [1, 10] : [0, 1];
  let [p, q] = [ends[0], ends[ends.length - 1]];
  if (log) {
    [p, q] = [Math.max(SMALLEST, p), Math.max(SMALLEST, q)];
    return q / p > 1 + LEAST_LENGTH ? [p, q] : [p / 1.5, q * 1.5];
  }
  const size = Math.max(Math.abs(p), Math.abs(q));
  if (size < SMALLEST) return [0, 1];
  return q - p > LEAST_LENGTH * size ? [p, q] : [p - 0.5 * size, q + 0.5 * size];
}

// Adds a margin beyond the values, but not beyond zero; a limit that is round-off compared with the other one becomes zero.
function withRoom(low, high, log = false, share = 0.05) {
  const [p, q] = axisEnds(low, high, log);
  if (log) {
    const room = Math.min(3, Math.max(1.05, (q / p) ** share));
    return axisEnds(p / room, q * room, log);
  }
  const room = share * (q - p);
  const tiny = 0.002 * (q - p);
  return [p > -tiny && p < room ? 0 : p - room, q < tiny && q > -room ? 0 : q + room];
}

// A tick is an integer times a power of ten: the nearest number, and its digits.
function tick(whole, power) { return { value: Number(`${whole}e${power}`) || 0, whole, power }; }

// Multiples of `lead` times a power of ten.
function multiples(low, high, lead, power) {
  const step = Number(`${lead}e${power}`);
  const ticks = [];
  const first = Math.ceil(low / step - 1e-6);
  for (let i = 0; i <= 200; i++) {
    const next = tick((first + i) * lead, power);
    if (next.value > high) break;
    if (next.value >= low) ticks.push(next);
  }
  return ticks;
}

// Tick lists of a linear axis, from dense to sparse.
function* linearLists(low, high) {
  const power = Math.floor(Math.log10((high - low) / MOST_TICKS)) - 1;
  for (let i = 0; i < 9; i++) yield multiples(low, high, [1, 2, 5][i % 3], power + Math.floor(i / 3));
}

// Tick lists of a logarithmic axis, from dense to sparse.
function* logLists(low, high) {
  const [first, last] = [low, high].map((v) => Math.floor(Math.log10(v)));
  const of = (leads, every) => {
    const ticks = [];
    for (let p = every * Math.floor((first - 1) / every); p <= last + 1; p += every) for (const lead of leads) ticks.push(tick(lead, p));
    return ticks.filter(({ value }) => value >= low && value <= high);
  };
  if (high < 4 * low) yield* linearLists(low, high);
  if (last - first <= 4) { yield of([1, 2, 3, 4, 5, 6, 7, 8, 9], 1); yield of([1, 2, 5], 1); }
  for (const every of [1, 2, 3, 5, 10, 20, 50, 100]) yield of([1], every);
}

const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

const isPlain = ({ value, power }, from = -4, to = 5) => {
  const size = Math.floor(Math.log10(Math.abs(value)) + 1e-12);
  return value === 0 || (power >= -6 && size <= to && size >= from);
};

// The number of a tick with all its digits; very large and small ones with a power of ten.
function tickLabel(tick, plain) {
  const { value, whole, power } = tick;
  if (value === 0) return "0";
  const minus = value < 0 ? "−" : "";
  if (plain) return minus + Math.abs(value).toFixed(Math.max(0, -power));
  // Digits of the integer as d.ddd
  const all = String(Math.abs(whole));
  const digits = all.replace(/0+$/, "");
  const lead = digits.length > 1 ? `${digits[0]}.${digits.slice(1)}` : digits;
  const raised = [...String(all.length - 1 + power)].map((c) => RAISED[c]).join("");
  return `${minus}${lead === "1" ? "" : `${lead}·`}10${raised}`;
}

// Labels of the ticks of an axis; where some need powers of ten, few are plain numbers.
function tickLabels(ticks) {
  const all = ticks.every((t) => isPlain(t));
  return ticks.map((t) => tickLabel(t, all || isPlain(t, -1, 1)));
}

// Values and labels of the ticks between two limits: the largest number up to `most` whose labels fit
// (`fits` takes both lists), but at least two.
function axisTicks(low, high, { log = false, most = MOST_TICKS, fits = () => true } = {}) {
  const [p, q] = axisEnds(low, high, log);
  let least = null;
  for (const ticks of log ? logLists(p, q) : linearLists(p, q)) {
    if (ticks.length < 2 || ticks.length > MOST_TICKS) continue;
    const found = { values: ticks.map((t) => t.value), labels: tickLabels(ticks) };
    if (ticks.length <= most && fits(found.values, found.labels)) return found;
    least = [ticks[0], ticks[ticks.length - 1]];
  }
  // No list fits: the ends of the sparsest one.
  return { values: least.map((t) => t.value), labels: tickLabels(least) };
}

// Whether labels along a line of this many pixels do not overlap, given their sizes along it.
function keepApart(place, sizes, gap) {
  return sizes.every((size, i) => i === 0 || Math.abs(place[i] - place[i - 1]) >= (size + sizes[i - 1]) / 2 + gap);
}

// Ticks of an axis of this many pixels with labels in a row (`across`) or in a column.
function ticksOver(low, high, pixels, { log = false, across = true } = {}) {
  const [p, q] = axisEnds(low, high, log);
  const at = log ? (v) => pixels * Math.log(v / p) / Math.log(q / p) : (v) => pixels * ((v - p) / (q - p));
  const size = (label) => (across ? 7 * label.length : 12);
  const fits = (values, labels) => keepApart(values.map(at), labels.map(size), across ? 10 : 8);
  return axisTicks(p, q, { log, most: Math.max(4, Math.min(MOST_TICKS, Math.round(pixels / (across ? 60 : 30)))), fits });
}
