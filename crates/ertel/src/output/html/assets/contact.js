// The contact area of one or several results: maps, cursor, and profiles through it.

const SAMPLES = 801;

// Share of the dry contact's size that counts as inside; the largest film there times the margin is the end of the colour scale.
const WITHIN = 0.9;
const FILM_MARGIN = 1.3;

// Whether a point is inside a closed polygon: a ray from it crosses an odd number of edges.
function isInside(polygon, x, y) {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [[x1, y1], [x2, y2]] = [polygon[i], polygon[j]];
    if ((y1 > y) !== (y2 > y) && x < x1 + (y - y1) / (y2 - y1) * (x2 - x1)) inside = !inside;
  }
  return inside;
}

class ContactView {
  constructor(results) {
    this.results = results;
    this.cursor = [0, 0];
    const shared = results[0].fields.filter((f) => results.every((r) => r.field(f.name)));
    this.names = shared.map((f) => f.name);
    const select = document.getElementById("field");
    for (const f of shared) select.add(new Option(capital(f.words), f.name));
    select.value = this.names.includes("film_thickness") ? "film_thickness" : this.names[0];
    select.addEventListener("change", () => this.show());
    document.getElementById("contours").addEventListener("change", () => this.show());
    for (const id of ["cursor-x", "cursor-y"]) {
      document.getElementById(id).addEventListener("change", () => {
        const read = (n) => Number(document.getElementById(n).value) || 0;
        this.moveTo([read("cursor-x"), read("cursor-y")], false);
      });
    }
    this.jumps();
    const { left_out: missing, off_by: offBy } = results[0].data.mesh;
    const omitted = missing.length ? ` Omitted from this page to limit its size: ${missing.join(", ")}; surface.vtu has them.` : "";
    const fewer = offBy ? ` To limit its size, this page has fewer nodes than the solution: except for the figures, values are within ${100 * offBy} % (relative for the film, of the range for other fields).` : "";
    document.getElementById("left-out").textContent = omitted + fewer;
    this.build();
  }

  // The window of all maps, in half-widths of each result: the contact and a margin.
  window() {
    const ends = (axis) => Math.max(...this.results.map((r) => r.data.zone[axis] / r.a));
    const [x, y] = [ends(0), ends(1)];
    const margin = 0.45 * Math.min(x, y);
    return [[-x - 1.4 * margin, x + margin], [-y - margin, y + margin]];
  }

  // Edge of the dry contact, in half-widths.
  zone(result) {
    if (result.data.edge) return result.data.edge.map((p) => p.map((v) => v / result.a));
    const [x, y] = result.data.zone.map((v) => v / result.a);
    if (result.data.kind === "roller") return [[-x, -y], [x, -y], [x, y], [-x, y]];
    return Array.from({ length: 121 }, (_, i) => [x * Math.cos(i * Math.PI / 60), y * Math.sin(i * Math.PI / 60)]);
  }

  jumps() {
    const host = document.getElementById("jumps");
    for (const figure of this.results[0].figures) {
      if (figure.x == null) continue;
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = capital(figure.words);
      button.dataset.figure = figure.name;
      button.addEventListener("click", () => {
        const a = this.results[0].a;
        const field = { Pa: "pressure", K: "temperature_mid", m: "film_thickness" }[figure.unit];
        const select = document.getElementById("field");
        if (this.names.includes(field) && select.value !== field) { select.value = field; this.show(); }
        this.moveTo([figure.x / a, figure.y / a]);
      });
      host.append(button);
    }
  }

  build() {
    const host = document.getElementById("maps");
    const window = this.window();
    this.maps = [];
    const add = (caption, result, of) => {
      const map = new FieldMap(host, {
        caption, window, zone: this.zone(result), onCursor: (p) => this.moveTo(p),
        describe: `Map of the chosen field, ${caption || "whole contact"}; the cursor reads values`,
      });
      this.maps.push({ map, of });
    };
    const single = this.results.length === 1;
    // A single map is next to its profiles, unless it is as wide as the page.
    const [[x0, x1], [y0, y1]] = window;
    document.getElementById("area").classList.toggle("paired", single && !isSlender(window) && x1 - x0 < 1.6 * (y1 - y0));
    host.classList.toggle("wide", single || isSlender(window));
    this.results.forEach((r, i) => add(single ? "" : `${i + 1}: ${r.name}`, r, { result: r }));
    this.results.slice(1).forEach((r, i) => add(`Difference, ${i + 2} − 1`, r, { result: r, minus: this.results[0] }));
    this.show();
  }

  // Display of the chosen field. Lengths and pressures take the unit of their magnitude in the dry contact.
  look() {
    const name = document.getElementById("field").value;
    const fields = this.results.map((r) => r.field(name));
    let size = 0;
    this.results.forEach((r, k) => {
      const f = fields[k];
      const edge = this.zone(r).map((p) => p.map((v) => WITHIN * r.a * v));
      for (let i = 0; i < f.values.length; i++) {
        if (isInside(edge, r.mesh.x[i], r.mesh.y[i])) size = Math.max(size, Math.abs(f.read(f.values[i])));
      }
    });
    return { name, words: fields[0].words, within: size, unit: unitOf(fields[0].unit, size), isWide: fields.every((f) => f.isWide) };
  }

