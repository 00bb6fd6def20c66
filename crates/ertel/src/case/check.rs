//! Checks that need more than one value.

use ertel_input::{Bounds, InputError, Table};

use super::bodies::name_in;
use super::thermal::SolidHeat;
use super::{Case, Mechanics, machine};
use crate::contact::{Contact, ContactKind, Hertz, equivalent_body};
use crate::params::{ElasticModel, Method, SensitivityDemand};
use crate::volumes;
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length, pressure};

/// Hertz pressures of lubricated contacts, Pa.
pub(super) const HERTZ_PRESSURE: Bounds = Bounds::closed(MIN_PRESSURE, MAX_PRESSURE);
const MIN_PRESSURE: f64 = 1e3;
const MAX_PRESSURE: f64 = 5e9;
/// Half-width over radius from which the parabola of Hertz theory is a poor sphere.
const POOR_PARABOLA: f64 = 0.2;

/// The Hertz contact, if it is one that the theory covers; `load_key` is the key of its load.
pub(super) fn hertz(
    table: &Table<'_>,
    load_key: &str,
    contact: &Contact,
    reduced_modulus: f64,
) -> Result<Hertz, InputError> {
    let hertz = Hertz::new(contact, reduced_modulus);
    // A Hertz pressure given as such was checked before the round trip through the load.
    let rounding = Bounds::closed(MIN_PRESSURE * (1.0 - 1e-12), MAX_PRESSURE * (1.0 + 1e-12));
    if !rounding.contains(hertz.pressure) {
        let unit = contact.kind.load_unit();
        let load = |pressure| Hertz::load_for_pressure(contact, reduced_modulus, pressure);
        return Err(table
            .error(
                load_key,
                format!(
                    "this load gives a Hertz pressure of {}, outside 1 kPa to 5 GPa",
                    pressure(hertz.pressure)
                ),
            )
            .with_help(format!(
                "with this radius and these bodies the load must be between {} {unit} and {} {unit}",
                rounded(load(MIN_PRESSURE), f64::ceil),
                rounded(load(MAX_PRESSURE), f64::floor)
            )));
    }
    let along_y = hertz
        .half_width_y
        .map(|b| (b, contact.radius_y, "radius_y"));
    let key = if along_y.is_some() {
        "radius_x"
    } else {
        "radius"
    };
    let along_x = (hertz.half_width, contact.radius, key);
    let wide = [Some(along_x), along_y]
        .into_iter()
        .flatten()
        .find(|(half_width, radius, _)| half_width >= radius);
    if let Some((half_width, _, key)) = wide {
        return Err(table
            .error(
                key,
                format!(
                    "the contact half-width, {}, exceeds the radius",
                    length(half_width)
                ),
            )
            .with_help(
                "Hertz theory and the film equation hold for contacts much smaller than the bodies",
            ));
    }
    Ok(hertz)
}

/// Poisson's ratio from which finite elements lock: the volume hardly changes, and the bulk modulus is infinite at 0.5.
const LOCKING: f64 = 0.495;

/// Refuses finite elements for bodies that are nearly incompressible; half-spaces take them.
pub(super) fn finite_elements_of_soft_bodies(
    case: &Case,
    root: &Table<'_>,
) -> Result<(), InputError> {
    if case.elastic_model() == ElasticModel::HalfSpace {
        return Ok(());
    }
    let body = equivalent_body(case.body_1.elasticity, case.body_2.elasticity);
    if body.poissons_ratio <= LOCKING {
        return Ok(());
    }
    Err(root
        .error(
            "bodies",
            format!(
                "finite-element bodies lock near Poisson's ratio 0.5: the equivalent body has {}, the limit is {LOCKING}",
                digits(body.poissons_ratio, 4)
            ),
        )
        .with_help(
            "half-spaces allow up to 0.5: remove elasticity and linear from [solver], and body_field from [output]",
        ))
}

