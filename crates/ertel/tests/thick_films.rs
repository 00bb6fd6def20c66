//! Films thicker than the dry contact is deep, around bodies that hardly deflect, with the motion at an angle.

use crate::common::text::read;
use ertel::engine::NoObserver;
use ertel::run::solve;
use ertel::solution::Estimate;

/// A body on a plane, by finite elements: its central film, m, for an incompressible oil of one viscosity.
fn film(contact: &str, mesh: &str) -> Estimate {
    let text = format!(
        "[contact]\n{contact}\nload = \"0.05 N\"\n\
         [bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
         [motion]\nentrainment_speed = \"0.05 m/s\"\nslide_to_roll_ratio = 0.0\n\
         [lubricant]\ntemperature = \"60 degC\"\ndensity = {{ law = \"constant\", rho_0 = \"860 kg/m^3\" }}\n\
         viscosity = {{ law = \"constant\", mu_0 = \"20 mPa.s\" }}\n\
         [solver]\nmethod = \"finite-elements\"\n[mesh]\ntarget_error = \"0.2 %\"\n{mesh}\n[output]\nsensitivities = false\n"
    );
    let case = read(&text);
    solve(&case, &mut NoObserver).unwrap().summary.film_central
}

/// Bodies all but round have the film of a ball whatever the angle: that of 3 a²/R, with the outlet edge of the ball set as far as theirs. With a
/// penalty of one size everywhere the film at 45 degrees was 6 % too thin.
#[test]
fn all_but_round_is_a_ball_at_any_angle() {
    let circle = "kind = \"circular\"\nradius = \"10 mm\"";
    let ball = film(circle, "outlet = 100.0");
    for degrees in [20.0, 45.0, 70.0, 90.0] {
        let turned = film(
            &format!(
                "kind = \"elliptical\"\nradius_x = \"10 mm\"\nradius_y = \"10.01 mm\"\nentrainment_angle = \"{degrees} deg\""
            ),
            "",
        );
        println!("{degrees}: {turned:?}, {ball:?}");
        // A rigid film is proportional to R^3 (Kapitza 1955): by a per mille of one of two radii it differs by 1.5 per mille.
        let bar = turned.error.unwrap() + ball.error.unwrap() + 1.5e-3 * ball.value;
        assert!((turned.value - ball.value).abs() < bar, "{degrees}");
    }
}
