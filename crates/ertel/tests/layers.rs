//! Contacts with layers: the limits of equal materials, the pressure of the dry contact, and heat.

use std::path::Path;

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::run;
use ertel::solution::{Figure, Solution};

fn case(kind: &str, load: &str, layers: &str) -> Case {
    let text = format!(
        "[contact]\nkind = \"{kind}\"\nradius = \"10 mm\"\nload = \"{load}\"\n\
         [bodies]\nbody_1 = {{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3{layers} }}\n\
         body_2 = {{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }}\n\
         [motion]\nentrainment_speed = \"0.05 m/s\"\nslide_to_roll_ratio = 0.0\n\
         [lubricant]\ntemperature = \"40 degC\"\n\
         density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}\n\
         viscosity = {{ law = \"roelands\", mu_0 = \"40 mPa.s\", alpha = \"15 1/GPa\" }}\n\
         [mesh]\ntarget_error = \"2 %\"\n[solver]\nmethod = \"finite-volumes\"\n"
    );
    Case::from_text("case.toml", &text, Path::new("")).unwrap()
}

fn solved(kind: &str, load: &str, layers: &str) -> Solution {
    run::solve(&case(kind, load, layers), &mut NoObserver).unwrap()
}

fn value(solution: &Solution, figure: Figure) -> f64 {
    solution.figure(figure).unwrap().value
}

/// A layer of the material of its body changes nothing.
#[test]
fn layers_of_the_same_material() {
    let layer = ", layers = [{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, thickness = \"20 um\" }]";
    for (kind, load) in [("circular", "20 N"), ("line", "50 kN/m")] {
        let [bare, layered] = ["", layer].map(|layers| solved(kind, load, layers));
        for figure in [Figure::FilmCentral, Figure::FilmMinimum] {
            let ratio = value(&layered, figure) / value(&bare, figure);
            assert!((ratio - 1.0).abs() < 1e-5, "{kind} {ratio}");
        }
    }
}

/// A soft layer of a fiftieth of the modulus, ν = 0.4 and a tenth of the half-width lowers the dry pressure to 0.646 781 2 of Hertz's by a Fredholm equation; a
/// slow film is close to the dry contact.
#[test]
fn pressure_on_a_soft_layer() {
    let half_width = case("circular", "20 N", "").hertz().half_width;
    let layer = format!(
        ", layers = [{{ youngs_modulus = \"4.2 GPa\", poissons_ratio = 0.4, thickness = \"{} um\" }}]",
        1e6 * 0.1 * half_width
    );
    let solution = solved("circular", "20 N", &layer);
    let bare = case("circular", "20 N", "").hertz();
    let share = value(&solution, Figure::PressureCentral) / bare.pressure;
    assert!((share / 0.646_781_2 - 1.0).abs() < 0.02, "{share}");
    // The scales of the contact are those of the wider contact, which the same equation has.
    let wider = solution.hertz.half_width / bare.half_width;
    assert!((wider / 1.390_375 - 1.0).abs() < 0.05, "{wider}");
}

const COAT: &str = "youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, thickness = \"3 um\"";
const STEEL: &str = "density = \"7850 kg/m^3\", thermal_conductivity = \"46 W/(m.K)\", heat_capacity = \"470 J/(kg.K)\"";

/// Sliding with heat; the coating has the elastic constants of the bodies.
fn warm_text(kind: &str, load: &str, coat: &str) -> String {
    format!(
        "[contact]\nkind = \"{kind}\"\nradius = \"10 mm\"\nload = \"{load}\"\n\
         [bodies]\nbody_1 = {{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, {STEEL}{coat} }}\n\
         body_2 = {{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, {STEEL} }}\n\
         [motion]\nentrainment_speed = \"2 m/s\"\nslide_to_roll_ratio = 0.3\n\
         [lubricant]\nname = \"iso-vg-68-pao\"\ntemperature = \"60 degC\"\n\
         [mesh]\ntarget_error = \"2 %\"\n[solver]\nmethod = \"finite-volumes\"\n[thermal]\n"
    )
}

fn warm(kind: &str, load: &str, coat: &str) -> Solution {
    let case = Case::from_text("case.toml", &warm_text(kind, load, coat), Path::new("")).unwrap();
    run::solve(&case, &mut NoObserver).unwrap()
}

/// A coating of the same material leaves heat unchanged; one that insulates warms the film and lowers its friction, most of all on the coated side.
#[test]
fn coats_with_heat() {
    for (kind, load) in [("circular", "5 N"), ("line", "30 kN/m")] {
        let of = |data: &str| warm(kind, load, &format!(", layers = [{{ {COAT}, {data} }}]"));
        let bare = warm(kind, load, "");
        let same = of(STEEL);
        let insulated = of(
            "density = \"2000 kg/m^3\", thermal_conductivity = \"1 W/(m.K)\", heat_capacity = \"700 J/(kg.K)\"",
        );
        for figure in [
            Figure::FilmCentral,
            Figure::TractionCoefficient,
            Figure::FilmTemperatureMaximum,
        ] {
            let ratio = value(&same, figure) / value(&bare, figure);
            assert!((ratio - 1.0).abs() < 2e-4, "{kind} {figure:?} {ratio}");
        }
        let rise = |solution: &Solution, figure| value(solution, figure) - 333.15;
        let wall = Figure::TemperatureBody1Mean;
        assert!(rise(&insulated, wall) > 2.0 * rise(&bare, wall), "{kind}");
        assert!(
            value(&insulated, Figure::TractionCoefficient)
                < value(&bare, Figure::TractionCoefficient)
        );
        // Into the coated body flows less.
        let heat = |solution: &Solution| {
            value(solution, Figure::HeatToBody1) / value(solution, Figure::HeatToBody2)
        };
        assert!(heat(&insulated) < heat(&bare), "{kind}");
    }
}

#[test]
fn coats_that_lack_thermal_data() {
    let text = warm_text(
        "circular",
        "5 N",
        &format!(", layers = [{{ {COAT}, density = \"2000 kg/m^3\" }}]"),
    );
    let error = Case::from_text("case.toml", &text, Path::new(""))
        .unwrap_err()
        .to_string();
    assert!(error.contains("the thermal_conductivity of the layers of body 1, the heat_capacity of the layers of body 1"), "{error}");
}
