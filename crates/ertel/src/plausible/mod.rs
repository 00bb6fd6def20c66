//! Converged results that are physically impossible: friction that no lubricant transmits, films that are not small compared with the
//! bodies, air colder than the inlet oil and both bodies; and effects that the model neglects, with their size.
//!
//! | check | threshold | source |
//! |---|---|---|
//! | traction coefficient | [`LARGEST_TRACTION`] | traction fluids |
//! | shear stress over p_h, sliding or rolling, whatever its error bar | [`LARGEST_STRESS_RATIO`] | Johnson; Habchi |
//! | film over the smallest radius | [`LARGEST_FILM`] | slope of the gap |
//! | film without shear thinning over that with it, by an estimated law | [`SMALL_THINNING`] | the estimates are of traction |
//! | heat of an isothermal contact | [`heat::LARGEST_RISE`], [`heat::SMALLEST_FACTOR`] | temperature coefficient of oils |
//! | inertia of the film | [`inertia::NEGLIGIBLE_INERTIA`], [`inertia::CRITICAL_REYNOLDS`] | Habchi |
//! | air colder than what flows in, heat balance | `UNDERSHOOT`, `LARGEST_HEAT_ERROR` | nothing cools before the contact |
//!
//! Checks of the input alone (Hertz pressure against the bodies' limit, width against each body's radii, the law's range) are made where the
//! case is read.

pub mod heat;
pub mod inertia;
pub mod neglected;

use crate::case::Case;
use crate::solution::{Estimate, Figure, Located, Solution, Traction};
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length, pressure};

/// Traction coefficient from which friction is doubted: traction fluids, made for it, reach 0.12 or so (Habchi 2008 computes
/// none above 0.08).
pub const LARGEST_TRACTION: f64 = 0.15;

/// Shear stress over the pressure that it is doubted from: limiting stresses measured are 0.03 to 0.1 of the pressure (Johnson,
/// Contact Mechanics, section 10.4; Habchi 2008, section 4.2).
pub const LARGEST_STRESS_RATIO: f64 = 0.1;

/// Film thickness over radius from which Reynolds' equation is doubted: surfaces are parallel within √(2h/R), which is 0.14 there,
/// over the length √(2hR) in which pressure builds up, and the parabola is taken for the circle.
pub const LARGEST_FILM: f64 = 0.01;

/// Share of the film by which a law with estimated constants may thin it without a warning: they come from traction at high pressure, while films form in the
/// inlet.
pub const SMALL_THINNING: f64 = 0.02;

/// Share of the largest rise by which, and K by which at the least, the film may be colder before the contact than what flows in:
/// an unresolved inflow leaves no larger residual.
const UNDERSHOOT: (f64, f64) = (0.02, 1.0);

/// Share of the generated heat above which an open heat balance is reported.
const LARGEST_HEAT_ERROR: f64 = 0.01;

/// Warnings about a solution that is physically impossible.
pub fn warnings(case: &Case, solution: &Solution) -> Vec<Warning> {
    [
        friction(case, &solution.traction, solution.hertz.pressure),
        thick_film(
            "the central film thickness",
            solution.summary.film_central.value,
            smallest_radius(case),
        ),
        estimated_thinning(case, solution),
        cold_inlet(case, solution),
        open_balance(solution),
    ]
    .into_iter()
    .flatten()
    .chain(neglected::warnings(
        case,
        solution.summary.film_central.value,
        &solution.left_out,
    ))
    .collect()
}

/// Smallest radius, m: of the gap, or of a body itself.
pub fn smallest_radius(case: &Case) -> f64 {
    let [x, y] = case.body_radii;
    case.contact.radius.min(x).min(y)
}

