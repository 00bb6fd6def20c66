//! The law of lift of a cam: an eccentric disc, lobes, a rise and a return, or a table.

use std::path::Path;

use ertel_input::csv::{CsvError, CsvTable, Wanted};
use ertel_input::file::{LARGEST_TABLE, read_text};
use ertel_input::{Bounds, InputError, Table};
use ertel_machines::cam::{CamError, LiftLaw, MotionLaw, ROWS, Segment};
use ertel_quantity::Dimension;

use super::TURN;
use crate::words::{digits, length};

/// Lifts, m.
const LIFT: Bounds = Bounds::above_to(0.0, 1e3);
/// Eccentricities, m; the angle is counted from the nose.
const ECCENTRICITY: Bounds = Bounds::above_to(0.0, 1e3);
/// Errors of a table, m.
const TOLERANCE: Bounds = Bounds::closed(0.0, 1e-2);
/// Angles of a part of a turn, rad.
const PART: Bounds = Bounds::open(0.0, TURN);
const DWELL: Bounds = Bounds::closed(0.0, TURN);

const LAWS: [(&str, MotionLaw); 4] = [
    ("3-4-5", MotionLaw::Polynomial345),
    ("4-5-6-7", MotionLaw::Polynomial4567),
    ("cycloidal", MotionLaw::Cycloidal),
    ("harmonic", MotionLaw::Harmonic),
];

/// A rise or a return.
struct Part {
    angle: f64,
    law: MotionLaw,
    name: &'static str,
}

/// Reads the law of lift, and its description.
pub(super) fn read(table: &mut Table<'_>, folder: &Path) -> Result<(LiftLaw, String), InputError> {
    let eccentricity = table.optional_quantity("eccentricity", Dimension::LENGTH, ECCENTRICITY)?;
    let lift = table.optional_quantity("lift", Dimension::LENGTH, LIFT)?;
    let lobes = table.optional_integer("lobes", 1..=1000)?;
    let rise = part(table, "rise")?;
    let dwell = table.optional_quantity("top_dwell", Dimension::ANGLE, DWELL)?;
    let back = part(table, "return")?;
    let file = table.optional_str("lift_table")?;
    let tolerance = table.optional_quantity("lift_tolerance", Dimension::LENGTH, TOLERANCE)?;
    let laws = [
        ("eccentricity", eccentricity.is_some()),
        ("lobes", lobes.is_some()),
        ("rise", rise.is_some()),
        ("lift_table", file.is_some()),
    ];
    let mut given = laws.iter().filter(|(_, is_given)| *is_given);
    let Some((law, _)) = given.next() else {
        return Err(table
            .error_here("the lift of the cam is missing")
            .with_help(
                "give `lift` with `rise` (and `top_dwell`, `return`) or with `lobes`; or `lift_table = \"cam.csv\"`; or `eccentricity`",
            ));
    };
    if let Some((other, _)) = given.next() {
        return Err(table.error(
            other,
            format!("`{law}` and `{other}` both define the lift of the cam; keep one of them"),
        ));
    }
    let law = *law;
    for (key, is_given, laws) in [
        ("lift", lift.is_some(), &["lobes", "rise"][..]),
        ("top_dwell", dwell.is_some(), &["rise"]),
        ("return", back.is_some(), &["rise"]),
        ("lift_tolerance", tolerance.is_some(), &["lift_table"]),
    ] {
        if is_given && !laws.contains(&law) {
            return Err(table.error(key, format!("a lift by `{law}` has no such key")));
        }
    }
    if let Some(eccentricity) = eccentricity {
        let words = format!("e cos θ, e = {}", length(eccentricity));
        return Ok((LiftLaw::Eccentric { eccentricity }, words));
    }
    if let Some(file) = file {
        return of_table(table, folder, file, tolerance);
    }
    let Some(lift) = lift else {
        return Err(table.missing("lift"));
    };
    if let Some(lobes) = lobes.and_then(|n| u32::try_from(n).ok()) {
        let words = format!("{} lobes of {}, harmonic", lobes, length(lift));
        return Ok((LiftLaw::Harmonic { lift, lobes }, words));
    }
    match rise {
        Some(rise) => of_parts(table, lift, &rise, dwell.unwrap_or(0.0), back),
        None => Err(table.missing("rise")),
    }
}

