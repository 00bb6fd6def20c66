// Fields on a mesh of Lagrange elements, and profiles.

function decode(text, Type) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return new Type(bytes.buffer);
}

// Barycentric indices of the nodes of a triangle: corners first, then the rest of the lattice.
function lattice(order) {
  const nodes = [[order, 0, 0], [0, order, 0], [0, 0, order]];
  for (let b = 0; b <= order; b++) {
    for (let c = 0; b + c <= order; c++) {
      const node = [order - b - c, b, c];
      if (!node.includes(order)) nodes.push(node);
    }
  }
  return nodes;
}

class Mesh {
  constructor(data) {
    this.order = data.order;
    this.mirrored = data.mirrored;
    this.reach = data.reach;
    this.x = decode(data.x, Float32Array);
    this.y = decode(data.y, Float32Array);
    this.nodes = decode(data.nodes, data.node_bytes === 2 ? Uint16Array : Uint32Array);
    this.lattice = lattice(this.order);
    this.perElement = this.lattice.length;
    this.count = this.nodes.length / this.perElement;
    this.weights = new Float64Array(this.perElement);
    this.factors = [0, 1, 2].map(() => new Float64Array(this.order + 1));
    this.buckets = null;
  }

  corners(element) {
    const at = element * this.perElement;
    return [this.nodes[at], this.nodes[at + 1], this.nodes[at + 2]];
  }

  // Shape functions at barycentric coordinates: products of (k λ - j)/(j + 1), j below the index (Silvester 1969).
  shape(l0, l1, l2) {
    const [k, factors] = [this.order, this.factors];
    [l0, l1, l2].forEach((l, i) => {
      factors[i][0] = 1;
      for (let j = 0; j < k; j++) factors[i][j + 1] = factors[i][j] * (k * l - j) / (j + 1);
    });
    this.lattice.forEach(([a, b, c], i) => { this.weights[i] = factors[0][a] * factors[1][b] * factors[2][c]; });
    return this.weights;
  }

  at(values, element, l0, l1, l2) {
    const weights = this.shape(l0, l1, l2);
    const first = element * this.perElement;
    let sum = 0;
    for (let i = 0; i < this.perElement; i++) sum += weights[i] * values[this.nodes[first + i]];
    return sum;
  }

  // Area coordinates of a point in an element, from its linear functions.
  linear(element) {
    const [a, b, c] = this.corners(element);
    const [x, y] = [this.x, this.y];
    const [bx, by, cx, cy] = [x[b] - x[a], y[b] - y[a], x[c] - x[a], y[c] - y[a]];
    const area = bx * cy - cx * by;
    return (px, py) => {
      const [dx, dy] = [px - x[a], py - y[a]];
      const l1 = (dx * cy - cx * dy) / area;
      const l2 = (bx * dy - dx * by) / area;
      return [1 - l1 - l2, l1, l2];
    };
  }

  bucket() {
    const n = 64;
    const lists = Array.from({ length: n * n }, () => []);
    const box = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < this.x.length; i++) {
      box[0] = Math.min(box[0], this.x[i]); box[1] = Math.max(box[1], this.x[i]);
      box[2] = Math.min(box[2], this.y[i]); box[3] = Math.max(box[3], this.y[i]);
    }
    const column = (x) => Math.max(0, Math.min(n - 1, Math.floor((x - box[0]) / (box[1] - box[0]) * n)));
    const row = (y) => Math.max(0, Math.min(n - 1, Math.floor((y - box[2]) / (box[3] - box[2]) * n)));
    for (let e = 0; e < this.count; e++) {
      const nodes = this.corners(e);
      const xs = nodes.map((i) => this.x[i]);
      const ys = nodes.map((i) => this.y[i]);
      for (let j = row(Math.min(...ys)); j <= row(Math.max(...ys)); j++) {
        for (let i = column(Math.min(...xs)); i <= column(Math.max(...xs)); i++) lists[j * n + i].push(e);
      }
    }
    return (x, y) => lists[row(y) * n + column(x)];
  }

  // Value at a point, m; NaN outside the mesh.
  value(values, x, y) {
    if (this.mirrored) y = -Math.abs(y);
    this.buckets ??= this.bucket();
    const slack = -1e-5;
    for (const e of this.buckets(x, y)) {
      const [l0, l1, l2] = this.linear(e)(x, y);
      if (l0 >= slack && l1 >= slack && l2 >= slack) return this.at(values, e, l0, l1, l2);
    }
    return NaN;
  }

  // Values at the pixel centres of a window, row by row from the top.
  raster(values, [x0, x1], [y0, y1], width, height) {
    const out = new Float32Array(width * height).fill(NaN);
    const [dx, dy] = [(x1 - x0) / width, (y1 - y0) / height];
    for (let e = 0; e < this.count; e++) {
      const nodes = this.corners(e);
      const xs = nodes.map((i) => this.x[i]);
      const ys = nodes.map((i) => this.y[i]);
      const left = Math.max(0, Math.ceil((Math.min(...xs) - x0) / dx - 0.5));
      const right = Math.min(width - 1, Math.floor((Math.max(...xs) - x0) / dx - 0.5));
      if (left > right) continue;
      const coordinates = this.linear(e);
      for (const sign of this.mirrored ? [1, -1] : [1]) {
        const signed = ys.map((y) => sign * y);
        const top = Math.max(0, Math.ceil((y1 - Math.max(...signed)) / dy - 0.5));
        const bottom = Math.min(height - 1, Math.floor((y1 - Math.min(...signed)) / dy - 0.5));
        for (let row = top; row <= bottom; row++) {
          const y = sign * (y1 - (row + 0.5) * dy);
          for (let column = left; column <= right; column++) {
            const [l0, l1, l2] = coordinates(x0 + (column + 0.5) * dx, y);
            if (l0 < -1e-6 || l1 < -1e-6 || l2 < -1e-6) continue;
            out[row * width + column] = this.at(values, e, l0, l1, l2);
          }
        }
      }
    }
    return out;
  }
}

// A field over many decades, such as the viscosity, is interpolated in its logarithm: the polynomial itself would become negative.
function spread(field) {
  let [low, high] = [Infinity, 0];
  for (const v of field.values) { low = Math.min(low, v); high = Math.max(high, v); }
  const isWide = low > 0 && high > 100 * low && field.unit !== "m";
  return isWide ? { ...field, values: field.values.map(Math.log), read: Math.exp, isWide } : { ...field, read: (v) => v, isWide };
}

class Result {
  constructor(data, name) {
    this.data = data;
    this.name = name;
    this.a = data.half_width;
    this.figures = data.figures;
    this.mesh = data.mesh ? new Mesh(data.mesh) : null;
    this.fields = (data.mesh?.fields ?? []).map((f) => spread({ ...f, values: decode(f.values, Float32Array) }));
    this.line = {
      x: decode(data.centreline.x, Float32Array),
      fields: data.centreline.fields.map((f) => ({ ...f, values: decode(f.values, Float32Array) })),
    };
  }

  field(name) { return this.fields.find((f) => f.name === name); }
  profile(name) { return this.line.fields.find((f) => f.name === name); }
  value(name, x, y) { const f = this.field(name); return f ? f.read(this.mesh.value(f.values, x, y)) : NaN; }
  raster(name, ...window) { const f = this.field(name); return this.mesh.raster(f.values, ...window).map(f.read); }
}
