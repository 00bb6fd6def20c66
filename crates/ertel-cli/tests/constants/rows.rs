//! Sentences of the theory pages with numbers, and the constants with these values.
//!
//! Not covered: numbers in words that are no count (`a mesh twice as coarse`, `more than half`, `exceeds twice the entrained flow`,
//! `a ridge of 5 %`, `half of 4θE of the other film`); limits that the pages give as the difference from one (`0.95 μ₁`, `1.05 μ₂`); numbers
//! that follow from constants (`24 e-folds`, `32 cells` for `PER_BINADE_LOG2 = 5`, `a factor of 5` for `LEAST_SHRINKING = 0.2`, Eyring's
//! `27, 16, 9, ...`); coefficients of formulas that are in the code term by term (Walther's, Larsson's); and results of measurements.

/// A sentence of a page with `{}` for each number, and the constants with these values: file, name, which of its numbers,
/// and the factor by which the page gives it (100 of a share in per cent). A file is one of the solver's, or its path from `crates`;
/// instead of a name, code with `{}` for numbers finds those without a name.
pub type Row = (
    &'static str,
    &'static str,
    &'static [(&'static str, &'static str, usize, f64)],
);

const ADAPT: &str = "solve/adapt.rs";
const NEWTON: &str = "solve/newton.rs";
const RELAXATION: &str = "engine/coupling/relaxation.rs";
const TUNING_CONTINUATION: &str = "solve/tuning/continuation.rs";
const TUNING_ERRORS: &str = "solve/tuning/errors.rs";
const TUNING_HEAT: &str = "solve/tuning/heat.rs";
const TUNING_NEWTON: &str = "solve/tuning/newton.rs";
const TUNING_REFINEMENT: &str = "solve/tuning/refinement.rs";
const TUNING_RIDGE: &str = "solve/tuning/ridge.rs";
const TUNING_STAGES: &str = "solve/tuning/stages.rs";
const PANELS: &str = "film/cross_film/panels.rs";

const OUTLET: &str = "crates/ertel/src/problem/outlet.rs";
const PROBLEM: &str = "crates/ertel/src/problem.rs";
const AREA: &str = "crates/ertel/src/problem/area.rs";
const PARAMS: &str = "params.rs";
const REYNOLDS: &str = "forms/reynolds.rs";
const ENDS: &str = "contact/roller/ends.rs";
const SHEETS: &str = "crates/ertel-rheology/src/data_sheet/mod.rs";
const OILS: &str = "crates/ertel-rheology/src/data_sheet/base_oil.rs";
const OIL_HEAT: &str = "crates/ertel-rheology/src/data_sheet/heat.rs";
const OIL_SHEAR: &str = "crates/ertel-rheology/src/data_sheet/shear.rs";
const POWERS: &str = "crates/ertel-rheology/src/shear/numbers.rs";

const RHEOLOGY: &str = "theory/rheology.md";
const ISOTHERMAL: &str = "theory/isothermal-contact.md";
const HEAT: &str = "theory/heat.md";
const THINNING: &str = "theory/shear-thinning.md";
const VOLUMES: &str = "theory/finite-volumes.md";