/// Limits of friction that a case neglects.
fn neglected_limits(case: &Case) -> Vec<&'static str> {
    let thinning = case.friction_thinning();
    [
        (
            thinning.is_some(),
            "shear thinning ([lubricant] shear_thinning)",
        ),
        (case.thermal().is_some(), "heat ([thermal])"),
        (
            thinning.is_some_and(|law| law.limit.is_some()),
            "a limiting shear stress ([lubricant] shear_thinning, limit)",
        ),
    ]
    .into_iter()
    .filter_map(|(has, what)| (!has).then_some(what))
    .collect()
}

/// Share of p_h from which a shear stress of rolling is more than a spike of the pressure gradient.
const GROSS_STRESS_RATIO: f64 = 0.5;

/// Friction beyond what lubricants transmit. The value counts, whatever its error bar: a wide bar makes a result no better. Where the
/// surfaces only roll, stress comes of the pressure gradient at the spike, which hardly affects films and rolling friction; on fine grids it grows with each grid, without being resolved.
fn friction(case: &Case, traction: &Traction, hertz_pressure: f64) -> Option<Warning> {
    let slides = case.motion.slides();
    let coefficient = traction.size().value;
    let stress = traction.shear_stress_maximum.value;
    let largest = LARGEST_STRESS_RATIO * hertz_pressure;
    let (excess, what) = if slides && coefficient > LARGEST_TRACTION {
        let reported = match traction.across {
            Some(_) => coefficient,
            None => traction.coefficient.value,
        };
        (coefficient / LARGEST_TRACTION, too_much_traction(reported))
    } else if stress > largest {
        let what = format!(
            "a shear stress of {} exceeds what lubricants can carry (about 0.1 of the pressure, here {})",
            pressure(stress),
            pressure(largest)
        );
        (stress / largest, what)
    } else {
        return None;
    };
    let why = why_so_much_friction(case);
    let is_gross =
        stress > GROSS_STRESS_RATIO * hertz_pressure && traction.shear_stress_maximum.is_resolved();
    let (kind, unusable) = match slides || is_gross {
        true => (
            WarningKind::Friction,
            "do not use friction, stress and heat of this result",
        ),
        false => (
            WarningKind::RollingStress,
            "do not use the shear stress of this result; in pure rolling film and pressure are not affected",
        ),
    };
    let text = format!("{what}: {why}; {unusable}");
    Some(Warning::beyond(kind, excess, text))
}

fn too_much_traction(coefficient: f64) -> String {
    format!(
        "a traction coefficient of {} is larger than measured for any lubricant (about 0.12)",
        digits(coefficient, 3)
    )
}

/// Advice where friction is beyond what lubricants transmit.
fn why_so_much_friction(case: &Case) -> String {
    match &neglected_limits(case)[..] {
        [] => "check the constants of the lubricant's laws".to_owned(),
        [one] => format!("the case neglects {one}"),
        [all @ .., last] => format!("the case neglects {} and {last}", all.join(", ")),
    }
}

/// The same for a contact in time, by its largest traction coefficient, and by its largest film, m, compared with the bodies.
pub fn in_time(case: &Case, coefficient: f64, film: f64) -> Vec<Warning> {
    let excess = coefficient.abs() / LARGEST_TRACTION;
    let friction = (excess > 1.0).then(|| {
        let (what, why) = (too_much_traction(coefficient), why_so_much_friction(case));
        let text = format!("{what}: {why}; do not use the friction of this result");
        Warning::beyond(WarningKind::Friction, excess, text)
    });
    let thick = thick_film(
        "the largest central film thickness",
        film,
        smallest_radius(case),
    );
    friction.into_iter().chain(thick).collect()
}

/// Warns if a film thickness, m, is not small compared with the radius, m. `film` names it.
pub fn thick_film(film: &str, thickness: f64, radius: f64) -> Option<Warning> {
    let ratio = thickness / radius;
    let share = digits(ratio, 2);
    let words = if ratio > 1.0 {
        "thicker than the body itself: no such contact exists; check speed, viscosity and load"
    } else if ratio > LARGEST_FILM {
        "too thick for Reynolds' equation and the parabolic gap"
    } else {
        return None;
    };
    let text = format!(
        "{film}, {}, is {share} of the radius, {words}",
        length(thickness)
    );
    Some(Warning::beyond(WarningKind::ThickFilm, ratio, text))
}

