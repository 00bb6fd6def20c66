//! Figures of a pair of gears: pressures, friction and losses, temperatures, and safety.
//!
//! ```text
//!   P = (1/p_bt) ∫ (p/cos β_b) b ds               p: friction power per length of the solved contacts (W/m), over the path of contact
//!   p = µ w |u_2 − u_1| + f u_m                   sliding, and rolling friction of the films
//!   µ_m = ∫ µ w |u_2 − u_1| ds/∫ w |u_2 − u_1| ds
//!   Θ = Θ_M + max Θ_fl                            Θ_fl: of the solved flanks, without heat Blok's by µ(s)
//! ```
//!
//! µ and f are linear between the contacts that are solved, while loads and speeds are those of each place: they jump where a pair of teeth
//! takes over. The error between the contacts is bounded by the same sums over half of them.

mod roughness;
mod rubbing;
pub(super) mod safety;

use ertel_machines::gear::PathPoint;
use ertel_machines::gear::friction::schlenk;

use super::contacts::{each, figure_of, friction_of};
use super::curve::Curve;
use super::films::Films;
use super::rolling::rolling_coefficient;
use crate::case::{Case, GearMechanics, WholeMachine};
use crate::figures::Row;
use crate::figures::gears::{
    FILM_MINIMUM_POSITION, FRICTION_COEFFICIENT_MEAN, FRICTION_COEFFICIENT_SCHLENK, FRICTION_POWER,
    FRICTION_POWER_MODELS, FRICTION_POWER_SLIDING, HERTZ_PRESSURE_MAXIMUM_POSITION, LOSS_FACTOR,
    LOSS_FACTOR_OHLENDORF, MESH_EFFICIENCY, MESH_LOSS, OVERLAP_RATIO, TOTAL_CONTACT_RATIO,
    TRANSVERSE_CONTACT_RATIO,
};
use crate::figures::machine::{FRICTION_POWER_ROLLING, HERTZ_PRESSURE_MAXIMUM};
use crate::mark::{Mark, Marked, Marks};
use crate::point::{MachineSolution, PointSolution};
use crate::solution::{FULL_FROM, Figure, roughness_warning};
use crate::warning::Warning;
use crate::words::length;
use roughness::{RoughnessFrom, composite, roughness};
use rubbing::Rubbing;
use safety::Flanks;

/// The figures of a pair of gears.
pub(super) fn figures(
    case: &Case,
    gears: &GearMechanics,
    solved: &MachineSolution,
    films: &Films,
    warnings: &mut Vec<Warning>,
) -> Vec<Row> {
    let has_asperities = |point: &PointSolution| point.case.asperities.is_some();
    if !solved.contacts.iter().flatten().any(has_asperities) {
        warnings.extend(rough(gears, films));
    }
    let flanks = solved_flanks(case, gears, solved, films);
    rows(case, gears, loss(gears, solved).as_ref(), &flanks)
}

/// Those that need no solved contact, with films by formulas and the mean friction after Schlenk.
pub(super) fn estimate(
    case: &Case,
    machine: &WholeMachine,
    gears: &GearMechanics,
    films: &Films,
) -> Vec<Row> {
    let flanks = estimated_flanks(case, machine, gears, films);
    rows(case, gears, None, &flanks)
}

/// The flanks as they are solved.
pub(super) fn solved_flanks<'a>(
    case: &Case,
    gears: &GearMechanics,
    solved: &MachineSolution,
    films: &'a Films,
) -> Flanks<'a> {
    let path = gears.path.iter().enumerate();
    Flanks {
        films,
        friction: each(solved, |point| traction(gears, point)),
        rubbing: path
            .map(|(i, at)| rubbing(gears, at, solved.of(i)?))
            .collect(),
        hottest: (case.heat().ok().flatten())
            .map(|_| each(solved, |point| hotter_flank(gears, point))),
    }
}

/// The flanks by films of formulas and the mean coefficient of friction after Schlenk, for every contact that could be solved.
pub(super) fn estimated_flanks<'a>(
    case: &Case,
    machine: &WholeMachine,
    gears: &GearMechanics,
    films: &'a Films,
) -> Flanks<'a> {
    let mean = schlenk_coefficient(case, gears).map(|(friction, _)| Marked::exact(friction));
    let contacts = machine.contacts.iter();
    Flanks {
        films,
        friction: contacts.map(|contact| contact.like.and(mean)).collect(),
        rubbing: Vec::new(),
        hottest: None,
    }
}

