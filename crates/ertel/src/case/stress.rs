//! `[stress]`: stresses in the bodies below the contact.

use std::path::Path;

use ertel_input::csv::{CsvError, CsvTable};
use ertel_input::file::{LARGEST_TABLE, read_text};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use crate::contact::Hertz;
use crate::stress::{Hardness, Residual, StressParams};
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length, pressure};

/// Depths, m.
const DEPTH: Bounds = Bounds::closed(1e-8, 1.0);
/// Depths of a table, from the surface on, m.
const TABLE_DEPTH: Bounds = Bounds::closed(0.0, 1.0);
/// Fatigue limits, Pa.
const LIMIT: Bounds = Bounds::closed(0.0, 1e10);
/// Residual stresses, Pa.
const RESIDUAL: Bounds = Bounds::closed(-2e10, 2e10);
/// Vickers hardness of metals.
const HARDNESS: Bounds = Bounds::closed(10.0, 2000.0);

/// Depths over the smaller half-width of the dry contact: the largest stresses of a dry contact lie above the first, planes are dense enough at the
/// surface up to the second.
const USUAL_DEPTH: [f64; 2] = [1.0, 30.0];
/// The same of cuts: grids of the stresses are coarser than the first, the largest orthogonal shear lies at 0.35 to 0.5.
const USUAL_CUT: [f64; 2] = [0.03, 0.35];
/// No shear of a dry contact exceeds this share of its pressure, by either criterion.
const LARGEST_SHEAR: f64 = 0.32;

/// Reads the section, whose files are in `folder`; `hertz`: the dry contact.
pub(super) fn read(
    table: Table<'_>,
    folder: &Path,
    hertz: &Hertz,
) -> Result<(StressParams, Vec<Warning>), InputError> {
    let params = read_params(table, folder)?;
    let warnings = warnings(&params, hertz);
    Ok((params, warnings))
}

/// Values that suit a contact badly.
fn warnings(params: &StressParams, hertz: &Hertz) -> Vec<Warning> {
    let smaller = (hertz.half_width_y).map_or(hertz.half_width, |b| b.min(hertz.half_width));
    let mut all = Vec::new();
    let mut ask = |key: &str, value: f64, [low, high]: [f64; 2], [few, many]: [&str; 2]| {
        let own = value / smaller;
        let (excess, why) = match own < low {
            true => (low / own, few),
            false => (own / high, many),
        };
        if excess > 1.0 {
            let text = format!(
                "stress.{key} = {} is {} of the smaller half-width of the dry contact, {}: {why}",
                length(value),
                digits(own, 2),
                length(smaller)
            );
            all.push(Warning::beyond(WarningKind::UnusualInput, excess, text));
        }
    };
    if let Some(depth) = params.depth {
        let why = [
            "the largest stresses may lie deeper",
            "the planes near the surface are far apart",
        ];
        ask("depth", depth, USUAL_DEPTH, why);
    }
    if let Some(cut) = params.cut_depth {
        let why = [
            "the surface decides over the lives, and the grid of the stresses is coarser",
            "the largest orthogonal shear lies less deep",
        ];
        ask("cut_depth", cut, USUAL_CUT, why);
    }
    let most = LARGEST_SHEAR * hertz.pressure;
    if params.fatigue_limit > most {
        let text = format!(
            "stress.fatigue_limit = {} exceeds all shear stresses of the dry contact, at most {}: lives are unlimited",
            pressure(params.fatigue_limit),
            pressure(most)
        );
        let excess = params.fatigue_limit / most;
        all.push(Warning::beyond(WarningKind::UnusualInput, excess, text));
    }
    all
}