pub const ROWS: &[Row] = &[
    (
        ISOTHERMAL,
        "cavitation penalty ramped {}, {};",
        &[
            (TUNING_STAGES, "PENALTY_RAMP", 0, 1.0),
            (TUNING_STAGES, "PENALTY_RAMP", 1, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "a start that stalls with a residual above {} skips",
        &[(TUNING_STAGES, "DIVERGENCE_LIMIT", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "refined further end at {}: the remaining error",
        &[(TUNING_STAGES, "EXACT_ENOUGH", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "they end at √({} e), {} at most, if the last step changed both films by less than {} e.",
        &[
            (TUNING_STAGES, "ROUGH_SHARE", 0, 1.0),
            (TUNING_STAGES, "ROUGH_UPDATE", 0, 1.0),
            (TUNING_STAGES, "ROUGH_FILM_CHANGE", 0, 1.0),
        ],
    ),
    (
        "decisions/0012-films-first.md",
        "{} times the target today, `ROUGH_FILM_CHANGE`",
        &[(TUNING_STAGES, "ROUGH_FILM_CHANGE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "the first try of the final stage stops after {} iterations without a smaller update, and after {} iterations in total ({} under rollers",
        &[
            (TUNING_STAGES, "EARLY_STAGNATION", 0, 1.0),
            (TUNING_STAGES, "EARLY_ITERATIONS", 0, 1.0),
            (TUNING_STAGES, "EARLY_ITERATIONS", 1, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "The prediction is u₂(u₂/u₁)^{}, which",
        &[(TUNING_NEWTON, "PREDICTED_ORDER", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "No step may increase the residual more than {} times",
        &[(TUNING_NEWTON, "MOST_RISE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "isotropic diffusion, ρ_id = {}, {}, {}, {} and that of the case",
        &[
            (TUNING_CONTINUATION, "DIFFUSION", 0, 1.0),
            (TUNING_CONTINUATION, "DIFFUSION", 1, 1.0),
            (TUNING_CONTINUATION, "DIFFUSION", 2, 1.0),
            (TUNING_CONTINUATION, "DIFFUSION", 3, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "ln μ̄ times {}, {}, {}, {} and {}, from a separate start",
        &[
            (TUNING_CONTINUATION, "EXPONENTS", 0, 1.0),
            (TUNING_CONTINUATION, "EXPONENTS", 1, 1.0),
            (TUNING_CONTINUATION, "EXPONENTS", 2, 1.0),
            (TUNING_CONTINUATION, "EXPONENTS", 3, 1.0),
            (TUNING_CONTINUATION, "EXPONENTS", 4, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "the speed, from {} times that of the case down in halves",
        &[(TUNING_CONTINUATION, "SPEEDS", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "not where the films have bars below {} % and a diffused ridge",
        &[(TUNING_CONTINUATION, "GOOD_ENOUGH", 0, 100.0)],
    ),
    (
        ISOTHERMAL,
        "halve the step, up to {} times in one continuation ({} if shear rates",
        &[
            (TUNING_CONTINUATION, "MAX_HALVED_STEPS", 0, 1.0),
            (TUNING_CONTINUATION, "MAX_HALVED_EXPONENTIAL_STEPS", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "less than {} % of the central film within {} half-widths of an end",
        &[
            (TUNING_STAGES, "NO_FILM", 0, 100.0),
            ("contact/roller/ends.rs", "AROUND_EDGE", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "the error bar is {}θE + {} E_r, combined",
        &[
            (TUNING_ERRORS, "SAFETY", 0, 1.0),
            (TUNING_ERRORS, "SAFETY_OF_RIDGE", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "θ = |h_1 − h_2|/(E_1 − E_2), between {} and {}, and {} if there is no previous mesh",
        &[
            (TUNING_ERRORS, "CALIBRATION", 0, 1.0),
            (TUNING_ERRORS, "CALIBRATION", 1, 1.0),
            (TUNING_ERRORS, "UNCALIBRATED", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "larger effect than the estimates: {} (point) or {} (line contacts)",
        &[
            (TUNING_ERRORS, "UNRESOLVED", 1, 1.0),
            (TUNING_ERRORS, "UNRESOLVED", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "η_T = {} A_T κ/(2C) |e_δ||e_ζ| + {} A_T (ε κ² + a κ",
        &[
            (TUNING_ERRORS, "ELASTIC", 0, 1.0),
            (TUNING_ERRORS, "REYNOLDS", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "The factors {} and {} are measured",
        &[
            (TUNING_ERRORS, "ELASTIC", 0, 1.0),
            (TUNING_ERRORS, "REYNOLDS", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "one refinement aims at no less than {} % of it",
        &[(TUNING_REFINEMENT, "SMALLEST_GOAL", 0, 100.0)],
    ),
    (
        ISOTHERMAL,
        "the sum may then be {} of its size",
        &[(TUNING_REFINEMENT, "CONFIRMING_GOAL", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "From error bars of {} times the target on",
        &[(TUNING_REFINEMENT, "NEAR_TARGET", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "d = {} C =",
        &[("elastic/half_space.rs", "LINE_REFERENCE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "at the distance d from the load, {} half-widths",
        &[("elastic/half_space.rs", "LINE_REFERENCE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "e₀ = {} p_h; in steps of 1/{})",
        &[
            (TUNING_RIDGE, "SCALE", 0, 1.0),
            (TUNING_RIDGE, "STEPS", 0, 1.0),
        ],
    ),
    (
        HEAT,
        "If it is more than {} of the previous one, only a fraction",
        &[(RELAXATION, "SLOW", 0, 1.0)],
    ),
    (
        HEAT,
        "costs at most {} iterations more than when it was new",
        &[(TUNING_HEAT, "SPARE_KRYLOV", 0, 1.0)],
    ),
    (
        HEAT,
        "to a depth of {} half-widths",
        &[("params/thermal.rs", "depth", 0, 1.0)],
    ),
    (
        HEAT,
        "is limited separately: to {} K,",
        &[("solve/heat/newton.rs", "largest_step", 0, 1.0)],
    ),
    (
        HEAT,
        "with `θ` = {}, {}, {}, {}, {}, {}, {}.",
        &[
            (TUNING_CONTINUATION, "SLIDING", 0, 1.0),
            (TUNING_CONTINUATION, "SLIDING", 1, 1.0),
            (TUNING_CONTINUATION, "SLIDING", 2, 1.0),
            (TUNING_CONTINUATION, "SLIDING", 3, 1.0),
            (TUNING_CONTINUATION, "SLIDING", 4, 1.0),
            (TUNING_CONTINUATION, "SLIDING", 5, 1.0),
            (TUNING_CONTINUATION, "SLIDING", 6, 1.0),
        ],
    ),
    (
        THINNING,
        "(1 − r₁²)/(2r₁) = {}, {}, {}, {}, {}, {}, {} r₁",
        &[
            (TUNING_CONTINUATION, "SOFTNESS", 0, 1e-3),
            (TUNING_CONTINUATION, "SOFTNESS", 1, 1e-3),
            (TUNING_CONTINUATION, "SOFTNESS", 2, 1e-3),
            (TUNING_CONTINUATION, "SOFTNESS", 3, 1e-3),
            (TUNING_CONTINUATION, "SOFTNESS", 4, 1e-3),
            (TUNING_CONTINUATION, "SOFTNESS", 5, 1e-3),
            (TUNING_CONTINUATION, "SOFTNESS", 6, 1e-3),
        ],
    ),
    (
        THINNING,
        "first increases sliding at `ε` = {}.",
        &[(TUNING_CONTINUATION, "MEDIUM_SOFTNESS", 0, 1e-3)],
    ),
    (
        THINNING,
        "Continuation steps end at updates and residuals of {},",
        &[(TUNING_STAGES, "EXPONENTIAL_TOLERANCE", 0, 1.0)],
    ),
    (
        THINNING,
        "panels end {} and",
        &[(PANELS, "UPPER_FOLDS", 0, 1.0)],
    ),
    (
        THINNING,
        "contributions more than {} e-folds below",
        &[(PANELS, "LOWER_FOLDS", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "as long along the axis as {} of the length over which q rises from nothing to the mean, in those as long as wide, and between {} and {};",
        &[
            (ENDS, "OF_RISE", 0, 1.0),
            (ENDS, "SHORTEST", 0, 1.0),
            (ENDS, "LONGEST", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "and up to {} times between them",
        &[("contact/roller/zone.rs", "LONGEST", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "and change by at most {} %;",
        &[("film/fluid.rs", "DEPTH", 0, 100.0)],
    ),
    (
        ISOTHERMAL,
        "ρ_r h_e (H ∂ρ̄/∂P + {} ρ̄h_e)/(2l)",
        &[(REYNOLDS, "DEFLECTION_SHARE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "β = (H ∂ρ̄/∂P + {} ρ̄h_e, 0)",
        &[(REYNOLDS, "DEFLECTION_SHARE", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "of order 1 to 5 (default {}) and H0",
        &[(PARAMS, "pressure_order", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "It is {} times e²/(e² + e₀²)",
        &[(PROBLEM, "RIDGE_DIFFUSION", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "increases are limited to {} p_h",
        &[(NEWTON, "rise_limit", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "simplified step would be more than {} times as long",
        &[(NEWTON, "growth_limit", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "updates have not shrunk for {} iterations stops",
        &[(NEWTON, "patience", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "(order 2, GLS, ρ_id = {},",
        &[(PROBLEM, "START_DIFFUSION", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "from the Hertz pressure and {} times the formula film;",
        &[(PROBLEM, "start_film: {} * start_film", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "with {}, {}, {} and {} of the penalty before all of it",
        &[
            (TUNING_STAGES, "PENALTY_CONTINUATION", 0, 1.0),
            (TUNING_STAGES, "PENALTY_CONTINUATION", 1, 1.0),
            (TUNING_STAGES, "PENALTY_CONTINUATION", 2, 1.0),
            (TUNING_STAGES, "PENALTY_CONTINUATION", 3, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "circular {} % of h_c, {} % of h_min at a depth growth of {}, line {} and {} % at {},",
        &[
            (ADAPT, "false => ([{}, {}], {}),", 0, 100.0),
            (ADAPT, "false => ([{}, {}], {}),", 1, 100.0),
            (ADAPT, "false => ([{}, {}], {}),", 2, 1.0),
            (ADAPT, "true => ([{}, {}], {}),", 0, 100.0),
            (ADAPT, "true => ([{}, {}], {}),", 1, 100.0),
            (ADAPT, "true => ([{}, {}], {}),", 2, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "at least {} tenths of the difference from the previous mesh",
        &[(TUNING_ERRORS, "LEAST_SHARE_OF_DIFFERENCE", 0, 10.0)],
    ),
    (
        ISOTHERMAL,
        "meets the target, and is at most {} of its size;",
        &[(TUNING_REFINEMENT, "LARGEST_GOAL", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "off the target of the cells, down to {} of it",
        &[(TUNING_REFINEMENT, "MIN_SHARE_OF_CELLS", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "({} t and {} t if both are too large)",
        &[
            (TUNING_REFINEMENT, "SHARES", 0, 1.0),
            (TUNING_REFINEMENT, "SHARES", 1, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "by ({}/M)^({}/{}), down to {}.",
        &[
            (PROBLEM, "MODERATE_LOAD", 0, 1.0),
            (
                PROBLEM,
                "(MODERATE_LOAD / load).powf({} / {}).clamp({}, ",
                0,
                1.0,
            ),
            (
                PROBLEM,
                "(MODERATE_LOAD / load).powf({} / {}).clamp({}, ",
                1,
                1.0,
            ),
            (
                PROBLEM,
                "(MODERATE_LOAD / load).powf({} / {}).clamp({}, ",
                2,
                1.0,
            ),
        ],
    ),
    (
        ISOTHERMAL,
        "The depth growth is {} (circular) or {} (line); for targets below {} % it",
        &[
            (PARAMS, "false => ({}, {}), true => ({}, {}), }", 1, 1.0),
            (PARAMS, "false => ({}, {}), true => ({}, {}), }", 3, 1.0),
            (PARAMS, "DEFAULT_TARGET_ERROR", 0, 100.0),
        ],
    ),
    (
        ISOTHERMAL,
        "X from −{} to {}, |Y| ≤ {} as in the thesis",
        &[
            (AREA, "let mut inlet: f64 = {};", 0, 1.0),
            (OUTLET, "{}_f64.max((1.0 + ", 0, 1.0),
            (AREA, "{}_f64 .max(reach.side", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "elliptical contacts with H_f > {} it is at {}√H_f",
        &[(OUTLET, "THICK", 0, 1.0), (OUTLET, "FAR", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "must be {} (H_f/{})^{} times the film (from {} to {})",
        &[
            (AREA, "({} * (film / {}).powf({})).clamp({}, {})", 0, 1.0),
            (AREA, "({} * (film / {}).powf({})).clamp({}, {})", 1, 1.0),
            (AREA, "({} * (film / {}).powf({})).clamp({}, {})", 2, 1.0),
            (AREA, "({} * (film / {}).powf({})).clamp({}, {})", 3, 1.0),
            (AREA, "({} * (film / {}).powf({})).clamp({}, {})", 4, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "The outlet edge is at {} + {}√H_f",
        &[
            (OUTLET, ".max(({} + {} * film.sqrt()", 0, 1.0),
            (OUTLET, ".max(({} + {} * film.sqrt()", 1, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "inlet and side are {} + {} H_f (1 + H_f) times as far (H_f at most 1) in isothermal point contacts, {} times in line contacts",
        &[
            (AREA, "{} + {} * film * (1.0", 0, 1.0),
            (AREA, "{} + {} * film * (1.0", 1, 1.0),
            (AREA, "Family::Cylinder => {}, ", 0, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "Body: {} wide and deep, or {} times the distance",
        &[
            (AREA, "unwrap_or_else(|| {}_f64.max({} * widest)", 0, 1.0),
            (AREA, "unwrap_or_else(|| {}_f64.max({} * widest)", 1, 1.0),
        ],
    ),
    (
        ISOTHERMAL,
        "ξ = ξ₀ max(1, H_f²/λ), ξ₀ = {}, H_f",
        &[(PARAMS, "penalty", 0, 1.0)],
    ),
    (
        ISOTHERMAL,
        "(eq. 6.1) of about {}, and",
        &[(
            "crates/ertel/src/plausible/inertia.rs",
            "CRITICAL_REYNOLDS",
            0,
            1.0,
        )],
    ),
    (
        HEAT,
        "Gauss-Lobatto nodes, by default of order {};",
        &[("params/thermal.rs", "film_order", 0, 1.0)],
    ),
    (
        HEAT,
        "change by less than the tolerance ({}),",
        &[("params/thermal.rs", "tolerance", 0, 1.0)],
    ),
    (
        HEAT,
        "lies between {} and 1; a fixed",
        &[(RELAXATION, "SMALLEST", 0, 1.0)],
    ),
    (
        HEAT,
        "and to {} K below the coldest",
        &[("solve/heat/newton.rs", "largest_cooling", 0, 1.0)],
    ),
    (
        THINNING,
        "`{} ≤ n_c ≤ 1`",
        &[(POWERS, "SMALLEST_EXPONENT", 0, 1.0)],
    ),
    (
        THINNING,
        "`{} ≤ β_c ≤ {}`",
        &[
            (
                "crates/ertel-rheology/src/shear/carreau.rs",
                "({}..={}).contains(&a)",
                0,
                1.0,
            ),
            (
                "crates/ertel-rheology/src/shear/carreau.rs",
                "({}..={}).contains(&a)",
                1,
                1.0,
            ),
        ],
    ),
    (
        THINNING,
        "as `r² (r² + {})^(k/2 − 1)`",
        &[(POWERS, "SMALLEST_SQUARE", 0, 1.0)],
    ),
    (
        THINNING,
        "From `r₁ = {}` on, `atanh r`",
        &[(
            "crates/ertel-rheology/src/shear/limit.rs",
            "LARGEST_RATIO",
            0,
            1.0,
        )],
    ),
    (
        THINNING,
        "From `x = {}` on, `exp(x)`",
        &[(POWERS, "LARGEST_EXPONENT", 0, 1.0)],
    ),
    (
        RHEOLOGY,
        "c₁ = {} 1/Pa, c₂ = {} 1/Pa",
        &[
            (
                "crates/ertel-rheology/src/density/dowson_higginson.rs",
                "COMPRESSIBILITY",
                0,
                1.0,
            ),
            (
                "crates/ertel-rheology/src/density/dowson_higginson.rs",
                "SATURATION",
                0,
                1.0,
            ),
        ],
    ),
    (
        RHEOLOGY,
        "μ = μ₀ exp{(ln μ₀ + {}) [−1 + (1 + p/p₀)^Z ((T − {})/(T_R − {}))^(−S₀)]}",
        &[
            (
                "crates/ertel-rheology/src/viscosity/roelands.rs",
                "POLE_LN_VISCOSITY",
                0,
                1.0,
            ),
            (
                "crates/ertel-rheology/src/viscosity/roelands.rs",
                "POLE_TEMPERATURE",
                0,
                1.0,
            ),
            (
                "crates/ertel-rheology/src/viscosity/roelands.rs",
                "POLE_TEMPERATURE",
                0,
                1.0,
            ),
        ],
    ),
    (
        RHEOLOGY,
        "Z = α p₀ / (ln μ₀ + {}), S₀ = β (T_R − {}) / (ln μ₀ + {})",
        &[
            (
                "crates/ertel-rheology/src/viscosity/roelands.rs",
                "POLE_LN_VISCOSITY",
                0,
                1.0,
            ),
            (
                "crates/ertel-rheology/src/viscosity/roelands.rs",
                "POLE_TEMPERATURE",
                0,
                1.0,
            ),
            (
                "crates/ertel-rheology/src/viscosity/roelands.rs",
                "POLE_LN_VISCOSITY",
                0,
                1.0,
            ),
        ],
    ),
    (
        RHEOLOGY,
        "and `1/p₀ = {} 1/Pa` unless given",
        &[(
            "crates/ertel-rheology/src/viscosity/roelands.rs",
            "PRESSURE_CONSTANT",
            1,
            1.0,
        )],
    ),
    (
        RHEOLOGY,
        "Above `ln(μ/μ₀) = {}`,",
        &[(
            "crates/ertel-rheology/src/viscosity/doolittle.rs",
            "LARGEST_LN_RATIO",
            0,
            1.0,
        )],
    ),
    (
        RHEOLOGY,
        "μ = μ_g exp[−{} C₁ x/(C₂ + x)]",
        &[(
            "crates/ertel-rheology/src/viscosity/yasutomi.rs",
            "DECADE",
            0,
            1.0,
        )],
    ),
    (
        RHEOLOGY,
        "z = ν + {} + exp(−1.47",
        &[(
            "crates/ertel-rheology/src/viscosity/walther.rs",
            "let y = ln_z.exp() - {};",
            0,
            1.0,
        )],
    ),
    (
        RHEOLOGY,
        "exp{(ln μ₀ + {}) [(1 + p/p₀)^Z − 1]}",
        &[(
            "crates/ertel-rheology/src/viscosity/walther.rs",
            "POLE_LN_VISCOSITY",
            0,
            1.0,
        )],
    ),
    (
        RHEOLOGY,
        "the bracket is at least {}.",
        &[("crates/ertel-rheology/src/linear.rs", "SMALLEST", 0, 1.0)],
    ),
    (
        RHEOLOGY,
        "a relative decrease per kelvin of {}, {}, {} and {} (mineral",
        &[
            (OILS, "Self::Mineral | Self::Naphthenic => {}, ", 0, 1.0),
            (OILS, "Self::Pao => {}, ", 0, 1.0),
            (OILS, "Self::Ester => {}, ", 0, 1.0),
            (OILS, "Self::Pag => {}, ", 0, 1.0),
        ],
    ),
    (
        RHEOLOGY,
        "α = {} s ν^t · 10 1/GPa",
        &[(OILS, "SLOPES_OVER_FORMULA", 0, 1.0)],
    ),
    (
        RHEOLOGY,
        "| mineral | {} | {} | | PAO | {} | {} | | ester | {} | {} | | PAG | {} | {} |",
        &[
            (
                OILS,
                "Self::Mineral | Self::Naphthenic => ({}, {}),",
                0,
                1.0,
            ),
            (
                OILS,
                "Self::Mineral | Self::Naphthenic => ({}, {}),",
                1,
                1.0,
            ),
            (OILS, "Self::Pao => ({}, {}),", 0, 1.0),
            (OILS, "Self::Pao => ({}, {}),", 1, 1.0),
            (OILS, "Self::Ester => ({}, {}),", 0, 1.0),
            (OILS, "Self::Ester => ({}, {}),", 1, 1.0),
            (OILS, "Self::Pag => ({}, {}),", 0, 1.0),
            (OILS, "Self::Pag => ({}, {}),", 1, 1.0),
        ],
    ),
    (
        RHEOLOGY,
        "ISO 3448: the middle of the grade, ± {} %",
        &[(SHEETS, "ISO_VG_TOLERANCE", 0, 100.0)],
    ),
    (
        RHEOLOGY,
        "hence a range of ± {} % (95 %)",
        &[(OILS, "_ => ( {}, \"44 measured", 0, 100.0)],
    ),
    (
        RHEOLOGY,
        "mineral oils with {} instead of {}",
        &[
            (OILS, "SLOPES_OF_LOW_INDEX", 0, 1.0),
            (OILS, "SLOPES_OVER_FORMULA", 0, 1.0),
        ],
    ),
    (
        RHEOLOGY,
        "| mineral, naphthenic | {} | −{} to +{} % | {} at {} K | −{} to +{} % | {} | {} | −{} to +{} % |",
        &[
            (
                OIL_HEAT,
                "conductivity: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                0,
                1.0,
            ),
            (
                OIL_HEAT,
                "conductivity: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                1,
                100.0,
            ),
            (
                OIL_HEAT,
                "conductivity: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                2,
                100.0,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                2,
                1e-6,
            ),
            (
                OIL_HEAT,
                "reference_temperature: {}, beta_0: {}, b_1: {}, b_2: {}, k_1: {}, k_2: {}, }",
                0,
                1.0,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                3,
                100.0,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                4,
                100.0,
            ),
            (
                OIL_SHEAR,
                "eyring_stress: stress({}), pressure_coefficient: limit( {}",
                0,
                1e-6,
            ),
            (
                OIL_SHEAR,
                "pressure_coefficient: limit( {}, [{}, {}], \"feup_gear, full film of a thrust ball bearing in mineral",
                0,
                1.0,
            ),
            (
                OIL_SHEAR,
                "pressure_coefficient: limit( {}, [{}, {}], \"feup_gear, full film of a thrust ball bearing in mineral",
                1,
                100.0,
            ),
            (
                OIL_SHEAR,
                "pressure_coefficient: limit( {}, [{}, {}], \"feup_gear, full film of a thrust ball bearing in mineral",
                2,
                100.0,
            ),
        ],
    ),
    (
        RHEOLOGY,
        "| PAO | {} | ± {} % | {} at 40 °C | −{} to +{} % | {} | {} | ± {} % |",
        &[
            (
                OIL_HEAT,
                "conductivity: estimate( {}, [{}, {}], \"kreuz_pao",
                0,
                1.0,
            ),
            (
                OIL_HEAT,
                "conductivity: estimate( {}, [{}, {}], \"kreuz_pao",
                1,
                100.0,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"kreuz_pao",
                2,
                1e-6,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"kreuz_pao",
                3,
                100.0,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"kreuz_pao",
                4,
                100.0,
            ),
            (OIL_SHEAR, "..stress({}) }", 0, 1e-6),
            (
                OIL_SHEAR,
                "pressure_coefficient: limit( {}, [{}, {}], \"kreuz_pao",
                0,
                1.0,
            ),
            (
                OIL_SHEAR,
                "pressure_coefficient: limit( {}, [{}, {}], \"kreuz_pao",
                1,
                100.0,
            ),
        ],
    ),
    (
        RHEOLOGY,
        "| `d₁`, `d₂`, 1/GPa | {}, {} | {}, {} | as PAO |",
        &[
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                0,
                1e9,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"larsson_andersson2000, paraffinic",
                1,
                1e9,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"kreuz_pao",
                0,
                1e9,
            ),
            (
                OIL_HEAT,
                "d_1: {}, d_2: {}, volumetric_heat: estimate( {}, [{}, {}], \"kreuz_pao",
                1,
                1e9,
            ),
        ],
    ),
    (
        RHEOLOGY,
        "| `k₁`, `k₂`, 1/GPa | {}, {} | {}, {} | as PAO |",
        &[
            (
                OIL_HEAT,
                "reference_temperature: {}, beta_0: {}, b_1: {}, b_2: {}, k_1: {}, k_2: {}, }",
                4,
                1e9,
            ),
            (
                OIL_HEAT,
                "reference_temperature: {}, beta_0: {}, b_1: {}, b_2: {}, k_1: {}, k_2: {}, }",
                5,
                1e9,
            ),
            (
                OIL_HEAT,
                "beta_0: {}, b_1: {}, b_2: {}, k_1: {}, k_2: {}, };",
                3,
                1e9,
            ),
            (
                OIL_HEAT,
                "beta_0: {}, b_1: {}, b_2: {}, k_1: {}, k_2: {}, };",
                4,
                1e9,
            ),
        ],
    ),
    (
        RHEOLOGY,
        "VI = 100 + (10^N − 1)/{}, N =",
        &[(
            "crates/ertel-rheology/src/data_sheet/viscosity_index.rs",
            "/ {}",
            0,
            1.0,
        )],
    ),
    (
        VOLUMES,
        "μ̄/K levels off below e^−{}, far below the values of a solution",
        &[("volumes/thinning.rs", "MAX_LN_THINNING", 0, 1.0)],
    ),
    (
        VOLUMES,
        "No pressure changes by more than {} p_h in a step",
        &[("volumes/newton.rs", "largest_change", 0, 1.0)],
    ),
    (
        VOLUMES,
        "A line on {} nodes or more has factors",
        &[("volumes/preconditioner.rs", "LONG_LINE", 0, 1.0)],
    ),
    (
        VOLUMES,
        "down to dense matrices of {} nodes",
        &[("volumes/line_factors.rs", "DENSE", 0, 1.0)],
    ),
    (
        VOLUMES,
        "err by {} of the largest entry",
        &[("volumes/line_factors.rs", "TOLERANCE", 0, 1.0)],
    ),
    (
        VOLUMES,
        "only with M above {} or L above {}, or with a film above {} a²/R",
        &[
            ("crates/ertel/src/run/mod.rs", "ELEMENTS_UP_TO", 0, 1.0),
            ("crates/ertel/src/run/mod.rs", "ELEMENTS_UP_TO", 1, 1.0),
            (OUTLET, "THICK", 0, 1.0),
        ],
    ),
];
