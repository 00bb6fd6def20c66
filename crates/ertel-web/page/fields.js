// The fields of the form: which keys of the case file they show, and what a change of one puts into the file.
//
// A field has `keys(file)`, the key path that it edits; `shown(file)`, whether it belongs to the case as it is; and, where it is a choice
// between forms of a case, `value(file)` and `choose(file, value)`, the list of changes. `file` is a view of the case file (class File).
// `database.keys`, from the program, has the choices of keys, their meaning, and which values are numbers.

/** Values of a case file by key path, as the module gives them. */
export class File {
  constructor({ values, tables }) {
    this.values = values;
    this.tables = tables;
  }

  value(key) {
    return this.values[key];
  }

  /** Whether the key is there, as a value or as a table. */
  has(key) {
    return key in this.values || this.tables.includes(key);
  }

  /** Changes that remove the keys that are there. */
  without(...keys) {
    return keys.filter((key) => this.has(key)).map((key) => [key, null]);
  }

  /** The first of some names of a key that is there, else the first one. */
  name(...keys) {
    return keys.find((key) => this.has(key)) ?? keys[0];
  }

  get kind() {
    return this.value("contact.kind");
  }

  /** The key of a body: `body_1` or, older, `plane`. */
  body(n) {
    return this.name(...(n === 1 ? ["bodies.plane", "bodies.body_1"] : ["bodies.ball", "bodies.body_2"]));
  }

  /** Where the name of a body's material stands, if it has one. */
  material(n) {
    const body = this.body(n);
    return this.tables.includes(body) ? `${body}.name` : body;
  }

  /** Where the name of the oil stands: `lubricant = "..."` is short for a table with `name`. */
  get oil() {
    return typeof this.value("lubricant") === "string" ? "lubricant" : "lubricant.name";
  }

  get oilKind() {
    if (this.has(this.oil)) return "database";
    const sheet = ["iso_vg", "kinematic_viscosity_40", "kinematic_viscosity_100", "viscosity_index", "density_15", "base_oil"];
    if (sheet.some((key) => this.has(`lubricant.${key}`))) return "sheet";
    const law = this.value("lubricant.viscosity.law");
    const density = this.value("lubricant.density.law");
    if (this.has("lubricant.viscosity") && !["roelands", "barus"].includes(law)) return "file";
    if (this.has("lubricant.density") && density !== "dowson-higginson") return "file";
    return "own";
  }
}

const speed = (text) => {
  const match = /^\s*([-+\d.eE]+)\s*m\/s\s*$/.exec(String(text ?? ""));
  return match ? Number(match[1]) : NaN;
};
const round = (number) => Number(number.toPrecision(12));

/** Both speeds as entrainment speed and slide-to-roll ratio, and the other way; empty changes where they cannot be read. */
function motionChanges(file, mode) {
  const old = [1, 2].map((n) => file.name(...(n === 1 ? ["motion.body_1_speed", "motion.plane_speed"] : ["motion.body_2_speed", "motion.ball_speed"])));
  if (mode === "speeds") {
    const u = speed(file.value("motion.entrainment_speed"));
    const ratio = Number(file.value("motion.slide_to_roll_ratio"));
    const known = Number.isFinite(u) && Number.isFinite(ratio);
    return [
      ...file.without("motion.entrainment_speed", "motion.slide_to_roll_ratio"),
      ["motion.body_1_speed", known ? `${round(u * (1 - ratio / 2))} m/s` : ""],
      ["motion.body_2_speed", known ? `${round(u * (1 + ratio / 2))} m/s` : ""],
    ];
  }
  const [u1, u2] = old.map((key) => speed(file.value(key)));
  const u = (u1 + u2) / 2;
  const known = Number.isFinite(u) && u !== 0;
  return [
    ...file.without(...old),
    ["motion.entrainment_speed", known ? `${round(u)} m/s` : ""],
    ["motion.slide_to_roll_ratio", known ? round((u2 - u1) / u) : 0],
  ];
}

const PASCAL = (value) => `${round(value / 1e9)} GPa`;
const ofMachine = (file) => file.has("machine");
const loadUnit = (kind) => (kind === "line" ? "N/m" : "N");

/** A load that was a force becomes one per length, or the other way: the number stays. */
function loadFor(file, kind) {
  const load = file.value("contact.load");
  if (typeof load !== "string" || loadUnit(kind) === loadUnit(file.kind)) return [];
  return [["contact.load", kind === "line" ? `${load.trim()}/m` : load.replace(/\/\s*m+\s*$/, "").trim()]];
}

