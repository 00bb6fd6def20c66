//! Internal geometry of a bearing: from its designation, of which every value can be replaced, or from dimensions.

use std::f64::consts::FRAC_PI_2;

use ertel_input::{Bounds, InputError, Table};
use ertel_machines::bearing::Geometry;
use ertel_machines::bearing::catalogue::{self, Entry, Internal, Origin, Series, Sourced, Special};
use ertel_machines::bearing::geometry::{BallGeometry, Play};
use ertel_quantity::Dimension;

use super::super::Rows;
use super::rollers;
use crate::case::contact::RADIUS;
use crate::words::{digits, length};

/// Clearances, m; negative where the elements are squeezed.
pub(super) const CLEARANCE: Bounds = Bounds::closed(-1e-3, 1e-2);
/// Free contact angles, rad.
pub(super) const ANGLE: Bounds = Bounds::closed(0.0, FRAC_PI_2);
/// Radius of a groove over the diameter of the ball.
const CURVATURE: Bounds = Bounds::open(0.5, f64::INFINITY);

/// Balls or rollers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::case::machine) enum Elements {
    /// Balls.
    Balls,
    /// Cylindrical rollers.
    Rollers,
    /// Tapered rollers.
    TaperedRollers,
}

impl Elements {
    /// Name of one of them.
    pub fn word(self) -> &'static str {
        match self {
            Elements::Balls => "ball",
            Elements::Rollers | Elements::TaperedRollers => "roller",
        }
    }

    /// The kind of machine that has them, and their type.
    fn names(self) -> [&'static str; 2] {
        match self {
            Elements::Balls => ["ball-bearing", "balls"],
            Elements::Rollers => ["roller-bearing", "cylindrical rollers"],
            Elements::TaperedRollers => ["roller-bearing", "tapered rollers"],
        }
    }

    /// Those of a bearing of the catalogue.
    fn of(entry: &Entry) -> Elements {
        match entry.internal {
            Internal::Ball(_) => Elements::Balls,
            Internal::Cylindrical { .. } => Elements::Rollers,
            Internal::Tapered { .. } => Elements::TaperedRollers,
        }
    }

    /// Those of a designation; `None` of unknown ones.
    pub fn of_designation(designation: &str) -> Option<Elements> {
        catalogue::find(designation)
            .ok()
            .map(|entry| Elements::of(&entry))
    }

    /// Rollers of a file: tapered ones by their designation or their contact angle.
    pub(super) fn of_rollers(table: &mut Table<'_>) -> Result<Elements, InputError> {
        let named = table.optional_str("designation")?;
        let is_tapered = named.and_then(Elements::of_designation) == Some(Elements::TaperedRollers);
        Ok(match is_tapered || table.contains("contact_angle") {
            true => Elements::TaperedRollers,
            false => Elements::Rollers,
        })
    }
}

/// Where load ratings come from that the file does not give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RatingBasis {
    /// C and C_0 of the catalogue, N: the internal geometry is estimated, and the file replaces no input of the ratings.
    Catalogue([f64; 2]),
    /// Dimensions of which some are estimated; relative error of C and C_0.
    Estimated(f64),
    /// Known dimensions.
    Geometry,
}

impl RatingBasis {
    /// From the origin of size and number of elements, and of the other dimensions that ratings need.
    pub(super) fn of(entry: Option<&Entry>, sizes: &[Origin], others: &[Origin]) -> RatingBasis {
        let is_estimated = sizes.iter().any(|how| matches!(how, Origin::Estimated(_)));
        let is_replaced = sizes.iter().chain(others).any(|how| *how == Origin::Given);
        match (entry, is_estimated) {
            (Some(entry), true) => match entry.ratings {
                Some(ratings) if !is_replaced => RatingBasis::Catalogue(ratings.value),
                _ => RatingBasis::Estimated(entry.designation.series.rating_spread()),
            },
            _ => RatingBasis::Geometry,
        }
    }
}

/// A bearing as the file describes it.
pub(super) struct Inside {
    /// Its geometry.
    pub geometry: Geometry,
    /// Where its load ratings come from.
    pub ratings: RatingBasis,
    /// Its catalogue entry, if it has a designation.
    pub entry: Option<Entry>,
    /// Rows of the report: values and their origins.
    pub rows: Vec<(String, String)>,
}

