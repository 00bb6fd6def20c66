// A map of a field: colours, contours, the edge of the dry contact, and a cursor.

// Stops of the colour scale viridis (Smith and van der Walt 2015, CC0), and of a scale diverging from white.
const VIRIDIS = ["440154", "481a6c", "472f7d", "414487", "39568c", "31688e", "2a788e", "23888e", "1f988b", "22a884", "35b779", "54c568", "7ad151", "a5db36", "d2e21b", "fde725"];
const DIVERGING = ["053061", "2166ac", "4393c3", "92c5de", "d1e5f0", "f7f7f7", "fddbc7", "f4a582", "d6604d", "b2182b", "67001f"];

function ramp(stops) {
  const parse = (hex) => [0, 2, 4].map((i) => parseInt(hex.slice(i, i + 2), 16));
  const all = stops.map(parse);
  const table = new Uint8ClampedArray(256 * 3);
  for (let i = 0; i < 256; i++) {
    const at = i / 255 * (all.length - 1);
    const low = Math.min(all.length - 2, Math.floor(at));
    for (let c = 0; c < 3; c++) table[3 * i + c] = all[low][c] + (at - low) * (all[low + 1][c] - all[low][c]);
  }
  return table;
}

const RAMPS = { viridis: ramp(VIRIDIS), diverging: ramp(DIVERGING) };

// Contour segments at a level through the pixels of a raster (marching squares).
function contour(raster, width, height, level, segment) {
  for (let j = 0; j + 1 < height; j++) {
    for (let i = 0; i + 1 < width; i++) {
      const at = j * width + i;
      const v = [raster[at], raster[at + 1], raster[at + width + 1], raster[at + width]];
      const low = Math.min(...v);
      if (!(low < level && Math.max(...v) >= level)) continue;
      const cut = [];
      for (let e = 0; e < 4; e++) {
        const [p, q] = [v[e], v[(e + 1) % 4]];
        if ((p < level) === (q < level)) continue;
        const t = (level - p) / (q - p);
        cut.push([[i + t, j], [i + 1, j + t], [i + 1 - t, j + 1], [i, j + 1 - t]][e]);
      }
      for (let c = 0; c + 1 < cut.length; c += 2) segment(cut[c], cut[c + 1]);
    }
  }
}

// Whether a window is much longer across the motion than along it.
function isSlender([[x0, x1], [y0, y1]]) { return y1 - y0 > 1.6 * (x1 - x0); }

class FieldMap {
  // `sample(window, width, height)` returns values in the display unit; `window` is in half-widths. A contact that is much longer across the
  // motion than along it is rotated if there is room: y to the right, x downwards.
  constructor(host, { caption, window, zone, onCursor, describe }) {
    this.window = window;
    this.zone = zone;
    this.figure = document.createElement("figure");
    this.figure.className = "map";
    const title = document.createElement("figcaption");
    title.textContent = caption;
    this.canvas = document.createElement("canvas");
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", describe);
    this.canvas.setAttribute("aria-describedby", "map-help");
    this.title = title;
    this.caption = caption;
    this.figure.append(title, this.canvas);
    host.append(this.figure);
    this.canvas.addEventListener("pointerdown", (e) => { const p = this.place(e); if (p) onCursor(p); });
    this.canvas.addEventListener("pointermove", (e) => { if (e.buttons & 1) { const p = this.place(e); if (p) onCursor(p); } });
    this.canvas.addEventListener("keydown", (e) => {
      const step = e.shiftKey ? 0.1 : 0.01;
      const shown = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[e.key];
      if (!shown) return;
      e.preventDefault();
      const move = this.fromShown(shown);
      onCursor([this.cursor[0] + move[0], this.cursor[1] + move[1]]);
    });
    this.cursor = [0, 0];
  }

  toShown([x, y]) { return this.turned ? [y, -x] : [x, y]; }

  fromShown([u, v]) { return this.turned ? [-v, u] : [u, v]; }

  layout() {
    const ratio = Math.min(2, devicePixelRatio || 1);
    const width = Math.max(260, this.canvas.clientWidth || this.figure.clientWidth);
    const [left, right, top, bottom] = [50, 92, 8, 44];
    const inner = width - left - right;
    const [[x0, x1], [y0, y1]] = this.window;
    this.turned = isSlender(this.window) && width > 620;
    this.shown = this.turned ? [[y0, y1], [-x1, -x0]] : this.window;
    const [[u0, u1], [v0, v1]] = this.shown;
    // Equal scales, unless one side would become too narrow.
    const [tallest, least] = [560, Math.min(200, inner)];
    const scale = Math.min(inner / (u1 - u0), tallest / (v1 - v0));
    const [wide, high] = [scale * (u1 - u0), scale * (v1 - v0)];
    this.frame = { left, top, width: Math.round(Math.max(wide, least)), height: Math.round(Math.max(high, least)) };
    const notes = [this.turned ? "The motion is downwards (arrow)." : "", wide < least || high < least ? "The axes have different scales." : ""];
    this.title.textContent = [this.caption, ...notes].filter(Boolean).join(" ");
    const full = top + this.frame.height + bottom;
    this.canvas.style.height = `${full}px`;
    this.canvas.width = width * ratio;
    this.canvas.height = full * ratio;
    this.ratio = ratio;
  }