function kindChanges(file, kind) {
  const radius = file.value("contact.radius") ?? file.value("contact.radius_x") ?? "10 mm";
  const bodyRadii = [1, 2].flatMap((n) => [`${file.body(n)}.radius_x`, `${file.body(n)}.radius_y`]);
  const changes = [["contact.kind", kind], ...loadFor(file, kind)];
  if (kind === "elliptical") {
    changes.push(...file.without("contact.radius", "contact.length", "contact.profile", "contact.misalignment"));
    if (!bodyRadii.some((key) => file.has(key))) {
      changes.push(["contact.radius_x", radius], ["contact.radius_y", file.value("contact.radius_y") ?? radius]);
    }
    return changes;
  }
  changes.push(...file.without("contact.radius_x", "contact.radius_y", "contact.entrainment_angle", "bodies.axes_angle", ...bodyRadii));
  if (!file.has("contact.radius")) changes.push(["contact.radius", radius]);
  if (kind !== "roller") {
    changes.push(...file.without("contact.length", "contact.profile", "contact.misalignment"));
  } else if (!file.has("contact.length")) {
    changes.push(["contact.length", "10 mm"], ["contact.profile.kind", "logarithmic"], ["contact.profile.design_load", file.value("contact.load")?.replace(/\/\s*m+\s*$/, "") ?? "1 kN"]);
  }
  return changes;
}

function body(n, what, database) {
  const name = (file) => file.value(file.material(n));
  return [
    {
      label: `Body ${n} (${what})`,
      wide: true,
      options: () => [
        ...database.solids.map((solid) => [solid.name, `${solid.name}: ${solid.title}`]),
        ["", "own elastic constants"],
      ],
      keys: (file) => file.material(n),
      also: (file) => [file.body(n)],
      value: (file) => name(file) ?? "",
      choose(file, material) {
        const key = file.body(n);
        const constants = file.without(`${key}.youngs_modulus`, `${key}.poissons_ratio`);
        if (material) return [...constants, [file.tables.includes(key) && hasMore(file, key) ? `${key}.name` : key, material]];
        const solid = database.solids.find((one) => one.name === name(file));
        return [
          ...file.without(`${key}.name`),
          [`${key}.youngs_modulus`, solid ? PASCAL(solid.youngs_modulus) : "210 GPa"],
          [`${key}.poissons_ratio`, solid ? solid.poissons_ratio : 0.3],
        ];
      },
    },
    {
      label: "Young’s modulus E",
      keys: (file) => `${file.body(n)}.youngs_modulus`,
      shown: (file) => name(file) === undefined || file.has(`${file.body(n)}.youngs_modulus`),
    },
    {
      label: "Poisson’s ratio ν",
      keys: (file) => `${file.body(n)}.poissons_ratio`,
      shown: (file) => name(file) === undefined || file.has(`${file.body(n)}.poissons_ratio`),
    },
    ...["x", "y"].map((axis) => ({
      label: `Radius of body ${n} along ${axis}`,
      hint: axis === "x" ? "concave: negative; “flat” is allowed" : "",
      keys: (file) => `${file.body(n)}.radius_${axis}`,
      shown: (file) => file.kind === "elliptical" && !file.has("contact.radius_x") && !file.has("contact.radius_y"),
    })),
  ];
}

/** Whether a body's table has keys other than its name and elastic constants. */
function hasMore(file, key) {
  const plain = ["name", "youngs_modulus", "poissons_ratio"].map((part) => `${key}.${part}`);
  return Object.keys(file.values).some((one) => one.startsWith(`${key}.`) && !plain.includes(one));
}

