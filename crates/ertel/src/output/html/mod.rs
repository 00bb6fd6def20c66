//! `report.html`: a result as one self-contained page.
//!
//! The template and its scripts are in `assets`; uPlot (MIT) draws the charts. The template engine escapes the text of cases, and
//! `<` is escaped in the data; a content security policy in the page forbids loading anything.

mod data;
mod differences;
mod instants;
mod thin;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use minijinja::{AutoEscape, Environment, UndefinedBehavior, context};
use serde::Serialize;
use serde_json::{Value, json};

pub use data::{DATA_FORMAT, DATA_VERSION};

use super::compare::{comparison_picture, failures, write_figures as write_compared};
use super::lines::{Block, Lines, shown_warnings};
use super::machine::{machine_pictures, table_of_pressed, warnings, write_figures, write_idle};
use super::pictures::{Picture, stress_map};
use super::report::{write_case, write_contact, write_effort, write_formulas, write_results};
use super::transient::{transient_table, write_results as write_transient};
use super::{curve_report, curve_table, heat, inputs, stress};
use crate::case::CaseEcho;
use crate::compare::Comparison;
use crate::figures::Definition;
use crate::machine::MachineFigures;
use crate::run::transient::TransientSolution;
use crate::solution::{Kind, Solution};
use crate::study::{CurveSolution, MachineSolution};
use crate::words::{digits, pressure};

/// Opening tag of the page's data element.
const DATA_OPEN: &str = r#"<script type="application/json" id="ertel-data">"#;

/// Maximum bytes of a table in a page.
const MOST_TABLE_BYTES: usize = 1_500_000;

const TEMPLATE: &str = include_str!("assets/page.html");
const STYLE: &str = concat!(
    include_str!("assets/uplot/uPlot.min.css"),
    include_str!("assets/page.css")
);
const SCRIPT: &str = concat!(
    include_str!("assets/uplot/uPlot.iife.min.js"),
    "\n(() => {\n\"use strict\";\n",
    include_str!("assets/field.js"),
    include_str!("assets/units.js"),
    include_str!("assets/axis.js"),
    include_str!("assets/chart.js"),
    include_str!("assets/map.js"),
    include_str!("assets/contact.js"),
    include_str!("assets/instants.js"),
    include_str!("assets/table.js"),
    include_str!("assets/page.js"),
    "})();\n"
);

/// A section of the page: a heading and its content.
#[derive(Debug, Default, Serialize)]
struct Section {
    heading: String,
    blocks: Vec<Shown>,
}

/// A block of a report, for the template.
#[derive(Debug, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
enum Shown {
    Rows {
        rows: Vec<[String; 2]>,
    },
    Line {
        text: String,
    },
    Note {
        text: String,
    },
    Table {
        head: Vec<String>,
        rows: Vec<Vec<String>>,
    },
}

/// The sections of a report; blocks before the first heading are placed under `first`.
fn sections(lines: Lines, first: &str) -> Vec<Section> {
    let mut sections = vec![Section {
        heading: first.to_owned(),
        ..Section::default()
    }];
    for block in lines.blocks {
        if let Block::Heading(heading) = block {
            sections.push(Section {
                heading,
                ..Section::default()
            });
            continue;
        }
        let blocks = &mut sections.last_mut().expect("has one").blocks;
        match block {
            Block::Row(name, value) => match blocks.last_mut() {
                Some(Shown::Rows { rows }) => rows.push([name, value]),
                _ => blocks.push(Shown::Rows {
                    rows: vec![[name, value]],
                }),
            },
            Block::Line(text) => blocks.push(Shown::Line { text }),
            Block::Note(text) => blocks.push(Shown::Note { text }),
            Block::Table(table) => blocks.push(Shown::Table {
                head: table.head,
                rows: table.rows,
            }),
            Block::Title(_) | Block::Heading(_) | Block::Warnings(_) => {}
        }
    }
    sections.retain(|s| !s.blocks.is_empty());
    sections
}

