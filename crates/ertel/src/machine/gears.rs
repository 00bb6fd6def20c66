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

use ertel_machines::gear::friction::schlenk;
use ertel_machines::gear::safety::{micropitting, scuffing};
use ertel_machines::gear::{FlashMethod, PathPoint, ThermalBody};

use super::contacts::{self, figure_of, friction_of};
use super::curve::Curve;
use super::rolling::rolling_coefficient;
use crate::case::{Body, Case, GearMechanics};
use crate::figures::Row;
use crate::figures::gears::{
    BULK_TEMPERATURE, CONTACT_TEMPERATURE, CONTACT_TEMPERATURE_BLOK, FILM_MINIMUM_POSITION,
    FLASH_TEMPERATURE, FLASH_TEMPERATURE_BLOK, FLASH_TEMPERATURE_POSITION,
    FRICTION_COEFFICIENT_MEAN, FRICTION_COEFFICIENT_SCHLENK, FRICTION_POWER, FRICTION_POWER_MODELS,
    FRICTION_POWER_SLIDING, HERTZ_PRESSURE_MAXIMUM_POSITION, LOSS_FACTOR, LOSS_FACTOR_OHLENDORF,
    MESH_EFFICIENCY, MESH_LOSS, MICROPITTING_SAFETY, OVERLAP_RATIO, SCUFFING_SAFETY,
    SPECIFIC_FILM_MINIMUM, TOTAL_CONTACT_RATIO, TRANSVERSE_CONTACT_RATIO,
};
use crate::figures::machine::{FRICTION_POWER_ROLLING, HERTZ_PRESSURE_MAXIMUM};
use crate::mark::{Mark, Marked, Marks};
use crate::point::{MachineSolution, PointSolution};
use crate::solution::{FULL_FROM, Figure, limits, roughness_warning};
use crate::warning::Warning;
use crate::words::length;

/// σ over Ra of normally distributed heights, as quoted.
const RMS_OVER_RA: f64 = 1.25;