/// A rise or a return, if it is there.
fn part(table: &mut Table<'_>, key: &str) -> Result<Option<Part>, InputError> {
    let Some(mut keys) = table.optional_table(key)? else {
        return Ok(None);
    };
    let angle = keys.required_quantity("angle", Dimension::ANGLE, PART)?;
    let law = keys.required_choice("law", &LAWS)?;
    keys.finish()?;
    let name = LAWS.iter().find(|(_, other)| *other == law);
    Ok(Some(Part {
        angle,
        law,
        name: name.map_or("", |(name, _)| name),
    }))
}

/// A rise from θ = 0 on, a dwell on top (rad), the return, and the rest of the turn on the base circle.
fn of_parts(
    table: &Table<'_>,
    lift: f64,
    rise: &Part,
    dwell: f64,
    back: Option<Part>,
) -> Result<(LiftLaw, String), InputError> {
    let (angle, law, name) = match &back {
        Some(back) => (back.angle, back.law, back.name),
        None => (rise.angle, rise.law, rise.name),
    };
    let rest = TURN - rise.angle - dwell - angle;
    if rest < -1e-9 {
        return Err(table
            .error(
                "rise",
                format!(
                    "rise, dwell and return take {} deg of the turn",
                    digits((TURN - rest).to_degrees(), 6)
                ),
            )
            .with_help("together they take at most 360 deg: the rest is the base circle"));
    }
    let mut segments = vec![Segment::Move {
        angle: rise.angle,
        lift,
        law: rise.law,
    }];
    if dwell > 0.0 {
        segments.push(Segment::Dwell { angle: dwell });
    }
    segments.push(Segment::Move {
        angle,
        lift: -lift,
        law,
    });
    if rest > 1e-9 {
        segments.push(Segment::Dwell { angle: rest });
    }
    let degrees = |angle: f64| digits(angle.to_degrees(), 5);
    let words = format!(
        "rise of {} ({}, {} deg), dwell {} deg, return ({name}, {} deg)",
        length(lift),
        rise.name,
        degrees(rise.angle),
        degrees(dwell),
        degrees(angle)
    );
    let law =
        LiftLaw::segments(segments).map_err(|error| table.error("rise", error.to_string()))?;
    Ok((law, words))
}

/// A law of a table of angles and lifts, whose lifts have errors of the root mean square `tolerance` (m) or those of rounding; and its description.
fn of_table(
    table: &Table<'_>,
    folder: &Path,
    file: &str,
    tolerance: Option<f64>,
) -> Result<(LiftLaw, String), InputError> {
    let path = folder.join(file);
    let text = read_text(&path, LARGEST_TABLE)
        .map_err(|error| table.error("lift_table", format!("{} {error}", path.display())))?;
    let Lifts {
        angles,
        lifts,
        digit,
    } = rows(file, &text).map_err(|error| {
        table.error("lift_table", error.to_string()).with_help(
            "lifts are a CSV table with a column of the angle and one of the lift, each with its unit: angle [deg], lift [mm]",
        )
    })?;
    let law = LiftLaw::rounded_table(&angles, &lifts, digit, tolerance).map_err(|error| {
        let refused = table.error("lift_table", error.to_string());
        match error {
            CamError::TableOrder { .. } => refused.with_help(
                "give one turn; repeat its first row at 360 deg only with the same lift",
            ),
            _ => refused,
        }
    })?;
    let smoothed = match &law {
        LiftLaw::Table(of) if of.tolerance > 0.0 => {
            format!("smoothed by {} (root mean square)", length(of.tolerance))
        }
        _ => "through all of it".to_owned(),
    };
    let words = format!(
        "{file}, ± {} by its last digit, {smoothed}",
        length(0.5 * digit)
    );
    Ok((law, words))
}