fn part(write: impl FnOnce(&mut Lines), first: &str) -> Vec<Section> {
    let mut lines = Lines::default();
    write(&mut lines);
    sections(lines, first)
}

/// The page of a solution; the tolerance of Newton's method is drawn with its iterations.
pub fn report_page(case: &CaseEcho, solution: &Solution, tolerance: f64) -> String {
    let mut results = part(
        |out| {
            write_results(out, solution);
            if let Some(thermal) = &solution.thermal {
                heat::write_results(out, solution, thermal);
            }
            stress::write_results(out, solution);
        },
        "",
    );
    // The heading above them says the same.
    for section in &mut results {
        if section.heading == "Results" {
            section.heading.clear();
        }
    }
    let inputs = part(
        |out| {
            write_case(out, case);
            write_contact(
                out,
                (&case.contact, &solution.hertz),
                solution.reduced_modulus,
                &solution.groups,
                solution.groups_asymptotic.as_ref(),
            );
        },
        "Case",
    );
    let warnings = shown_warnings(&solution.warnings);
    let data = json!({
        "version": DATA_VERSION,
        "results": [data::data(case, solution, tolerance)],
    });
    page(Page {
        title: &case.title,
        subtitle: subtitle(solution),
        warnings,
        results,
        inputs,
        formulas: part(|out| write_formulas(out, solution), ""),
        sensitivities: part(|out| inputs::write(out, solution), ""),
        effort: part(|out| write_effort(out, solution), ""),
        case_file: case.case_file.as_deref(),
        has_uncertainty: solution.uncertainty.is_some(),
        pictures: Vec::new(),
        bodies: stress_map(&case.title, solution).map(|map| STANDARD.encode(map.svg())),
        data,
    })
}

/// The page of a curve.
pub fn curve_page(case: &CaseEcho, curve: &CurveSolution) -> String {
    let unit = curve.quantity.unit();
    let data = json!({
        "version": DATA_VERSION,
        "title": case.title,
        "table": table(&curve_table(curve), 1),
    });
    let subtitle = format!(
        "{} points over {}{}{}",
        curve.points.len(),
        curve.quantity.name,
        if unit.is_empty() { "" } else { " in " },
        unit,
    );
    page(Page {
        title: &case.title,
        subtitle,
        warnings: remarks(&curve_report(case, curve, None)),
        inputs: part(
            |out| write_case(out, case),
            "Case (of the file, before the curve's values)",
        ),
        case_file: case.case_file.as_deref(),
        data,
        ..Page::default()
    })
}

/// The page of a machine: its figures, the pictures of its contacts, and their table.
pub fn machine_page(
    case: &CaseEcho,
    machine: &MachineSolution,
    figures: &MachineFigures,
) -> String {
    let whole = &machine.machine;
    let n_axes = if whole.has_sides() { 2 } else { 1 };
    let values: Vec<Value> = (figures.all.iter())
        .map(|row| {
            let value = row.estimate.is_resolved().then_some(row.estimate.value);
            let marks = row.estimate.marks.symbols();
            let Definition {
                name, words, kind, ..
            } = row.figure;
            let unit = match kind {
                Kind::Rise => differences::RISE,
                _ => row.unit,
            };
            json!({ "name": name, "words": words, "unit": unit, "value": value, "marks": marks })
        })
        .collect();
    let data = json!({
        "version": DATA_VERSION,
        "title": case.title,
        "table": table(&table_of_pressed(machine, &figures.at_contacts), n_axes),
        "figures": values,
    });
    let results = part(
        |out| {
            write_figures(out, figures, &[]);
            write_idle(out, machine);
        },
        "",
    );
    let pictures = machine_pictures(&case.title, machine, &figures.at_contacts).into_iter();
    page(Page {
        title: &case.title,
        subtitle: whole.title.clone(),
        warnings: shown_warnings(&warnings(machine, figures)),
        results,
        inputs: part(|out| write_case(out, case), "Governing contact"),
        case_file: case.case_file.as_deref(),
        pictures: pictures.map(|p| STANDARD.encode(p.svg)).collect(),
        data,
        ..Page::default()
    })
}