/// The figures of a pair of gears.
pub(super) fn figures(
    case: &Case,
    gears: &GearMechanics,
    solved: &MachineSolution,
    warnings: &mut Vec<Warning>,
) -> Vec<Row> {
    let mut figures = mechanics(gears);
    figures.extend(thinnest(gears, solved));
    warnings.extend(rough(gears, solved));
    figures.extend(friction(case, gears, solved));
    let hot = temperatures(case, gears, solved);
    figures.extend(hot);
    figures.extend(specific_film(case, gears, solved));
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
fn thinnest(gears: &GearMechanics, solved: &MachineSolution) -> Option<Row> {
    let i = contacts::thinnest(solved)?;
    Some(FILM_MINIMUM_POSITION.row(gears.path[i].position, ""))
}

/// Composite rms roughness of the flanks by their Ra, m.
fn composite(gears: &GearMechanics) -> Option<f64> {
    let [pinion, wheel] = gears.limits.roughness?;
    Some(RMS_OVER_RA * pinion.hypot(wheel))
}

/// The smallest film of the path; its bar allows for what lies between the contacts.
fn thinnest_film(gears: &GearMechanics, solved: &MachineSolution) -> Option<Marked> {
    let films = (gears.path.iter().enumerate())
        .filter_map(|(i, at)| Some((at.position, figure_of(solved.of(i)?, Figure::FilmMinimum)?)));
    Some(Curve::new(films.collect())?.smallest().1)
}

/// Warns where the smallest film does not separate flanks whose Ra is given.
fn rough(gears: &GearMechanics, solved: &MachineSolution) -> Option<Warning> {
    let film = thinnest_film(gears, solved)?;
    let words = format!("the smallest film of the path, {},", length(film.value));
    // Asperities that share the load are in all of these.
    let mut points = solved.contacts.iter().flatten();
    if points.any(|point| point.case.asperities.is_some()) {
        return None;
    }
    let warning = roughness_warning(&words, film.value, composite(gears)?)?;
    let text = format!(
        "{warning}: friction, losses, flash temperature and safety against scuffing are those of the film alone, and asperities add to them (compare the \
         friction after Schlenk)"
    );
    Some(Warning { text, ..warning })
}

/// The coefficient of traction of a contact, and whether it is that of a film that does not separate the flanks.
pub(super) fn traction(gears: &GearMechanics, point: &PointSolution) -> Option<Marked> {
    let film = figure_of(point, Figure::FilmMinimum)?.value;
    let is_alone = point.case.asperities.is_none()
        && composite(gears).is_some_and(|rough| film < FULL_FROM * rough);
    let found = friction_of(point)?;
    Some(found.with(Marks::when(is_alone, Mark::FilmAlone)))
}

/// A solved contact: its coefficient of traction, the resistance to rolling f per length, and the bar of the whole loss over u_m, N/m.
pub(super) struct Rubbing {
    pub(super) coefficient: Marked,
    resistance: Marked,
    total_bar: Marked,
}

impl Rubbing {
    /// Friction power per length (W/m) of this contact under the load of another: where a pair of teeth takes over, the load jumps, and µ and f do not.
    ///
    /// p = µ w |u_2 − u_1| + f u_m
    pub(super) fn power(&self, at: &PathPoint) -> Marked {
        let sliding = self.coefficient.value * at.load_per_length * at.sliding_speed.abs();
        Marked {
            value: sliding + self.resistance.value * at.entrainment_speed,
            error: self.total_bar.error.map(|bar| bar * at.entrainment_speed),
            marks: self.coefficient.marks,
        }
    }
}

/// Friction of a contact at a point of the path.
///
/// f = (p − µ w |u_2 − u_1|)/u_m
pub(super) fn rubbing(
    gears: &GearMechanics,
    at: &PathPoint,
    point: &PointSolution,
) -> Option<Rubbing> {
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
fn friction(case: &Case, gears: &GearMechanics, solved: &MachineSolution) -> Vec<Row> {
    let mut figures = Vec::new();
    if let Some(loss) = loss(gears, solved) {
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
            LOSS_FACTOR.row(loss.factor, "H_V: Wimmer 2006"),
        ]);
    }
    let ohlendorf = gears.pair.ohlendorf_loss_factor();
    figures.push(LOSS_FACTOR_OHLENDORF.row(ohlendorf, "Ohlendorf 1958, for even load sharing"));
    if let Some((roughness, source)) = roughness(case, gears) {
        let model = schlenk_coefficient(case, gears, 0.5 * (roughness[0] + roughness[1]));
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
    factor: f64,
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
        factor: sliding.loss_factor,
    })
}

/// Source of a roughness Ra.
#[derive(Clone, Copy)]
enum RoughnessFrom {
    /// The Ra of both gears.
    Gears,
    /// The composite roughness of the case.
    Composite,
}

/// Ra of the pinion and the wheel, m: as given, or for equal surfaces with the composite roughness σ, Ra = σ/(1.25 √2).
fn roughness(case: &Case, gears: &GearMechanics) -> Option<([f64; 2], RoughnessFrom)> {
    if let Some(own) = gears.limits.roughness {
        return Some((own, RoughnessFrom::Gears));
    }
    let ra = case.roughness? / (RMS_OVER_RA * std::f64::consts::SQRT_2);
    (ra > 0.0).then_some(([ra; 2], RoughnessFrom::Composite))
}

/// [`schlenk`] at the temperature of the oil.
fn schlenk_coefficient(case: &Case, gears: &GearMechanics, roughness: f64) -> f64 {
    let (pair, operation) = (&gears.pair, &gears.operation);
    let [pinion, wheel] = operation.surface_speeds(pair, 0.0);
    let lubricant = &case.lubricant;
    schlenk(
        operation.base_force(pair) / pair.face_width,
        pinion + wheel,
        pair.reduced_radius(0.0) * pair.base_helix_angle.cos(),
        (lubricant.viscosity).viscosity(0.0, lubricant.oil_temperature()),
        roughness,
        gears.limits.oil_factor.unwrap_or(1.0),
    )
}

/// Thermal constants of a body at a temperature (K), if all are known.
fn thermal_body(body: &Body, temperature: f64) -> Option<ThermalBody> {
    let conductivity = body.thermal_conductivity.as_ref()?;
    let heat_capacity = body.heat_capacity.as_ref()?;
    let density = body.density?;
    Some(ThermalBody {
        conductivity: conductivity.conductivity(0.0, temperature),
        density,
        heat_capacity: heat_capacity.heat_capacity(0.0, temperature),
    })
}