/// A film thinned by `shear_thinning = { law = "estimate" }`. Its limiting stress at ambient pressure is a guess, and bounds the pressure that the inlet
/// builds up.
fn estimated_thinning(case: &Case, solution: &Solution) -> Option<Warning> {
    let estimates = &case.lubricant.estimates;
    let of_shear = |key: &str| key.starts_with("shear_thinning.");
    if !estimates.iter().any(|datum| of_shear(&datum.key)) {
        return None;
    }
    let by = solution.film_reduction?;
    let summary = &solution.summary;
    // Between rough surfaces the reduction is that of the mean gap.
    let gap = |figure| solution.figure(figure).map(|gap| gap.value);
    let films = [
        (
            "central",
            by.central,
            gap(Figure::MeanGapCentral).unwrap_or(summary.film_central.value),
        ),
        (
            "minimum",
            by.minimum,
            gap(Figure::MeanGapMinimum).unwrap_or(summary.film_minimum.value),
        ),
    ];
    let larger = |(_, one, _): &(_, Estimate, _), (_, two, _): &(_, Estimate, _)| {
        one.value.abs().total_cmp(&two.value.abs())
    };
    let (name, reduction, film) = films.into_iter().max_by(larger)?;
    let share = reduction.value;
    if share.abs() <= SMALL_THINNING {
        return None;
    }
    let text = format!(
        "the estimated shear-thinning law makes the {name} film {} % {}: {}, without it {}; its constants come from traction at high pressure and are not \
         verified for the inlet, where the film forms; give a measured law, or compute films with [solver] newtonian = true",
        digits(100.0 * share.abs(), 2),
        if share > 0.0 { "thinner" } else { "thicker" },
        length(film),
        length(film / (1.0 - share)),
    );
    Some(Warning::beyond(
        WarningKind::EstimatedThinning,
        share.abs(),
        text,
    ))
}

/// Nothing cools the film before the contact: shear and compression heat it, and expansion follows behind the contact.
fn cold_inlet(case: &Case, solution: &Solution) -> Option<Warning> {
    let thermal = solution.thermal.as_ref()?;
    let heat = case.heat().ok().flatten()?;
    let coldest = (thermal.inlet_temperature)
        .min(heat.body_1.temperature)
        .min(heat.body_2.temperature);
    let rise = thermal.film_maximum.value - coldest;
    undershoot(&thermal.film_lowest, coldest, rise, solution.scales.length)
}

/// Warns if the heat balance is open.
fn open_balance(solution: &Solution) -> Option<Warning> {
    let balance = &solution.thermal.as_ref()?.balance;
    let error = balance.error;
    if error.abs() <= LARGEST_HEAT_ERROR {
        return None;
    }
    let share = digits(100.0 * error.abs(), 2);
    let text = format!(
        "the heat balance is open by {share} %, bodies and film remove {} than is generated: the mesh does not resolve the thermal \
         boundary layer, mostly at the inlet edge; the heat carried off by each of them is as uncertain",
        if error < 0.0 { "more" } else { "less" }
    );
    Some(Warning::beyond(WarningKind::HeatBalance, error.abs(), text))
}

