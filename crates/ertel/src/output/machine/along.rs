//! Curves along a path of contact and over the turn of a cam.
//!
//! Where the load jumps, there are two places with one coordinate: a curve with both values is vertical there, one with a single value has a gap.

use ertel_plot::{Axis, Chart, Drawing, Look, Marker, PALETTE, Series, side_by_side};

use super::super::pictures::film_unit;
use super::values::{film, largest};
use crate::case::{MachineAxis, Mechanics};
use crate::contact::Motion;
use crate::figures::at_contacts::ContactFigures;
use crate::figures::{Definition, path};
use crate::mark::Mark;
use crate::solution::{Figure, Solution};
use crate::study::MachineSolution;
use crate::words::{CELSIUS, pressure_unit};

/// A curve: its label, its points, and how it is drawn.
type Curve = (&'static str, Vec<[f64; 2]>, Look);

/// The axis of all diagrams, and what they show.
struct Along<'a> {
    title: &'a str,
    machine: &'a MachineSolution,
    at_contacts: &'a ContactFigures,
    /// Coordinates per metre or radian.
    scale: f64,
    axis: Axis,
    /// A to E.
    markers: Vec<Marker>,
}

impl<'a> Along<'a> {
    fn new(
        title: &'a str,
        machine: &'a MachineSolution,
        at_contacts: &'a ContactFigures,
    ) -> Along<'a> {
        let (scale, label) = match machine.machine.axis {
            MachineAxis::LineOfAction => (1e3, "distance from the pitch point (mm)"),
            _ => (1f64.to_degrees(), "angle of the cam (deg)"),
        };
        let places = || at_contacts.places.iter();
        let low = places().map(|p| scale * p.at).fold(f64::INFINITY, f64::min);
        let high = places()
            .map(|p| scale * p.at)
            .fold(f64::NEG_INFINITY, f64::max);
        let named = places().filter(|place| place.beyond.is_none());
        let markers = named.filter_map(|place| {
            Some(Marker {
                x: scale * place.at,
                label: place.label.clone()?,
            })
        });
        Along {
            title,
            machine,
            at_contacts,
            scale,
            axis: Axis::linear(label, low, high),
            markers: markers.collect(),
        }
    }

    fn chart(&self, y: &str, curves: Vec<Curve>) -> Chart {
        let heights = curves.iter().flat_map(|(_, points, _)| points.iter());
        let heights = heights.map(|p| p[1]).filter(|h| h.is_finite());
        let axis = Axis::linear_around(y, heights.chain([0.0]));
        let mut chart = Chart::new(self.title, self.axis.clone(), axis);
        chart.markers.clone_from(&self.markers);
        chart.series = (curves.into_iter().zip(PALETTE))
            .map(|((label, points, look), colour)| Series::new(label, points, look, colour))
            .collect();
        chart
    }

    /// A value of each contact that has one; a gap at jumps of the load, beyond which it is not known.
    fn of_contacts(&self, value: impl Fn(usize) -> Option<f64>) -> Vec<[f64; 2]> {
        let places = self.at_contacts.places.iter();
        let point = places.filter_map(|place| {
            let value = match place.beyond {
                None => value(place.contact)?,
                Some(_) => f64::NAN,
            };
            Some([self.scale * place.at, value])
        });
        point.collect()
    }

    /// A figure of the places; a gap where it is not known beyond a jump of the load.
    fn figure(&self, figure: Definition, shown: impl Fn(f64) -> f64) -> Option<Vec<[f64; 2]>> {
        let places = self.at_contacts.places.iter();
        let values = places.zip(&self.at_contacts.find(figure)?.values);
        let point = values.filter_map(|(place, value)| {
            let known = value.filter(|value| !value.marks.has(Mark::Unresolved));
            let value = match known {
                Some(value) => shown(value.value),
                None => place.beyond.map(|_| f64::NAN)?,
            };
            Some([self.scale * place.at, value])
        });
        Some(point.collect())
    }
}

fn times(factor: f64, points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let points = points.into_iter();
    points.map(|[x, y]| [x, factor * y]).collect()
}

