//! Closed forms of a whole machine, and the figures that need more.

use std::sync::Arc;

use crate::case::{BearingMechanics, Case, GearMechanics, Mechanics, WholeMachine};
use crate::figures::{Definition, Row, bearing, cam, find, gears, machine};
use crate::mark::Marked;
use crate::point::MachineFigures;

/// A whole machine by closed forms and film formulas.
#[derive(Clone, Debug)]
pub struct MachineEstimate {
    /// The machine.
    pub machine: Arc<WholeMachine>,
    /// The figures that need no solved film, and those that a formula's film gives.
    pub figures: MachineFigures,
    /// Figures that are not estimated, each with what it needs.
    pub absent: Vec<(Definition, &'static str)>,
    /// Central and minimum film of each contact, m; `None` where no formula holds.
    pub films: [Vec<Option<Marked>>; 2],
}

/// The need of figures that follow from solved films alone.
const SOLVE: &str = "needs a solve";

/// The figures of a machine that its estimate lacks, with what each of them needs.
pub(super) fn absent(
    case: &Case,
    mechanics: &Mechanics,
    all: &[Row],
) -> Vec<(Definition, &'static str)> {
    let of_machine = match mechanics {
        Mechanics::Bearing(mechanics) => of_bearing(mechanics),
        Mechanics::Gears(mechanics) => of_gears(mechanics, all),
        Mechanics::Cam(_) => vec![(cam::FRICTION_POWER, SOLVE), (cam::FRICTION_TORQUE, SOLVE)],
    };
    let mut of_films = vec![
        (machine::FILM_CENTRAL, SOLVE),
        (machine::FILM_MINIMUM, SOLVE),
    ];
    if case.asperities.is_some() {
        of_films.push((machine::ASPERITY_LOAD_SHARE_MAXIMUM, SOLVE));
    }
    let lacks = |(figure, _): &(Definition, &str)| find(all, figure.name).is_none();
    (of_films.into_iter().chain(of_machine))
        .filter(lacks)
        .collect()
}

fn of_bearing(mechanics: &BearingMechanics) -> Vec<(Definition, &'static str)> {
    let mut figures = vec![
        (bearing::FRICTION_POWER, SOLVE),
        (bearing::FRICTION_TORQUE, SOLVE),
    ];
    if mechanics.life.cooling.is_some() {
        figures.push((bearing::BEARING_TEMPERATURE, SOLVE));
    }
    if mechanics.life.contamination.is_none() {
        let cleanliness = "give `cleanliness` or `contamination_factor`";
        figures.push((bearing::LIFE_FACTOR, cleanliness));
        figures.push((bearing::MODIFIED_RATING_LIFE, cleanliness));
    }
    figures
}

fn of_gears(mechanics: &GearMechanics, all: &[Row]) -> Vec<(Definition, &'static str)> {
    let has = |figure: Definition| find(all, figure.name).is_some();
    let limits = &mechanics.limits;
    let rough = "give `pinion_ra` and `wheel_ra`";
    let heat = match has(gears::FRICTION_COEFFICIENT_SCHLENK) {
        true => "give the thermal data of both bodies",
        false => rough,
    };
    let film = match has(gears::FRICTION_COEFFICIENT_SCHLENK) {
        true => SOLVE,
        false => rough,
    };
    vec![
        (gears::FRICTION_COEFFICIENT_MEAN, SOLVE),
        (gears::FRICTION_POWER, SOLVE),
        (gears::MESH_LOSS, SOLVE),
        (gears::MESH_EFFICIENCY, SOLVE),
        (gears::FRICTION_COEFFICIENT_SCHLENK, rough),
        (gears::FLASH_TEMPERATURE, heat),
        (gears::CONTACT_TEMPERATURE, heat),
        (
            gears::SCUFFING_SAFETY,
            match (limits.scuffing_temperature, has(gears::FLASH_TEMPERATURE)) {
                (None, _) => "give `scuffing_temperature`",
                (Some(_), false) => heat,
                (Some(_), true) => {
                    "the oil must be colder than the teeth and than `scuffing_temperature`"
                }
            },
        ),
        (gears::SPECIFIC_FILM_MINIMUM, film),
        (
            gears::MICROPITTING_SAFETY,
            match limits.permissible_lambda {
                Some(_) => film,
                None => "give `permissible_lambda`",
            },
        ),
    ]
}
