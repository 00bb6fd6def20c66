//! `ertel solve --cross-check`.

use tempfile::TempDir;

use crate::common::{code, contains, read, solve, stderr, stderr_of, stdout_of, write};

const CASE: &str = concat!(
    "[contact]\nkind = \"circular\"\nradius = \"16 mm\"\nload = \"30 N\"\n",
    "[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n",
    "[motion]\nentrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.05\n",
    "[lubricant]\nname = \"iso-vg-32-mineral\"\ntemperature = \"40 degC\"\n",
    "[mesh]\ntarget_error = 0.02\n"
);

/// Every figure in a table and a file, with both bars; the result folder stays one that may be replaced.
#[test]
fn both_methods_side_by_side() {
    let folder = TempDir::new().unwrap();
    write(&folder, "case.toml", CASE);
    for extra in ["", "--set solver.method=finite-elements"] {
        let arguments = format!("case.toml --cross-check -o out --accept-unresolved {extra}");
        let text = stdout_of(solve(&folder, &arguments), 0);
        contains(&text, "Cross-check by finite");
        contains(&text, "agree within the sum of both error bars, 0 differ");
        let table = read(&folder, "out/cross-check.csv");
        let head = table.lines().next().unwrap();
        let names = match extra.is_empty() {
            true => ["finite_volumes", "finite_elements"],
            false => ["finite_elements", "finite_volumes"],
        };
        let [own, other] = names;
        assert_eq!(
            head,
            format!("figure,unit,{own},{own}_bar,{other},{other}_bar,verdict")
        );
        let film = table
            .lines()
            .find(|l| l.starts_with("film_central,m,"))
            .unwrap();
        assert!(film.ends_with(",agrees"), "{film}");
    }
}

/// Cases that only one method solves are refused before any work, and so is a key without effect.
#[test]
fn refusals() {
    let folder = TempDir::new().unwrap();
    write(&folder, "case.toml", CASE);
    let roller = CASE.replace(
        "\"circular\"",
        "\"roller\"\nlength = \"8 mm\"\nprofile = { kind = \"crown\", crown_radius = \"1 m\" }",
    );
    // Temperatures within the bodies.
    write(
        &folder,
        "roller.toml",
        format!("{roller}[thermal]\nfield = true\n"),
    );
    let error = stderr_of(solve(&folder, "roller.toml --cross-check"), 2);
    contains(
        &error,
        "finite volumes find no temperatures within the bodies",
    );
    for (set, words) in [
        (
            "solver.tolerance=1e-6",
            "`tolerance` has no effect on finite volumes",
        ),
        (
            "mesh.pressure_order=2",
            "`pressure_order` has no effect on finite volumes",
        ),
    ] {
        let arguments = format!("case.toml --set solver.method=finite-volumes --set {set}");
        let error = stderr_of(solve(&folder, &arguments), 2);
        contains(&error, words);
    }
    let output = solve(&folder, "roller.toml --set solver.method=finite-volumes");
    code(&output, 2);
    contains(stderr(&output), "no temperatures within the bodies");
}
