//! Temperatures of flanks, and safety against scuffing and micropitting.

use ertel_machines::gear::safety::{micropitting, scuffing};
use ertel_machines::gear::{PathPoint, ThermalBody};

use super::super::contacts::Values;
use super::super::curve::Curve;
use super::super::films::{By, Films};
use super::roughness::{RoughnessFrom, roughness};
use super::rubbing::Rubbing;
use crate::case::{Body, Case, GearMechanics};
use crate::figures::Row;
use crate::figures::gears::{
    BULK_TEMPERATURE, CONTACT_TEMPERATURE, CONTACT_TEMPERATURE_BLOK, FLASH_TEMPERATURE,
    FLASH_TEMPERATURE_BLOK, FLASH_TEMPERATURE_POSITION, MICROPITTING_SAFETY, SCUFFING_SAFETY,
    SPECIFIC_FILM_MINIMUM,
};
use crate::mark::{Mark, Marked, Marks};
use crate::solution::limits;

/// Values of the contacts of a path, in its order.
pub(in crate::machine) struct Flanks<'a> {
    /// Films.
    pub films: &'a Films,
    /// Coefficients of friction.
    pub friction: Values,
    /// Friction of the solved contacts; empty without a solution.
    pub rubbing: Vec<Option<Rubbing>>,
    /// Temperatures of the hotter flank, K, where they are solved with heat.
    pub hottest: Option<Values>,
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

/// Thermal constants of the pinion and the wheel at the temperature `bulk` (K), if all are known.
pub(in crate::machine) fn teeth(case: &Case, bulk: f64) -> Option<[ThermalBody; 2]> {
    let [pinion, wheel] = [&case.body_2, &case.body_1].map(|body| thermal_body(body, bulk));
    Some([pinion?, wheel?])
}

/// Bulk temperature of the teeth, K: the hotter of both gears where `[thermal]` gives them other temperatures.
pub(in crate::machine) fn bulk_temperature(case: &Case, gears: &GearMechanics) -> f64 {
    match case.heat().ok().flatten() {
        Some(heat) => heat.body_1.temperature.max(heat.body_2.temperature),
        None => (gears.limits.bulk_temperature).unwrap_or(case.lubricant.temperature),
    }
}

/// Bulk, flash and contact temperatures, and safety against scuffing.
pub(super) fn temperatures(case: &Case, gears: &GearMechanics, flanks: &Flanks<'_>) -> Vec<Row> {
    let bulk = bulk_temperature(case, gears);
    let of_films = match gears.limits.bulk_temperature {
        Some(_) => "films and specific films are those at the bulk temperature of the teeth",
        None => {
            "no `bulk_temperature` is given, so that of the lubricant is used: real teeth are hotter, and films thinner"
        }
    };
    let mut figures = vec![BULK_TEMPERATURE.row(bulk, of_films)];
    let blok = blok_rises(case, gears, &flanks.friction);
    let of_flanks = (flanks.hottest.as_ref()).map(|hottest| {
        let rise = |hotter: Marked| rise_above(hotter, bulk);
        hottest.iter().map(|hotter| hotter.map(rise)).collect()
    });
    let is_solved = of_flanks.is_some();
    let rises = of_flanks.as_ref().unwrap_or(&blok);
    let Some((position, flash)) = hottest(gears, rises) else {
        return figures;
    };
    let by_blok = match flanks.films.by {
        By::Solution => {
            "flash temperature: Blok 1937, from the solved friction, at the smooth-surface pressure of Hertz"
        }
        By::Formulas(_) => {
            "flash temperature: Blok 1937, from the mean friction after Schlenk, at the smooth-surface pressure of Hertz"
        }
    };
    let source = match is_solved {
        true => "flash temperature: of the solved flanks, above the bulk temperature",
        false => by_blok,
    };
    figures.extend([
        FLASH_TEMPERATURE.row(flash, source),
        FLASH_TEMPERATURE_POSITION.row(position, ""),
        CONTACT_TEMPERATURE.row(
            contact(flash, bulk),
            "contact temperature: bulk temperature and flash temperature",
        ),
    ]);
    if let Some((_, flash)) = hottest(gears, &blok).filter(|_| is_solved) {
        figures.extend([
            FLASH_TEMPERATURE_BLOK.row(flash, by_blok),
            CONTACT_TEMPERATURE_BLOK.row(contact(flash, bulk), ""),
        ]);
    }
    figures.extend(scuffing_safety(case, gears, rises, bulk));
    figures
}

/// The temperature of a flank that is warmer by a rise than the temperature `bulk` (K); not resolved where no oil would survive.
pub(in crate::machine) fn contact(rise: Marked, bulk: f64) -> Marked {
    let hot = rise.above(bulk);
    let melts = hot.value > limits::TEMPERATURE;
    hot.with(Marks::when(melts, Mark::Unresolved))
}

