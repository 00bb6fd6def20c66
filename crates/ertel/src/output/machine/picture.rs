//! Loads and films around a bearing, along a path of contact, or over a cam revolution.

use ertel_machines::gear::PathLabel;
use ertel_plot::{
    Axis, Chart, Drawing, Look, Marker, PALETTE, Polar, Series, Side, polar_row, side_by_side,
};

use super::super::pictures::{Picture, film_unit};
use crate::case::{GearMechanics, MachineAxis, Mechanics, RINGS};
use crate::solution::{Figure, Solution};
use crate::study::MachineSolution;
use crate::words::{CELSIUS, force_unit, pressure_unit};

/// Every picture of a machine.
pub(in crate::output) fn machine_pictures(title: &str, machine: &MachineSolution) -> Vec<Picture> {
    let title = match machine.interruption() {
        Some(text) => format!("{title} ({text})"),
        None => title.to_owned(),
    };
    let drawing = match machine.machine.axis {
        MachineAxis::Around => Picture::new("around", around(&title, machine)),
        MachineAxis::LineOfAction | MachineAxis::CamAngle => {
            Picture::new("path", along(&title, machine))
        }
    };
    vec![drawing]
}

/// Angular separation of the two rings' points, relative to the element spacing: otherwise equal films would hide each other.
const RING_SEPARATION: f64 = 0.12;

/// Shifts the points of a ring slightly from the angle of their element.
fn offset(points: Vec<[f64; 2]>, side: usize, n_elements: usize) -> Vec<[f64; 2]> {
    let by = RING_SEPARATION * std::f64::consts::TAU / n_elements.max(1) as f64;
    let by = if side == 0 { -0.5 * by } else { 0.5 * by };
    (points.into_iter())
        .map(|[angle, value]| [angle + by, value])
        .collect()
}

fn ring(side: usize) -> String {
    format!("{} ring", RINGS[side])
}

/// A value of each contact of a side with its place, without unsolved contacts.
fn values(
    machine: &MachineSolution,
    side: usize,
    value: impl Fn(usize) -> Option<f64>,
) -> Vec<[f64; 2]> {
    let contacts = machine.machine.contacts.iter().enumerate();
    let of = contacts.filter(|(_, contact)| contact.side == side);
    of.filter_map(|(i, contact)| Some([contact.place, value(i)?]))
        .collect()
}

fn film(machine: &MachineSolution, contact: usize, figure: Figure) -> Option<f64> {
    let found = machine.solution(contact)?.figure(figure)?;
    found.resolved.then_some(found.value)
}

fn largest(of: &[Vec<[f64; 2]>]) -> f64 {
    of.iter().flatten().map(|p| p[1].abs()).fold(0.0, f64::max)
}

/// Loads, and central and minimum films, around a bearing.
fn around(title: &str, machine: &MachineSolution) -> Drawing {
    let whole = &machine.machine;
    let first: Vec<f64> = (whole.contacts.iter())
        .filter(|contact| contact.side == 0)
        .map(|contact| contact.place)
        .collect();
    let labels: Vec<(f64, String)> = (first.iter().enumerate())
        .map(|(i, angle)| (*angle, i.to_string()))
        .collect();
    let polar = |heading: &str, label: String, high: f64| Polar {
        title: title.to_owned(),
        heading: heading.to_owned(),
        // Margin for the points at the rim.
        radius: Axis::linear(&label, 0.0, 1.08 * high),
        series: Vec::new(),
        labels: labels.clone(),
    };
    let largest_load = whole
        .contacts
        .iter()
        .map(|contact| contact.load)
        .fold(0.0, f64::max);
    let (factor, unit) = force_unit(largest_load, whole.is_line);
    let load = |side| values(machine, side, |i| Some(factor * whole.contacts[i].load));
    let loads = [load(0), load(1)];
    let mut of_loads = polar(
        "Load of each element",
        format!("load ({unit})"),
        largest(&loads),
    );
    let looks = [Look::Dots, Look::Circles];
    for (side, points) in loads.into_iter().enumerate().rev() {
        let points = offset(points, side, first.len());
        of_loads.add(&ring(side), points, looks[side], PALETTE[side]);
    }
    let films: Vec<[Vec<[f64; 2]>; 2]> = [0, 1]
        .map(|side| {
            [Figure::FilmCentral, Figure::FilmMinimum]
                .map(|figure| values(machine, side, |i| film(machine, i, figure)))
        })
        .to_vec();
    let all: Vec<Vec<[f64; 2]>> = films.iter().flatten().cloned().collect();
    let (factor, unit) = film_unit(largest(&all));
    let high = factor * largest(&all);
    let mut of_films = polar("Film thickness", format!("*h* ({unit})"), high);
    for (side, [central, minimum]) in films.into_iter().enumerate().rev() {
        let scaled = |points: Vec<[f64; 2]>| -> Vec<[f64; 2]> {
            let scaled = points.into_iter().map(|[angle, h]| [angle, factor * h]);
            offset(scaled.collect(), side, first.len())
        };
        let label = |what: &str| format!("{what}, {}", ring(side));
        of_films.add(
            &label("central"),
            scaled(central),
            looks[side],
            PALETTE[side],
        );
        of_films.add(
            &label("minimum"),
            scaled(minimum),
            Look::Crosses,
            PALETTE[side],
        );
    }
    polar_row(title, &[of_loads, of_films])
}