/// Refuses layers that are thicker than a body, and contacts with layers that are not solved.
pub(super) fn layers(case: &Case, root: &mut Table<'_>) -> Result<(), InputError> {
    let refused = [
        (
            case.elastic_model() != ElasticModel::HalfSpace,
            "finite-element bodies: remove elasticity and linear from [solver], and body_field from [output]",
        ),
        (
            case.solver.method == Some(Method::FiniteElements),
            "finite elements: layers are solved by finite volumes; remove method from [solver]",
        ),
        (
            case.contact.kind == ContactKind::Roller,
            "rollers of finite length",
        ),
    ];
    let names = [["body_1", "plane"], ["body_2", "ball"]];
    for (names, layers) in names.into_iter().zip(case.layers()) {
        if layers.is_empty() {
            continue;
        }
        let mut bodies = root.required_table("bodies")?;
        let key = name_in(&mut bodies, names)?;
        let body = bodies.required_table(key)?;
        if let Some((_, reason)) = refused.iter().find(|(applies, _)| *applies) {
            let text = format!("`layers` cannot be combined with {reason}");
            return Err(body.error("layers", text));
        }
        if let Some(reason) = finite_volumes_refuse(case) {
            let text = format!("`layers` are solved by finite volumes, which {reason}");
            return Err(body.error("layers", text));
        }
        let thickness: f64 = layers.iter().map(|layer| layer.thickness).sum();
        let radius = case.contact.radius;
        if thickness > radius {
            let text = format!(
                "the layers are {} thick, more than the radius of the contact, {}",
                length(thickness),
                length(radius)
            );
            return Err(body.error("layers", text));
        }
    }
    Ok(())
}

/// Half-width over the radius of a body itself from which the parabola is a poor circle. Of two bodies that fit closely, the gap between
/// their circles exceeds that between their parabolas by ¾(y/R)²: 7 % there at the edge of the contact.
const POOR_CIRCLE: f64 = 0.3;

/// Refuses a contact that is wider than one of its bodies; `radii` are the smallest of both along x and y, m.
pub(super) fn body_size(
    table: &Table<'_>,
    key: &str,
    hertz: &Hertz,
    radii: [f64; 2],
) -> Result<(), InputError> {
    let half_widths = [hertz.half_width, hertz.half_width_y.unwrap_or(0.0)];
    let wide = half_widths.into_iter().zip(radii).find(|(a, r)| a >= r);
    let Some((half_width, radius)) = wide else {
        return Ok(());
    };
    Err(table
        .error(
            key,
            format!(
                "the contact half-width, {}, exceeds the radius of a body, {}",
                length(half_width),
                length(radius)
            ),
        )
        .with_help(
            "Hertz theory and the film equation hold for contacts much smaller than the bodies",
        ))
}

/// Largest Hertz pressures, Pa, of hardened bearing steel in ball and in roller bearings under static load: a permanent deformation of
/// 0.0001 of the diameter (ISO 76). Also the limit of solids that state none.
const HARDEST_STEEL: [f64; 2] = [4.2e9, 4.0e9];

/// Warns if a Hertz pressure, Pa, exceeds the limit of the bodies.
fn strength(case: &Case, hertz_pressure: f64) -> Option<Warning> {
    let (limit, whose) = case.pressure_limit();
    if hertz_pressure <= limit {
        return None;
    }
    let text = format!(
        "the Hertz pressure of {} exceeds {}, the limit of {whose}: the bodies do not stay elastic, as the computation assumes",
        pressure(hertz_pressure),
        pressure(limit),
    );
    Some(Warning::beyond(
        WarningKind::Strength,
        hertz_pressure / limit,
        text,
    ))
}