  // Values at the pixels of the frame, row by row from the top.
  sampled(sample, [width, height]) {
    if (!this.turned) return sample(this.window, width, height);
    // Rows run along x from the largest y: the pixel at (column, row) has the y of the column and the x of the row.
    const raster = sample(this.window, height, width);
    const out = new Float32Array(width * height);
    for (let row = 0; row < height; row++) {
      for (let column = 0; column < width; column++) out[row * width + column] = raster[(width - 1 - column) * height + row];
    }
    return out;
  }

  // Draws a raster of the frame's size; `values` as `{sample, range, log, ramp, unit, contours}`.
  draw(values) {
    if (!this.figure.clientWidth) return;
    this.layout();
    this.values = values;
    const { width, height } = this.frame;
    const cells = [Math.round(width * this.ratio), Math.round(height * this.ratio)];
    this.raster = this.sampled(values.sample, cells);
    this.cells = cells;
    const [low, high] = axisEnds(...values.range(this.raster), values.log);
    this.range = [low, high];
    const place = values.log ? (v) => Math.log(v / low) / Math.log(high / low) : (v) => (v - low) / (high - low);
    const table = RAMPS[values.ramp ?? "viridis"];
    const image = new ImageData(...cells);
    for (let i = 0; i < this.raster.length; i++) {
      const v = this.raster[i];
      if (!Number.isFinite(v)) continue;
      const at = 3 * Math.max(0, Math.min(255, Math.round(255 * place(v))));
      image.data[4 * i] = table[at]; image.data[4 * i + 1] = table[at + 1]; image.data[4 * i + 2] = table[at + 2]; image.data[4 * i + 3] = 255;
    }
    this.image = document.createElement("canvas");
    [this.image.width, this.image.height] = cells;
    this.image.getContext("2d").putImageData(image, 0, 0);
    this.place01 = place;
    this.paint();
  }

  levels() {
    const [low, high] = this.range;
    if (this.values.log) return [];
    return axisTicks(low, high, { most: 10 }).values.filter((v) => v > low && v < high);
  }

  paint() {
    if (!this.image) return;
    const ctx = this.canvas.getContext("2d");
    const { left, top, width, height } = this.frame;
    ctx.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    ctx.clearRect(0, 0, this.canvas.width, this.canvas.height);
    ctx.imageSmoothingEnabled = false;
    ctx.drawImage(this.image, left, top, width, height);
    const ink = colour("--ink");
    ctx.font = "12px system-ui, sans-serif";
    if (this.values.contours) this.paintContours(ctx);
    this.paintZone(ctx);
    this.paintMotion(ctx);
    this.paintAxes(ctx, ink);
    this.paintBar(ctx, ink);
    this.paintCursor(ctx);
  }

  paintContours(ctx) {
    const { left, top } = this.frame;
    ctx.strokeStyle = "rgba(0,0,0,0.55)";
    ctx.lineWidth = 0.8;
    ctx.beginPath();
    for (const level of this.levels()) {
      contour(this.raster, ...this.cells, level, (p, q) => {
        ctx.moveTo(left + (p[0] + 0.5) / this.ratio, top + (p[1] + 0.5) / this.ratio);
        ctx.lineTo(left + (q[0] + 0.5) / this.ratio, top + (q[1] + 0.5) / this.ratio);
      });
    }
    ctx.stroke();
  }