/// The figures by the losses of the solved contacts, if they are, and by films and friction of the flanks.
fn rows(case: &Case, gears: &GearMechanics, loss: Option<&Loss>, flanks: &Flanks<'_>) -> Vec<Row> {
    let mut figures = mechanics(gears);
    figures.extend(thinnest(gears, flanks.films));
    figures.extend(friction(case, gears, loss));
    figures.extend(safety::temperatures(case, gears, flanks));
    figures.extend(safety::specific_film(case, gears, flanks.films));
    figures
}

/// Contact ratios and the largest pressure.
fn mechanics(gears: &GearMechanics) -> Vec<Row> {
    let pair = &gears.pair;
    let mut figures = vec![TRANSVERSE_CONTACT_RATIO.row(pair.contact_ratio, "")];
    if pair.overlap_ratio > 0.0 {
        let total = pair.contact_ratio + pair.overlap_ratio;
        figures.push(OVERLAP_RATIO.row(pair.overlap_ratio, ""));
        figures.push(TOTAL_CONTACT_RATIO.row(total, ""));
    }
    let finite = gears.path.iter().filter(|p| p.hertz_pressure.is_finite());
    let highest = finite.max_by(|a, b| a.hertz_pressure.total_cmp(&b.hertz_pressure));
    if let Some(highest) = highest {
        figures.push(HERTZ_PRESSURE_MAXIMUM.row(highest.hertz_pressure, ""));
        figures.push(HERTZ_PRESSURE_MAXIMUM_POSITION.row(highest.position, ""));
    }
    figures
}

/// Where the film is thinnest.
fn thinnest(gears: &GearMechanics, films: &Films) -> Option<Row> {
    let i = films.thinnest()?;
    Some(FILM_MINIMUM_POSITION.row(gears.path[i].position, ""))
}

/// Warns where the smallest film does not separate flanks whose Ra is given.
fn rough(gears: &GearMechanics, films: &Films) -> Option<Warning> {
    let film = safety::thinnest_film(gears, films)?;
    let words = format!("the smallest film of the path, {},", length(film.value));
    let warning = roughness_warning(&words, film.value, composite(gears)?)?;
    let text = format!(
        "{warning}: friction, losses, flash temperature and safety against scuffing are those of the film alone, and asperities add to them (compare the \
         friction after Schlenk)"
    );
    Some(Warning { text, ..warning })
}

/// The coefficient of traction of a contact, and whether it is that of a film that does not separate the flanks.
fn traction(gears: &GearMechanics, point: &PointSolution) -> Option<Marked> {
    let film = figure_of(point, Figure::FilmMinimum)?.value;
    let is_alone = point.case.asperities.is_none()
        && composite(gears).is_some_and(|rough| film < FULL_FROM * rough);
    let found = friction_of(point)?;
    Some(found.with(Marks::when(is_alone, Mark::FilmAlone)))
}

/// Temperature of the hotter of both solved flanks, K, with the marks of its friction.
fn hotter_flank(gears: &GearMechanics, point: &PointSolution) -> Option<Marked> {
    let flanks = [
        Figure::TemperatureBody1Maximum,
        Figure::TemperatureBody2Maximum,
    ];
    let flanks = flanks
        .into_iter()
        .filter_map(|flank| figure_of(point, flank));
    let hotter = flanks.max_by(|a, b| a.value.total_cmp(&b.value))?;
    let marks = traction(gears, point).map_or(Marks::default(), |friction| friction.marks);
    Some(hotter.with(marks))
}

/// Friction of a contact at a point of the path.
///
/// f = (p − µ w |u_2 − u_1|)/u_m
fn rubbing(gears: &GearMechanics, at: &PathPoint, point: &PointSolution) -> Option<Rubbing> {
    let coefficient = traction(gears, point)?;
    let power = figure_of(point, Figure::FrictionPower)?;
    let sliding = at.load_per_length * at.sliding_speed.abs();
    let coefficient = coefficient.abs();
    let resistance = Marked {
        value: (power.value - coefficient.value * sliding) / at.entrainment_speed,
        error: (power.error.zip(coefficient.error)).map(|(power, mu)| {
            let both = (power + mu * sliding) / at.entrainment_speed;
            let own = rolling_coefficient(point).and_then(|f| Some(f.error? * at.load_per_length));
            own.map_or(both, |own| both.min(own))
        }),
        marks: Marks::default(),
    };
    let total_bar = Marked {
        value: 0.0,
        ..power / at.entrainment_speed
    };
    Some(Rubbing {
        coefficient,
        resistance,
        total_bar,
    })
}