impl Case {
    /// Hertz pressure limit of the weaker body, Pa, and its owner; that of the hardest steels where no body states one.
    pub fn pressure_limit(&self) -> (f64, String) {
        let own = [&self.body_1, &self.body_2].map(|body| {
            let limit = body.hertz_pressure_limit?;
            Some((limit, format!("{} (hertz_pressure_limit)", body.name)))
        });
        let weaker = own.into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0));
        weaker.unwrap_or_else(|| {
            let limit = HARDEST_STEEL[usize::from(self.contact.kind.is_cylinder())];
            (limit, "hardened bearing steel (ISO 76)".to_owned())
        })
    }
}

/// Warnings about the input.
pub(super) fn warnings(case: &Case, hertz: &Hertz) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let ratio = case.motion.slide_to_roll_ratio;
    if ratio.abs() > 2.0 {
        let text = format!(
            "the slide-to-roll ratio {} is beyond 2: the surfaces move in opposite directions",
            digits(ratio, 6)
        );
        warnings.push(Warning::beyond(
            WarningKind::OppositeMotion,
            ratio.abs(),
            text,
        ));
    } else if case.motion.sliding_at_centre() > 2.0 {
        // u_1·u_2 = u_m² (1 − (S² + S_⊥²)/4) < 0
        let (size, across) = (
            case.motion.sliding_at_centre(),
            case.motion.slide_to_roll_ratio_across,
        );
        let text = format!(
            "the slide-to-roll ratio across the motion is {}, and that of both components together {} is beyond 2: the surfaces move \
             in opposite directions",
            digits(across, 6),
            digits(size, 6)
        );
        warnings.push(Warning::beyond(WarningKind::OppositeMotion, size, text));
    }
    let share_y = (hertz.half_width_y).map_or(0.0, |b| b / case.contact.radius_y);
    let share = (hertz.half_width / case.contact.radius).max(share_y);
    if share > POOR_PARABOLA {
        let text = format!(
            "the contact half-width is {share:.2} of the radius: the parabolic gap of Hertz theory is crude"
        );
        warnings.push(Warning::beyond(WarningKind::WideContact, share, text));
    }
    let half_widths = [hertz.half_width, hertz.half_width_y.unwrap_or(0.0)];
    let share = (half_widths.into_iter().zip(case.body_radii))
        .map(|(half_width, radius)| half_width / radius)
        .fold(0.0, f64::max);
    if share > POOR_CIRCLE {
        let text = format!(
            "the contact half-width is {share:.2} of the radius of a body: half-spaces and the parabolic gap of Hertz theory are crude"
        );
        warnings.push(Warning::beyond(WarningKind::WideContact, share, text));
    }
    warnings.extend(strength(case, hertz.pressure));
    warnings.extend(super::roller::warnings(
        &case.contact,
        hertz,
        case.reduced_modulus(),
    ));
    warnings
}

/// Keys of `[mesh]` that describe a finite-element body.
const BODY_KEYS: [&str; 3] = ["depth_growth", "body_width", "body_depth"];
/// Highest Lagrange order of the displacement in such a body.
const HIGHEST_ORDER_OF_BODIES: usize = 2;

/// Checks `[mesh]` against the elastic model; returns warnings.
///
/// # Errors
/// An order of the displacement that finite-element bodies do not have.
pub fn mesh_of_bodies(case: &Case, table: &Table<'_>) -> Result<Vec<Warning>, InputError> {
    let order = case.mesh.elastic_order;
    if case.elastic_model() != ElasticModel::HalfSpace {
        return match order {
            Some(order) if order > HIGHEST_ORDER_OF_BODIES => Err(table
                .error(
                    "elastic_order",
                    format!(
                        "`elastic_order` is {order}, but displacements of finite-element bodies have the order 1 or \
                         {HIGHEST_ORDER_OF_BODIES}"
                    ),
                )
                .with_help("half-spaces (`elasticity = \"half-space\"` in [solver]) take up to 5")),
            _ => Ok(Vec::new()),
        };
    }
    let mut warnings = Vec::new();
    let mut keys = table.clone();
    let given: Vec<String> = (BODY_KEYS.into_iter())
        .filter(|key| keys.contains(key))
        .map(|key| format!("mesh.{key}"))
        .collect();
    if !given.is_empty() {
        warnings.push(Warning::new(WarningKind::NoEffect, format!(
            "the bodies are half-spaces, on which {} {} no effect; solver.elasticity = \"equivalent\" uses {}",
            given.join(", "),
            if given.len() == 1 { "has" } else { "have" },
            if given.len() == 1 { "it" } else { "them" },
        )));
    }
    let pressure = case.mesh.pressure_order;
    if let Some(order) = order.filter(|order| *order < pressure) {
        warnings.push(Warning::new(WarningKind::NoEffect, format!(
            "mesh.elastic_order = {order} is below mesh.pressure_order = {pressure}: deflections of half-spaces \
             have the order of the pressure"
        )));
    }
    Ok(warnings)
}

