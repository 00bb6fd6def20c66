//! Reading studies.
//!
//! ```toml
//! title = "Subject of the validation"
//! source = "Whose values"
//!
//! [[run]]
//! name = "normal"                 # within the study
//! case = "case.toml"              # next to this file
//! task = "solve"                  # or "deflect": deflection under the Hertz pressure; "curve": the case's [curve];
//!                                 # "transient": the contact over time
//! quick = true                    # takes seconds
//! newton_iterations = 31          # of a cold start, all levels together
//! moes = [200.0, 10.0]            # sets load and alpha (Barus, Roelands) for these groups
//! entrainment_speed = "1.47 m/s"  # replaces that of the case, if it has one; likewise slide_to_roll_ratio
//! [run.mesh]                      # replaces the case's [mesh]; likewise [run.solver]
//! preset = "normal"
//! [run.thermal]                   # likewise, of a thermal case
//! film_order = 4
//!
//! [[check]]
//! quantity = "central-film"
//! runs = ["normal"]               # all that have the quantity, if absent
//! value = 0.0822                  # or formula = "moes-line" (compressed = true), or
//!                                 # power_law = [c, a, b] of h = c R √(2U) M^a L^b, or none of these
//! tolerance = "1 %"               # or tolerance_absolute, at_most, between = [2.0, 4.0], sign = true
//! source = "Table 3.4"
//! reason = "why this tolerance"
//!
//! [[picture]]
//! name = "centreline"
//! kind = "centreline"             # of a `run`; map (of a `field`); deflection, deflection-error, film-over-load,
//!                                 # penalty; of several `runs`: profiles, cross-film, temperatures (panels in
//!                                 # `columns`), pressures, films, mid-temperatures (over each other, again within
//!                                 # `zoom`);
//!                                 # of curves: film-curves, film-shape (of one `run`), traction-curves;
//!                                 # of a contact over time: instants (of one `run`, panels in `columns`)
//! range = [200, 400]              # of the left axis, as shown; around the values, if absent; not of panels,
//!                                 # of overlays and of maps
//! run = "normal"
//! caption = "Its content."
//! ```
//! A check of the quantity `film-at` has the `x` and the `time` of the film, which is one of the case's output times.
//! A picture of the kind `instants` compares films at such times with published ones:
//!
//! ```toml
//! [[picture.instant]]
//! time = "1.2 ms"
//! x_um = [-10.0, 0.0]
//! film_nm = [210.0, 350.0]
//! ```
//!
//! A check of a change has `run` and `relative_to`; one of the order of convergence has
//! `order = [...]`, three runs with cells halved from one to the next.

use std::path::{Path, PathBuf};

use ertel_input::{Bounds, Document, InputError, Table};
use ertel_quantity::Dimension;
use ertel_rheology::ViscosityLaw;

use super::check::Subject;
use super::instants::read_place;
use super::read_picture::{formula_key, indices, read_picture};
use super::{Accept, Check, Quantity, Reference, Run, Study, Task};
use ertel::case::{Case, check_mesh_of_bodies, read_mesh, read_named, read_solver, read_thermal};
use ertel::contact::Family;
use ertel::params::{MeshParams, MeshPreset};
use ertel::reference::FilmFormula;

/// Names of the studies in a folder, sorted.
///
/// # Errors
/// When the folder cannot be read.
pub fn names(folder: &Path) -> std::io::Result<Vec<String>> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        if entry.path().join(REFERENCE).is_file() {
            names.extend(entry.file_name().into_string());
        }
    }
    names.sort();
    Ok(names)
}

/// The file that describes a study.
const REFERENCE: &str = "reference.toml";

/// Reads the study in `folder`.
///
/// # Errors
/// [`InputError`] with file, line and key, of `reference.toml` or a case file.
pub fn read(folder: &Path) -> Result<Study, InputError> {
    let path = folder.join(REFERENCE);
    let document = Document::read(&path)?;
    let mut root = document.root();
    let name = folder
        .file_name()
        .map(|n| n.to_string_lossy().into_owned())
        .unwrap_or_default();
    let mut study = Study {
        name,
        title: root.required_str("title")?.to_owned(),
        source: root.required_str("source")?.to_owned(),
        files: vec![path],
        runs: Vec::new(),
        checks: Vec::new(),
        pictures: Vec::new(),
    };
    for table in root.tables("run")? {
        let (run, files) = read_run(table, folder)?;
        study.runs.push(run);
        study.files.extend(files);
    }
    for table in root.tables("check")? {
        let check = read_check(table, &study)?;
        study.checks.push(check);
    }
    for table in root.tables("picture")? {
        let picture = read_picture(table, &study)?;
        study.pictures.push(picture);
    }
    root.finish()?;
    Ok(study)
}