fn read_params(mut table: Table<'_>, folder: &Path) -> Result<StressParams, InputError> {
    let usual = StressParams::default();
    let weight = Bounds::closed(0.0, 2.0);
    let depth = table.optional_quantity("depth", Dimension::LENGTH, DEPTH)?;
    let planes = table.optional_integer("planes", 10..=400)?;
    let cut_depth = table.optional_quantity("cut_depth", Dimension::LENGTH, DEPTH)?;
    if let (Some(depth), Some(cut)) = (depth, cut_depth)
        && 2.0 * cut >= depth
    {
        return Err(table.error(
            "cut_depth",
            "lives are computed from `cut_depth` and from twice that on: `depth` must be more",
        ));
    }
    let fatigue_limit = table.optional_quantity("fatigue_limit", Dimension::PRESSURE, LIMIT)?;
    let dang_van = table.optional_number("dang_van_weight", weight)?;
    let fatemi_socie = table.optional_number("fatemi_socie_weight", weight)?;
    let hardness = [
        hardness(&mut table, "body_1_hardness")?,
        hardness(&mut table, "body_2_hardness")?,
    ];
    let residual = [
        residual(&mut table, "body_1_residual_stress", folder)?,
        residual(&mut table, "body_2_residual_stress", folder)?,
    ];
    table.finish()?;
    Ok(StressParams {
        depth,
        planes: planes.map_or(usual.planes, |n| n as usize),
        cut_depth,
        fatigue_limit: fatigue_limit.unwrap_or(usual.fatigue_limit),
        dang_van: dang_van.unwrap_or(usual.dang_van),
        fatemi_socie: fatemi_socie.unwrap_or(usual.fatemi_socie),
        hardness,
        residual,
    })
}