/// The page of a transient case: extremes and instants, pictures, an instant slider, and the table over time.
pub fn transient_page(case: &CaseEcho, found: &TransientSolution, pictures: &[Picture]) -> String {
    let csv = transient_table(found, case.contact.kind.is_line());
    let data = json!({
        "version": DATA_VERSION,
        "title": case.title,
        "table": table(&csv, 1),
        "instants": instants::instants(found),
    });
    page(Page {
        title: &case.title,
        subtitle: format!("{} instants", found.instants.len()),
        warnings: shown_warnings(&found.warnings),
        results: part(
            |out| write_transient(out, found, case.contact.kind),
            "Results",
        ),
        inputs: part(|out| write_case(out, case), "Case at the start"),
        case_file: case.case_file.as_deref(),
        pictures: pictures.iter().map(|p| STANDARD.encode(&p.svg)).collect(),
        data,
        ..Page::default()
    })
}

/// The page of a study from its table (CSV); the first columns after the point number are the axes.
pub fn study_page(title: &str, csv: &str, n_axes: usize, warnings: Vec<String>) -> String {
    let data = json!({ "version": DATA_VERSION, "title": title, "table": table(csv, n_axes) });
    let n = csv.lines().count().saturating_sub(1);
    page(Page {
        title,
        subtitle: format!("Study of {n} finished points"),
        warnings,
        data,
        ..Page::default()
    })
}

/// The page of a comparison with measurements: a table and statistics of each figure, and the picture. `case` is the text of the base case.
pub fn comparison_page(comparison: &Comparison, case: &str) -> String {
    let pictures = comparison_picture(comparison).into_iter();
    let n_solved = comparison.rows.len() - comparison.n_unsolved();
    let results = part(
        |out| {
            comparison.notes.iter().for_each(|note| out.note(note));
            write_compared(out, comparison);
        },
        "",
    );
    page(Page {
        title: &comparison.title,
        subtitle: format!(
            "Measured and computed: {n_solved} of {} rows compared, {} points",
            comparison.rows.len(),
            comparison.n_points
        ),
        warnings: failures(comparison),
        results,
        case_file: Some(case),
        pictures: pictures.map(|p| STANDARD.encode(p.svg())).collect(),
        data: json!({ "version": DATA_VERSION }),
        ..Page::default()
    })
}

/// Why a text cannot be shown as a result page.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// Not a result page, or damaged.
    #[error("it is not a result page of ertel")]
    NotAPage,
    /// It was written by another version.
    #[error(
        "it was written by a version of ertel with another layout ({found}, not {DATA_VERSION}); solve the case again"
    )]
    Version {
        /// Version of its layout.
        found: String,
    },
    /// Contacts and tables of points cannot share a page.
    #[error("results of single contacts and tables of curves or studies cannot be shown together")]
    Mixed,
}

/// A page with several results, each given by its title, its name and its page data: contacts with the differences
/// of their fields, or curves, machines and studies with a merged table and the differences of their figures.
///
/// # Errors
/// [`PageError::Mixed`]; [`PageError::NotAPage`] for damaged data.
pub fn joint_page(parts: Vec<(String, Value)>) -> Result<String, PageError> {
    let n = parts.len();
    let (mut results, mut tables) = (Vec::new(), Vec::new());
    for (name, data) in parts {
        let title = (data["title"].as_str()).or(data["results"][0]["title"].as_str());
        let name = match title.map(str::trim).filter(|title| !title.is_empty()) {
            Some(title) => format!("{title} ({name})"),
            None => name,
        };
        if let Some(found) = data["results"].as_array() {
            for result in found {
                let mut result = result.as_object().ok_or(PageError::NotAPage)?.clone();
                result.insert("name".to_owned(), name.clone().into());
                results.push(Value::Object(result));
            }
        }
        if data["table"].is_object() {
            let mut table = data["table"].clone();
            table["name"] = name.into();
            table["figures"] = data["figures"].clone();
            tables.push(table);
        }
    }
    let (data, what) = match (results.is_empty(), tables.is_empty()) {
        (false, true) => (
            json!({ "version": DATA_VERSION, "results": results }),
            "contacts",
        ),
        (true, false) => (
            json!({ "version": DATA_VERSION, "tables": tables.clone() }),
            "tables",
        ),
        _ => return Err(PageError::Mixed),
    };
    Ok(page(Page {
        title: "Comparison of results",
        subtitle: format!("{n} {what}"),
        results: part(|out| differences::write(out, &tables), ""),
        data,
        ..Page::default()
    }))
}