/// Losses of the mesh, from the solved contacts and from separate models.
fn friction(case: &Case, gears: &GearMechanics, loss: Option<&Loss>) -> Vec<Row> {
    let mut figures = Vec::new();
    if let Some(loss) = loss {
        let share = loss.total / gears.operation.power();
        figures.extend([
            FRICTION_COEFFICIENT_MEAN.row(
                loss.mean_friction,
                "over the path of contact, by load and sliding speed",
            ),
            FRICTION_POWER_SLIDING.row(loss.sliding, ""),
            FRICTION_POWER_ROLLING.row(
                loss.rolling,
                "rolling: resistance of the films to rolling, at both walls",
            ),
            FRICTION_POWER.row(
                loss.total,
                "without bearings, seals and churning of the oil",
            ),
            MESH_LOSS.row(share, ""),
            MESH_EFFICIENCY.row(efficiency(share), ""),
        ]);
    }
    let factor = (gears.pair).loss(&gears.operation, gears.sharing, |_| 1.0);
    if let Ok(of) = factor {
        figures.push(LOSS_FACTOR.row(of.loss_factor, "H_V: Wimmer 2006"));
    }
    let ohlendorf = gears.pair.ohlendorf_loss_factor();
    figures.push(LOSS_FACTOR_OHLENDORF.row(ohlendorf, "Ohlendorf 1958, for even load sharing"));
    if let Some((model, source)) = schlenk_coefficient(case, gears) {
        figures.push(FRICTION_COEFFICIENT_SCHLENK.row(
            model,
            match (gears.limits.oil_factor, source) {
                (Some(_), RoughnessFrom::Gears) => {
                    "Schlenk 1994, a fit to tests, with w = F_bt/b, from the Ra and the oil factor X_L given"
                }
                (None, RoughnessFrom::Gears) => {
                    "Schlenk 1994, a fit to tests, with w = F_bt/b, from the Ra given and the oil factor X_L = 1 of mineral oils"
                }
                (Some(_), RoughnessFrom::Composite) => {
                    "Schlenk 1994, a fit to tests, with w = F_bt/b, for equal surfaces: Ra = σ/(1.25 √2), and the oil factor X_L given"
                }
                (None, RoughnessFrom::Composite) => {
                    "Schlenk 1994, a fit to tests, with w = F_bt/b, for equal surfaces: Ra = σ/(1.25 √2), and the oil factor X_L = 1 of mineral oils"
                }
            },
        ));
        let power = gears.operation.power() * ohlendorf * model;
        figures.push(FRICTION_POWER_MODELS.row(power, ""));
    }
    figures
}

/// Efficiency by the loss over the power at the pinion, which cannot exceed that power.
fn efficiency(loss: Marked) -> Marked {
    let is_beyond = !loss.is_resolved() || loss.value > 1.0;
    (loss.map(|loss| 1.0 - loss)).with(Marks::when(is_beyond, Mark::Unresolved))
}

/// Losses from the solved contacts.
struct Loss {
    sliding: Marked,
    rolling: Marked,
    total: Marked,
    mean_friction: Marked,
}

