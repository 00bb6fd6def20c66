//! `ertel fit` end to end: report, entry, picture, and exit codes.

use std::path::Path;

use crate::common::{code, contains, copy, ertel, read, root, stderr_of, stdout_of, text, write};

/// Published viscosities.
const FLUID_A: &str = "../../validation/appendix-c/fluid-a.csv";

/// The entry goes into a case file's lubricant and passes the check.
#[test]
fn an_entry_serves_in_a_case_file() {
    let folder = tempfile::tempdir().unwrap();
    copy(FLUID_A, &folder, "fluid-a.csv");
    let output = ertel(
        &folder,
        "fit viscosity fluid-a.csv --law cheng --hold 'mu_0=0.465 mPa.s' --reference-temperature '24.5 degC' \
         --absolute --source habchi2008 -v -o a.toml",
    );
    code(&output, 0);
    let report = text(&output.stdout);
    // 23 states, and what Gauss-Newton steps in another program give: β = 1397.93 K
    contains(report, "23 states");
    contains(report, "1397.9 K");
    let svg = read(&folder, "a.svg");
    assert!(svg.contains("<svg") && svg.contains("24.5"));

    let written = read(&folder, "a.toml");
    contains(&written, "source = \"habchi2008\"");
    assert!(written.contains("temperature = [\"257.15 K\", \"297.65 K\"]"));
    let section = written.split("[viscosity]").nth(1).unwrap();
    let quick = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good/quick.toml");
    let case = std::fs::read_to_string(quick).unwrap();
    let lines = case.lines().filter(|line| !line.starts_with("viscosity"));
    let case = lines.collect::<Vec<_>>().join("\n") + "\n[lubricant.viscosity]" + section;
    write(&folder, "case.toml", case);
    let output = ertel(&folder, "solve --check case.toml");
    code(&output, 0);
}

#[test]
fn bad_data_and_usage_exit_with_2() {
    let folder = tempfile::tempdir().unwrap();
    let bad = "pressure_MPa,temperature_K,viscosity_mPa_s\n1,300,x\n";
    write(&folder, "bad.csv", bad);
    copy(FLUID_A, &folder, "good.csv");
    for (arguments, part) in [
        ("bad.csv --law cheng", "bad.csv:2:3"),
        ("none.csv --law cheng", "cannot be read"),
        (
            "good.csv --law tait",
            "cheng, roelands, wlf, yasutomi, doolittle, barus, mcewen, paluch, mcewen-paluch",
        ),
        ("good.csv --law doolittle", "--density"),
        (
            "good.csv --law doolittle --density r123",
            "`tait` is needed",
        ),
        (
            "good.csv --law cheng --hold delta=1",
            "mu_0, alpha, beta, gamma",
        ),
        ("good.csv --law cheng --hold 'beta=1 MPa'", "temperature"),
        ("good.csv --law cheng --confidence 1.5", "confidence"),
        ("good.csv --law cheng --plot x.jpg", ".svg, .pdf"),
        (
            "good.csv --law all --hold 'mu_0=1 Pa.s'",
            "instead of `all` in --law",
        ),
    ] {
        let output = ertel(&folder, &format!("fit viscosity {arguments}"));
        let error = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
        assert!(error.contains(part), "{arguments:?}: {error}");
    }
}

/// Films made by a formula deviate from it by nothing, and from half of it by half.
#[test]
fn films_are_compared_with_given_formulas() {
    let folder = tempfile::tempdir().unwrap();
    let mut rows =
        String::from("note,radius_m,speed_group,moes_load,moes_material,film_central_m\n");
    for (m, l) in [(50.0f64, 0.1f64), (200.0, 0.1), (50.0, 0.3), (900.0, 0.2)] {
        let film = 2.2318 * 0.0127 * (2e-12f64).sqrt() * m.powf(-0.1362) * l.powf(0.0198);
        rows += &format!("\"a, b\",0.0127,1e-12,{m},{l},{film:e}\n");
    }
    write(&folder, "films.csv", rows);
    let fit = |formula: &str| ertel(&folder, &format!("fit film films.csv --given {formula}"));
    let report = stdout_of(fit("central=2.2318,-0.1362,0.0198"), 0);
    assert!(
        report.contains("deviates by -0.00 to +0.00 %")
            || report.contains("deviates by +0.00 to +0.00 %"),
        "{report}"
    );
    let output = fit("central=1.1159,-0.1362,0.0198");
    contains(text(&output.stdout), "deviates by -50.00 to -50.00 %");
    for bad in [
        "1.96,0,0",
        "middle=1,0,0",
        "central=1,0",
        "central=-1,0,0",
        "central=1,x,0",
        // of films that the table does not have
        "minimum=1,0,0",
    ] {
        let output = fit(bad);
        assert_eq!(output.status.code(), Some(2), "{bad}");
        assert!(text(&output.stderr).contains("--given"), "{bad}");
    }
}

