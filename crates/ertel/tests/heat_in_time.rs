//! Heat in time: what is steady stays, and what has changed comes to the steady contact of the new conditions.

use std::path::Path;

use approx::assert_relative_eq;
use ertel::case::Case;
use ertel::run::transient::{self, TransientSolution};
use ertel::solution::Figure;
use ertel::solve::NoObserver;
use ertel_input::Document;

/// A ball on glass, both of whose surfaces slide, by a coarse mesh.
const CASE: &str = r#"
title = "Heat in time"
lubricant = "squalane-pip"
temperature = "313 K"

[contact]
kind = "circular"
radius = "12.7 mm"
load = "23 N"

[bodies]
body_1 = "glass"
body_2 = "steel"

[motion]
entrainment_speed = "1.47 m/s"
slide_to_roll_ratio = 0.5

[thermal]

[mesh]
target_error = "3 %"

[output]
sensitivities = false
"#;

fn parsed(text: &str) -> Case {
    let document = Document::parse("case.toml", text).unwrap();
    Case::from_document(&document, Path::new("")).unwrap()
}

fn solved(more: &str) -> TransientSolution {
    let case = parsed(&format!("{CASE}{more}"));
    let found = transient::solve(&case, &mut NoObserver);
    assert!(found.failure.is_none(), "{:?}", found.failure);
    found
}

const FIGURES: [Figure; 7] = [
    Figure::FilmCentral,
    Figure::FilmMinimum,
    Figure::TractionCoefficient,
    Figure::HeatToBody1,
    Figure::HeatToBody2,
    Figure::TemperatureBody1Mean,
    Figure::TemperatureBody2Mean,
];

fn figures(found: &TransientSolution, last: bool) -> [f64; FIGURES.len()] {
    let instant = match last {
        true => found.instants.last(),
        false => found.instants.first(),
    };
    FIGURES.map(|figure| {
        let value = instant.unwrap().measured.estimate(figure).value;
        match figure {
            // Rises over the inlet.
            Figure::TemperatureBody1Mean | Figure::TemperatureBody2Mean => value - 313.0,
            _ => value,
        }
    })
}

/// Under the conditions of the start nothing changes: the film equation and the energy of the film are those of the steady contact, and what the bodies remember is the
/// steady rise, but for the heat that spreads beyond the grid.
#[test]
fn what_is_steady_stays() {
    let found = solved("[transient]\nduration = \"1 ms\"\n");
    let [start, end] = [false, true].map(|last| figures(&found, last));
    for (figure, (start, end)) in FIGURES.iter().zip(start.iter().zip(&end)) {
        assert_relative_eq!(start, end, max_relative = 3e-3);
        println!("{}: {start} {end}", figure.name());
    }
}

/// A contact that slows down, whose load falls, comes to what a contact is that begins so.
#[test]
fn changes_come_to_the_steady_contact() {
    let slower = "[transient]\nduration = \"2 ms\"\nentrainment_speed = { course = \"ramp\", end = \"0.3 ms\", to = \"1 m/s\" }\nload = { course = \"ramp\", end = \"0.3 ms\", to = \"15 N\" }\n";
    let found = solved(slower);
    let end = figures(&found, true);
    let case = CASE.replace("1.47 m/s", "1 m/s").replace("23 N", "15 N");
    let case = format!("{case}[transient]\nduration = \"10 us\"\n");
    let case = parsed(&case);
    let steady = figures(&transient::solve(&case, &mut NoObserver), false);
    for (figure, (end, steady)) in FIGURES.iter().zip(end.iter().zip(&steady)) {
        println!("{}: {end} {steady}", figure.name());
        assert_relative_eq!(end, steady, max_relative = 1e-2);
    }
}