/// Refuses finite-element bodies below elliptical contacts, rollers, and surfaces that slide at an angle or spin: their meshes are made around
/// circles, and halves of them.
pub(super) fn body_of_wide_contact(case: &Case, table: &Table<'_>) -> Result<(), InputError> {
    let what = match case.contact.kind {
        ContactKind::Elliptical => "an elliptical contact",
        ContactKind::Roller => "a roller",
        ContactKind::Circular if !case.motion.is_straight() => {
            "a contact whose surfaces slide across the entrainment or spin"
        }
        ContactKind::Line | ContactKind::Circular => return Ok(()),
    };
    if case.elastic_model() == ElasticModel::HalfSpace {
        return Ok(());
    }
    Err(table
        .error(
            "kind",
            format!("{what} needs half-spaces, but this case selects finite-element bodies"),
        )
        .with_help("remove `elasticity` and `linear` from [solver] and `body_field` from [output]"))
}

/// Keys of [solver] and [mesh] that do not apply to finite volumes.
const SOLVER_KEYS_OF_ELEMENTS: [&str; 9] = [
    "formulation",
    "isotropic_diffusion",
    "elastic_stabilisation",
    "penalty",
    "penalty_scaling",
    "linear",
    "tolerance",
    "max_iterations",
    "error_estimate",
];
const MESH_KEYS_OF_ELEMENTS: [&str; 10] = [
    "hertz_size",
    "constriction_size",
    "rim_size",
    "edge_size",
    "growth",
    "depth_growth",
    "body_width",
    "body_depth",
    "pressure_order",
    "elastic_order",
];

/// Those of [thermal], likewise.
const THERMAL_KEYS_OF_ELEMENTS: [&str; 2] = ["solid_elements", "surface_order"];

/// Refuses asperities where no method shares the load between them and the oil.
pub(super) fn asperities(case: &Case, roughness: Option<&Table<'_>>) -> Result<(), InputError> {
    let (Some(asperities), Some(roughness)) = (&case.asperities, roughness) else {
        return Ok(());
    };
    super::asperities::check_range(asperities, roughness, case.hertz().pressure)?;
    let by_elements = "`method` is \"finite-elements\", which knows no asperities";
    let reason = match case.solver.method {
        Some(Method::FiniteElements) => by_elements.to_owned(),
        _ => match finite_volumes_refuse(case) {
            None => return Ok(()),
            Some(reason) => format!("only finite volumes share it, but these {reason}"),
        },
    };
    Err(roughness
        .error(
            "asperity_group",
            format!("oil and asperities cannot share the load here: {reason}"),
        )
        .with_help(
            "without asperity_group, rms_height_to_asperity_radius and boundary_friction_coefficient the surfaces are computed as smooth, with the lambda ratio",
        ))
}

