// A transient case, instant by instant: a time slider, the centreline, and the film map of point contacts.

// Duration of the whole animation in milliseconds, and the shortest and longest frame.
const PLAY = { whole: 8000, shortest: 40, longest: 600 };

// A map without a cursor.
class InstantMap extends FieldMap {
  constructor(host, caption, window, isRolling) {
    super(host, { caption, window, zone: [], onCursor: () => {}, describe: caption });
    this.canvas.removeAttribute("tabindex");
    this.canvas.removeAttribute("aria-describedby");
    this.canvas.setAttribute("role", "img");
    this.isRolling = isRolling;
  }

  name(caption) {
    this.caption = caption;
    this.canvas.setAttribute("aria-label", caption);
  }

  // Surfaces at rest have no direction of motion.
  paintMotion(ctx) { if (this.isRolling) super.paintMotion(ctx); }

  paintZone() {}

  paintCursor() {}
}

class InstantsView {
  constructor(data) {
    const element = (id) => document.getElementById(id);
    this.data = data;
    this.n = data.times.length;
    this.x = Array.from(decode(data.x, Float32Array), (x) => x / data.half_width);
    this.film = { ...data.film, values: decode(data.film.values, Uint16Array), unit: unitOf("m", data.film_axis[1] / 2) };
    this.pressure = { ...data.pressure, values: decode(data.pressure.values, Uint16Array), unit: unitOf("Pa", data.pressure.high) };
    this.time = unitOf("s", data.times[this.n - 1] / 2);
    this.slider = element("instant");
    this.button = element("play");
    this.caption = element("instant-caption");
    this.shown = element("instant-time");
    this.slider.max = this.n - 1;
    this.slider.addEventListener("input", () => { this.stop(); this.show(Number(this.slider.value)); });
    this.button.addEventListener("click", () => (this.timer ? this.stop() : this.play()));
    if (data.map) {
      const over = (ends) => ends.map((v) => v / data.half_width);
      this.films = decode(data.map.values, Uint8Array);
      this.map = new InstantMap(element("instant-map"), "Film thickness", [over(data.map.x), over(data.map.y)], data.is_rolling);
    }
    this.show(this.n - 1);
    addEventListener("beforeprint", () => { this.stop(); this.before = this.at; this.show(this.n - 1); });
    addEventListener("afterprint", () => this.show(this.before ?? this.at));
  }

  text(i) { return `${digits(this.time.show(this.data.times[i]), 4)} ${this.time.name}`; }

  // Values along the centreline at an instant, in the display unit.
  line({ low, high, values, unit }, i) {
    const n = this.x.length;
    return Array.from(values.subarray(i * n, (i + 1) * n), (v) => unit.show(low + v / 65535 * (high - low)));
  }

  show(i) {
    this.at = i;
    this.slider.value = i;
    const time = this.text(i);
    this.slider.setAttribute("aria-valuetext", time);
    this.shown.textContent = time;
    this.caption.textContent = `Film and pressure on the centreline at t = ${time}`;
    const [film, pressure] = [this.film, this.pressure].map((field) => this.line(field, i));
    const describe = this.caption.textContent;
    const drawn = charts.get("instant-profile");
    if (drawn) {
      drawn.spec.series[0].data = film;
      drawn.spec.series[1].data = pressure;
      drawn.spec.describe = describe;
      drawn.chart.setData([this.x, film, pressure]);
      drawn.chart.root.querySelector(".u-wrap").setAttribute("aria-label", describe);
    } else {
      const films = this.data.film_axis.map(this.film.unit.show);
      const highest = this.pressure.unit.show(1.05 * this.pressure.high);
      lineChart("instant-profile", {
        x: { label: "x/a", data: this.x }, describe,
        y: { label: `Film thickness (${this.film.unit.name})`, range: () => films },
        right: { label: `Pressure (${this.pressure.unit.name})`, range: () => [0, highest] },
        series: [
          { label: "film thickness", unit: this.film.unit.name, data: film },
          { label: "pressure", unit: this.pressure.unit.name, data: pressure, scale: "right", dash: [6, 4] },
        ],
      });
    }
    if (this.map) this.drawMap(i);
  }

  drawMap(i) {
    const { n: [nx, ny], range } = this.data.map;
    const [low, high] = range.map(this.film.unit.show);
    const values = this.films.subarray(i * nx * ny, (i + 1) * nx * ny);
    this.map.name(`Film thickness at t = ${this.text(i)}.`);
    const sample = (window, width, height) => {
      const out = new Float32Array(width * height);
      const across = Array.from({ length: width }, (_, k) => Math.max(0, Math.min(nx - 1.001, (k + 0.5) / width * (nx - 1))));
      for (let row = 0; row < height; row++) {
        // Picture rows start at the top, field rows at the smallest y.
        const v = Math.max(0, Math.min(ny - 1.001, (1 - (row + 0.5) / height) * (ny - 1)));
        const j = Math.floor(v);
        const t = v - j;
        for (let column = 0; column < width; column++) {
          const k = Math.floor(across[column]);
          const s = across[column] - k;
          const at = j * nx + k;
          const lower = values[at] + s * (values[at + 1] - values[at]);
          const upper = values[at + nx] + s * (values[at + nx + 1] - values[at + nx]);
          out[row * width + column] = low + (lower + t * (upper - lower)) / 255 * (high - low);
        }
      }
      return out;
    };
    this.map.draw({ sample, range: () => [low, high], unit: this.film.unit.name });
  }

  play() {
    const each = Math.max(PLAY.shortest, Math.min(PLAY.longest, PLAY.whole / this.n));
    this.button.textContent = "Stop";
    if (this.at === this.n - 1) this.show(0);
    this.timer = setInterval(() => {
      this.show(this.at + 1);
      if (this.at === this.n - 1) this.stop();
    }, each);
  }

  stop() {
    clearInterval(this.timer);
    this.timer = 0;
    this.button.textContent = "Play";
  }

  redraw() { if (this.map) this.drawMap(this.at); }
}
