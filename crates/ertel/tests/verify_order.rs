//! Observed order of the films of finite volumes on fixed grids: where cells are halved, differences of the central film fall by a factor of three or more (four at second
//! order), as long as the error is above 0.05 %.

use ertel::solution::Figure;

use crate::common::solved;
use crate::common::text::read;

/// Central films of all grids up to 40,000 unknowns, nm.
fn central_films(contact: &str, speed: &str) -> Vec<f64> {
    let mut case = read(format!(
        "[contact]\n{contact}\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n[motion]\nentrainment_speed = \"{speed}\"\nslide_to_roll_ratio = 0.0\n\
         [lubricant]\ntemperature = \"40 degC\"\ndensity = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}\n\
         viscosity = {{ law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"22 1/GPa\" }}\n\
         [mesh]\ntarget_error = \"0.02 %\"\nmax_unknowns = 40000\n[output]\nsensitivities = false\n"
    ));
    case.solver.method = Some(ertel::params::Method::FiniteVolumes);
    let levels = solved(&case).stats.levels;
    (levels.iter())
        .map(|level| 1e9 * level.figures.value(Figure::FilmCentral).unwrap())
        .collect()
}

/// Ratio of the last two differences.
fn ratio(films: &[f64]) -> f64 {
    let [.., a, b, c] = films else {
        panic!("{films:?}");
    };
    (b - a) / (c - b)
}

/// The main contact and an ellipse across the motion. With the limiter of van Albada et al. the ratio of the main contact is 1.6.
#[test]
fn central_films_are_of_second_order() {
    for (contact, speed) in [
        (
            "kind = \"circular\"\nradius = \"16 mm\"\nload = \"100 N\"",
            "0.8 m/s",
        ),
        (
            "kind = \"elliptical\"\nradius_x = \"4 mm\"\nradius_y = \"60 mm\"\nload = \"200 N\"",
            "2 m/s",
        ),
    ] {
        let films = central_films(contact, speed);
        let found = ratio(&films);
        assert!(
            found > 3.0 && found < 6.0,
            "{contact}: {found} of {films:?}"
        );
    }
}
