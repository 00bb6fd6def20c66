//! The keys of cases and studies. `tests/schema.rs` holds them against the readers, the reference page and all shipped files.

use ertel_quantity::Dimension as D;

/// A key and what its value is.
pub type Key = (&'static str, Kind);

/// What a value is.
#[derive(Clone, Copy)]
pub enum Kind {
    Text,
    Switch,
    Count,
    Number,
    Numbers,
    /// With a unit of one of these.
    Quantity(&'static [D]),
    Quantities(&'static [D]),
    /// A length, or one of these words.
    QuantityOr(&'static [&'static str]),
    Points,
    Choice(&'static [&'static str]),
    /// A list of these words.
    Choices(&'static [&'static str]),
    Table(&'static [Key]),
    Tables(&'static [Key]),
    /// A table with the key `law`; the keys of each law; whether a constant may stand in its place.
    Law {
        laws: &'static [(&'static str, &'static [&'static str])],
        keys: &'static [Key],
        or: bool,
    },
    Fluid,
    FluidOrTable(&'static [Key]),
    Solid,
    SolidOrTable(&'static [Key]),
    Machine(&'static [Key]),
    Any,
    List,
}

use Kind::{
    Any, Choice, Choices, Count, Fluid, FluidOrTable, Law, List, Machine, Number, Numbers, Points,
    Quantities, Quantity, QuantityOr, Solid, SolidOrTable, Switch, Table, Tables, Text,
};

const LENGTH: Kind = Quantity(&[D::LENGTH]);
const SPEED: Kind = Quantity(&[D::SPEED]);
const ANGLE: Kind = Quantity(&[D::ANGLE]);
const ROTATION: Kind = Quantity(&[D::ANGULAR_SPEED]);
const FORCE: Kind = Quantity(&[D::FORCE]);
const TEMPERATURE: Kind = Quantity(&[D::TEMPERATURE]);
const PRESSURE: Kind = Quantity(&[D::PRESSURE]);
const VISCOSITY: Kind = Quantity(&[D::VISCOSITY]);
const DENSITY: Kind = Quantity(&[D::DENSITY]);
const PER_PRESSURE: Kind = Quantity(&[D::INVERSE_PRESSURE]);
const PER_KELVIN: Kind = Quantity(&[D::INVERSE_TEMPERATURE]);
const KINEMATIC: Kind = Quantity(&[D::KINEMATIC_VISCOSITY]);
const KELVIN: Kind = Quantity(&[D::TEMPERATURE_DIFFERENCE]);

/// A case.
pub const CASE: &[Key] = &[
    ("title", Text),
    ("contact", Table(CONTACT)),
    ("motion", Table(MOTION)),
    ("machine", Machine(MACHINE)),
    ("bodies", Table(BODIES)),
    ("surface_roughness", Table(ROUGHNESS)),
    ("inlet", Table(INLET)),
    ("lubricant", FluidOrTable(LUBRICANT)),
    ("temperature", TEMPERATURE),
    ("thermal", Table(THERMAL)),
    ("mesh", Table(MESH)),
    ("solver", Table(SOLVER)),
    ("output", Table(OUTPUT)),
    ("curve", Table(CURVE)),
    ("compare", Table(COMPARE)),
    ("correlation", Tables(CORRELATION)),
];

const COMPARE: &[Key] = &[("columns", Any), ("ignore", List), ("decimal", DECIMAL)];

const DECIMAL: Kind = Choice(&["point", "comma"]);

const CONTACT: &[Key] = &[
    (
        "kind",
        Choice(&["circular", "line", "elliptical", "roller"]),
    ),
    ("radius", LENGTH),
    ("radius_x", LENGTH),
    ("radius_y", LENGTH),
    ("entrainment_angle", ANGLE),
    ("load", Quantity(&[D::FORCE, D::FORCE_PER_LENGTH])),
    ("hertz_pressure", PRESSURE),
    ("length", LENGTH),
    ("profile", Table(PROFILE)),
    ("misalignment", ANGLE),
];

const PROFILE: &[Key] = &[
    (
        "kind",
        Choice(&["straight", "crown", "logarithmic", "iso-16281", "table"]),
    ),
    ("straight_length", LENGTH),
    ("end_radius", LENGTH),
    ("crown_radius", LENGTH),
    ("end_drop", LENGTH),
    ("design_load", FORCE),
    ("diameter", LENGTH),
    ("position", Quantities(&[D::LENGTH])),
    ("drop", Quantities(&[D::LENGTH])),
    ("file", Text),
    ("smoothing_length", LENGTH),
    ("level", Switch),
];

const MOTION: &[Key] = &[
    ("entrainment_speed", SPEED),
    ("slide_to_roll_ratio", Number),
    ("slide_to_roll_ratio_across", Number),
    ("body_1_speed", SPEED),
    ("body_2_speed", SPEED),
    ("plane_speed", SPEED),
    ("ball_speed", SPEED),
    ("skew_angle", ANGLE),
    ("body_1_spin", ROTATION),
    ("body_2_spin", ROTATION),
];

const MACHINE: &[Key] = &[
    ("kind", Text),
    ("ball_diameter", LENGTH),
    ("ball_radius", LENGTH),
    ("load", FORCE),
    ("hertz_pressure", PRESSURE),
    ("entrainment_speed", SPEED),
    ("slide_to_roll_ratio", Number),
    ("slide_to_roll_ratio_across", Number),
    ("ball_speed", SPEED),
    ("disc_speed", SPEED),
    ("body_1_speed", SPEED),
    ("body_2_speed", SPEED),
    ("skew_angle", ANGLE),
    ("body_1_spin", ROTATION),
    ("body_2_spin", ROTATION),
    ("ring", Choice(&["inner", "outer"])),
    ("pitch_diameter", LENGTH),
    ("inner_groove_curvature", Number),
    ("outer_groove_curvature", Number),
    ("contact_angle", ANGLE),
    ("inner_ring_speed", ROTATION),
    ("outer_ring_speed", ROTATION),
    ("ball_load", FORCE),
    ("raceway_control", Choice(&["outer", "inner"])),
    ("roller_diameter", LENGTH),
    ("roller_length", LENGTH),
    ("roller_load", FORCE),
    ("profile", Table(PROFILE)),
    ("misalignment", ANGLE),
    ("module", LENGTH),
    ("normal_module", LENGTH),
    ("pinion_teeth", Count),
    ("wheel_teeth", Count),
    ("pressure_angle", ANGLE),
    ("normal_pressure_angle", ANGLE),
    ("helix_angle", ANGLE),
    ("face_width", LENGTH),
    ("pinion_torque", Quantity(&[D::ENERGY])),
    ("pinion_speed", ROTATION),
    ("position", QuantityOr(&["pitch point"])),
    ("load_share", Number),
    ("addendum_pinion", LENGTH),
    ("addendum_wheel", LENGTH),
    ("base_radius", LENGTH),
    ("lift", LENGTH),
    ("lift_acceleration", LENGTH),
    ("cam_speed", ROTATION),
    ("width", LENGTH),
];

/// The keys of each machine, without `kind`.
pub const MACHINES: &[(&str, &[&str])] = &[
    (
        "ball-on-disc",
        &[
            "ball_diameter",
            "ball_radius",
            "load",
            "hertz_pressure",
            "entrainment_speed",
            "slide_to_roll_ratio",
            "slide_to_roll_ratio_across",
            "ball_speed",
            "disc_speed",
            "body_1_speed",
            "body_2_speed",
            "skew_angle",
            "body_1_spin",
            "body_2_spin",
        ],
    ),
    (
        "ball-bearing",
        &[
            "ring",
            "ball_diameter",
            "pitch_diameter",
            "inner_groove_curvature",
            "outer_groove_curvature",
            "contact_angle",
            "inner_ring_speed",
            "outer_ring_speed",
            "ball_load",
            "hertz_pressure",
            "raceway_control",
        ],
    ),
    (
        "roller-bearing",
        &[
            "ring",
            "roller_diameter",
            "roller_length",
            "pitch_diameter",
            "inner_ring_speed",
            "outer_ring_speed",
            "roller_load",
            "hertz_pressure",
            "profile",
            "misalignment",
        ],
    ),
    (
        "spur-gear",
        &[
            "module",
            "pinion_teeth",
            "wheel_teeth",
            "pressure_angle",
            "face_width",
            "pinion_torque",
            "pinion_speed",
            "position",
            "load_share",
            "addendum_pinion",
            "addendum_wheel",
        ],
    ),
    (
        "helical-gear",
        &[
            "normal_module",
            "pinion_teeth",
            "wheel_teeth",
            "normal_pressure_angle",
            "helix_angle",
            "face_width",
            "pinion_torque",
            "pinion_speed",
            "position",
            "load_share",
            "addendum_pinion",
            "addendum_wheel",
        ],
    ),
    (
        "cam-and-flat-tappet",
        &[
            "base_radius",
            "lift",
            "lift_acceleration",
            "cam_speed",
            "width",
            "load",
            "hertz_pressure",
        ],
    ),
];

const BODIES: &[Key] = &[
    ("plane", SolidOrTable(BODY)),
    ("ball", SolidOrTable(BODY)),
    ("body_1", SolidOrTable(BODY)),
    ("body_2", SolidOrTable(BODY)),
    ("roughness", LENGTH),
    ("axes_angle", ANGLE),
];

const BODY: &[Key] = &[
    ("name", Solid),
    ("youngs_modulus", PRESSURE),
    ("poissons_ratio", Number),
    ("hertz_pressure_limit", PRESSURE),
    ("density", DENSITY),
    ("thermal_conductivity", CONDUCTIVITY),
    ("heat_capacity", HEAT_CAPACITY),
    ("radius_x", QuantityOr(&["flat"])),
    ("radius_y", QuantityOr(&["flat"])),
];

const ROUGHNESS: &[Key] = &[
    ("body_1_rms_height", LENGTH),
    ("body_2_rms_height", LENGTH),
    ("body_1_ra", LENGTH),
    ("body_2_ra", LENGTH),
    ("body_1_rq", LENGTH),
    ("body_2_rq", LENGTH),
    ("body_1_rz", LENGTH),
    ("body_2_rz", LENGTH),
    ("asperity_group", Number),
    ("rms_height_to_asperity_radius", Number),
    ("boundary_friction_coefficient", Number),
];

const INLET: &[Key] = &[("oil_layer", LENGTH), ("meniscus_distance", LENGTH)];

const LUBRICANT: &[Key] = &[
    ("temperature", TEMPERATURE),
    ("name", Fluid),
    (
        "density",
        Law {
            laws: DENSITIES,
            keys: DENSITY_KEYS,
            or: false,
        },
    ),
    (
        "viscosity",
        Law {
            laws: VISCOSITIES,
            keys: VISCOSITY_KEYS,
            or: false,
        },
    ),
    (
        "shear_thinning",
        Law {
            laws: SHEAR,
            keys: SHEAR_KEYS,
            or: false,
        },
    ),
    ("thermal_conductivity", CONDUCTIVITY),
    ("heat_capacity", HEAT_CAPACITY),
    ("reference_temperature", TEMPERATURE),
    ("validity", Table(VALIDITY)),
    ("correlation", Tables(CORRELATION)),
    ("iso_vg", Number),
    ("kinematic_viscosity_20", KINEMATIC),
    ("kinematic_viscosity_25", KINEMATIC),
    ("kinematic_viscosity_30", KINEMATIC),
    ("kinematic_viscosity_40", KINEMATIC),
    ("kinematic_viscosity_50", KINEMATIC),
    ("kinematic_viscosity_60", KINEMATIC),
    ("kinematic_viscosity_80", KINEMATIC),
    ("kinematic_viscosity_100", KINEMATIC),
    ("dynamic_viscosity_20", VISCOSITY),
    ("dynamic_viscosity_25", VISCOSITY),
    ("dynamic_viscosity_30", VISCOSITY),
    ("dynamic_viscosity_40", VISCOSITY),
    ("dynamic_viscosity_50", VISCOSITY),
    ("dynamic_viscosity_60", VISCOSITY),
    ("dynamic_viscosity_80", VISCOSITY),
    ("dynamic_viscosity_100", VISCOSITY),
    ("viscosity_index", Number),
    ("density_15", DENSITY),
    ("density_20", DENSITY),
    ("relative_density_15", Number),
    ("base_oil", Choice(&["mineral", "PAO", "ester", "PAG"])),
    ("pressure_viscosity_coefficient", PER_PRESSURE),
    ("pressure_viscosity_coefficient_20", PER_PRESSURE),
    ("pressure_viscosity_coefficient_25", PER_PRESSURE),
    ("pressure_viscosity_coefficient_30", PER_PRESSURE),
    ("pressure_viscosity_coefficient_40", PER_PRESSURE),
    ("pressure_viscosity_coefficient_50", PER_PRESSURE),
    ("pressure_viscosity_coefficient_60", PER_PRESSURE),
    ("pressure_viscosity_coefficient_80", PER_PRESSURE),
    ("pressure_viscosity_coefficient_100", PER_PRESSURE),
    ("pressure_law", Choice(&["roelands", "barus"])),
];

const VALIDITY: &[Key] = &[
    ("pressure", Quantities(&[D::PRESSURE])),
    ("temperature", Quantities(&[D::TEMPERATURE])),
    ("source", Text),
];

const ISOTHERMS: &[Key] = &[
    ("temperature", TEMPERATURE),
    ("pressure", Numbers),
    ("viscosity", Numbers),
    ("density", Numbers),
    ("thermal_conductivity", Numbers),
    ("heat_capacity", Numbers),
];

const UNITS: &[Key] = &[
    ("pressure", Text),
    ("viscosity", Text),
    ("density", Text),
    ("thermal_conductivity", Text),
    ("heat_capacity", Text),
];

const TABLE_OF_LAW: &[&str] = &["file", "isotherms", "units", "columns", "decimal"];

const DENSITIES: &[(&str, &[&str])] = &[
    ("constant", &["rho_0"]),
    (
        "dowson-higginson",
        &["rho_0", "c_1", "c_2", "reference_temperature", "beta"],
    ),
    (
        "tait",
        &[
            "rho_0",
            "k_0r",
            "k_0r_prime",
            "reference_temperature",
            "beta_k",
            "beta_k_prime",
            "a_v",
        ],
    ),
    (
        "murnaghan",
        &[
            "rho_0",
            "k_0r",
            "k_0r_prime",
            "reference_temperature",
            "beta_k",
            "beta_k_prime",
            "a_v",
        ],
    ),
    ("table", TABLE_OF_LAW),
];

const DENSITY_KEYS: &[Key] = &[
    ("law", Text),
    ("rho_0", DENSITY),
    ("c_1", PER_PRESSURE),
    ("c_2", PER_PRESSURE),
    ("beta", PER_KELVIN),
    ("k_0r", PRESSURE),
    ("k_0r_prime", Number),
    ("reference_temperature", TEMPERATURE),
    ("beta_k", PER_KELVIN),
    ("beta_k_prime", PER_KELVIN),
    ("a_v", PER_KELVIN),
    ("file", Text),
    ("columns", Any),
    ("decimal", DECIMAL),
    ("units", Table(UNITS)),
    ("isotherms", Tables(ISOTHERMS)),
];

const VISCOSITIES: &[(&str, &[&str])] = &[
    ("constant", &["mu_0"]),
    ("barus", &["mu_0", "alpha"]),
    (
        "cheng",
        &["mu_0", "alpha", "beta", "gamma", "reference_temperature"],
    ),
    (
        "roelands",
        &["mu_0", "alpha", "z", "p_0", "reference_temperature", "beta"],
    ),
    (
        "wlf",
        &["mu_g", "t_g0", "a_1", "a_2", "b_1", "b_2", "c_1", "c_2"],
    ),
    (
        "doolittle",
        &[
            "mu_0",
            "b",
            "r_0",
            "equation_of_state",
            "reference_temperature",
            "epsilon",
        ],
    ),
    (
        "yasutomi",
        &["mu_g", "t_g0", "a_1", "a_2", "b_1", "b_2", "c_1", "c_2"],
    ),
    ("mcewen", &["mu_0", "alpha", "q"]),
    ("paluch", &["mu_0", "mu_inf", "c_f", "p_inf"]),
    ("mcewen-paluch", &["mu_0", "a_0", "q", "c_f", "p_inf"]),
    (
        "walther",
        &[
            "a",
            "b",
            "alpha",
            "alpha_exponent",
            "reference_temperature",
            "pressure",
        ],
    ),
    ("table", TABLE_OF_LAW),
];

const VISCOSITY_KEYS: &[Key] = &[
    ("law", Text),
    ("mu_0", VISCOSITY),
    ("alpha", PER_PRESSURE),
    ("alpha_exponent", Number),
    // Of Cheng a temperature, of Roelands its reciprocal.
    (
        "beta",
        Quantity(&[D::INVERSE_TEMPERATURE, D::TEMPERATURE_DIFFERENCE]),
    ),
    ("gamma", Quantity(&[D::TEMPERATURE_PER_PRESSURE])),
    ("reference_temperature", TEMPERATURE),
    ("z", Number),
    ("p_0", PRESSURE),
    ("mu_g", VISCOSITY),
    ("t_g0", TEMPERATURE),
    ("a_0", PER_PRESSURE),
    ("a_1", KELVIN),
    ("a_2", PER_PRESSURE),
    // Of WLF and of Yasutomi the other way round.
    ("b_1", Any),
    ("b_2", Any),
    ("c_1", Number),
    ("c_2", KELVIN),
    ("a", Number),
    ("b", Number),
    ("r_0", Number),
    ("epsilon", PER_KELVIN),
    ("equation_of_state", Table(DENSITY_KEYS)),
    ("q", Number),
    ("mu_inf", VISCOSITY),
    ("c_f", Number),
    ("p_inf", PRESSURE),
    ("pressure", Choice(&["roelands", "barus"])),
    ("file", Text),
    ("columns", Any),
    ("decimal", DECIMAL),
    ("units", Table(UNITS)),
    ("isotherms", Tables(ISOTHERMS)),
];

const SHEAR: &[(&str, &[&str])] = &[
    (
        "carreau",
        &[
            "g_c",
            "n",
            "beta_c",
            "mu_2",
            "reference_temperature",
            "limit",
        ],
    ),
    (
        "carreau-yasuda",
        &["g", "n", "a", "mu_2", "reference_temperature", "limit"],
    ),
    ("ree-eyring", &["tau_0", "limit"]),
    ("rabinowitsch", &["tau_0", "n", "limit"]),
    ("limiting-stress", &["tau_l0", "lambda"]),
];

const SHEAR_KEYS: &[Key] = &[
    ("law", Text),
    ("g_c", PRESSURE),
    ("g", PRESSURE),
    ("n", Number),
    ("a", Number),
    ("beta_c", Number),
    ("mu_2", VISCOSITY),
    ("reference_temperature", TEMPERATURE),
    ("tau_0", PRESSURE),
    ("tau_l0", PRESSURE),
    ("lambda", Number),
    ("limit", Table(&[("tau_l0", PRESSURE), ("lambda", Number)])),
];

const CONDUCTIVITY: Kind = Law {
    laws: &[
        ("constant", &["k_0"]),
        ("linear", &["k_0", "reference_temperature", "a_t", "a_p"]),
        ("larsson-andersson", &["k_0", "d_1", "d_2"]),
        (
            "scaling",
            &["b", "c", "s", "a", "q", "reference_temperature"],
        ),
        ("table", TABLE_OF_LAW),
    ],
    keys: &[
        ("law", Text),
        ("k_0", Quantity(&[D::THERMAL_CONDUCTIVITY])),
        ("reference_temperature", TEMPERATURE),
        ("a_t", PER_KELVIN),
        ("a_p", PER_PRESSURE),
        ("d_1", PER_PRESSURE),
        ("d_2", PER_PRESSURE),
        ("b", Quantity(&[D::THERMAL_CONDUCTIVITY])),
        ("c", Quantity(&[D::THERMAL_CONDUCTIVITY])),
        ("s", Number),
        ("a", Number),
        ("q", Number),
        ("file", Text),
        ("columns", Any),
        ("decimal", DECIMAL),
        ("units", Table(UNITS)),
        ("isotherms", Tables(ISOTHERMS)),
    ],
    or: true,
};

const HEAT_CAPACITY: Kind = Law {
    laws: &[
        ("constant", &["c_0"]),
        ("linear", &["c_0", "reference_temperature", "a_t", "a_p"]),
        (
            "larsson-andersson",
            &[
                "rho_c_0",
                "reference_temperature",
                "beta_0",
                "b_1",
                "b_2",
                "k_1",
                "k_2",
            ],
        ),
        ("scaling", &["rho_c_0", "m", "reference_temperature", "w"]),
        ("table", TABLE_OF_LAW),
    ],
    keys: &[
        ("law", Text),
        ("c_0", Quantity(&[D::SPECIFIC_HEAT])),
        ("rho_c_0", Quantity(&[D::VOLUMETRIC_HEAT])),
        ("m", Quantity(&[D::VOLUMETRIC_HEAT])),
        ("w", Number),
        ("reference_temperature", TEMPERATURE),
        ("a_t", PER_KELVIN),
        ("a_p", PER_PRESSURE),
        ("beta_0", PER_KELVIN),
        ("b_1", PER_PRESSURE),
        ("b_2", Quantity(&[D::INVERSE_PRESSURE_SQUARED])),
        ("k_1", PER_PRESSURE),
        ("k_2", PER_PRESSURE),
        ("file", Text),
        ("columns", Any),
        ("decimal", DECIMAL),
        ("units", Table(UNITS)),
        ("isotherms", Tables(ISOTHERMS)),
    ],
    or: true,
};

const THERMAL: &[Key] = &[
    ("depth", Number),
    ("body_1_temperature", TEMPERATURE),
    ("body_2_temperature", TEMPERATURE),
    ("plane_temperature", TEMPERATURE),
    ("ball_temperature", TEMPERATURE),
    ("film_order", Count),
    ("solid_elements", Count),
    ("surface_order", Count),
    ("tolerance", Number),
    ("max_iterations", Count),
    ("profiles", Points),
    ("field", Switch),
];

const MESH: &[Key] = &[
    ("target_error", Number),
    ("refine_for", Choice(&["fields", "films"])),
    ("pressure_error", Number),
    ("max_unknowns", Count),
    ("preset", Choice(&["coarse", "normal", "fine"])),
    ("hertz_size", Number),
    ("constriction_size", Number),
    ("edge_size", Number),
    ("rim_size", Number),
    ("growth", Number),
    ("depth_growth", Number),
    ("inlet", Number),
    ("outlet", Number),
    ("side", Number),
    ("body_width", Number),
    ("body_depth", Number),
    ("pressure_order", Count),
    ("elastic_order", Count),
];

const SOLVER: &[Key] = &[
    ("formulation", Choice(&["gls", "supg", "galerkin"])),
    ("isotropic_diffusion", Number),
    ("ridge_diffusion", Number),
    ("elastic_stabilisation", Switch),
    ("penalty", Number),
    (
        "penalty_scaling",
        Choice(&[
            "film",
            "constant",
            "element-squared",
            "inverse-element-squared",
        ]),
    ),
    (
        "elasticity",
        Choice(&["half-space", "equivalent", "two-bodies"]),
    ),
    ("linear", Choice(&["condensed", "monolithic"])),
    ("tolerance", Number),
    ("max_iterations", Count),
    ("error_estimate", Switch),
    ("newtonian", Switch),
    ("isothermal", Switch),
];

const OUTPUT: &[Key] = &[
    ("folder", Text),
    ("pictures", Choices(&["svg", "pdf", "png"])),
    ("body_field", Switch),
    ("sensitivities", Switch),
    ("interferogram", Table(INTERFEROGRAM)),
];

const INTERFEROGRAM: &[Key] = &[
    ("wavelength", LENGTH),
    ("wavelengths", Quantities(&[D::LENGTH])),
    ("light", Choice(&["cie-rgb"])),
    ("refractive_index", Number),
    ("follows_density", Switch),
    ("spacer_thickness", LENGTH),
    ("spacer_refractive_index", Number),
    ("phase_change", ANGLE),
    ("visibility", Number),
];

const CURVE: &[Key] = &[
    (
        "quantity",
        Choice(&[
            "motion.entrainment_speed",
            "motion.slide_to_roll_ratio",
            "motion.ball_speed",
            "motion.plane_speed",
            "motion.body_1_speed",
            "motion.body_2_speed",
            "contact.load",
            "contact.hertz_pressure",
            "contact.radius",
            "inlet.oil_layer",
            "inlet.meniscus_distance",
            "temperature",
            "lubricant.temperature",
        ]),
    ),
    ("values", List),
    ("from", Number),
    ("to", Number),
    ("points", Count),
    ("spacing", Choice(&["linear", "log"])),
    ("folders", Switch),
    ("newtonian", Switch),
    ("isothermal", Switch),
];

const CORRELATION: &[Key] = &[("of", Text), ("with", Text), ("coefficient", Number)];

/// A study.
pub const STUDY: &[Key] = &[
    ("title", Text),
    ("case", Text),
    ("points", Text),
    ("axis", Tables(AXIS)),
];

const AXIS: &[Key] = &[
    ("key", Text),
    ("values", List),
    ("from", Any),
    ("to", Any),
    ("points", Count),
    ("spacing", Choice(&["linear", "log"])),
    ("zip", Text),
];