/// The largest rise of temperature, with its place, m.
fn hottest(gears: &GearMechanics, rises: &Values) -> Option<(f64, Marked)> {
    let rises = gears.path.iter().zip(rises);
    let rises = rises.filter_map(|(at, rise)| Some((at.position, (*rise)?)));
    let rises: Vec<(f64, Marked)> = rises.collect();
    let (i, rise) = Curve::new(rises.clone())?.largest();
    Some((rises[i].0, rise))
}

/// Flash temperature after Blok at a place, of a coefficient of friction.
pub(in crate::machine) fn blok_rise(
    at: &PathPoint,
    friction: Marked,
    teeth: [ThermalBody; 2],
) -> Marked {
    let rise = |mu: f64| at.flash(mu, teeth);
    Marked {
        value: rise(friction.value.abs()),
        error: friction.error.map(rise),
        ..friction
    }
}

/// Flash temperatures after Blok from the friction of the contacts, of teeth at their bulk temperature; none where a body lacks its thermal data.
pub(super) fn blok_rises(case: &Case, gears: &GearMechanics, friction: &Values) -> Values {
    let teeth = teeth(case, bulk_temperature(case, gears));
    let of = |(point, friction): (&PathPoint, &Option<Marked>)| {
        Some(blok_rise(point, (*friction)?, teeth?))
    };
    gears.path.iter().zip(friction).map(of).collect()
}

/// By how much the temperature of the hotter flank exceeds the temperature `bulk` (K).
pub(in crate::machine) fn rise_above(hotter: Marked, bulk: f64) -> Marked {
    Marked {
        value: (hotter.value - bulk).max(0.0),
        ..hotter
    }
}

/// S_B where the file gives the scuffing temperature; without heat, or an oil as hot as the limit, there is no safety to give.
fn scuffing_safety(case: &Case, gears: &GearMechanics, rises: &Values, bulk: f64) -> Option<Row> {
    let limit = gears.limits.scuffing_temperature?;
    let oil = case.lubricant.oil_temperature();
    let (_, flash) = hottest(gears, rises)?;
    let safety = |flash: f64| scuffing(&[flash.max(0.0)], bulk, oil, limit).map(|s| s.safety);
    let nominal = safety(flash.value).ok()?;
    Some(SCUFFING_SAFETY.row(
        flash.map(|flash| safety(flash).unwrap_or(nominal)),
        "S_B = (Θ_S − Θ_oil)/(Θ_B,max − Θ_oil): ISO/TS 6336-20",
    ))
}

/// The smallest film of the path; its bar allows for what lies between the contacts.
pub(super) fn thinnest_film(gears: &GearMechanics, films: &Films) -> Option<Marked> {
    let films = (gears.path.iter().zip(&films.minimum))
        .filter_map(|(at, film)| Some((at.position, (*film)?)));
    Some(Curve::new(films.collect())?.smallest().1)
}

/// λ_GF of a film, m, by the roughness Ra of both flanks; `None` without a roughness.
pub(in crate::machine) fn specific(
    case: &Case,
    gears: &GearMechanics,
    film: Marked,
) -> Option<Marked> {
    let (roughness, _) = roughness(case, gears)?;
    let found = micropitting(&[film.value], roughness, 1.0).ok()?;
    Some(film * (found.specific_film / film.value))
}

/// Smallest specific film and safety against micropitting.
pub(super) fn specific_film(case: &Case, gears: &GearMechanics, films: &Films) -> Vec<Row> {
    let Some((roughness, source)) = roughness(case, gears) else {
        return Vec::new();
    };
    let Some(thinnest) = thinnest_film(gears, films) else {
        return Vec::new();
    };
    let limit = gears.limits.permissible_lambda;
    let Ok(found) = micropitting(&[thinnest.value], roughness, limit.unwrap_or(1.0)) else {
        return Vec::new();
    };
    let scaled = |value: f64| thinnest * (value / thinnest.value);
    let mut figures = vec![SPECIFIC_FILM_MINIMUM.row(
        scaled(found.specific_film),
        match (source, films.by) {
            (RoughnessFrom::Gears, By::Solution) => {
                "λ_GF = h/Ra, Ra = (Ra_1 + Ra_2)/2, of the smallest solved film: ISO/TS 6336-22"
            }
            (RoughnessFrom::Composite, By::Solution) => {
                "λ_GF = h/Ra of the smallest solved film: ISO/TS 6336-22; Ra = σ/(1.25 √2) for equal surfaces"
            }
            (RoughnessFrom::Gears, By::Formulas(_)) => {
                "λ_GF = h/Ra, Ra = (Ra_1 + Ra_2)/2, of the smallest film by formula: ISO/TS 6336-22"
            }
            (RoughnessFrom::Composite, By::Formulas(_)) => {
                "λ_GF = h/Ra of the smallest film by formula: ISO/TS 6336-22; Ra = σ/(1.25 √2) for equal surfaces"
            }
        },
    )];
    if limit.is_some() {
        figures.push(MICROPITTING_SAFETY.row(scaled(found.safety), "S_λ = λ_GF/λ_GFP"));
    }
    figures
}