/// A table of lifts.
struct Lifts {
    /// rad.
    angles: Vec<f64>,
    /// m.
    lifts: Vec<f64>,
    /// Unit of the last digit of the lifts, m.
    digit: f64,
}

/// The lifts of a CSV file. A last row one turn after the first, with the same lift, repeats the first.
fn rows(file: &str, text: &str) -> Result<Lifts, CsvError> {
    let of_angle = Wanted {
        names: &["angle"],
        dimension: Dimension::ANGLE,
    };
    let of_lift = Wanted {
        names: &["lift"],
        dimension: Dimension::LENGTH,
    };
    let (csv, [angle, lift]) = CsvTable::series(file, text, [of_angle, of_lift])?;
    let title = csv.title(angle.index).to_lowercase();
    if ["crank", "kurbel"].iter().any(|word| title.contains(word)) {
        let problem =
            "these are angles of the crank, of which the cam turns half: give those of the cam";
        return Err(csv.error(csv.header(), angle.index, problem));
    }
    let (mut angles, mut lifts) = (Vec::new(), Vec::new());
    for row in csv.rows() {
        angles.push(csv.required_number(row, &angle)?);
        lifts.push(csv.required_number(row, &lift)?);
    }
    let n = angles.len();
    if n > 1
        && (angles[n - 1] - angles[0] - TURN).abs() < 1e-9
        && (lifts[n - 1] - lifts[0]).abs() < 1e-12
    {
        angles.pop();
        lifts.pop();
    }
    let digit = csv.last_digit(&lift);
    fill(&mut angles, &mut lifts, digit);
    Ok(Lifts {
        angles,
        lifts,
        digit,
    })
}

/// Steps of a table beyond which rows count as omitted.
const GAP: f64 = 4.0;

/// Adds the rows that tables omit where the lift is constant within a `digit` (m), as on the base circle: a spline would oscillate there.
fn fill(angles: &mut Vec<f64>, lifts: &mut Vec<f64>, digit: f64) {
    let n = angles.len();
    let widths: Vec<f64> = (0..n)
        .map(|i| angles.get(i + 1).map_or(angles[0] + TURN, |next| *next) - angles[i])
        .collect();
    let mut sorted = widths.clone();
    sorted.sort_by(f64::total_cmp);
    let Some(step) = sorted.get(n / 2).copied().filter(|step| *step > 0.0) else {
        return;
    };
    let rows: Vec<[f64; 2]> = angles.iter().zip(&*lifts).map(|(a, s)| [*a, *s]).collect();
    angles.clear();
    lifts.clear();
    // Rows that the spline still takes: a table of fine steps has no room for its gaps, and none needs as many.
    let mut room = ROWS[1].saturating_sub(n);
    for (i, [angle, lift]) in rows.iter().enumerate() {
        let next = rows[(i + 1) % n][1];
        let is_gap = widths[i] > GAP * step && (lift - next).abs() <= digit;
        let more = if is_gap {
            ((widths[i] / step).round() as usize).min(room + 1)
        } else {
            1
        };
        room -= more - 1;
        angles.extend((0..more).map(|k| angle + widths[i] * k as f64 / more as f64));
        lifts.extend(std::iter::repeat_n(*lift, more));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gaps of a base circle are filled with rows as far apart as the others, and with no more than the spline takes: steps of 1e-12 rad would make 6e12 rows.
    #[test]
    fn gaps_have_bounded_rows() {
        let filled = |angles: &[f64]| {
            let (mut angles, mut lifts) = (angles.to_vec(), vec![0.0; angles.len()]);
            fill(&mut angles, &mut lifts, 1e-6);
            assert_eq!(angles.len(), lifts.len());
            assert!(angles.is_sorted());
            angles.len()
        };
        let steps =
            |n: u32, step: f64| -> Vec<f64> { (0..n).map(|i| step * f64::from(i)).collect() };
        assert_eq!(filled(&steps(90, TURN / 180.0)), 180);
        assert_eq!(filled(&[0.0, 1e-12, 2e-12]), ROWS[1]);
        assert_eq!(filled(&steps(1601, TURN / 3600.0)), ROWS[1]);
    }
}