/// Temperature of the teeth, K, the hotter of both gears where `[thermal]` gives them other temperatures; and whether flanks are solved with heat.
pub(super) fn bulk(case: &Case, gears: &GearMechanics) -> (f64, bool) {
    match case.heat().ok().flatten() {
        Some(heat) => (heat.body_1.temperature.max(heat.body_2.temperature), true),
        None => {
            let given = gears.limits.bulk_temperature;
            (given.unwrap_or(case.lubricant.temperature), false)
        }
    }
}

/// Bulk, flash and contact temperatures, and safety against scuffing.
fn temperatures(case: &Case, gears: &GearMechanics, solved: &MachineSolution) -> Vec<Row> {
    let (bulk, has_heat) = bulk(case, gears);
    let of_films = match gears.limits.bulk_temperature {
        Some(_) => "films and specific films are those at the bulk temperature of the teeth",
        None => {
            "no `bulk_temperature` is given, so that of the lubricant is used: real teeth are hotter, and films thinner"
        }
    };
    let mut figures = vec![BULK_TEMPERATURE.row(bulk, of_films)];
    let blok = blok_rises(case, gears, solved, bulk);
    let of_flanks = has_heat.then(|| solved_rises(gears, solved, bulk));
    let is_solved = of_flanks.is_some();
    let rises = of_flanks.as_ref().unwrap_or(&blok);
    let Some((position, flash)) = hottest(rises) else {
        return figures;
    };
    const BLOK: &str = "flash temperature: Blok 1937, from the solved friction, at the smooth-surface pressure of Hertz";
    let source = match is_solved {
        true => "flash temperature: of the solved flanks, above the bulk temperature",
        false => BLOK,
    };
    figures.extend([
        FLASH_TEMPERATURE.row(flash, source),
        FLASH_TEMPERATURE_POSITION.row(position, ""),
        CONTACT_TEMPERATURE.row(
            contact(flash, bulk),
            "contact temperature: bulk temperature and flash temperature",
        ),
    ]);
    if let Some((_, flash)) = hottest(&blok).filter(|_| is_solved) {
        figures.extend([
            FLASH_TEMPERATURE_BLOK.row(flash, BLOK),
            CONTACT_TEMPERATURE_BLOK.row(contact(flash, bulk), ""),
        ]);
    }
    figures.extend(scuffing_safety(case, gears, rises, bulk));
    figures
}

/// The temperature of a flank that is warmer by a rise than the temperature `bulk` (K); not resolved where no oil would survive.
pub(super) fn contact(rise: Marked, bulk: f64) -> Marked {
    let hot = rise.above(bulk);
    let melts = hot.value > limits::TEMPERATURE;
    hot.with(Marks::when(melts, Mark::Unresolved))
}

/// Rises of temperature with the places of their contacts, m.
type Rises = Vec<(f64, Marked)>;

/// The largest of them, with its place.
fn hottest(rises: &Rises) -> Option<(f64, Marked)> {
    let (i, rise) = Curve::new(rises.clone())?.largest();
    Some((rises[i].0, rise))
}

/// Thermal constants of the pinion and the wheel at the temperature `bulk` (K), if all are known.
pub(super) fn teeth(case: &Case, bulk: f64) -> Option<[ThermalBody; 2]> {
    let [pinion, wheel] = [&case.body_2, &case.body_1].map(|body| thermal_body(body, bulk));
    Some([pinion?, wheel?])
}

/// Flash temperature after Blok at a place, of a coefficient of friction.
pub(super) fn blok_rise(at: &PathPoint, friction: Marked, teeth: [ThermalBody; 2]) -> Marked {
    let rise = |mu: f64| at.flash(mu, teeth, FlashMethod::AnySpeed).rise;
    Marked {
        value: rise(friction.value.abs()),
        error: friction.error.map(rise),
        ..friction
    }
}

/// Flash temperatures after Blok from the solved friction, of teeth at the temperature `bulk` (K); none where a body lacks its thermal data.
fn blok_rises(case: &Case, gears: &GearMechanics, solved: &MachineSolution, bulk: f64) -> Rises {
    let Some(teeth) = teeth(case, bulk) else {
        return Vec::new();
    };
    let of = |(i, point): (usize, &PathPoint)| {
        let friction = traction(gears, solved.of(i)?)?;
        Some((point.position, blok_rise(point, friction, teeth)))
    };
    gears.path.iter().enumerate().filter_map(of).collect()
}

