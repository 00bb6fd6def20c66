//! Closed forms of a whole machine: the columns of its contacts, and the figures that need more.

use std::sync::Arc;

use super::contacts::Values;
use super::films::Films;
use crate::case::{BearingMechanics, CamMechanics, Case, GearMechanics, Mechanics, WholeMachine};
use crate::figures::{Definition, Row, bearing, cam, find, gears, machine};
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
    /// Quantities of the contacts.
    pub columns: Vec<ContactColumn>,
}

/// A quantity of every contact of a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactColumn {
    /// Name in results.
    pub name: &'static str,
    /// Head in reports; `None` where only documents have the column.
    pub head: Option<&'static str>,
    /// SI unit, empty of a pure number.
    pub unit: &'static str,
    /// The value of each contact, SI; `None` where it is not known.
    pub values: Vec<Option<f64>>,
}

/// Name, head and unit of a column.
type Title = (&'static str, Option<&'static str>, &'static str);

fn column((name, head, unit): Title, values: impl Iterator<Item = Option<f64>>) -> ContactColumn {
    ContactColumn {
        name,
        head,
        unit,
        values: values.collect(),
    }
}

/// Columns of the contacts of a bearing, in the order of its elements, the inner ring before the outer one.
pub(super) fn around(mechanics: &BearingMechanics) -> Vec<ContactColumn> {
    let of = || {
        mechanics
            .distribution
            .elements
            .iter()
            .flat_map(|e| &e.contacts)
    };
    vec![
        column(
            ("contact_angle", Some("angle"), "rad"),
            of().map(|contact| Some(contact.angle)),
        ),
        column(
            ("entrainment_speed", None, "m/s"),
            of().map(|contact| Some(contact.entrainment_speed)),
        ),
    ]
}

/// Columns of the contacts along a path, with their flash temperatures and specific films.
pub(super) fn along(
    mechanics: &GearMechanics,
    [flash, specific]: [Values; 2],
) -> Vec<ContactColumn> {
    let path = || mechanics.path.iter();
    let known = |values: Values| values.into_iter().map(|value| Some(value?.value));
    vec![
        column(
            ("load_share", Some("share"), ""),
            path().map(|at| Some(at.load_share)),
        ),
        column(
            ("sliding_speed", Some("sliding"), "m/s"),
            path().map(|at| Some(at.sliding_speed)),
        ),
        column(
            ("entrainment_speed", None, "m/s"),
            path().map(|at| Some(at.entrainment_speed)),
        ),
        column(("flash_temperature", Some("flash"), "K"), known(flash)),
        column(("specific_film", Some("λ_GF"), ""), known(specific)),
    ]
}

/// Columns of the contacts over a turn.
pub(super) fn over_turn(mechanics: &CamMechanics) -> Vec<ContactColumn> {
    let points = || mechanics.points.iter();
    vec![
        column(
            ("force", Some("force"), "N"),
            points().map(|at| Some(at.force)),
        ),
        column(
            ("pressure_angle", Some("angle φ"), "rad"),
            points().map(|at| Some(at.pressure_angle)),
        ),
        column(
            ("entrainment_speed", Some("u_m"), "m/s"),
            points().map(|at| Some(at.entrainment_speed)),
        ),
    ]
}

/// Columns of films.
pub(super) fn of_films(films: &Films) -> Vec<ContactColumn> {
    let known = |values: &Values| -> Vec<Option<f64>> {
        values.iter().map(|value| Some((*value)?.value)).collect()
    };
    vec![
        column(
            ("film_central", Some("h_c"), "m"),
            known(&films.central).into_iter(),
        ),
        column(
            ("film_minimum", Some("h_min"), "m"),
            known(&films.minimum).into_iter(),
        ),
    ]
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