/// The run, and the files that it was read from.
fn read_run(mut table: Table<'_>, folder: &Path) -> Result<(Run, Vec<PathBuf>), InputError> {
    let name = table.required_str("name")?.to_owned();
    let path = folder.join(table.required_str("case")?);
    let case_folder = path.parent().unwrap_or(folder);
    let mut case = Case::from_document(&read_named(&table, "case", &path)?, case_folder)?;
    let mut files = case.files(case_folder);
    files.push(path);
    if case.title.is_empty() {
        case.title.clone_from(&name);
    }
    let task = table
        .optional_choice(
            "task",
            &[
                ("solve", Task::Solve),
                ("deflect", Task::Deflect),
                ("curve", Task::Curve),
                ("transient", Task::Transient),
            ],
        )?
        .unwrap_or(Task::Solve);
    if task == Task::Curve && case.curve.is_none() {
        return Err(table.error("task", "the case has no [curve]"));
    }
    if (task == Task::Transient) != case.transient.is_some() {
        let text = "a case with [transient] has the task `transient`, and no other has";
        return Err(table.error("task", text));
    }
    if let Some(groups) = table.optional_numbers("moes", Bounds::closed(0.0, 1e5))? {
        let [m, l] = groups[..] else {
            return Err(table.error("moes", "`moes` is [M, L]"));
        };
        set_groups(&mut case, m, l).map_err(|message| table.error("moes", message))?;
    }
    let speed = table.optional_quantity("entrainment_speed", Dimension::SPEED, Bounds::POSITIVE)?;
    if let Some(speed) = speed {
        change(&mut case, |case| case.motion.entrainment_speed = speed);
    }
    if let Some(ratio) = table.optional_number("slide_to_roll_ratio", Bounds::ANY)? {
        change(&mut case, |case| case.motion.slide_to_roll_ratio = ratio);
    }
    if let Some(solver) = table.optional_table("solver")? {
        let solver = read_solver(solver)?;
        change(&mut case, |case| case.solver = solver.clone());
    }
    if let Some(thermal) = table.optional_table("thermal")? {
        if case.thermal.is_none() {
            return Err(table.error("thermal", "the case has no [thermal]"));
        }
        let thermal = read_thermal(thermal, &case.contact)?;
        change(&mut case, |case| case.thermal = Some(thermal.clone()));
    }
    set_mesh(&mut case, table.optional_table("mesh")?)?;
    let iterations = table.optional_integer("newton_iterations", 1..=10_000)?;
    let run = Run {
        name,
        case,
        task,
        quick: table.optional_bool("quick")?.unwrap_or(false),
        newton_iterations: iterations.and_then(|n| usize::try_from(n).ok()),
    };
    table.finish()?;
    Ok((run, files))
}

/// Sets the mesh to that of a run; without one, reference values are compared on a mesh that stays as it is.
fn set_mesh(case: &mut Case, table: Option<Table<'_>>) -> Result<(), InputError> {
    let mesh = match &table {
        Some(table) => {
            let error_estimate = case.solver.error_estimate;
            Some(read_mesh(table.clone(), &case.contact, error_estimate)?)
        }
        None if case.given.get("mesh").is_none() => {
            Some(MeshParams::preset(MeshPreset::Normal, case.contact.kind))
        }
        None => None,
    };
    if let Some(mesh) = mesh {
        change(case, |case| case.mesh = mesh.clone());
    }
    case.output.body_field = false;
    if let Some(table) = &table {
        let warnings = check_mesh_of_bodies(case, table)?;
        case.warnings.extend(warnings);
    }
    Ok(())
}

/// Changes a case and the points of its curve.
fn change(case: &mut Case, change: impl Fn(&mut Case)) {
    change(case);
    for point in case.curve.iter_mut().flat_map(|curve| &mut curve.points) {
        change(&mut point.case);
    }
}

/// Sets load and pressure-viscosity coefficient so that the groups are M and L.
fn set_groups(case: &mut Case, m: f64, l: f64) -> Result<(), String> {
    let modulus = case.reduced_modulus();
    let radius = case.contact.radius;
    let mu_0 = case.lubricant.ambient_viscosity();
    let twice_speed = 2.0 * mu_0 * case.motion.entrainment_speed / (modulus * radius);
    case.contact.load = match case.contact.kind.family() {
        Family::Point => m * twice_speed.powf(0.75) * modulus * radius * radius,
        Family::Cylinder => {
            // Of a line the load is per length.
            let length = case.contact.roller.as_ref().map_or(1.0, |r| r.length);
            m * twice_speed.sqrt() * modulus * radius * length
        }
    };
    let alpha = l * twice_speed.powf(-0.25) / modulus;
    let law = match case.lubricant.viscosity {
        ViscosityLaw::Barus(_) => ViscosityLaw::barus(mu_0, alpha),
        ViscosityLaw::Roelands(_) => ViscosityLaw::roelands(mu_0, alpha),
        _ => return Err("`moes` needs a Barus or Roelands viscosity".to_owned()),
    };
    case.lubricant.viscosity = law.map_err(|error| error.to_string())?;
    Ok(())
}