/// The films of chapter 6 as they are kept (docs/studies/ultra-low-viscosity.md) lie by the formulas of Habchi 2008, eq.
/// 6.4, for the fluid that is specified in full: the central ones within 1 %, the minimum ones within 7 %.
#[test]
fn films_of_chapter_6_lie_by_its_formulas() {
    let output = ertel(
        root(),
        "fit film studies/chapter-6/results/fluid-c-speeds.csv \
         --given central=2.2318,-0.1362,0.0198 --given minimum=2.6759,-0.2525,0.0297",
    );
    let report = text(&output.stdout);
    let limits = report
        .lines()
        .filter_map(|l| Some(l.split_once("deviates by ")?.1.split_once(" %")?.0))
        .map(|range| {
            let (low, high) = range.split_once(" to ").unwrap();
            let size = |v: &str| v.parse::<f64>().unwrap().abs();
            size(low).max(size(high))
        });
    let limits: Vec<f64> = limits.collect();
    assert!(
        limits.len() == 2 && limits[0] < 1.0 && limits[1] < 7.0,
        "{report}"
    );
    // Its constants lie within the intervals of ours, widened by the error bars of the films.
    let widened: Vec<[f64; 2]> = (report.lines())
        .filter(|l| ["c", "a", "b"].contains(&l.split_whitespace().next().unwrap_or_default()))
        .map(|l| {
            let words: Vec<&str> = l.split_whitespace().collect();
            let end = |i: usize| words[words.len() - i].parse().unwrap();
            [end(3), end(1)]
        })
        .collect();
    let published = [2.2318, -0.1362, 0.0198, 2.6759, -0.2525, 0.0297];
    assert_eq!(widened.len(), published.len(), "{report}");
    for ([low, high], constant) in widened.iter().zip(published) {
        assert!(low < &constant && &constant < high, "{constant}: {report}");
    }
}

/// The ellipses of docs/studies/ellipses.md: every point of the study is a valid case, and the formula that the page gives is the one
/// that its command fits to the table.
#[test]
fn ellipses_have_the_formula_of_their_page() {
    let study = root().join("studies/ellipses");
    let output = ertel(&study, "sweep ellipses.toml --dry-run");
    code(&output, 0);
    let points = text(&output.stdout)
        .lines()
        .filter(|l| l.contains("contact.entrainment_angle ="));
    assert_eq!(points.count(), 100);
    let page = std::fs::read_to_string(root().join("docs/studies/ellipses.md")).unwrap();
    // Limits of the root mean square deviation of the central and the minimum film, %.
    for (name, limits) in [("ellipses", [10.0, 16.0]), ("ellipses-wide", [5.1, 14.0])] {
        let fit = format!("fit film results/{name}.csv --form elliptical");
        let output = ertel(&study, &fit);
        code(&output, 0);
        let report = text(&output.stdout);
        let of = |start: &str| -> Vec<&str> {
            let lines = report.lines();
            let values = lines.filter_map(|l| Some(l.trim().strip_prefix(start)?.trim()));
            values.collect()
        };
        assert_eq!(of("text ").len(), 2, "{report}");
        for formula in of("text ") {
            contains(&page, formula);
        }
        for (rms, limit) in of("deviation, rms").into_iter().zip(limits) {
            let rms: f64 = rms.trim_end_matches(" %").parse().unwrap();
            assert!(rms < limit, "{name}: {rms}");
        }
    }
    let output = ertel(&study, "fit film results/ellipses.csv --form moes");
    let warnings = text(&output.stderr);
    contains(warnings, "the ellipses differ, R_y/R_x");
}

/// The title of a column is shown, not obeyed, where a warning quotes it.
#[test]
fn warnings_show_control_characters_of_titles() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (1..=5)
        .map(|i| format!("{i},{},{}e-9\n", 40 + i, 100 * i))
        .collect();
    let head = "entrainment_speed_m_per_s,temperature\u{b}[degC],film_central_m\n";
    write(&folder, "films.csv", head.to_owned() + &rows);
    let output = ertel(&folder, "fit film films.csv --form speed");
    let warning = text(&output.stderr);
    contains(warning, "(temperature\\u000b[degC])");
}

/// The laws are ranked by the isotherms that they were not fitted to, and the best one is written.
#[test]
fn all_laws_are_ranked() {
    let folder = tempfile::tempdir().unwrap();
    copy(FLUID_A, &folder, "fluid-a.csv");
    let arguments = "fit viscosity fluid-a.csv --law all -o oil.toml";
    let report = stdout_of(ertel(&folder, arguments), 0);
    for words in [
        "isotherm left out",
        "Not ranked",
        "no temperature dependence; cannot be ranked",
        "equation of state",
        "cheng",
        "wlf",
    ] {
        contains(&report, words);
    }
    let best = report
        .lines()
        .skip_while(|l| !l.contains("isotherm left out") || l.starts_with("Cross-validation"))
        .nth(1)
        .unwrap();
    let best = best.split_whitespace().next().unwrap();
    contains(&read(&folder, "oil.toml"), &format!("law = \"{best}\""));
    // One isotherm says nothing about others.
    let isotherm =
        "pressure_MPa,temperature_K,viscosity_mPa_s\n0,300,10\n50,300,20\n100,300,40\n150,300,90\n";
    write(&folder, "isotherm.csv", isotherm);
    let output = ertel(&folder, "fit viscosity isotherm.csv --law all");
    code(&output, 2);
    contains(text(&output.stderr), "at least 3 isotherms");
}

