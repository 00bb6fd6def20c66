//! Reliefs that stand still in steady contacts, and maps.

use crate::common::near;
use std::path::Path;

use approx::assert_relative_eq;
use ertel::case::Case;
use ertel::contact::Symmetry;
use ertel::engine::{NoObserver, SolveError};
use ertel::run;
use ertel::solution::{Figure, Solution};

/// The contact of Mourier et al. 2006 without its cavity: 15 N, E' = 110 GPa, 12.5 mm, 0.09 m/s; half-width 136.7 µm.
fn case(motion: &str, folder: &Path, more: &str) -> Case {
    let text = format!(
        "[contact]\nkind = \"circular\"\nradius = \"12.5 mm\"\nload = \"15 N\"\n\
         [bodies]\nbody_1 = {{ youngs_modulus = \"100.1 GPa\", poissons_ratio = 0.3 }}\nbody_2 = {{ youngs_modulus = \"100.1 GPa\", poissons_ratio = 0.3 }}\n\
         [motion]\n{motion}\n[lubricant]\nname = \"mourier-oil\"\ntemperature = \"25 degC\"\n{more}"
    );
    Case::from_text("case.toml", &text, folder).unwrap()
}

const ROLLING: &str = "entrainment_speed = \"0.09 m/s\"\nslide_to_roll_ratio = 0.0";
const AT_REST: &str = "body_1_speed = \"0.18 m/s\"\nbody_2_speed = \"0 m/s\"";
const COARSE: &str = "[mesh]\ntarget_error = \"2 %\"\n";

fn solved(motion: &str, more: &str) -> Solution {
    run::solve(&case(motion, Path::new(""), more), &mut NoObserver).unwrap()
}

fn films(solution: &Solution) -> [f64; 2] {
    [Figure::FilmCentral, Figure::FilmMinimum]
        .map(|figure| 1e9 * solution.figure(figure).unwrap().value)
}

/// Waves of 50 nm and half a half-width whose crest is in the centre, along the motion and, on a body at rest, across it, compared with an independent
/// full-system finite-element computation of the same contacts: 213.4 and 120.6 nm without them, 172.5 and 114.2, 183.8 and 107.4. The central
/// films of all three are 0.35 % lower there, so their ratios to the smooth one are compared; the remaining difference is within the bars of both, 0.5 % each.
#[test]
fn stationary_waves_agree_with_finite_elements() {
    let smooth = films(&solved(ROLLING, COARSE));
    assert_relative_eq!(smooth[0], 213.4, max_relative = 1e-2);
    assert_relative_eq!(smooth[1], 120.6, max_relative = 2e-2);
    let waves = |direction: &str, place: &str| {
        format!(
            "{COARSE}[[surface]]\nkind = \"waves\"\nbody = \"body_2\"\nwavelength = \"68.35 um\"\namplitude = \"50 nm\"\ndirection = \"{direction}\"\n{place}\n"
        )
    };
    for (motion, more, expected) in [
        (
            ROLLING,
            waves("90 deg", "x = \"0 m\"\ny = \"1.367 mm\""),
            [172.5, 114.2],
        ),
        (AT_REST, waves("0 deg", "x = \"1.367 mm\""), [183.8, 107.4]),
    ] {
        let found = films(&solved(motion, &more));
        near(found[0] / smooth[0], expected[0] / 213.4, 1e-2);
        near(found[1] / smooth[1], expected[1] / 120.6, 2e-2);
    }
}

/// A map of the same waves gives the same films as their formula, up to its filter, which leaves exp(−ln 2 (λ_c/λ)²) of the amplitude; all of the
/// contact is solved for it, under all of its load.
#[test]
fn a_map_of_waves_is_waves() {
    let folder = tempfile::tempdir().unwrap();
    let n = 401;
    let spacing = 2.5;
    let lambda: f64 = 68.35;
    let row: Vec<String> = (0..n)
        .map(|i| {
            let x = spacing * (i as f64 - 200.0);
            format!(
                "{:.5}",
                50.0 * (2.0 * std::f64::consts::PI * x / lambda).cos()
            )
        })
        .collect();
    let row = row.join(" ") + "\n";
    std::fs::write(folder.path().join("waves.txt"), row.repeat(n)).unwrap();
    let map = format!(
        "{COARSE}[[surface]]\nkind = \"map\"\nbody = \"body_2\"\nfile = \"waves.txt\"\nspacing = \"{spacing} um\"\nheight_unit = \"nm\"\nlevel = \"none\"\n\
         low_pass = \"30 um\"\nx = \"0 m\"\n"
    );
    let map = case(AT_REST, folder.path(), &map);
    let problem = run::problem(&map);
    assert_eq!(problem.shape.symmetry, Symmetry::Full);
    assert_relative_eq!(problem.load, problem.shape.load(), max_relative = 1e-12);
    let left = 50.0 * (-std::f64::consts::LN_2 * (30.0 / lambda).powi(2)).exp();
    let echo = map.echo().surfaces;
    near(echo[0].filtered.sq, 1e-9 * left / 2.0_f64.sqrt(), 1e-2);
    let waves = format!(
        "{COARSE}[[surface]]\nkind = \"waves\"\nbody = \"body_2\"\nwavelength = \"{lambda} um\"\namplitude = \"{left} nm\"\nx = \"1.367 mm\"\n"
    );
    let of_map = films(&run::solve(&map, &mut NoObserver).unwrap());
    let of_waves = films(&solved(AT_REST, &waves));
    for (map, waves) in of_map.into_iter().zip(of_waves) {
        assert_relative_eq!(map, waves, max_relative = 5e-3);
    }
}

/// Too few unknowns for a relief are reported, and so is a moving relief without space.
#[test]
fn unresolved_reliefs_are_reported() {
    let waves = |length: &str, most: &str| {
        format!(
            "[mesh]\ntarget_error = \"5 %\"\nmax_unknowns = {most}\n[[surface]]\nkind = \"waves\"\nbody = \"body_2\"\nwavelength = \"{length}\"\namplitude = \"5 nm\"\n\
             x = \"1 mm\"\n"
        )
    };
    let fine = case(AT_REST, Path::new(""), &waves("5 um", "4000"));
    match run::solve(&fine, &mut NoObserver) {
        Err(error @ SolveError::ReliefNotResolved { .. }) => {
            assert!(error.advice().unwrap().contains("max_unknowns"));
        }
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("cells of 5 µm/16 in so few unknowns"),
    }
}
