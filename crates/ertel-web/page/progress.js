// Newton's method as it goes: a line of words, a picture of the residuals, a table.

const SVG = "http://www.w3.org/2000/svg";
const HEIGHT = 200;
const EDGE = { left: 46, right: 10, top: 18, bottom: 26 };

function draw(name, attributes, parent, text) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
}

const power = (value) => value.toExponential(1);

export class Progress {
  static resizes = null;

  /** `say(line)` shows a line of words. */
  constructor(element, say) {
    this.element = element;
    this.say = say;
    this.point = "";
    this.stage = "";
    this.heat = "";
    this.residuals = [];
    this.stages = [];
    this.rows = element.querySelector("#iterations");
    this.rows.replaceChildren();
    element.querySelector("#plot").replaceChildren();
    element.hidden = false;
    this.planned = false;
    Progress.resizes?.disconnect();
    Progress.resizes = new ResizeObserver(([{ contentRect }]) => {
      if (this.residuals.length > 0 && contentRect.width !== this.width) this.#plan();
    });
    Progress.resizes.observe(element.querySelector("#plot"));
  }

  add(event) {
    switch (event.event) {
      case "point":
        this.point = `Point ${event.point} of ${event.n_points} (${event.value}), `;
        break;
      case "stage": {
        this.stage = `stage ${event.stage} of ${event.n_stages}`;
        this.stages.push({ at: this.residuals.length, name: String(event.stage) });
        const unknowns = `${event.pressure_unknowns.toLocaleString("en")} pressure unknowns`;
        this.say(`${this.point}${this.point ? this.stage : this.stage.replace("s", "S")}: ${unknowns}…`);
        break;
      }
      case "iteration":
        this.residuals.push(event.residual);
        this.#row(event);
        this.#plan();
        break;
      case "heat":
        this.say(`${this.point}${this.stage}, heat ${event.round}: change ${power(event.change)}, temperature rise ${event.rise.toFixed(2)} K`);
        break;
      default:
    }
  }

  #row(event) {
    const row = document.createElement("tr");
    const cells = [this.stage.replace(/^stage /, ""), event.iteration, power(event.residual), power(event.update), event.step.toFixed(2), event.film_central_text];
    row.append(...cells.map((cell) => Object.assign(document.createElement("td"), { textContent: cell })));
    this.rows.append(row);
    this.last = event;
  }

  /** At most one picture in each frame. */
  #plan() {
    if (this.planned) return;
    this.planned = true;
    requestAnimationFrame(() => {
      this.planned = false;
      this.#draw();
    });
  }

  #draw() {
    const shown = this.residuals.map((residual) => Math.log10(Math.max(residual, 1e-16)));
    const high = Math.ceil(Math.max(...shown, 0));
    const low = Math.floor(Math.min(...shown, -2));
    // As wide as its place, so that letters keep their size.
    this.width = this.element.querySelector("#plot").clientWidth;
    const width = Math.max(280, this.width);
    const n = Math.max(shown.length, 10);
    const x = (i) => EDGE.left + ((i + 0.5) / n) * (width - EDGE.left - EDGE.right);
    const y = (value) => EDGE.top + ((high - value) / (high - low)) * (HEIGHT - EDGE.top - EDGE.bottom);
    const svg = document.createElementNS(SVG, "svg");
    svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-label", `Residual over ${shown.length} Newton iterations, last ${power(this.last.residual)}; central film ${this.last.film_central_text}`);
    const step = Math.max(1, Math.ceil((high - low) / 5));
    for (let value = high; value >= low; value -= step) {
      draw("line", { class: "grid", x1: EDGE.left, x2: width - EDGE.right, y1: y(value), y2: y(value) }, svg);
      draw("text", { x: EDGE.left - 6, y: y(value) + 4, "text-anchor": "end" }, svg, `1e${value}`);
    }
    for (const { at, name } of this.stages) {
      const place = x(at) - 0.5 * (x(1) - x(0));
      draw("line", { class: "stage", x1: place, x2: place, y1: EDGE.top, y2: HEIGHT - EDGE.bottom }, svg);
      draw("text", { x: place + 4, y: EDGE.top - 5 }, svg, at === 0 ? `stage ${name}` : name);
    }
    const path = shown.map((value, i) => `${this.stages.some(({ at }) => at === i) ? "M" : "L"}${x(i).toFixed(1)} ${y(value).toFixed(1)}`);
    draw("path", { class: "curve", d: path.join("").replace(/^L/, "M") }, svg);
    shown.forEach((value, i) => draw("circle", { cx: x(i).toFixed(1), cy: y(value).toFixed(1), r: 3 }, svg));
    draw("text", { x: EDGE.left, y: HEIGHT - 8 }, svg, `residual ${power(this.last.residual)}, central film ${this.last.film_central_text}`);
    this.element.querySelector("#plot").replaceChildren(svg);
  }
}