/// Distance from B or D at which the loads on both sides are taken, relative to the path length.
const JUMP_STEP: f64 = 1e-6;
/// Smallest relative load difference that counts as a jump.
const JUMP: f64 = 1e-3;

/// The gears of a machine, if it is a pair of them.
fn gears(machine: &MachineSolution) -> Option<&GearMechanics> {
    match &machine.machine.mechanics {
        Mechanics::Gears(gears) => Some(gears),
        _ => None,
    }
}

/// Load jumps where tooth pairs engage or disengage, with the Hertz pressures before and behind: [place (m), pressure, pressure (Pa)].
fn jumps(gears: &GearMechanics) -> Vec<[f64; 3]> {
    let points = gears.pair.points;
    let step = JUMP_STEP * (points.e - points.a);
    let taken_over = [PathLabel::B, PathLabel::D];
    let at = |s: f64| (gears.pair.contact_at(&gears.operation, gears.sharing, s)).ok();
    let labelled = gears.path.iter().filter(|point| {
        let label = point.label;
        label.is_some_and(|label| taken_over.contains(&label))
    });
    let jump = |s: f64| {
        let (before, behind) = (at(s - step)?, at(s + step)?);
        let change = (behind.load_per_length / before.load_per_length).ln();
        (change.abs() > JUMP).then_some([s, before.hertz_pressure, behind.hertz_pressure])
    };
    labelled.filter_map(|point| jump(point.position)).collect()
}

/// Interrupts lines at load jumps, [place, pressure before, pressure behind]: a point there has the larger load, that of single contact.
fn interrupted(points: Vec<[f64; 2]>, jumps: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let mut shown: Vec<[f64; 2]> = Vec::with_capacity(points.len() + jumps.len());
    for point in points {
        if let Some(last) = shown.last().map(|last| last[0]) {
            let between = |[place, before, behind]: &[f64; 3]| match before < behind {
                true => point[0] == *place,
                false => last == *place,
            };
            if jumps.iter().any(between) {
                shown.push([point[0], f64::NAN]);
            }
        }
        shown.push(point);
    }
    shown
}

/// Points with the values on both sides of each jump: [place, value before, value behind].
fn with_both_sides(points: Vec<[f64; 2]>, jumps: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let mut shown = Vec::with_capacity(points.len() + jumps.len());
    for point in points {
        match jumps.iter().find(|jump| jump[0] == point[0]) {
            Some([place, before, behind]) => shown.extend([[*place, *before], [*place, *behind]]),
            None => shown.push(point),
        }
    }
    shown
}