  show() {
    const look = this.look();
    this.shown = look;
    const contours = document.getElementById("contours").checked;
    const sample = (r) => (w, width, height) => {
      const [xs, ys] = w.map((ends) => ends.map((v) => v * r.a));
      return r.raster(look.name, xs, ys, width, height).map(look.unit.show);
    };
    // The gap is wide far from the contact: the colours cover the film within the dry contact.
    const top = look.name === "film_thickness" && look.within > 0 ? FILM_MARGIN * look.unit.show(look.within) : Infinity;
    const ends = (raster) => {
      let [low, high] = [Infinity, -Infinity];
      for (const v of raster) if (Number.isFinite(v)) { if (v < low) low = v; if (v > high) high = v; }
      return [low, Math.min(high, top)];
    };
    const rasters = this.maps.filter((m) => !m.of.minus);
    let common = [Infinity, -Infinity];
    for (const { of } of rasters) {
      const [low, high] = ends(sample(of.result)(this.window(), 120, 100));
      common = [Math.min(common[0], low), Math.max(common[1], high)];
    }
    const log = look.isWide && common[1] > 100 * common[0];
    for (const { map, of } of this.maps) {
      if (of.minus) {
        const difference = (w, width, height) => {
          const [one, two] = [of.result, of.minus].map((r) => sample(r)(w, width, height));
          return one.map((v, i) => (two[i] > top || v > top ? NaN : v - two[i]));
        };
        const range = (raster) => {
          let most = 0;
          for (const v of raster) if (Number.isFinite(v)) most = Math.max(most, Math.abs(v));
          return [-(most || 1), most || 1];
        };
        const unit = look.unit.name === "°C" ? "K" : look.unit.name;
        map.draw({ sample: difference, range, ramp: "diverging", unit, contours: false });
      } else {
        const range = (raster) => (this.results.length > 1 ? common : ends(raster));
        map.draw({ sample: sample(of.result), range, log, unit: look.unit.name, contours });
      }
    }
    this.moveTo(this.cursor, true, true);
  }

  moveTo(place, write = true, again = false) {
    const [[x0, x1], [y0, y1]] = this.window();
    const clamp = (v, low, high) => Math.max(low, Math.min(high, v));
    const next = [clamp(place[0], x0, x1), clamp(place[1], y0, y1)];
    const same = next[0] === this.cursor[0] && next[1] === this.cursor[1];
    this.cursor = next;
    if (write || !same) {
      document.getElementById("cursor-x").value = Number(next[0].toFixed(4));
      document.getElementById("cursor-y").value = Number(next[1].toFixed(4));
    }
    if (same && !again && this.drawn) return;
    this.drawn = true;
    for (const { map } of this.maps) map.moveTo(...next);
    this.read();
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.profiles());
  }

  // Values under the cursor, in SI units for programs and as text for users.
  values() {
    return this.results.map((r) => Object.fromEntries(r.fields.map((f) => [f.name, r.value(f.name, this.cursor[0] * r.a, this.cursor[1] * r.a)])));
  }

  read() {
    const all = this.values();
    const text = this.results.map((r, i) => {
      const first = ["film_thickness", "pressure", this.shown.name, "temperature_mid"].filter((n, k, list) => r.field(n) && list.indexOf(n) === k);
      const parts = first.map((n) => {
        const f = r.field(n);
        const unit = unitOf(f.unit, Math.abs(all[i][n]));
        return `${f.words} ${digits(unit.show(all[i][n]), 5)} ${unit.name}`;
      });
      return (this.results.length > 1 ? `${i + 1}: ` : "") + parts.join(", ");
    });
    const at = `x/a ${this.cursor[0].toFixed(3)}, y/a ${this.cursor[1].toFixed(3)}`.replaceAll("-", "−");
    const reading = document.getElementById("reading");
    reading.textContent = `At ${at}: ${text.join("; ")}`;
    reading.dataset.values = JSON.stringify(all);
  }

  profiles() {
    const { name, unit, words, isWide } = this.shown;
    const window = this.window();
    const label = `${capital(words)} (${unit.name})`;
    for (const [id, axis] of [["along", 0], ["across", 1]]) {
      const [low, high] = window[axis];
      const at = Array.from({ length: SAMPLES }, (_, i) => low + (high - low) * i / (SAMPLES - 1));
      const series = this.results.map((r, k) => ({
        label: this.results.length > 1 ? `${k + 1}: ${r.name}` : words,
        unit: unit.name,
        dash: k % 2 ? [6, 4] : undefined,
        ink: k,
        data: at.map((v) => {
          const p = axis === 0 ? [v, this.cursor[1]] : [this.cursor[0], v];
          return unit.show(r.value(name, p[0] * r.a, p[1] * r.a));
        }),
      }));
      const isFilm = name === "film_thickness";
      const most = isFilm ? 3 * Math.max(...this.results.map((r) => unit.show(r.figures[0].value))) : null;
      const range = isFilm ? (min, max) => [0, Math.min(most, 1.08 * max)] : null;
      lineChart(id, {
        x: { label: axis === 0 ? "x/a" : "y/a", data: at }, y: { label, range, log: isWide }, series, mark: this.cursor[axis], height: 240,
        describe: `${capital(words)} ${axis === 0 ? "along" : "across"} the motion through the cursor`,
      });
    }
  }
}

