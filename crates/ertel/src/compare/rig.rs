//! Exports of the rigs of PCS Instruments: film thickness of the EHD2, traction of the MTM and ETM.
//!
//! Such a file is text with a head, `EHD261 Test Data File` or `MTM311 Test Data File`, and then step by step
//!
//! ```text
//! Step 2 "New film step" started at 09/03/2017 17:28
//! Step type   FILM   Step description   New film step
//! Rolling Speed (mm/s)   Average Film (nm)  ...  Lube Temp (°C)  Ball Load (N)  ...  SRR (%)  ...
//! 19.9   4.1   ...
//! ```
//!
//! with tabs between the cells and an empty line behind the table. A summary of a few columns comes first and the same
//! columns again with more digits; the last one of a title is read.
//!
//! The layout is that of the files in `tribology/tests/data_import/test_data_pcs` of the project github.com/moritzploss/tribology
//! (MIT): EHD261 of 2017, MTM311 of 2016 and an ETM of 2019. There SRR is `100 (u_disc - u_ball)/u_rolling`, as the speeds of ball
//! and disc in the same table show.

use std::ops::Range;

use ertel_input::Document;
use ertel_input::csv::{Column, CsvError, CsvTable, Row, line_list};
use ertel_quantity::Unit;

use super::columns::Operating;
use super::measured::{Content, column};
use super::table::impossible;
use super::turned::{self, Turned};
use super::{Measurand, Measurement, N_MEASURANDS, Probe, ReadParams};
use crate::case::study::PointColumn;

const SPEED: &str = "Rolling Speed (mm/s)";
const SLIDING: &str = "SRR (%)";
const LOAD: &str = "Ball Load (N)";
const FILM: &str = "Average Film (nm)";
const DEVIATION: &str = "Standard Deviation (nm)";
const TRACTION: &str = "Traction Coeff (-)";
/// First column of steps in which nothing but time passes.
const TIME: &str = "Step Time (s)";
const LUBRICANT_TEMPERATURES: [&str; 2] = ["Lube Temp (°C)", "Lube RTD Temp (degC)"];
const POT_TEMPERATURES: [&str; 2] = ["Pot Temp (°C)", "Pot RTD Temp (degC)"];

/// Lines within which a file says what it is.
const HEAD: usize = 200;

/// Whether a text is an export of a rig.
pub(super) fn is_export(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    let first = text.lines().next().unwrap_or_default().trim();
    first.ends_with("Test Data File")
        || text
            .lines()
            .take(HEAD)
            .any(|l| l.starts_with("Step type\t"))
}

/// A step with a table.
struct Step {
    number: usize,
    kind: String,
    /// Line of the table's header, from 1.
    line: usize,
    /// Bytes of the table.
    span: Range<usize>,
}

/// Columns of a step's table.
struct Columns {
    speed: Column,
    sliding: Column,
    load: Column,
    temperature: Column,
    film: Option<Column>,
    deviation: Option<Column>,
    traction: Option<Column>,
}

/// Reads an export.
pub(super) fn read(
    case: &Document,
    file: &str,
    text: &str,
    params: &ReadParams,
) -> Result<Content, CsvError> {
    let whole = |line: usize, problem: String| CsvError {
        file: file.to_owned(),
        line,
        column: 1,
        problem,
    };
    let names = params.table.ignored.iter();
    let names = names.chain(params.table.columns.iter().map(|map| &map.title));
    if let Some(name) = names.into_iter().next() {
        let problem = format!(
            "columns of an export of a rig are chosen by their titles: `{name}` can be neither ignored nor mapped"
        );
        return Err(whole(1, problem));
    }
    let steps = steps(text);
    if let Some(problem) = missing_step(params, &steps) {
        return Err(whole(1, problem));
    }
    let mut content = Content {
        columns: Vec::new(),
        rows: Vec::new(),
        notes: Vec::new(),
        measured: Vec::new(),
    };
    let mut taken = Vec::new();
    for step in &steps {
        let is_asked = params.steps.contains(&step.number);
        if !params.steps.is_empty() && !is_asked {
            continue;
        }
        let (own, offset) = (&text[step.span.clone()], step.span.start);
        let table = CsvTable::parse_part(file, own, step.line)?;
        if !is_asked && table.header().cell(0) == TIME {
            let note = format!(
                "step {} ({}) is omitted: only time varies in it; --step {} includes it",
                step.number, step.kind, step.number
            );
            content.notes.push(note);
            continue;
        }
        match columns_of(&table, params.probe) {
            Ok(columns) => read_step(case, &table, (own, offset), &columns, step, &mut content)?,
            Err(problem) if is_asked => return Err(whole(step.line, problem)),
            Err(problem) => {
                let note = format!("step {} ({}) is omitted: {problem}", step.number, step.kind);
                content.notes.push(note);
                continue;
            }
        }
        taken.push(step.number.to_string());
    }
    if content.rows.is_empty() {
        let reasons = match content.notes.is_empty() {
            true => "there is no table of a step with speeds".to_owned(),
            false => content.notes.join("; "),
        };
        return Err(whole(
            1,
            format!("no measurement was found in this export of a rig: {reasons}"),
        ));
    }
    content
        .notes
        .insert(0, format!("export of a rig: step {}", taken.join(", ")));
    content.notes.push(
        "its slide-to-roll ratio, (u_disc - u_ball)/u, has the other sign here, (u_body_2 - u_body_1)/u: body_1 of the case is \
         the disc, body_2 the ball"
            .to_owned(),
    );
    Ok(content)
}