/// Refuses contacts whose wear is not computed; `table` is `[wear]`.
pub(super) fn wear(case: &Case, table: &Table<'_>, root: &mut Table<'_>) -> Result<(), InputError> {
    let refused = [
        (
            root.contains("transient"),
            "[transient]: wear takes far longer than passages, and its contacts are steady",
        ),
        (
            case.machine.is_some() || case.whole.is_some(),
            "[machine]: it has many contacts with different sliding distances; write one of them as [contact] and [motion]",
        ),
        (
            case.contact.kind == ContactKind::Roller,
            "rollers of finite length: the wear of their ends is not computed",
        ),
        (
            !case.motion.is_straight(),
            "surfaces that slide across the entrainment or spin: tracks lie along the entrainment",
        ),
        (
            root.contains("surface"),
            "[[surface]]: asperities on reliefs wear differently, and reliefs of moving bodies do not stay where they are",
        ),
        (
            case.output.sensitivities == SensitivityDemand::All,
            "[output] sensitivities: derivatives of worn contacts are not computed",
        ),
    ];
    if let Some((_, reason)) = refused.iter().find(|(applies, _)| *applies) {
        return Err(table.error_here(format!("[wear] cannot be combined with {reason}")));
    }
    if case.asperities.is_none() {
        let text = "[wear] needs asperities, whose load wears the bodies, and [surface_roughness] describes none";
        return Err(table.error_here(text).with_help(
            "give the rms heights of both bodies, `asperity_group` and `rms_height_to_asperity_radius`, or another `asperity_law`",
        ));
    }
    if !case.motion.slides() {
        return Err(table
            .error_here(
                "[wear] needs surfaces that slide: without sliding there is no sliding distance",
            )
            .with_help("give a slide_to_roll_ratio other than 0, or remove [wear]"));
    }
    Ok(())
}

/// Refuses finite volumes for contacts that they do not solve, and keys that have no effect on them.
pub(super) fn finite_volumes(
    case: &Case,
    solver: Option<&Table<'_>>,
    mesh: Option<&Table<'_>>,
    thermal: Option<&Table<'_>>,
) -> Result<(), InputError> {
    let is_chosen = case.solver.method == Some(Method::FiniteVolumes);
    if !is_chosen && case.asperities.is_none() {
        return Ok(());
    }
    if let (Some(reason), Some(solver), true) = (finite_volumes_refuse(case), solver, is_chosen) {
        return Err(solver
            .error(
                "method",
                format!("`method` is \"finite-volumes\", but these {reason}"),
            )
            .with_help("write `method = \"finite-elements\"`, or remove the key"));
    }
    let keys = [
        (solver, &SOLVER_KEYS_OF_ELEMENTS[..]),
        (mesh, &MESH_KEYS_OF_ELEMENTS[..]),
        (thermal, &THERMAL_KEYS_OF_ELEMENTS[..]),
    ];
    for (table, keys) in keys {
        let Some(table) = table else { continue };
        let mut table = table.clone();
        if let Some(key) = keys.iter().find(|key| table.contains(key)) {
            return Err(table
                .error(key, format!("`{key}` has no effect on finite volumes"))
                .with_help(
                    "remove it; of [mesh], finite volumes take target_error, preset, max_unknowns, inlet, outlet and side; of [thermal] all but \
                     solid_elements, surface_order and field",
                ));
        }
    }
    Ok(())
}

impl Case {
    /// Whether the case file has a key of `[solver]`, `[mesh]` or `[thermal]` that does not apply to finite volumes.
    pub fn has_key_of_elements(&self) -> bool {
        let has = |table: &str, keys: &[&str]| {
            let table = &self.given[table];
            keys.iter().any(|key| table.get(key).is_some())
        };
        has("solver", &SOLVER_KEYS_OF_ELEMENTS)
            || has("mesh", &MESH_KEYS_OF_ELEMENTS)
            || has("thermal", &THERMAL_KEYS_OF_ELEMENTS)
    }
}