impl Inside {
    /// Its series, if it has a designation.
    pub fn series(&self) -> Option<Series> {
        self.entry.as_ref().map(|entry| entry.designation.series)
    }
}

/// Reads designation and dimensions.
pub(super) fn read(table: &mut Table<'_>, elements: Elements) -> Result<Inside, InputError> {
    let entry = match table.optional_str("designation")? {
        Some(given) => Some(find(table, given, elements)?),
        None => None,
    };
    let mut rows = Rows::default();
    if let Some(entry) = &entry {
        let boundary = &entry.boundary;
        let [d, outside, b] =
            [boundary.bore, boundary.outside, boundary.width].map(|v| digits(1e3 * v, 4));
        rows.text("bearing", entry.designation.name());
        rows.text(
            "bore, outside, width",
            match boundary.special {
                Special::Taper { width, .. } => {
                    let t = digits(1e3 * width, 4);
                    format!("{d}, {outside}, {b} mm, {t} mm with the cup (ISO 355)")
                }
                Special::None | Special::Raceways { .. } => {
                    format!("{d}, {outside}, {b} mm (ISO 15)")
                }
            },
        );
        let ignored = &entry.designation.ignored;
        if !ignored.is_empty() {
            rows.text("designs and suffixes without effect", ignored.join(", "));
        }
    }
    let entry_of = entry.as_ref();
    let (geometry, ratings) = match elements {
        Elements::Balls => {
            let (balls, ratings) = balls(table, entry_of, &mut rows)?;
            (Geometry::Ball(balls), ratings)
        }
        Elements::Rollers => {
            let (rollers, ratings) = rollers::read(table, entry_of, &mut rows)?;
            (Geometry::CylindricalRoller(rollers), ratings)
        }
        Elements::TaperedRollers => {
            let (rollers, ratings) = rollers::read_tapered(table, entry_of, &mut rows)?;
            (Geometry::TaperedRoller(rollers), ratings)
        }
    };
    geometry
        .check()
        .map_err(|error| table.error_here(error.to_string()))?;
    Ok(Inside {
        geometry,
        ratings,
        entry,
        rows: rows.0,
    })
}

/// The bearing of a designation, of the kind that the file says.
fn find(table: &Table<'_>, given: &str, elements: Elements) -> Result<Entry, InputError> {
    let entry = catalogue::find(given).map_err(|error| {
        let by_dimensions = "a bearing that is not in it is described by its dimensions";
        let help = match error.kind {
            Some(_) => "deep groove and angular contact ball bearings, cylindrical and tapered roller bearings of one row are covered".to_owned(),
            None => format!("the nearest ones are {}; {by_dimensions}", error.nearest.join(", ")),
        };
        table.error("designation", error.to_string()).with_help(help)
    })?;
    let own = Elements::of(&entry);
    if own == elements {
        return Ok(entry);
    }
    let [kind, names] = own.names();
    let error = table.error("designation", format!("{given} has {names}"));
    Err(match kind == elements.names()[0] {
        true => error.with_help("tapered rollers have a `contact_angle`, cylindrical ones none"),
        false => error.with_help(format!("use kind = \"{kind}\"")),
    })
}

/// A value with its origin, in words.
pub(super) fn with_origin(value: String, origin: Origin) -> String {
    match origin {
        Origin::Published(source) => format!("{value} (published: {source})"),
        Origin::Estimated(rule) => format!("{value} (estimated: {rule})"),
        Origin::Given => format!("{value} (given)"),
    }
}

/// A length of the file, or else that of the catalogue.
pub(super) fn length_or(
    table: &mut Table<'_>,
    key: &str,
    known: Option<Sourced<f64>>,
) -> Result<Sourced<f64>, InputError> {
    given_or(table, (key, Dimension::LENGTH, RADIUS), known)
}

/// A quantity of the file, or else that of the catalogue.
pub(super) fn given_or(
    table: &mut Table<'_>,
    (key, dimension, bounds): (&str, Dimension, Bounds),
    known: Option<Sourced<f64>>,
) -> Result<Sourced<f64>, InputError> {
    let given = table.optional_quantity(key, dimension, bounds)?;
    (given.map(Sourced::given).or(known)).ok_or_else(|| table.missing(key))
}