/// Words about a step that the user asks for and that has no table.
fn missing_step(params: &ReadParams, steps: &[Step]) -> Option<String> {
    let number = (params.steps.iter()).find(|n| steps.iter().all(|s| s.number != **n))?;
    let have: Vec<String> = steps
        .iter()
        .map(|s| format!("{} ({})", s.number, s.kind))
        .collect();
    Some(match have.is_empty() {
        true => "no step has a table".to_owned(),
        false => format!(
            "no step {number} has a table; those that have are {}",
            have.join(", ")
        ),
    })
}

/// The steps that have a table with speeds.
fn steps(text: &str) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    let (mut number, mut kind) = (0, String::new());
    let (mut start, mut is_open) = (0, false);
    for (index, whole) in text.split_inclusive('\n').enumerate() {
        let line = whole.trim_end();
        let span = start..start + line.len();
        start += whole.len();
        if let Some(rest) = line.strip_prefix("Step type\t") {
            kind = rest
                .split('\t')
                .next()
                .unwrap_or_default()
                .trim()
                .to_owned();
            is_open = false;
        } else if let Some(own) = step_number(line) {
            (number, is_open) = (own, false);
        } else if line.trim().is_empty() {
            is_open = false;
        } else if line.split('\t').any(|title| title.trim() == SPEED) {
            is_open = true;
            steps.push(Step {
                number,
                kind: kind.clone(),
                line: index + 1,
                span,
            });
        } else if !line.contains('\t') {
            // Such as the line that says how the test ended.
            is_open = false;
        } else if is_open && let Some(step) = steps.last_mut() {
            step.span.end = span.end;
        }
    }
    steps
}

/// 2 of `Step 2 "New film step" started at 09/03/2017 17:28`.
fn step_number(line: &str) -> Option<usize> {
    let rest = line.strip_prefix("Step ")?;
    let (number, rest) = rest.split_once(' ')?;
    rest.contains("started at")
        .then(|| number.parse().ok())
        .flatten()
}

/// The columns of a table; or why it has none.
fn columns_of(table: &CsvTable, probe: Probe) -> Result<Columns, String> {
    let titles = table.header().cells();
    let find = |title: &'static str, name: &'static str, unit_text: &str| -> Option<Column> {
        let index = titles.iter().rposition(|own| own == title)?;
        let unit = Unit::parse(unit_text).ok()?;
        Some(Column {
            index,
            name,
            unit,
            unit_text: unit_text.to_owned(),
            is_open: false,
        })
    };
    let need = |found: Option<Column>, title: &str| {
        found.ok_or_else(|| format!("it has no column `{title}`"))
    };
    let temperatures = match probe {
        Probe::Lubricant => LUBRICANT_TEMPERATURES,
        Probe::Pot => POT_TEMPERATURES,
    };
    let temperature = (temperatures.into_iter()).find_map(|title| find(title, title, "degC"));
    let columns = Columns {
        speed: need(find(SPEED, SPEED, "mm/s"), SPEED)?,
        sliding: need(find(SLIDING, SLIDING, "%"), SLIDING)?,
        load: need(find(LOAD, LOAD, "N"), LOAD)?,
        temperature: need(temperature, temperatures[0])?,
        film: find(FILM, FILM, "nm"),
        deviation: find(DEVIATION, DEVIATION, "nm"),
        traction: find(TRACTION, TRACTION, ""),
    };
    match columns.film.is_some() || columns.traction.is_some() {
        true => Ok(columns),
        false => Err(format!("it has neither `{FILM}` nor `{TRACTION}`")),
    }
}