/// By how much the hotter of both solved flanks of a contact exceeds the temperature `bulk` (K).
pub(super) fn solved_rise(gears: &GearMechanics, own: &PointSolution, bulk: f64) -> Option<Marked> {
    let flanks = [
        Figure::TemperatureBody1Maximum,
        Figure::TemperatureBody2Maximum,
    ];
    let flanks = flanks.into_iter().filter_map(|flank| figure_of(own, flank));
    let hotter = flanks.max_by(|a, b| a.value.total_cmp(&b.value))?;
    let marks = traction(gears, own).map_or(Marks::default(), |friction| friction.marks);
    Some(Marked {
        value: (hotter.value - bulk).max(0.0),
        ..hotter.with(marks)
    })
}

/// The same at all contacts.
fn solved_rises(gears: &GearMechanics, solved: &MachineSolution, bulk: f64) -> Rises {
    let of = |(i, point): (usize, &PathPoint)| {
        Some((point.position, solved_rise(gears, solved.of(i)?, bulk)?))
    };
    gears.path.iter().enumerate().filter_map(of).collect()
}

/// S_B where the file gives the scuffing temperature; without heat, or an oil as hot as the limit, there is no safety to give.
fn scuffing_safety(case: &Case, gears: &GearMechanics, rises: &Rises, bulk: f64) -> Option<Row> {
    let limit = gears.limits.scuffing_temperature?;
    let oil = case.lubricant.oil_temperature();
    let (_, flash) = hottest(rises)?;
    let safety = |flash: f64| scuffing(&[flash.max(0.0)], bulk, oil, limit).map(|s| s.safety);
    let nominal = safety(flash.value).ok()?;
    Some(SCUFFING_SAFETY.row(
        flash.map(|flash| safety(flash).unwrap_or(nominal)),
        "S_B = (Θ_S − Θ_oil)/(Θ_B,max − Θ_oil): ISO/TS 6336-20",
    ))
}

/// λ_GF and S_λ of a film (m), the roughness Ra of both gears (m) and the permissible specific film.
fn specific(film: Marked, roughness: [f64; 2], permissible: f64) -> Option<[Marked; 2]> {
    let found = micropitting(&[film.value], roughness, permissible).ok()?;
    Some([found.specific_film, found.safety].map(|value| film * (value / film.value)))
}

/// λ_GF of a contact, where its roughness is known.
pub(super) fn specific_film_of(
    case: &Case,
    gears: &GearMechanics,
    point: &PointSolution,
) -> Option<Marked> {
    let (roughness, _) = roughness(case, gears)?;
    let film = figure_of(point, Figure::FilmMinimum)?;
    Some(specific(film, roughness, 1.0)?[0])
}

/// Specific film and safety against micropitting.
fn specific_film(case: &Case, gears: &GearMechanics, solved: &MachineSolution) -> Vec<Row> {
    let Some((roughness, source)) = roughness(case, gears) else {
        return Vec::new();
    };
    let Some(thinnest) = thinnest_film(gears, solved) else {
        return Vec::new();
    };
    let limit = gears.limits.permissible_lambda;
    let Some([film, safety]) = specific(thinnest, roughness, limit.unwrap_or(1.0)) else {
        return Vec::new();
    };
    let mut figures = vec![SPECIFIC_FILM_MINIMUM.row(
        film,
        match source {
            RoughnessFrom::Gears => {
                "λ_GF = h/Ra, Ra = (Ra_1 + Ra_2)/2, of the smallest solved film: ISO/TS 6336-22"
            }
            RoughnessFrom::Composite => {
                "λ_GF = h/Ra of the smallest solved film: ISO/TS 6336-22; Ra = σ/(1.25 √2) for equal surfaces"
            }
        },
    )];
    if limit.is_some() {
        figures.push(MICROPITTING_SAFETY.row(safety, "S_λ = λ_GF/λ_GFP"));
    }
    figures
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
        let found = schlenk_coefficient(&case, gears, 0.4e-6);
        assert_relative_eq!(found, 0.040_963, max_relative = 1e-4);
    }
}