/// Films, pressures, speeds and friction over the place.
pub(super) fn along(
    title: &str,
    machine: &MachineSolution,
    at_contacts: &ContactFigures,
) -> Drawing {
    let along = Along::new(title, machine, at_contacts);
    let solved = |value: fn(&Solution) -> Option<f64>| {
        along.of_contacts(|i| machine.solution(i).and_then(value))
    };
    let mut charts = vec![films(&along), pressures(&along), speeds(&along)];
    let share = solved(|s| Some(s.figure(Figure::AsperityLoadShare)?.value));
    let traction = solved(|s| {
        let both = s.figure(Figure::FrictionTotal);
        Some(
            both.or_else(|| s.figure(Figure::TractionCoefficient))?
                .value,
        )
    });
    let is_known = |points: &[[f64; 2]]| points.iter().any(|p| p[1].is_finite());
    charts.push(along.chart(
        match is_known(&share) {
            true => "Friction coefficient",
            false => "Traction coefficient",
        },
        vec![("", traction, Look::LineAndDots)],
    ));
    if is_known(&share) {
        let share = times(100.0, share);
        charts.push(along.chart(
            "Load on asperities (%)",
            vec![("", share, Look::LineAndDots)],
        ));
    }
    let hottest = solved(|s| Some(s.figure(Figure::FilmTemperatureMaximum)?.value - CELSIUS));
    if is_known(&hottest) {
        charts.push(along.chart("Hottest film (°C)", vec![("", hottest, Look::LineAndDots)]));
    }
    // Two rows.
    side_by_side(title, &charts, charts.len().div_ceil(2))
}

fn films(along: &Along<'_>) -> Chart {
    let of = |figure| along.of_contacts(|i| film(along.machine, i, figure));
    let films = [of(Figure::FilmCentral), of(Figure::FilmMinimum)];
    let (factor, unit) = film_unit(largest(&films));
    let [central, minimum] = films.map(|film| times(factor, film));
    along.chart(
        &format!("Film thickness *h* ({unit})"),
        vec![
            ("central", central, Look::LineAndDots),
            ("minimum", minimum, Look::LineAndRings),
        ],
    )
}

fn pressures(along: &Along<'_>) -> Chart {
    let contacts = &along.machine.machine.contacts;
    let hertz = (along.figure(path::HERTZ_PRESSURE, |pressure| pressure))
        .unwrap_or_else(|| along.of_contacts(|i| Some(contacts[i].hertz_pressure)));
    let (factor, unit) = pressure_unit(largest(std::slice::from_ref(&hertz)));
    along.chart(
        &format!("Hertz pressure *p*_{{h}} ({unit})"),
        vec![("", times(factor, hertz), Look::LineAndDots)],
    )
}

fn speeds(along: &Along<'_>) -> Chart {
    // Speeds do not jump.
    let of = |value: fn(&Motion) -> f64| -> Vec<[f64; 2]> {
        let all = along.of_contacts(|i| Some(value(&along.machine.of(i)?.case.motion)));
        all.into_iter().filter(|p| p[1].is_finite()).collect()
    };
    let [wheel, pinion] = match along.machine.machine.mechanics {
        Mechanics::Gears(_) => ["wheel (body 1)", "pinion (body 2)"],
        _ => ["body 1", "body 2"],
    };
    along.chart(
        "Surface speeds (m/s)",
        vec![
            (wheel, of(Motion::body_1_speed), Look::Line),
            (pinion, of(Motion::body_2_speed), Look::Dashed),
        ],
    )
}

/// Load share, sliding, friction power, temperatures and specific film along a path of contact.
pub(super) fn flanks(
    title: &str,
    machine: &MachineSolution,
    at_contacts: &ContactFigures,
) -> Drawing {
    let along = Along::new(title, machine, at_contacts);
    let mut charts = Vec::new();
    let mut add =
        |label: &str, curves: &[(Definition, &'static str, Look)], shown: fn(f64) -> f64| {
            let curves = curves.iter();
            let curves: Vec<Curve> = curves
                .filter_map(|(figure, label, look)| {
                    Some((*label, along.figure(*figure, shown)?, *look))
                })
                .collect();
            if !curves.is_empty() {
                charts.push(along.chart(label, curves));
            }
        };
    let dots = Look::LineAndDots;
    add("Load share *X*", &[(path::LOAD_SHARE, "", dots)], |x| x);
    add(
        "Specific sliding *ζ*",
        &[
            (path::SPECIFIC_SLIDING_WHEEL, "wheel (body 1)", Look::Line),
            (
                path::SPECIFIC_SLIDING_PINION,
                "pinion (body 2)",
                Look::Dashed,
            ),
        ],
        |x| x,
    );
    add(
        "Friction power (W/mm)",
        &[(path::FRICTION_POWER, "", dots)],
        |p| 1e-3 * p,
    );
    let blok = (path::FLASH_TEMPERATURE_BLOK, "Blok", Look::Dashed);
    let solved = match at_contacts.find(path::FLASH_TEMPERATURE_BLOK) {
        Some(_) => "solved flanks",
        None => "",
    };
    add(
        "Flash temperature (K)",
        &[(path::FLASH_TEMPERATURE, solved, dots), blok],
        |x| x,
    );
    add(
        "Contact temperature (°C)",
        &[(path::CONTACT_TEMPERATURE, "", dots)],
        |kelvin| kelvin - CELSIUS,
    );
    add(
        "Specific film *λ*_{GF}",
        &[(path::SPECIFIC_FILM, "", dots)],
        |x| x,
    );
    // Two rows.
    side_by_side(title, &charts, charts.len().div_ceil(2))
}