/// Reads the rows of a step.
fn read_step(
    case: &Document,
    table: &CsvTable,
    (text, offset): (&str, usize),
    columns: &Columns,
    step: &Step,
    content: &mut Content,
) -> Result<(), CsvError> {
    let span_of = |row: &Row, index: usize| {
        let span = table.cell_span(text, row, index);
        span.start + offset..span.end + offset
    };
    if content.columns.is_empty() {
        for (quantity, own) in [
            (Operating::Speed, &columns.speed),
            (Operating::Sliding, &columns.sliding),
            (Operating::Load, &columns.load),
            (Operating::Temperature, &columns.temperature),
        ] {
            let key = quantity.key(case).map_err(|why| {
                let problem = format!("the case cannot take this column from an export: {why}");
                table.error(table.header(), own.index, problem)
            })?;
            let span = span_of(table.header(), own.index);
            content.columns.push(column(key, span));
        }
    }
    add_measured(&mut content.measured, columns);
    let (mut without_film, mut empty) = (Vec::new(), Vec::new());
    let mut turned = turned::Rows::of(case);
    for row in table.rows() {
        let figures = figures(table, row, columns, &mut without_film)?;
        if figures == [None; N_MEASURANDS] {
            empty.push(row.line);
            continue;
        }
        let speed = table.required_number(row, &columns.speed)?;
        let turn = turned.take(row.line, Some(speed));
        if turn == Turned::LeftOut {
            continue;
        }
        let sliding = table.required_number(row, &columns.sliding)?;
        let units = [
            (&columns.speed, "mm/s"),
            (&columns.load, "N"),
            (&columns.temperature, "degC"),
        ];
        for (own, _) in units {
            table.required_number(row, own)?;
        }
        let push = |point: &mut PointColumn, (own, unit): (&Column, &str)| {
            let cell = table.with_point(row.cell(own.index));
            let cell = match own.index == columns.speed.index {
                true => turn.speed(&cell),
                false => &cell,
            };
            point.push(span_of(row, own.index), cell, unit);
        };
        push(&mut content.columns[0], units[0]);
        let span = span_of(row, columns.sliding.index);
        // The rig's ratio is that of the disc's speed above the ball's; no minus zero.
        content.columns[1].push_number(span, 0.0 - sliding);
        push(&mut content.columns[2], units[1]);
        push(&mut content.columns[3], units[2]);
        content.rows.push((row.line, figures));
    }
    let mut notes = turned.notes();
    if !without_film.is_empty() {
        let lines = line_list(&without_film);
        notes.push(format!(
            "films that are not above zero are omitted ({lines})"
        ));
    }
    if !empty.is_empty() {
        notes.push(format!("nothing was measured in {}", line_list(&empty)));
    }
    let of_step = |note: String| format!("step {}: {note}", step.number);
    content.notes.extend(notes.into_iter().map(of_step));
    Ok(())
}

/// Adds the titles of measured columns, and their meaning.
fn add_measured(measured: &mut Vec<(String, String)>, columns: &Columns) {
    for (own, what) in [
        (&columns.film, "measured central film thickness"),
        (
            &columns.deviation,
            "uncertainty of the central film thickness",
        ),
        (&columns.traction, "measured traction coefficient"),
    ] {
        let Some(own) = own else { continue };
        let entry = (own.name.to_owned(), what.to_owned());
        if !measured.contains(&entry) {
            measured.push(entry);
        }
    }
}

/// Measurements of a line. The deviation of repeated films is their uncertainty; it is zero where there was one alone.
fn figures(
    table: &CsvTable,
    row: &Row,
    columns: &Columns,
    without_film: &mut Vec<usize>,
) -> Result<[Option<Measurement>; N_MEASURANDS], CsvError> {
    let number = |own: &Option<Column>| match own {
        Some(own) => table.number(row, own),
        None => Ok(None),
    };
    let mut figures = [None; N_MEASURANDS];
    let deviation = number(&columns.deviation)?.filter(|deviation| *deviation > 0.0);
    for (figure, own, uncertainty) in [
        (Measurand::FilmCentral, &columns.film, deviation),
        (Measurand::Traction, &columns.traction, None),
    ] {
        let Some(value) = number(own)? else { continue };
        let index = own.as_ref().map_or(0, |own| own.index);
        if figure.is_film() && value <= 0.0 {
            without_film.push(row.line);
            continue;
        }
        if let Some(problem) = impossible(figure, value, row.cell(index)) {
            return Err(table.error(row, index, problem));
        }
        figures[figure as usize] = Some(Measurement { value, uncertainty });
    }
    Ok(figures)
}