/// Films, pressures, speeds and friction over the place.
fn along(title: &str, machine: &MachineSolution) -> Drawing {
    let whole = &machine.machine;
    let (scale, label) = match whole.axis {
        MachineAxis::LineOfAction => (1e3, "distance from the pitch point (mm)"),
        _ => (1f64.to_degrees(), "angle of the cam (deg)"),
    };
    let gears = gears(machine);
    let jumps = gears.map_or_else(Vec::new, jumps);
    let scaled = |points: Vec<[f64; 2]>, factor: f64| -> Vec<[f64; 2]> {
        points
            .into_iter()
            .map(|[x, y]| [scale * x, factor * y])
            .collect()
    };
    let shown = |points, factor| scaled(interrupted(points, &jumps), factor);
    let named = gears.into_iter().flat_map(|gears| &gears.path);
    let markers: Vec<Marker> = named
        .filter_map(|point| {
            Some(Marker {
                x: scale * point.position,
                label: point.label?.to_string(),
            })
        })
        .collect();
    let places: Vec<f64> = whole
        .contacts
        .iter()
        .map(|contact| scale * contact.place)
        .collect();
    let low = places.iter().copied().fold(f64::INFINITY, f64::min);
    let high = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let chart = |y: &str, series: Vec<(String, Vec<[f64; 2]>, Look)>| {
        let heights = series
            .iter()
            .flat_map(|(_, points, _)| points.iter().map(|p| p[1]));
        let axis = Axis::linear_around(y, heights.filter(|h| h.is_finite()).chain([0.0]));
        let mut chart = Chart::new(title, Axis::linear(label, low, high), axis);
        chart.markers.clone_from(&markers);
        chart.series = (series.into_iter().zip(PALETTE))
            .map(|((label, points, look), colour)| Series {
                label,
                points,
                look,
                colour: colour.into(),
                side: Side::Left,
            })
            .collect();
        chart
    };
    let of = |figure| values(machine, 0, |i| film(machine, i, figure));
    let films = [of(Figure::FilmCentral), of(Figure::FilmMinimum)];
    let (factor, unit) = film_unit(largest(&films));
    let [central, minimum] = films;
    let mut charts = vec![chart(
        &format!("Film thickness *h* ({unit})"),
        vec![
            ("central".into(), shown(central, factor), Look::LineAndDots),
            ("minimum".into(), shown(minimum, factor), Look::LineAndRings),
        ],
    )];
    let hertz = values(machine, 0, |i| Some(whole.contacts[i].hertz_pressure));
    let (factor, unit) = pressure_unit(largest(std::slice::from_ref(&hertz)));
    let label = format!("Hertz pressure *p*_{{h}} ({unit})");
    let hertz = with_both_sides(hertz, &jumps);
    charts.push(chart(
        &label,
        vec![(String::new(), scaled(hertz, factor), Look::LineAndDots)],
    ));
    let speeds = |value: fn(&crate::contact::Motion) -> f64| {
        values(machine, 0, |i| Some(value(&machine.of(i)?.case.motion)))
    };
    let names = match gears {
        Some(_) => ["wheel (body 1)", "pinion (body 2)"],
        None => ["body 1", "body 2"],
    };
    charts.push(chart(
        "Surface speeds (m/s)",
        vec![
            (
                names[0].into(),
                shown(speeds(|m| m.body_1_speed()), 1.0),
                Look::Line,
            ),
            (
                names[1].into(),
                shown(speeds(|m| m.body_2_speed()), 1.0),
                Look::Dashed,
            ),
        ],
    ));
    let friction = |value: fn(&Solution) -> Option<f64>| {
        values(machine, 0, |i| machine.solution(i).and_then(value))
    };
    let traction = friction(|s| Some(s.figure(Figure::TractionCoefficient)?.value));
    charts.push(chart(
        "Traction coefficient",
        vec![(String::new(), shown(traction, 1.0), Look::LineAndDots)],
    ));
    let hottest = friction(|s| Some(s.figure(Figure::FilmTemperatureMaximum)?.value - CELSIUS));
    if !hottest.is_empty() {
        charts.push(chart(
            "Hottest film (°C)",
            vec![(String::new(), shown(hottest, 1.0), Look::LineAndDots)],
        ));
    }
    // Two rows.
    side_by_side(title, &charts, charts.len().div_ceil(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The load jumps at 1 and 3: the line is interrupted before the first and behind the second, and the pressure has two values there.
    #[test]
    fn jumps_are_drawn_as_jumps() {
        let points: Vec<[f64; 2]> = (0..5).map(|i| [f64::from(i), 10.0]).collect();
        let jumps = [[1.0, 5.0, 10.0], [3.0, 10.0, 6.0]];
        let shown = interrupted(points.clone(), &jumps);
        let gaps: Vec<usize> = (0..shown.len()).filter(|i| shown[*i][1].is_nan()).collect();
        assert_eq!((shown.len(), gaps), (7, vec![1, 5]));
        let both = with_both_sides(points, &jumps);
        assert_eq!(both[1..3], [[1.0, 5.0], [1.0, 10.0]]);
        assert_eq!(both[4..6], [[3.0, 10.0], [3.0, 6.0]]);
    }

    /// For nine elements, 40° apart, the points of the rings are 2.4° to either side.
    #[test]
    fn points_of_both_rings_are_seen() {
        let at = |side| offset(vec![[1.0, 5.0]], side, 9)[0];
        let by = 2.4_f64.to_radians();
        for (side, expected) in [(0, 1.0 - by), (1, 1.0 + by)] {
            assert!((at(side)[0] - expected).abs() < 1e-12);
            assert_eq!(at(side)[1], 5.0);
        }
    }
}
