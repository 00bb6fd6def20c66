// Units and digits of displayed numbers.

const CELSIUS = 273.15;

function unitOf(unit, size) {
  const among = (list) => list.find(([from]) => size >= from) ?? list[list.length - 1];
  const lists = {
    m: [[1e-3, 1e3, "mm"], [1e-6, 1e6, "µm"], [0, 1e9, "nm"]],
    Pa: [[1e9, 1e-9, "GPa"], [1e6, 1e-6, "MPa"], [1e3, 1e-3, "kPa"], [0, 1, "Pa"]],
    "Pa.s": [[1, 1, "Pa·s"], [0, 1e3, "mPa·s"]],
    "kg/m^3": [[0, 1, "kg/m³"]],
    "N/m": [[1e3, 1e-3, "kN/m"], [0, 1, "N/m"]],
    "1/s": [[0, 1, "1/s"]],
    s: [[1, 1, "s"], [1e-3, 1e3, "ms"], [0, 1e6, "µs"]],
    "1/Pa": [[0, 1e9, "1/GPa"]],
    "rad/s": [[0, 30 / Math.PI, "rpm"]],
    rad: [[0, 180 / Math.PI, "°"]],
  };
  if (unit === "K") return { show: (v) => v - CELSIUS, back: (v) => v + CELSIUS, factor: 1, name: "°C" };
  const [, factor, name] = lists[unit] ? among(lists[unit]) : [0, 1, unit];
  return { show: (v) => v * factor, back: (v) => v / factor, factor, name };
}

function digits(value, n = 4) {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)));
  if (exponent < -4 || exponent > 8) return value.toExponential(n - 1);
  return value.toFixed(Math.max(0, n - 1 - exponent));
}

// An input value, without added digits.
function exactly(value) { return String(Number(value.toPrecision(6))); }

// Value and error bar with the certain digits.
function withBar(value, error, unit) {
  const space = unit ? " " : "";
  if (!(error > 0) || !Number.isFinite(error)) return `${digits(value, 5)}${space}${unit}`;
  const first = Math.floor(Math.log10(error));
  const two = Math.round(error * 10 ** (2 - first)) <= 354;
  const places = two ? 1 - first : -first;
  if (places > 12) return `${value.toExponential(4)} ± ${error.toExponential(1)}${space}${unit}`;
  // Uncertain digits before the point become zeros.
  if (places < 0) {
    const round = (v) => (Math.round(v * 10 ** places) / 10 ** places).toFixed(0);
    return `${round(value)} ± ${round(error)}${space}${unit}`;
  }
  const at = Math.max(0, Math.min(places, 5 - Math.floor(Math.log10(Math.max(Math.abs(value), error)))));
  const shown = Math.max(error, 10 ** -at).toFixed(at);
  return `${value.toFixed(at)} ± ${shown}${space}${unit}`;
}

function figureText(figure) {
  const unit = unitOf(figure.unit, Math.abs(figure.value));
  const error = figure.error == null ? null : figure.error * unit.factor;
  // A bar too wide for a number: a peak that the mesh cuts off is a lower bound.
  if (figure.resolved === false) return figure.is_peak ? `at least ${digits(unit.show(figure.value), 3)} ${unit.name}, not resolved` : "not resolved";
  return withBar(unit.show(figure.value), error, unit.name);
}

function capital(text) { return text.charAt(0).toUpperCase() + text.slice(1); }
