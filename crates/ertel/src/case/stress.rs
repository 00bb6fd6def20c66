//! `[stress]`: stresses in the bodies below the contact.

use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

use crate::contact::Hertz;
use crate::stress::{Hardness, StressParams};
use crate::warning::{Warning, WarningKind};
use crate::words::{digits, length, pressure};

/// Depths, m.
const DEPTH: Bounds = Bounds::closed(1e-8, 1.0);
/// Depths of a table, from the surface on, m.
const TABLE_DEPTH: Bounds = Bounds::closed(0.0, 1.0);
/// Fatigue limits, Pa.
const LIMIT: Bounds = Bounds::closed(0.0, 1e10);
/// Vickers hardness of metals.
const HARDNESS: Bounds = Bounds::closed(10.0, 2000.0);

/// Depths over the smaller half-width of the dry contact: the largest stresses of a dry contact lie above the first, planes are dense enough at the
/// surface up to the second.
const USUAL_DEPTH: [f64; 2] = [1.0, 30.0];
/// The same of cuts: grids of the stresses are coarser than the first, the largest orthogonal shear lies at 0.35 to 0.5.
const USUAL_CUT: [f64; 2] = [0.03, 0.35];
/// No shear of a dry contact exceeds this share of its pressure, by either criterion.
const LARGEST_SHEAR: f64 = 0.32;

/// Reads the section; `hertz`: the dry contact.
pub(super) fn read(
    table: Table<'_>,
    hertz: &Hertz,
) -> Result<(StressParams, Vec<Warning>), InputError> {
    let params = read_params(table)?;
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

fn read_params(mut table: Table<'_>) -> Result<StressParams, InputError> {
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
    table.finish()?;
    Ok(StressParams {
        depth,
        planes: planes.map_or(usual.planes, |n| n as usize),
        cut_depth,
        fatigue_limit: fatigue_limit.unwrap_or(usual.fatigue_limit),
        dang_van: dang_van.unwrap_or(usual.dang_van),
        fatemi_socie: fatemi_socie.unwrap_or(usual.fatemi_socie),
        hardness,
    })
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
        let depths = table.required_quantities("depth", Dimension::LENGTH, TABLE_DEPTH)?;
        let values = table.required_numbers("hardness", HARDNESS)?;
        if depths.len() != values.len() {
            let text = format!(
                "`hardness` needs as many values as `depth`: {}, not {}",
                depths.len(),
                values.len()
            );
            return Err(table.error("hardness", text));
        }
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