/** Groups of fields; `section` is the table of the case file that errors without a field belong to. */
export function groups(database) {
  /** The choices of a key, each with a title or its own name. */
  const choices = (key, titles = {}) => () => database.keys[key].choices.map((choice) => [choice, titles[choice] ?? choice]);
  return [
    {
      legend: "Contact",
      sections: ["title", "contact"],
      fields: [
        {
          label: "Kind",
          wide: true,
          options: choices("contact.kind", { circular: "circular: ball on plane", line: "line: long cylinder on plane", elliptical: "elliptical: two radii", roller: "roller of finite length" }),
          keys: () => "contact.kind",
          shown: (file) => !ofMachine(file),
          choose: kindChanges,
        },
        {
          label: "Reduced radius R",
          hint: "1/R = 1/R₁ + 1/R₂, such as 16 mm",
          keys: () => "contact.radius",
          shown: (file) => !ofMachine(file) && file.kind !== "elliptical",
        },
        {
          label: "Radii",
          wide: true,
          options: () => [["reduced", "reduced radii"], ["bodies", "radii of both bodies"]],
          keys: () => "",
          shown: (file) => file.kind === "elliptical",
          value: (file) => (file.has("contact.radius_x") || file.has("contact.radius_y") ? "reduced" : "bodies"),
          choose(file, which) {
            const [one, two] = [file.body(1), file.body(2)];
            const table = (n) => (file.tables.includes(file.body(n)) ? [] : [[`${file.body(n)}.name`, file.value(file.body(n)) ?? "steel"]]);
            if (which === "reduced") {
              return [
                ...file.without(...[one, two].flatMap((key) => [`${key}.radius_x`, `${key}.radius_y`]), "bodies.axes_angle"),
                ["contact.radius_x", "10 mm"],
                ["contact.radius_y", "10 mm"],
              ];
            }
            return [
              ...table(1),
              ...table(2),
              [`${one}.radius_x`, "flat"],
              [`${one}.radius_y`, "flat"],
              [`${two}.radius_x`, file.value("contact.radius_x") ?? "10 mm"],
              [`${two}.radius_y`, file.value("contact.radius_y") ?? "10 mm"],
              ...file.without("contact.radius_x", "contact.radius_y"),
            ];
          },
        },
        ...["x", "y"].map((axis) => ({
          label: `Reduced radius along ${axis}`,
          keys: () => `contact.radius_${axis}`,
          shown: (file) => file.kind === "elliptical" && (file.has("contact.radius_x") || file.has("contact.radius_y")),
        })),
        { label: "Length l", keys: () => "contact.length", shown: (file) => file.kind === "roller" },
        {
          label: "Load given by",
          options: () => [["load", "load"], ["hertz_pressure", "Hertz pressure"]],
          keys: () => "",
          shown: (file) => !ofMachine(file),
          value: (file) => (file.has("contact.hertz_pressure") ? "hertz_pressure" : "load"),
          choose: (file, which) => (which === "load"
            ? [["contact.hertz_pressure", null], ["contact.load", file.kind === "line" ? "100 kN/m" : "100 N"]]
            : [["contact.load", null], ["contact.hertz_pressure", "1 GPa"]]),
        },
        {
          label: "Load",
          hint: "a force, of a line contact per length: 100 N, 50 kN/m",
          keys: () => "contact.load",
          shown: (file) => !ofMachine(file) && !file.has("contact.hertz_pressure"),
        },
        { label: "Hertz pressure", keys: () => "contact.hertz_pressure", shown: (file) => !ofMachine(file) && file.has("contact.hertz_pressure") },
        { label: "Design load of the profile", keys: () => "contact.profile.design_load", shown: (file) => file.kind === "roller" && file.value("contact.profile.kind") === "logarithmic" },
        { label: "Crown radius of the profile", keys: () => "contact.profile.crown_radius", shown: (file) => file.kind === "roller" && file.has("contact.profile.crown_radius") },
      ],
      note: (file) => (ofMachine(file) ? "[machine] in the case file gives contact and speeds." : ""),
    },
    { legend: "Materials", sections: ["bodies", "surface_roughness"], fields: [...body(1, "plane, disc", database), ...body(2, "ball, cylinder", database)] },
    {
      legend: "Speeds",
      sections: ["motion", "machine"],
      fields: [
        {
          label: "Given by",
          wide: true,
          options: () => [["entrainment", "entrainment speed and slide-to-roll ratio"], ["speeds", "speeds of both bodies"]],
          keys: () => "",
          shown: (file) => !ofMachine(file),
          value: (file) => (["motion.body_1_speed", "motion.body_2_speed", "motion.plane_speed", "motion.ball_speed"].some((key) => file.has(key)) ? "speeds" : "entrainment"),
          choose: motionChanges,
        },
        {
          label: "Entrainment speed uₘ",
          hint: "(u₁ + u₂)/2",
          keys: () => "motion.entrainment_speed",
          shown: (file, field) => !ofMachine(file) && field("Given by") === "entrainment",
        },
        {
          label: "Slide-to-roll ratio",
          hint: "(u₂ − u₁)/uₘ",
          keys: () => "motion.slide_to_roll_ratio",
          shown: (file, field) => !ofMachine(file) && field("Given by") === "entrainment",
        },
        ...[1, 2].map((n) => ({
          label: `Speed of body ${n}`,
          keys: (file) => file.name(`motion.body_${n}_speed`, n === 1 ? "motion.plane_speed" : "motion.ball_speed"),
          shown: (file, field) => !ofMachine(file) && field("Given by") === "speeds",
        })),
      ],
    },
    {
      legend: "Oil",
      sections: ["lubricant", "temperature", "inlet"],
      fields: [
        {
          label: "Lubricant",
          wide: true,
          options: (file) => [
            ["own:", "own values: viscosity, pressure coefficient, density"],
            ["sheet:", "own values: data sheet (viscosities at 40 and 100 °C)"],
            ...(file.oilKind === "file" ? [["file:", "laws in the case file"]] : []),
            ...database.fluids.map((fluid) => [fluid.name, `${fluid.name}: ${fluid.title}`]),
          ],
          keys: (file) => file.oil,
          also: () => ["lubricant"],
          value: (file) => (file.oilKind === "database" ? file.value(file.oil) : `${file.oilKind}:`),
          choose(file, oil) {
            if (oil === "file:") return [];
            const short = file.oil === "lubricant";
            const temperature = file.value(short ? "temperature" : "lubricant.temperature") ?? "40 degC";
            if (short && !oil.endsWith(":")) return [["lubricant", oil]];
            const begin = [...file.without("lubricant", ...(short ? ["temperature"] : [])), ["lubricant.temperature", temperature]];
            if (oil === "own:") {
              return [
                ...begin,
                ["lubricant.density.law", "dowson-higginson"],
                ["lubricant.density.rho_0", "870 kg/m^3"],
                ["lubricant.viscosity.law", "roelands"],
                ["lubricant.viscosity.mu_0", "40 mPa.s"],
                ["lubricant.viscosity.alpha", "22 1/GPa"],
              ];
            }
            if (oil === "sheet:") {
              return [
                ...begin,
                ["lubricant.kinematic_viscosity_40", "46 cSt"],
                ["lubricant.kinematic_viscosity_100", "6.9 cSt"],
                ["lubricant.density_15", "870 kg/m^3"],
                ["lubricant.base_oil", "mineral"],
              ];
            }
            return [...begin.slice(0, -1), ["lubricant.name", oil], ["lubricant.temperature", temperature]];
          },
        },
        { label: "Temperature", hint: "such as 40 degC or 313 K", keys: (file) => (file.oil === "lubricant" ? "temperature" : "lubricant.temperature") },
        {
          label: "Law of pressure",
          options: () => [["roelands", "Roelands"], ["barus", "Barus (exponential)"]],
          keys: () => "lubricant.viscosity.law",
          shown: (file) => file.oilKind === "own",
        },
        { label: "Viscosity µ₀", hint: "at ambient pressure, such as 40 mPa.s", keys: () => "lubricant.viscosity.mu_0", shown: (file) => file.oilKind === "own" },
        { label: "Pressure-viscosity coefficient α", keys: () => "lubricant.viscosity.alpha", shown: (file) => file.oilKind === "own" && !file.has("lubricant.viscosity.z") },
        { label: "Density ρ₀", keys: () => "lubricant.density.rho_0", shown: (file) => file.oilKind === "own" },
        { label: "Kinematic viscosity at 40 °C", keys: () => "lubricant.kinematic_viscosity_40", shown: (file) => file.oilKind === "sheet" },
        { label: "Kinematic viscosity at 100 °C", keys: () => "lubricant.kinematic_viscosity_100", shown: (file) => file.oilKind === "sheet" && !file.has("lubricant.viscosity_index") },
        { label: "Viscosity index", keys: () => "lubricant.viscosity_index", shown: (file) => file.oilKind === "sheet" && file.has("lubricant.viscosity_index") },
        { label: "Density at 15 °C", keys: () => "lubricant.density_15", shown: (file) => file.oilKind === "sheet" },
        {
          label: "Base oil",
          options: choices("lubricant.base_oil"),
          keys: () => "lubricant.base_oil",
          shown: (file) => file.oilKind === "sheet",
        },
      ],
    },
    {
      legend: "Heat",
      sections: ["thermal"],
      fields: [
        {
          label: "with the heat of film and bodies",
          wide: true,
          checkbox: true,
          hint: "takes about ten times as long; the oil needs conductivity and heat capacity",
          keys: () => "thermal",
          value: (file) => file.tables.includes("thermal"),
          choose: (file, on) => (on ? [["thermal", {}]] : [["thermal", null]]),
        },
      ],
    },
  ];
}