class CentrelineView {
  constructor(results) {
    this.results = results;
    const shared = results[0].line.fields.filter((f) => results.every((r) => r.profile(f.name)));
    for (const [id, start] of [["left", "pressure"], ["right", "film_thickness"]]) {
      const select = document.getElementById(id);
      for (const f of shared) select.add(new Option(capital(f.words), f.name));
      if (id === "right") select.add(new Option("Nothing", ""));
      select.value = start;
      select.addEventListener("change", () => this.show());
    }
    this.show();
  }

  show() {
    const chosen = (id) => document.getElementById(id).value;
    const series = [];
    const axis = (name, scale) => {
      const fields = this.results.map((r) => r.profile(name));
      const inside = (r, f) => f.values.filter((_, i) => Math.abs(r.line.x[i]) < 1.05 * r.data.zone[0]);
      const size = Math.max(...this.results.map((r, k) => inside(r, fields[k]).reduce((m, v) => Math.max(m, Math.abs(v)), 0)));
      const unit = unitOf(fields[0].unit, size);
      const shown = this.results.flatMap((r, k) => Array.from(inside(r, fields[k]), unit.show)).filter((v) => v > 0);
      const log = shown.length && Math.max(...shown) > 1e3 * Math.min(...shown) && fields[0].unit === "Pa.s";
      this.results.forEach((r, k) => series.push({
        label: (this.results.length > 1 ? `${k + 1}: ` : "") + fields[k].words, unit: unit.name, scale,
        ink: this.results.length > 1 ? k : (scale === "y" ? 0 : 1), dash: this.results.length > 1 && scale !== "y" ? [6, 4] : undefined,
        x: r.line.x, a: r.a, data: fields[k].values, show: unit.show,
        most: name === "film_thickness" ? 3 * unit.show(Math.max(...this.results.map((q) => q.figures[0].value))) : Infinity,
      }));
      const most = series[series.length - 1].most;
      const range = Number.isFinite(most) ? () => [0, most] : null;
      return { label: `${capital(fields[0].words)} (${unit.name})`, log, range };
    };
    const y = axis(chosen("left"), "y");
    const right = chosen("right") ? axis(chosen("right"), "right") : null;
    if (chosen("left") === "pressure" && this.results.length === 1) {
      const hertz = this.results[0].profile("hertz_pressure");
      const pressure = series[0];
      series.splice(1, 0, { ...pressure, label: "dry contact (Hertz)", data: hertz.values, dash: [6, 5], ink: 4 });
    }
    // Results of several meshes share an axis: it has the points of all of them, with the other results interpolated.
    const all = [...new Set(this.results.flatMap((r) => Array.from(r.line.x, (x) => x / r.a)))].sort((p, q) => p - q);
    for (const s of series) {
      const xs = Array.from(s.x, (x) => x / s.a);
      let at = 0;
      s.data = all.map((x) => {
        while (at + 1 < xs.length - 1 && xs[at + 1] < x) at++;
        const t = (x - xs[at]) / (xs[at + 1] - xs[at]);
        if (t < -1e-9 || t > 1 + 1e-9) return NaN;
        const [p, q] = [this.original(s, at), this.original(s, at + 1)];
        const v = t === 0 ? p : t === 1 ? q : p + t * (q - p);
        return v;
      });
    }
    // The view covers the pressure field; the copied points cover the whole centreline.
    const [first, last] = this.ends();
    const x = { label: "x/a", data: all, range: (low, high) => [Math.max(low, first), Math.min(high, last)] };
    lineChart("profile", {
      x, y, right, series, height: 380,
      describe: `Profiles along the centreline: ${series.map((s) => s.label).join(", ")}`,
    });
  }

  // Range of the pressure, in half-widths: above a hundredth of its maximum, plus a margin.
  ends() {
    let [first, last] = [Infinity, -Infinity];
    for (const r of this.results) {
      const { values } = r.profile("pressure");
      const most = values.reduce((m, v) => Math.max(m, v), 0);
      values.forEach((v, i) => {
        if (!(v > 0.01 * most)) return;
        first = Math.min(first, r.line.x[i] / r.a);
        last = Math.max(last, r.line.x[i] / r.a);
      });
    }
    return [first - 0.4, last + 0.4];
  }

  original(series, i) {
    series.values ??= series.data;
    return series.show(series.values[i]);
  }
}