fn read_check(mut table: Table<'_>, study: &Study) -> Result<Check, InputError> {
    let quantities = Quantity::all()
        .into_iter()
        .map(|q| (q.key(), q))
        .collect::<Vec<_>>();
    let quantity = table.required_choice("quantity", &quantities)?;
    let subject = read_subject(&mut table, study)?;
    let place = match quantity {
        Quantity::FilmAt => {
            let runs = subject.runs();
            let runs = runs.iter().map(|i| &study.runs[*i]);
            Some(read_place(&mut table, runs)?)
        }
        _ => None,
    };
    let formulas = FilmFormula::ALL.map(|f| (formula_key(f), f));
    let power_law = match table.optional_numbers("power_law", Bounds::ANY)? {
        None => None,
        Some(constants) => {
            let [c, a, b] = constants[..] else {
                return Err(table.error("power_law", "`power_law` is [c, a, b]"));
            };
            let is_film = matches!(quantity, Quantity::CentralFilm | Quantity::MinimumFilm);
            if !is_film {
                return Err(table.error("power_law", "a power law is of a film"));
            }
            Some([c, a, b])
        }
    };
    let reference = match (
        table.optional_number("value", Bounds::ANY)?,
        table.optional_choice("formula", &formulas)?,
        power_law,
    ) {
        (None, None, None) => Reference::Nothing,
        (Some(value), None, None) => Reference::Value(value),
        (None, Some(formula), None) => {
            Reference::Formula(formula, table.optional_bool("compressed")?.unwrap_or(false))
        }
        (None, None, Some(constants)) => Reference::PowerLaw(constants),
        _ => {
            return Err(table.error_here("a check has a `value`, a `formula` or a `power_law`"));
        }
    };
    let accept = read_accept(&mut table)?;
    let needs_value = matches!(
        accept,
        Accept::Relative(_) | Accept::Absolute(_) | Accept::Sign
    );
    if needs_value && reference == Reference::Nothing {
        return Err(table.missing("value"));
    }
    let source = table.optional_str("source")?.unwrap_or_default().to_owned();
    let reason = match accept {
        Accept::Anything => table.optional_str("reason")?.unwrap_or_default(),
        _ => table.required_str("reason")?,
    }
    .to_owned();
    table.finish()?;
    Ok(Check {
        quantity,
        subject,
        place,
        reference,
        accept,
        source,
        reason,
    })
}

fn read_subject(table: &mut Table<'_>, study: &Study) -> Result<Subject, InputError> {
    if let Some(runs) = table.optional_strs("order")? {
        let runs = indices(table, "order", &runs, study)?;
        let [a, b, c] = runs[..] else {
            return Err(table.error("order", "an order of convergence needs three runs"));
        };
        return Ok(Subject::Order([a, b, c]));
    }
    if let Some(other) = table.optional_str("relative_to")? {
        let run = table.required_str("run")?;
        let run = indices(table, "run", &[run], study)?;
        let other = indices(table, "relative_to", &[other], study)?;
        return Ok(Subject::Change(run[0], other[0]));
    }
    let runs = match table.optional_strs("runs")? {
        Some(runs) => indices(table, "runs", &runs, study)?,
        None => (0..study.runs.len()).collect(),
    };
    Ok(Subject::Value(runs))
}

fn read_accept(table: &mut Table<'_>) -> Result<Accept, InputError> {
    let positive = Bounds::POSITIVE;
    let mut found = Vec::new();
    if let Some(limit) = table.optional_number("tolerance", positive)? {
        found.push(Accept::Relative(limit));
    }
    if let Some(limit) = table.optional_number("tolerance_absolute", positive)? {
        found.push(Accept::Absolute(limit));
    }
    if let Some(limit) = table.optional_number("at_most", positive)? {
        found.push(Accept::AtMost(limit));
    }
    if let Some(bounds) = table.optional_numbers("between", Bounds::ANY)? {
        let [low, high] = bounds[..] else {
            return Err(table.error("between", "`between` is [low, high]"));
        };
        found.push(Accept::Between(low, high));
    }
    if table.optional_bool("sign")? == Some(true) {
        found.push(Accept::Sign);
    }
    match found[..] {
        [] => Ok(Accept::Anything),
        [accept] => Ok(accept),
        _ => Err(table.error_here("a check has one tolerance")),
    }
}
