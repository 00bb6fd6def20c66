//! Load, radius and speeds of a machine's contact over time: a pair of teeth along its path of contact, a cam over a turn.
//!
//! ```text
//!   teeth: t = (s − s_A)/(ω_1 r_b1)        cam: t = (θ − θ_0)/ω
//! ```
//! Loads, radii and speeds are those of the machine's points; between them they follow smooth curves without new extremum, so that a load that jumps does so within the distance of two
//! points. A passage begins and ends where the teeth bear [`LEAST_LOAD`] of their largest load.

use std::f64::consts::TAU;

use ertel_machines::cam::CamPoint;

use super::cam_turn::{self, CamMechanics};
use super::gears::GearMechanics;
use super::{Mechanics, WholeMachine};
use crate::transient::Course;
use crate::words::digits;

/// Load per length, reduced radius and speeds of body 1 and body 2 over time, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Passage {
    /// s.
    pub duration: f64,
    /// N/m.
    pub load: Course,
    /// m.
    pub radius: Course,
    /// m/s.
    pub speeds: [Course; 2],
}

/// Share of the largest load of teeth at which a passage begins and ends.
const LEAST_LOAD: f64 = 0.01;

/// A point: s, N/m, m, m/s, m/s.
type Row = [f64; 5];

impl WholeMachine {
    /// Load, radius and speeds of its contact over time.
    ///
    /// # Errors
    /// Why there is none.
    pub fn passage(&self) -> Result<Passage, String> {
        match &self.mechanics {
            Mechanics::Bearing(_) => Err(
                "the loads of a bearing change slowly compared with the transit time of the oil: choose one of its contacts in [machine]".to_owned(),
            ),
            Mechanics::Gears(gears) => of_teeth(gears),
            Mechanics::Cam(cam) => of_cam(cam),
        }
    }
}

fn of_teeth(gears: &GearMechanics) -> Result<Passage, String> {
    let speed = gears.operation.base_speed(&gears.pair);
    let rows: Vec<Row> = (gears.path.iter())
        .map(|point| {
            let time = point.position / speed;
            [
                time,
                point.load_per_length,
                point.reduced_radius,
                point.u_1,
                point.u_2,
            ]
        })
        .collect();
    let largest = rows.iter().fold(0.0_f64, |m, row| m.max(row[1]));
    let bears = |row: &&Row| row[1] > LEAST_LOAD * largest;
    let first = rows.iter().position(|row| bears(&row));
    let last = rows.iter().rposition(|row| bears(&row));
    let (Some(first), Some(last)) = (first, last) else {
        return Err("no teeth bear a load".to_owned());
    };
    let within = &rows[first..=last];
    if let Some(row) = within.iter().find(|row| row[1] <= 0.0 || row[2] <= 0.0) {
        return Err(format!(
            "the teeth do not touch at s = {} mm within their passage",
            digits(1e3 * row[0] * speed, 4)
        ));
    }
    // Beyond the ends slopes continue.
    let beyond = |at: &Row, next: &Row| {
        let time = 2.0 * at[0] - next[0];
        let radius = gears.pair.reduced_radius(time * speed);
        [
            time,
            at[1],
            radius,
            2.0 * at[3] - next[3],
            2.0 * at[4] - next[4],
        ]
    };
    let n = within.len();
    if n < 2 {
        return Err("the path of contact has one point alone: raise `points`".to_owned());
    }
    let ends = [
        beyond(&within[0], &within[1]),
        beyond(&within[n - 1], &within[n - 2]),
    ];
    Ok(courses(within, ends))
}

fn of_cam(mechanics: &CamMechanics) -> Result<Passage, String> {
    let points = &mechanics.points;
    let bad = points.iter().find(|point| !cam_turn::is_contact(point));
    if let Some(point) = bad {
        let angle = digits(point.angle.to_degrees(), 4);
        return Err(match point.contact_lost {
            true => format!(
                "the follower leaves the cam at {angle} deg: its flight and impact are not computed"
            ),
            false => format!("radius or pressure at {angle} deg are outside those of Hertz theory"),
        });
    }
    let speed = mechanics.operation.speed.abs();
    // x points along the entrainment at the start.
    let sign = points[0].entrainment_speed.signum();
    let row = |point: &CamPoint, turns: f64| {
        let time = (point.angle - points[0].angle + TAU * turns) / speed;
        [
            time,
            point.load_per_length,
            point.reduced_radius,
            sign * point.u_1,
            sign * point.u_2,
        ]
    };
    let mut rows: Vec<Row> = points.iter().map(|point| row(point, 0.0)).collect();
    rows.push(row(&points[0], 1.0));
    let last = points.len() - 1;
    let ends = [row(&points[last], -1.0), row(&points[1], 1.0)];
    Ok(courses(&rows, ends))
}

/// Of points in order, with one before and one behind them, from the time of the first point on.
fn courses(rows: &[Row], [before, behind]: [Row; 2]) -> Passage {
    let start = rows[0][0];
    let of = |quantity: usize| {
        let all = std::iter::once(&before).chain(rows).chain([&behind]);
        Course::Smooth(all.map(|row| [row[0] - start, row[quantity]]).collect())
    };
    Passage {
        duration: rows[rows.len() - 1][0] - start,
        load: of(1),
        radius: of(2),
        speeds: [of(3), of(4)],
    }
}