/// The data of a page.
///
/// # Errors
/// [`PageError`] if the text is not a page of this version.
pub fn page_data(page: &str) -> Result<Value, PageError> {
    let (_, rest) = page.split_once(DATA_OPEN).ok_or(PageError::NotAPage)?;
    let (text, _) = rest.split_once("</script>").ok_or(PageError::NotAPage)?;
    let data: Value = serde_json::from_str(text).map_err(|_| PageError::NotAPage)?;
    match data["version"] == DATA_VERSION {
        true => Ok(data),
        false => Err(PageError::Version {
            found: data["version"].to_string(),
        }),
    }
}

/// A table with the number of columns, after the point number, that state the varied inputs.
fn table(csv: &str, n_axes: usize) -> Value {
    let end = match csv.get(..MOST_TABLE_BYTES.min(csv.len())) {
        Some(text) if text.len() == csv.len() => csv.len(),
        _ => csv
            .char_indices()
            .take_while(|(i, _)| *i < MOST_TABLE_BYTES)
            .filter(|(_, c)| *c == '\n')
            .last()
            .map_or(0, |(i, _)| i + 1),
    };
    let left_out = csv[end..].lines().count();
    json!({ "csv": &csv[..end], "n_axes": n_axes, "left_out": left_out })
}

/// The lines of a curve's report that start with an exclamation mark.
fn remarks(report: &str) -> Vec<String> {
    let marked = report
        .lines()
        .filter_map(|line| line.trim().strip_prefix("! "));
    marked.map(str::to_owned).collect()
}

fn subtitle(solution: &Solution) -> String {
    let g = &solution.groups;
    let (first, rest) = solution.kind.name().split_at(1);
    let kind = first.to_uppercase() + rest;
    format!(
        "{} contact, p_h {}, M {}, L {}",
        kind,
        pressure(solution.hertz.pressure),
        digits(g.moes_load, 4),
        digits(g.moes_material, 4),
    )
}

/// Context of the template.
#[derive(Debug, Default, Serialize)]
struct Page<'a> {
    title: &'a str,
    subtitle: String,
    warnings: Vec<String>,
    results: Vec<Section>,
    inputs: Vec<Section>,
    formulas: Vec<Section>,
    sensitivities: Vec<Section>,
    effort: Vec<Section>,
    case_file: Option<&'a str>,
    has_uncertainty: bool,
    /// SVG files in base 64.
    pictures: Vec<String>,
    /// SVG file of the stresses in the bodies, likewise.
    bodies: Option<String>,
    #[serde(skip)]
    data: Value,
}

fn page(page: Page<'_>) -> String {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    environment
        .add_template("page", TEMPLATE)
        .expect("the template is ours");
    let template = environment.get_template("page").expect("just added");
    let data = script_data(&page.data);
    template
        .render(context! {
            page => minijinja::value::Serde(&page),
            style => minijinja::Value::from_safe_string(STYLE.to_owned()),
            script => minijinja::Value::from_safe_string(SCRIPT.to_owned()),
            data => minijinja::Value::from_safe_string(format!("{DATA_OPEN}{data}</script>")),
            version => env!("CARGO_PKG_VERSION"),
        })
        .expect("the template is ours")
}

/// JSON that cannot close or open a script element.
fn script_data(data: &Value) -> String {
    data.to_string().replace('<', "\\u003c")
}