/// The reason why finite volumes do not solve a case, to follow "finite volumes"; `None` where they do.
pub fn finite_volumes_refuse(case: &Case) -> Option<&'static str> {
    volumes::why_not(&volumes::About {
        has_half_spaces: case.elastic_model() == ElasticModel::HalfSpace,
        heat: heat_about(case),
    })
}

/// Relative change of a property, some kelvins from the bulk temperature of a body, that counts as none.
const CONSTANT: f64 = 1e-6;
const WARMER: f64 = 30.0;

/// Data of heat that decide whether finite volumes solve a case.
fn heat_about(case: &Case) -> Option<volumes::HeatAbout> {
    let params = case.thermal()?;
    let heat = case.heat().ok().flatten();
    let varies = |body: &SolidHeat| {
        let t = body.temperature;
        let differs = |at: &dyn Fn(f64) -> f64| (at(t + WARMER) / at(t) - 1.0).abs() > CONSTANT;
        differs(&|t| body.conductivity.conductivity(0.0, t))
            || differs(&|t| body.heat_capacity.heat_capacity(0.0, t))
    };
    let varies = |body: &SolidHeat| varies(body) || body.layers.iter().any(|(_, l)| varies(l));
    Some(volumes::HeatAbout {
        slides_along_roller: case.contact.kind == ContactKind::Roller && !case.motion.is_straight(),
        turns_nearby: turns_nearby(case),
        bodies_vary: heat.is_some_and(|heat| varies(&heat.body_1) || varies(&heat.body_2)),
        asks_for_bodies: params.field,
    })
}

/// Largest speed by its spin at the edge of the Hertz zone over that of a body at the centre up to which finite volumes solve for its heat.
const MOST_TURN: f64 = 0.5;

/// Whether the point about which a body turns lies near the contact.
fn turns_nearby(case: &Case) -> bool {
    let hertz = case.hertz();
    let reach = (hertz.half_width).max(hertz.half_width_y.unwrap_or(0.0));
    case.motion.surfaces(reach).iter().any(|body| {
        let [u, v] = body.centre;
        body.spin.abs() > MOST_TURN * u.hypot(v)
    })
}

/// Four significant digits, rounded up or down so that the number itself still fits.
fn rounded(value: f64, direction: fn(f64) -> f64) -> String {
    let step = 10_f64.powf(value.log10().floor() - 3.0);
    digits(direction(value / step) * step, 4)
}

/// Balls that spin on films with shear thinning: each contact takes minutes.
pub(super) fn slow_spin(case: &Case) -> Option<Warning> {
    let Mechanics::Bearing(bearing) = &case.whole.as_ref()?.mechanics else {
        return None;
    };
    let mut contacts = bearing
        .distribution
        .elements
        .iter()
        .flat_map(|e| &e.contacts);
    let spins = contacts.any(|contact| contact.spin[0] != contact.spin[1]);
    let is_slow = spins && bearing.contacts == machine::ContactKind::Ellipses;
    (is_slow && case.shear_thinning().is_some()).then(|| {
        Warning::new(
            WarningKind::UnusualInput,
            "the balls spin: shear-thinning films under spin take minutes per contact; with [solver] newtonian = true films are Newtonian, and \
             friction still follows the law of the lubricant",
        )
    })
}

/// Inputs without effect on a machine of many contacts: sensitivities and uncertainties.
pub(super) fn inputs_of_machine(case: &Case) -> Option<Warning> {
    case.whole.as_ref()?;
    let uncertain =
        (case.inputs().iter()).find(|input| input.written && input.uncertainty.is_some());
    let what = match uncertain {
        Some(input) => format!("the uncertainty of {} has no effect", input.key),
        None if case.output.sensitivities == SensitivityDemand::All => {
            "[output] sensitivities has no effect".to_owned()
        }
        None => return None,
    };
    Some(Warning::new(
        WarningKind::NoEffect,
        format!(
            "{what}: a whole machine has neither sensitivities nor propagated uncertainties; vary its inputs in a study"
        ),
    ))
}