  toPixel(x, y) {
    const [[u0, u1], [v0, v1]] = this.shown;
    const [u, v] = this.toShown([x, y]);
    const { left, top, width, height } = this.frame;
    return [left + (u - u0) / (u1 - u0) * width, top + (v1 - v) / (v1 - v0) * height];
  }

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    const { left, top, width, height } = this.frame;
    const [s, t] = [(event.clientX - box.left - left) / width, (event.clientY - box.top - top) / height];
    if (s < 0 || s > 1 || t < 0 || t > 1) return null;
    const [[u0, u1], [v0, v1]] = this.shown;
    return this.fromShown([u0 + s * (u1 - u0), v1 - t * (v1 - v0)]);
  }

  paintZone(ctx) {
    const { left, top, width, height } = this.frame;
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    for (const [style, dash] of [["rgba(0,0,0,0.8)", []], ["#ffffff", [5, 5]]]) {
      ctx.strokeStyle = style;
      ctx.setLineDash(dash);
      ctx.lineWidth = 1.3;
      ctx.beginPath();
      this.zone.forEach(([x, y], i) => ctx[i ? "lineTo" : "moveTo"](...this.toPixel(x, y)));
      ctx.closePath();
      ctx.stroke();
    }
    ctx.restore();
  }

  // An arrow in the corner, in the direction of the entrainment.
  paintMotion(ctx) {
    const { left, top } = this.frame;
    const [length, head] = [36, 7];
    ctx.save();
    ctx.translate(left + 14, top + 14);
    if (this.turned) ctx.rotate(Math.PI / 2);
    ctx.lineCap = "round";
    for (const [style, width] of [["#ffffff", 4.5], ["#000000", 1.8]]) {
      ctx.strokeStyle = style;
      ctx.lineWidth = width;
      ctx.beginPath();
      ctx.moveTo(0, 0); ctx.lineTo(length, 0);
      ctx.moveTo(length - head, -head / 2); ctx.lineTo(length, 0); ctx.lineTo(length - head, head / 2);
      ctx.stroke();
    }
    ctx.restore();
  }

  paintAxes(ctx, ink) {
    const { left, top, width, height } = this.frame;
    const along = this.turned ? this.window[1] : this.window[0];
    const up = this.turned ? this.window[0] : this.window[1];
    const names = this.turned ? ["y/a", "x/a"] : ["x/a", "y/a"];
    ctx.strokeStyle = ink;
    ctx.fillStyle = ink;
    ctx.lineWidth = 1;
    ctx.strokeRect(left, top, width, height);
    ctx.beginPath();
    ctx.textAlign = "center";
    ctx.textBaseline = "top";
    const xs = ticksOver(...along, width);
    xs.values.forEach((v, i) => {
      const [x] = this.turned ? this.toPixel(0, v) : this.toPixel(v, 0);
      ctx.moveTo(x, top + height); ctx.lineTo(x, top + height + 4);
      ctx.fillText(xs.labels[i], x, top + height + 6);
    });
    ctx.textAlign = "right";
    ctx.textBaseline = "middle";
    const ys = ticksOver(...up, height, { across: false });
    ys.values.forEach((v, i) => {
      const [, y] = this.turned ? this.toPixel(v, 0) : this.toPixel(0, v);
      ctx.moveTo(left, y); ctx.lineTo(left - 4, y);
      ctx.fillText(ys.labels[i], left - 7, y);
    });
    this.axes = [{ low: along[0], high: along[1], ...xs }, { low: up[0], high: up[1], ...ys }];
    ctx.stroke();
    ctx.textAlign = "center";
    ctx.textBaseline = "bottom";
    ctx.fillText(names[0], left + width / 2, top + height + 40);
    ctx.save();
    ctx.translate(14, top + height / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.fillText(names[1], 0, 0);
    ctx.restore();
  }

  paintBar(ctx, ink) {
    const { left, top, width, height } = this.frame;
    const [x, w] = [left + width + 14, 14];
    const table = RAMPS[this.values.ramp ?? "viridis"];
    for (let i = 0; i < height; i++) {
      const at = 3 * Math.round(255 * (1 - i / Math.max(1, height - 1)));
      ctx.fillStyle = `rgb(${table[at]},${table[at + 1]},${table[at + 2]})`;
      ctx.fillRect(x, top + i, w, 1.5);
    }
    ctx.strokeStyle = ink;
    ctx.strokeRect(x, top, w, height);
    const [low, high] = this.range;
    const ticks = ticksOver(low, high, height, { log: this.values.log, across: false });
    ctx.fillStyle = ink;
    ctx.textAlign = "left";
    ctx.textBaseline = "middle";
    ctx.beginPath();
    ticks.values.forEach((v, i) => {
      const y = top + (1 - this.place01(v)) * height;
      ctx.moveTo(x + w, y); ctx.lineTo(x + w + 4, y);
      ctx.fillText(ticks.labels[i], x + w + 7, y);
    });
    this.figure.dataset.frame = JSON.stringify([left, top, width, height].map((v) => Math.round(v * this.ratio)));
    this.figure.dataset.axes = JSON.stringify([...this.axes, { low, high, ...ticks }]);
    ctx.stroke();
    ctx.textBaseline = "bottom";
    ctx.fillText(this.values.unit, x, top + height + 26);
  }

  paintCursor(ctx) {
    const [x, y] = this.toPixel(...this.cursor);
    const { left, top, width, height } = this.frame;
    if (x < left || x > left + width || y < top || y > top + height) return;
    for (const [style, w] of [["rgba(0,0,0,0.75)", 3], ["#ffffff", 1.2]]) {
      ctx.strokeStyle = style;
      ctx.lineWidth = w;
      ctx.beginPath();
      ctx.moveTo(left, y); ctx.lineTo(x - 7, y); ctx.moveTo(x + 7, y); ctx.lineTo(left + width, y);
      ctx.moveTo(x, top); ctx.lineTo(x, y - 7); ctx.moveTo(x, y + 7); ctx.lineTo(x, top + height);
      ctx.stroke();
      ctx.beginPath();
      ctx.arc(x, y, 6, 0, 2 * Math.PI);
      ctx.stroke();
    }
  }

  moveTo(x, y) { this.cursor = [x, y]; this.paint(); }
}