/// The number of elements, likewise.
pub(super) fn number_or(
    table: &mut Table<'_>,
    key: &str,
    known: Option<Sourced<usize>>,
) -> Result<Sourced<usize>, InputError> {
    match (table.contains(key), known) {
        (false, Some(known)) => Ok(known),
        _ => Ok(Sourced::given(
            table.required_integer(key, 3..=1000)? as usize
        )),
    }
}

fn balls(
    table: &mut Table<'_>,
    entry: Option<&Entry>,
    rows: &mut Rows,
) -> Result<(BallGeometry, RatingBasis), InputError> {
    let known = match entry.map(|entry| entry.internal) {
        Some(Internal::Ball(balls)) => Some(balls),
        _ => None,
    };
    let ball_diameter = length_or(table, "ball_diameter", known.map(|k| k.diameter))?;
    let pitch_diameter = length_or(table, "pitch_diameter", known.map(|k| k.pitch_diameter))?;
    let number = number_or(table, "balls", known.map(|k| k.number))?;
    let mut curvature = |k: usize, key: &str| -> Result<Sourced<f64>, InputError> {
        let known = known.map(|balls| Sourced {
            value: balls.groove.value[k],
            origin: balls.groove.origin,
        });
        match (table.optional_number(key, CURVATURE)?, known) {
            (Some(given), _) => Ok(Sourced::given(given)),
            (None, Some(known)) => Ok(known),
            (None, None) => Err(table
                .missing(key)
                .with_help("the radius of the groove over the diameter of the ball, such as 0.52")),
        }
    };
    let grooves = [
        curvature(0, "inner_groove_curvature")?,
        curvature(1, "outer_groove_curvature")?,
    ];
    let play = read_play(table, known.map(|k| k.play))?;
    rows.text(
        "ball diameter D",
        with_origin(length(ball_diameter.value), ball_diameter.origin),
    );
    rows.text(
        "pitch diameter d_m",
        with_origin(length(pitch_diameter.value), pitch_diameter.origin),
    );
    rows.text(
        "balls Z",
        with_origin(number.value.to_string(), number.origin),
    );
    for (name, f) in ["inner", "outer"].iter().zip(&grooves) {
        let name = format!("{name} groove radius over D");
        rows.text(&name, with_origin(digits(f.value, 4), f.origin));
    }
    let geometry = BallGeometry {
        ball_diameter: ball_diameter.value,
        pitch_diameter: pitch_diameter.value,
        number: number.value,
        groove: grooves.map(|f| f.value),
        play: play.value,
    };
    let clearance = format!("{} µm", digits(1e6 * geometry.clearance(), 4));
    let angle = format!("{} deg", digits(geometry.free_angle().to_degrees(), 4));
    let [of_clearance, of_angle] = match play.value {
        Play::Clearance(_) => [with_origin(clearance, play.origin), angle],
        Play::FreeAngle(_) => [
            format!("{clearance} (by the contact angle)"),
            with_origin(angle, play.origin),
        ],
    };
    rows.text("radial clearance", of_clearance);
    rows.text("contact angle without load", of_angle);
    let ratings = RatingBasis::of(
        entry,
        &[ball_diameter.origin, number.origin],
        &[pitch_diameter.origin, grooves[0].origin, grooves[1].origin],
    );
    Ok((geometry, ratings))
}

/// `radial_clearance` or `contact_angle`.
fn read_play(
    table: &mut Table<'_>,
    known: Option<Sourced<Play>>,
) -> Result<Sourced<Play>, InputError> {
    let angle = table.optional_quantity("contact_angle", Dimension::ANGLE, ANGLE)?;
    let clearance = table.optional_quantity("radial_clearance", Dimension::LENGTH, CLEARANCE)?;
    match (angle, clearance, known) {
        (Some(_), Some(_), _) => Err(table.error(
            "radial_clearance",
            "`contact_angle` and `radial_clearance` give the same quantity; keep one of them",
        )),
        (Some(angle), None, _) => Ok(Sourced::given(Play::FreeAngle(angle))),
        (None, Some(clearance), _) => Ok(Sourced::given(Play::Clearance(clearance))),
        (None, None, Some(known)) => Ok(known),
        (None, None, None) => Err(table.missing("radial_clearance").with_help(
            "the radial internal clearance, such as \"10 um\", or `contact_angle`, the contact angle without load",
        )),
    }
}