/// Losses where all contacts are solved; bars of contacts solved by one method add, plus the effect of the distance of the contacts.
fn loss(gears: &GearMechanics, solved: &MachineSolution) -> Option<Loss> {
    let mut coefficient = Vec::new();
    let mut resistance = Vec::new();
    let mut total = Vec::new();
    for (i, at) in gears.path.iter().enumerate() {
        if solved.machine.contacts[i].like.is_none() {
            continue;
        }
        let rubbing = rubbing(gears, at, solved.of(i)?)?;
        coefficient.push((at.position, rubbing.coefficient));
        resistance.push((at.position, rubbing.resistance));
        total.push((at.position, rubbing.total_bar));
    }
    let (coefficient, resistance) = (Curve::new(coefficient)?, Curve::new(resistance)?);
    let total = Curve::new(total)?;
    let sum =
        |of: &dyn Fn(&PathPoint) -> f64| gears.pair.loss(&gears.operation, gears.sharing, of).ok();
    let sliding = sum(&|p| coefficient.at(p.position))?;
    let sliding_bar = sum(&|p| coefficient.bar_at(p.position))?.power;
    // The sum is over µ w |u_2 − u_1|: the rolling part is divided by it.
    let per_slide = |p: &PathPoint, value: f64| {
        let slide = p.load_per_length * p.sliding_speed.abs();
        match slide > 0.0 {
            true => value * p.entrainment_speed / slide,
            false => 0.0,
        }
    };
    let rolling = sum(&|p| per_slide(p, resistance.at(p.position)))?.power;
    let rolling_bar = sum(&|p| per_slide(p, resistance.bar_at(p.position)))?.power;
    let total_bar = sum(&|p| per_slide(p, total.bar_at(p.position)))?.power;
    let coarse = coefficient.halves().zip(resistance.halves());
    let powers = |(coefficient, resistance): (&Curve, &Curve)| {
        let sliding = sum(&|p| coefficient.at(p.position))?.power;
        let rolling = sum(&|p| per_slide(p, resistance.at(p.position)))?.power;
        Some([sliding, rolling])
    };
    let own = [sliding.power, rolling];
    // Between the contacts that are solved, friction is not linear: the sum over half of them shows by how much.
    let spacing = match &coarse {
        None => None,
        Some((coefficients, resistances)) => {
            let halves = coefficients.iter().zip(resistances).map(powers);
            let halves: Vec<[f64; 2]> = halves.collect::<Option<_>>()?;
            let off = |of: &dyn Fn([f64; 2]) -> f64| {
                let all = halves.iter().map(|half| (of(*half) - of(own)).abs());
                all.fold(0.0, f64::max)
            };
            Some([off(&|p| p[0]), off(&|p| p[1]), off(&|p| p[0] + p[1])])
        }
    };
    let bar = |has_bars: bool, value: f64, part: usize| {
        let spacing = spacing.filter(|_| has_bars)?;
        Some(value + spacing[part])
    };
    let at_friction_1 = sliding.loss_factor * gears.operation.power();
    let sliding_bar = bar(coefficient.has_bars(), sliding_bar, 0);
    let marks = coefficient.marks();
    Some(Loss {
        sliding: Marked {
            value: sliding.power,
            error: sliding_bar,
            marks,
        },
        rolling: Marked {
            value: rolling,
            error: bar(resistance.has_bars(), rolling_bar, 1),
            marks: resistance.marks(),
        },
        total: Marked {
            value: sliding.power + rolling,
            error: bar(total.has_bars(), total_bar, 2),
            marks,
        },
        mean_friction: Marked {
            value: sliding.mean_friction,
            error: sliding_bar.map(|bar| bar / at_friction_1),
            marks,
        },
    })
}

/// [`schlenk`] at the temperature of the oil, and where its roughness comes from; `None` without a roughness.
fn schlenk_coefficient(case: &Case, gears: &GearMechanics) -> Option<(f64, RoughnessFrom)> {
    let ([one, two], source) = roughness(case, gears)?;
    let (pair, operation) = (&gears.pair, &gears.operation);
    let [pinion, wheel] = operation.surface_speeds(pair, 0.0);
    let lubricant = &case.lubricant;
    let coefficient = schlenk(
        operation.base_force(pair) / pair.face_width,
        pinion + wheel,
        pair.reduced_radius(0.0) * pair.base_helix_angle.cos(),
        (lubricant.viscosity).viscosity(0.0, lubricant.oil_temperature()),
        0.5 * (one + two),
        gears.limits.oil_factor.unwrap_or(1.0),
    );
    Some((coefficient, source))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use approx::assert_relative_eq;

    use super::*;
    use crate::case::Mechanics;

    /// By hand for 20 and 40 teeth, m_n = 4 mm, β = 15°: F_bt = 6451.40 N over b = 50 mm, v_ΣC = 4.58731 m/s, ρ_C = 9.73457 mm; with 17 mPa·s and Ra = 0.4 µm Schlenk's
    /// friction is 0.048 (129.028/(4.58731 · 9.73457))^0.2 17^−0.05 0.4^0.25 = 0.04096.
    #[test]
    fn schlenk_of_helical_teeth() {
        let text = r#"
[machine]
kind = "helical-gear"
normal_module = "4 mm"
pinion_teeth = 20
wheel_teeth = 40
normal_pressure_angle = "20 deg"
helix_angle = "15 deg"
face_width = "50 mm"
pinion_torque = "250 N.m"
pinion_speed = "1500 rpm"
position = "path"
bulk_temperature = "90 degC"
pinion_ra = "0.4 um"
wheel_ra = "0.4 um"
[bodies]
body_1 = "steel"
body_2 = "steel"
[lubricant]
temperature = "70 degC"
density = { law = "constant", rho_0 = "870 kg/m^3" }
viscosity = { law = "roelands", mu_0 = "17 mPa.s", alpha = "20 1/GPa", beta = "0.04 1/K", reference_temperature = "70 degC" }
"#;
        let case = Case::from_text("gears.toml", text, Path::new("")).unwrap();
        let Mechanics::Gears(gears) = &case.whole.as_ref().unwrap().mechanics else {
            panic!("gears")
        };
        // Of the oil, and not of the teeth.
        let (found, _) = schlenk_coefficient(&case, gears).unwrap();
        assert_relative_eq!(found, 0.040_963, max_relative = 1e-4);
    }
}