/// Warns if the lowest temperature of the film is before the contact and below `coldest`, K, that of the inlet oil and both bodies; `rise`
/// is the largest rise, K, `half_width` in m.
fn undershoot(lowest: &Located, coldest: f64, rise: f64, half_width: f64) -> Option<Warning> {
    let below = coldest - lowest.value;
    if lowest.x > -half_width || below < (UNDERSHOOT.0 * rise).max(UNDERSHOOT.1) {
        return None;
    }
    let text = format!(
        "the film is {below:.1} K colder at x/a {:.2} than the inlet oil and both bodies: the mesh of the inlet does not resolve the \
         temperature there; set a nearer inlet edge ([mesh] inlet), or a finer mesh ([mesh] target_error)",
        lowest.x / half_width
    );
    Some(Warning::beyond(WarningKind::ColdInlet, below, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 55 K below at the inlet edge is reported; half a kelvin is not, nor 2 K with a rise of 200 K, nor cooling by expansion behind.
    #[test]
    fn a_film_colder_than_the_inflow() {
        let words = |value, x, rise| {
            let lowest = Located {
                value,
                error: None,
                resolved: true,
                x,
                y: 0.0,
                place_error: None,
                place_resolved: true,
            };
            undershoot(&lowest, 313.0, rise, 1e-4).map(|w| w.text)
        };
        let text = words(258.0, -4.5e-4, 6.4).unwrap();
        assert!(
            text.starts_with("the film is 55.0 K colder at x/a -4.50"),
            "{text}"
        );
        assert_eq!(words(312.5, -4.5e-4, 6.4), None);
        assert_eq!(words(311.0, -4.5e-4, 200.0), None);
        assert_eq!(words(258.0, 1.2e-4, 6.4), None);
    }

    fn case(ratio: f64) -> Case {
        let text = include_str!("../../../ertel-cli/tests/good/quick.toml");
        let setting = format!("motion.slide_to_roll_ratio={ratio:?}");
        Case::from_text_with("quick.toml", text, std::path::Path::new(""), &[setting]).unwrap()
    }

    /// Both sides of each bound; a bar as wide as the figure silences nothing.
    #[test]
    fn stresses_that_no_lubricant_bears() {
        let exact = |value| crate::solution::Estimate {
            value,
            error: Some(0.0),
        };
        let kind = |ratio: f64, stress: f64, error: f64| {
            let traction = Traction {
                coefficient: exact(0.02),
                coefficient_body_1: exact(0.02),
                coefficient_body_2: exact(0.02),
                force: exact(0.0),
                across: None,
                moment: None,
                friction_power: exact(0.0),
                shear_stress_maximum: crate::solution::Estimate {
                    value: stress,
                    error: Some(error * stress),
                },
                beyond_first_limit: None,
                beyond_second_limit: None,
            };
            friction(&case(ratio), &traction, 1e9).map(|warning| warning.kind)
        };
        // Half of the figure or more is not resolved.
        let (wide, narrow) = (1.0, 0.1);
        for (ratio, stress, error, expected) in [
            (0.1, 0.099e9, wide, None),
            (0.1, 0.101e9, wide, Some(WarningKind::Friction)),
            (0.0, 0.099e9, wide, None),
            (0.0, 0.101e9, narrow, Some(WarningKind::RollingStress)),
            (0.0, 0.499e9, narrow, Some(WarningKind::RollingStress)),
            (0.0, 0.501e9, narrow, Some(WarningKind::Friction)),
            (0.0, 12e9, narrow, Some(WarningKind::Friction)),
            (0.0, 12e9, wide, Some(WarningKind::RollingStress)),
        ] {
            assert_eq!(
                kind(ratio, stress, error),
                expected,
                "{ratio} {stress} {error}"
            );
        }
    }

    /// Flash temperature of a uniform band on a fast half-space: the mean rise is 0.5319230 (Q/b)/(e √(u/b)) (computed by quadrature); two
    /// bodies of one effusivity and speed halve it.
    #[test]
    fn flash_temperature() {
        let case = case(0.0);
        let power = 1e5;
        let b = case.hertz().half_width;
        let u = case.motion.body_1_speed();
        let steel = (46.0_f64 * 7850.0 * 470.0).sqrt();
        let expected = 0.5 * 0.531_923_040_5 * (power / b) / (steel * (u / b).sqrt());
        let found = heat::rise(&case, power, 0.0);
        approx::assert_relative_eq!(found.mean, expected, max_relative = 1e-4);
    }
}