/// A column over depth: its key, unit and limits.
type Over = (&'static str, Dimension, Bounds);

/// The depths of a table and columns over them.
fn over_depth<const N: usize>(
    table: &mut Table<'_>,
    columns: [Over; N],
) -> Result<(Vec<f64>, [Vec<f64>; N]), InputError> {
    let depths = table.required_quantities("depth", Dimension::LENGTH, TABLE_DEPTH)?;
    let mut all = [const { Vec::new() }; N];
    for (column, (key, dimension, bounds)) in all.iter_mut().zip(columns) {
        *column = table.required_quantities(key, dimension, bounds)?;
        if column.len() != depths.len() {
            let text = format!(
                "`{key}` needs as many values as `depth`: {}, not {}",
                depths.len(),
                column.len()
            );
            return Err(table.error(key, text));
        }
    }
    Ok((depths, all))
}

/// Residual stress over depth: a table, or a file with one.
fn residual(
    outer: &mut Table<'_>,
    key: &str,
    folder: &Path,
) -> Result<Option<Residual>, InputError> {
    let Some(mut table) = outer.optional_table(key)? else {
        return Ok(None);
    };
    let (points, at) = match table.optional_str("file")? {
        Some(file) => {
            let path = folder.join(file);
            let text = read_text(&path, LARGEST_TABLE)
                .map_err(|error| table.error("file", format!("{} {error}", path.display())))?;
            let points = residual_rows(file, &text).map_err(|error| {
                table.error("file", error.to_string()).with_help(
                    "residual stresses are a CSV table with columns of depth, along and across, each with its unit: depth_um, along_MPa, across_MPa",
                )
            })?;
            (points, "file")
        }
        None => {
            let stress = |key| (key, Dimension::PRESSURE, RESIDUAL);
            let (depths, [along, across]) =
                over_depth(&mut table, [stress("along"), stress("across")])?;
            let rows = depths.into_iter().zip(along.into_iter().zip(across));
            let points = rows.map(|(depth, (along, across))| [depth, along, across]);
            (points.collect(), "depth")
        }
    };
    let found = Residual::of_table(points).map_err(|text| table.error(at, text))?;
    table.finish()?;
    Ok(Some(found))
}

/// The rows of a CSV table of residual stress.
fn residual_rows(file: &str, text: &str) -> Result<Vec<[f64; 3]>, CsvError> {
    let csv = CsvTable::parse(file, text)?;
    let stress = Dimension::PRESSURE;
    let mut columns = Vec::new();
    for (name, dimension) in [
        ("depth", Dimension::LENGTH),
        ("along", stress),
        ("across", stress),
    ] {
        let found = csv.find_with_unit(name, dimension)?;
        columns.push(found.ok_or_else(|| {
            csv.error(
                csv.header(),
                0,
                format!("there is no column `{name}` with its unit"),
            )
        })?);
    }
    let mut rows = Vec::new();
    for row in csv.rows() {
        let mut values = [0.0; 3];
        let limits = [(TABLE_DEPTH, "m"), (RESIDUAL, "Pa"), (RESIDUAL, "Pa")];
        for (value, (column, (bounds, unit))) in values.iter_mut().zip(columns.iter().zip(limits)) {
            *value = csv.required_number(row, column)?;
            if !bounds.contains(*value) {
                let problem = format!("must be {}", bounds.describe(unit));
                return Err(csv.error(row, column.index, problem));
            }
        }
        rows.push(values);
    }
    Ok(rows)
}

/// Hardness over depth: one value, a table, or that of a case.
fn hardness(outer: &mut Table<'_>, key: &str) -> Result<Option<Hardness>, InputError> {
    let Some(mut table) = outer.optional_table(key)? else {
        return Ok(None);
    };
    if let Some(value) = table.optional_number("uniform", HARDNESS)? {
        table.finish()?;
        return Ok(Some(Hardness::uniform(value)));
    }
    let is_table = table.contains("depth") || table.contains("hardness");
    let (found, at) = if is_table {
        let column = ("hardness", Dimension::DIMENSIONLESS, HARDNESS);
        let (depths, [values]) = over_depth(&mut table, [column])?;
        let points = depths.into_iter().zip(values);
        let points = points.map(|(depth, value)| [depth, value]).collect();
        (Hardness::of_table(points), "hardness")
    } else {
        let surface = table.required_number("surface", HARDNESS).map_err(|error| {
            error.with_help(
                "surface = 700, core = 350 and case_depth = \"0.8 mm\"; or depth = [\"0 mm\", \"0.5 mm\", \"2 mm\"] and \
                 hardness = [720, 600, 350]; or uniform = 700 of through-hardened steel",
            )
        })?;
        let core = table.required_number("core", HARDNESS)?;
        let depth = table.required_quantity("case_depth", Dimension::LENGTH, DEPTH)?;
        (Hardness::of_case(surface, core, depth), "core")
    };
    let error = |text: &str| table.error(at, text);
    let found = found.map_err(error)?;
    table.finish()?;
    Ok(Some(found))
}

#[cfg(test)]
mod tests {
    use crate::case::Case;

    const CASE: &str = r#"
        contact = { kind = "line", radius = "10 mm", load = "100 kN/m" }
        bodies = { body_1 = "steel", body_2 = "steel" }
        motion = { entrainment_speed = "1 m/s", slide_to_roll_ratio = 0.1 }
        lubricant = { name = "squalane-pip", temperature = "40 degC" }
    "#;

    fn read(section: &str) -> Result<Case, String> {
        let text = format!("{CASE}\n[stress]\n{section}");
        Case::from_text("case.toml", &text, std::path::Path::new(""))
            .map_err(|error| error.to_string())
    }

    #[test]
    fn defaults_and_both_kinds_of_hardness() {
        let of = |section: &str| read(section).unwrap().stress.unwrap();
        assert_eq!(of(""), super::StressParams::default());
        let through = of("body_2_hardness = { uniform = 750 }").hardness;
        assert_eq!(through[1].as_ref().unwrap().at(2e-3), 750.0);
        let given = of(
            "depth = \"1 mm\"\nplanes = 80\nfatigue_limit = \"300 MPa\"\n\
             body_1_hardness = { surface = 700, core = 350, case_depth = \"0.8 mm\" }\n\
             body_2_hardness = { depth = [\"0 mm\", \"1 mm\"], hardness = [700, 350] }",
        );
        assert_eq!((given.depth, given.planes), (Some(1e-3), 80));
        let [one, two] = given.hardness.map(|hardness| hardness.unwrap().at(0.8e-3));
        assert!(
            (one - 550.0).abs() < 1.0 && (two - 420.0).abs() < 1e-9,
            "{one} {two}"
        );
    }

    const TABLE: &str = "body_2_residual_stress = { depth = [\"0 um\", \"100 um\", \"0.5 mm\"], along = [\"-800 MPa\", \"-400 MPa\", \"50 MPa\"], across = [\"-600 MPa\", \"-300 MPa\", \"0 MPa\"] }";

    /// A table in the case and the same in a file; linear between the depths.
    #[test]
    fn residual_stress() {
        let params = read(TABLE).unwrap().stress.unwrap();
        let [None, Some(residual)] = &params.residual else {
            panic!("{params:?}");
        };
        let [along, across, ..] = residual.at(50e-6, true).0;
        assert!((along + 600e6).abs() < 1.0 && (across + 450e6).abs() < 1.0);
        assert_eq!(residual.at(1e-3, true).0[0], 50e6);
        let folder = tempfile::tempdir().unwrap();
        let table = "depth_um,along_MPa,across_MPa\n0,-800,-600\n100,-400,-300\n500,50,0\n";
        std::fs::write(folder.path().join("peened.csv"), table).unwrap();
        let of_file = |text: &str| {
            let text =
                format!("{CASE}\n[stress]\nbody_2_residual_stress = {{ file = \"{text}\" }}");
            Case::from_text("case.toml", &text, folder.path())
        };
        let found = of_file("peened.csv").unwrap().stress.unwrap();
        for depth in [0.0, 30e-6, 0.2e-3, 2e-3] {
            let [one, other] = [&found, &params]
                .map(|params| params.residual[1].as_ref().unwrap().at(depth, true));
            assert!((one.0[0] - other.0[0]).abs() < 1.0 && (one.0[1] - other.0[1]).abs() < 1.0);
        }
        for (table, words) in [
            ("depth_um,along_MPa\n0,-800\n100,0\n", "across"),
            (
                "depth_um,along_MPa,across_MPa\n0,-800,nan\n100,0,0\n",
                "bad.csv:2:3: across",
            ),
            (
                "depth_um,along_MPa,across_MPa\n0,-800,-1e6\n100,0,0\n",
                "must be",
            ),
            (
                "depth_um,along_MPa,across_MPa\n100,-800,-600\n0,0,0\n",
                "ascend",
            ),
        ] {
            std::fs::write(folder.path().join("bad.csv"), table).unwrap();
            let error = of_file("bad.csv").unwrap_err().to_string();
            assert!(error.contains(words), "{error}");
        }
    }

    /// Other ones are among the bad cases of the command.
    #[test]
    fn refused() {
        for (section, expected) in [
            ("body_1_hardness = { uniform = 5 }", "must be between"),
            ("body_1_hardness = { uniform = 700, core = 350 }", "core"),
            (
                "body_1_hardness = { depth = [\"0 mm\"], hardness = [700] }",
                "`uniform`",
            ),
            ("depth = \"1 um\"\ncut_depth = \"1 um\"", "must be more"),
            (
                "body_1_hardness = { surface = 300, core = 350, case_depth = \"1 mm\" }",
                "fall to a core value",
            ),
            (
                "body_1_hardness = { depth = [\"0 mm\"], hardness = [350, 700] }",
                "as many values",
            ),
            ("body_1_hardness = {}", "surface"),
            ("body_1_residual_stress = {}", "depth"),
            (&TABLE.replace("\"0 um\"", "\"200 um\""), "ascend"),
            (&TABLE.replace("\"-600 MPa\", ", ""), "as many values"),
            (&TABLE.replace("-600 MPa", "-600 GPa"), "must be between"),
            (&TABLE.replace("\"-600 MPa\"", "nan"), "across"),
            (
                "body_1_residual_stress = { file = \"none.csv\" }",
                "none.csv",
            ),
        ] {
            let error = read(section).unwrap_err();
            assert!(error.contains(expected), "{error}");
        }
    }

    /// By hand: steel of 10 mm under 100 kN/m has a half-width of 105 µm and 606 MPa.
    #[test]
    fn values_that_suit_the_contact_badly_are_asked_about() {
        for (section, words) in [
            ("depth = \"50 um\"", "may lie deeper"),
            ("depth = \"5 mm\"", "far apart"),
            ("cut_depth = \"50 um\"", "lies less deep"),
            ("cut_depth = \"1 um\"", "the surface decides"),
            ("fatigue_limit = \"250 MPa\"", "unlimited"),
        ] {
            let warnings = read(section).unwrap().warnings;
            assert!(
                warnings.iter().any(|w| w.text.contains(words)),
                "{warnings:?}"
            );
        }
        let usual = read("depth = \"0.3 mm\"\ncut_depth = \"10 um\"\nfatigue_limit = \"100 MPa\"");
        let asked = |w: &crate::warning::Warning| w.text.contains("stress.");
        assert!(!usual.unwrap().warnings.iter().any(asked));
    }
}