/// A viscosity that falls with pressure is reported, and refused by `--strict`, with the entry written.
#[test]
fn implausible_constants_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let entry = folder.path().join("odd.toml");
    let odd = "pressure_MPa,temperature_K,viscosity_mPa_s\n0,300,100\n100,300,400\n200,300,150\n300,300,3000\n400,300,900\n";
    write(&folder, "odd.csv", odd);
    let arguments = "fit viscosity odd.csv --law barus -o odd.toml";
    let error = stderr_of(ertel(&folder, arguments), 0);
    contains(
        &error,
        "warning: the law `barus` does not describe the data",
    );
    for suffix in ["toml", "svg"] {
        std::fs::remove_file(entry.with_extension(suffix)).unwrap();
    }
    let error = stderr_of(ertel(&folder, &format!("{arguments} --strict")), 3);
    contains(&error, "is implausible");
    assert!(entry.is_file());
    // Measurements that rise with temperature.
    let hot = "pressure_MPa,temperature_K,viscosity_mPa_s\n0,300,10\n100,300,40\n200,300,160\n0,320,20\n100,320,80\n200,320,320\n0,340,38\n100,340,150\n200,340,600\n";
    write(&folder, "odd.csv", hot);
    let output = ertel(&folder, "fit viscosity odd.csv --law cheng --strict");
    code(&output, 3);
    contains(text(&output.stderr), "rises with temperature");
}

/// A data sheet, as one finds it: temperatures and kinematic viscosities, without pressures; the entry goes into a case as it is.
#[test]
fn a_table_of_a_data_sheet_becomes_a_lubricant() {
    let folder = tempfile::tempdir().unwrap();
    // lg lg(ν + 0.7) = 9.417992554 - 3.684441498 lg T: 46 mm²/s at 40 degC and 6.8 at 100.
    let table = "Temperature [°C],Kinematic viscosity [mm²/s]\n20,133.8382\n40,46.0000\n60,20.6227\n80,11.1026\n100,6.8000\n";
    write(&folder, "sheet.csv", table);
    let density = "density_15 = \"870 kg/m^3\"\nbase_oil = \"mineral\"\n";
    write(&folder, "density.toml", density);
    let fit = |more: &str| {
        let walther = "fit viscosity sheet.csv --law walther";
        ertel(&folder, &format!("{walther} {more}"))
    };
    let with = "--density density.toml";
    let hold = "--hold 'alpha=22 1/GPa'";
    let at = "--reference-temperature '40 degC'";
    for (more, words) in [
        (String::new(), "--density"),
        (with.to_owned(), "--hold \"alpha=22 1/GPa\""),
        (format!("{with} {hold}"), "--reference-temperature"),
        (
            format!("{with} --hold 'alpha=-1 1/GPa' {at}"),
            "the value of a fixed constant is not allowed",
        ),
    ] {
        let output = fit(&more);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {message}");
        assert!(message.contains(words), "{more:?}: {message}");
    }
    let output = fit(&format!("{with} {hold} {at} -o oil.toml"));
    let message = text(&output.stderr);
    code(&output, 0);
    contains(message, "all states count as measured at ambient pressure");
    contains(
        message,
        "multiplied by the density of the law dowson-higginson",
    );
    contains(text(&output.stdout), "22 1/GPa");
    assert!(folder.path().join("oil.svg").exists());

    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/data-sheet-oil.toml");
    let case = std::fs::read_to_string(shipped).unwrap();
    let own = "temperature = \"40 degC\"\nname = \"oil.toml\"\n";
    let head = case.split("[lubricant]").next().unwrap();
    write(&folder, "case.toml", format!("{head}[lubricant]\n{own}"));
    let sheet = "temperature = \"40 degC\"\nkinematic_viscosity_40 = \"46 cSt\"\nkinematic_viscosity_100 = \"6.8 cSt\"\n\
                 pressure_viscosity_coefficient = \"22 1/GPa\"\n";
    let sheet = format!("{head}[lubricant]\n{sheet}{density}");
    write(&folder, "sheet.toml", sheet);
    let film = |case: &str| {
        let output = ertel(&folder, &format!("estimate {case} --json"));
        code(&output, 0);
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        json["film"]["film_central"].as_f64().unwrap()
    };
    let (fitted, given) = (film("case.toml"), film("sheet.toml"));
    assert!((fitted / given - 1.0).abs() < 1e-4, "{fitted} {given}");
}