#[cfg(test)]
mod tests {
    use super::super::sample;
    use super::*;
    use crate::solution::Figure;
    use crate::warning::{Warning, WarningKind};

    /// Titles and case files are treated as text, whatever they contain, and the data cannot end a script.
    #[test]
    fn user_text_is_escaped() {
        let (mut case, solution) = sample::circle().clone();
        case.title = "</script><script>alert(1)</script> & \"ball\"".to_owned();
        case.case_file = Some("<!-- <b>title</b> -->".to_owned());
        let page = report_page(&case, &solution, 1e-6);
        assert_eq!(page.matches("<script").count(), 2);
        assert_eq!(page.matches("</script>").count(), 2);
        assert!(page.contains("&lt;!-- &lt;b&gt;title"));
        let data = page_data(&page).unwrap();
        assert_eq!(data["results"][0]["title"], case.title);
    }

    /// The page loads nothing: its policy forbids it, and the only address is in the licence of uPlot.
    #[test]
    fn pages_need_no_network() {
        let (case, solution) = sample::line();
        let page = report_page(case, solution, 1e-6);
        assert!(page.contains("default-src 'none'"));
        for loading in ["src=\"", "@import", "url(", "<link rel=\"style"] {
            assert!(!page.contains(loading), "{loading}");
        }
        for ((case, solution), has_map) in [(sample::line(), false), (sample::circle(), true)] {
            let data = page_data(&report_page(case, solution, 1e-6)).unwrap();
            assert_eq!(data["results"][0]["mesh"].is_object(), has_map);
        }
    }

    /// Figures, warnings and formulas are readable without scripts.
    #[test]
    fn pages_repeat_the_report() {
        let (case, mut solution) = sample::circle().clone();
        sample::set(&mut solution, Figure::FilmCentral, 245e-9, 0.8e-9);
        solution.formulas[0].central = Some(264.1e-9);
        solution.warnings = vec![Warning::new(
            WarningKind::PressureRange,
            "the pressure leaves the range",
        )];
        let page = report_page(&case, &solution, 1e-6);
        for expected in ["245.0 ± 0.8 nm", "264.1 nm (+7.8 %)", "the pressure leaves"] {
            assert!(page.contains(expected), "{expected}");
        }
    }

    #[test]
    fn pages_are_joined_by_kind() {
        let (case, solution) = sample::circle().clone();
        let contact = page_data(&report_page(&case, &solution, 1e-6)).unwrap();
        let study = page_data(&study_page("a study", "point,a\n1,2\n", 1, Vec::new())).unwrap();
        let named = |data: &Value| ("one".to_owned(), data.clone());
        let both = page_data(&joint_page(vec![named(&contact), named(&contact)]).unwrap());
        assert_eq!(both.unwrap()["results"].as_array().unwrap().len(), 2);
        let both = page_data(&joint_page(vec![named(&study), named(&study)]).unwrap());
        assert_eq!(both.unwrap()["tables"][1]["name"], "a study (one)");
        let mixed = joint_page(vec![named(&contact), named(&study)]);
        assert!(matches!(mixed, Err(PageError::Mixed)));
        assert!(matches!(page_data("<html>"), Err(PageError::NotAPage)));
        let old = format!("{DATA_OPEN}{{\"version\":0}}</script>");
        assert!(matches!(page_data(&old), Err(PageError::Version { .. })));
    }

    /// A table that is too long ends after a complete line, and the page states the number of omitted lines.
    #[test]
    fn long_tables_are_cut() {
        let csv = "point,a\n".to_owned() + &"1,22222222\n".repeat(200_000);
        let cut = table(&csv, 1);
        let kept = cut["csv"].as_str().unwrap();
        assert!(kept.len() <= MOST_TABLE_BYTES && kept.ends_with('\n'));
        let n = kept.lines().count() + cut["left_out"].as_u64().unwrap() as usize;
        assert_eq!(n, 200_001);
        assert_eq!(table("point,a\n1,2\n", 1)["left_out"], 0);
    }
}
