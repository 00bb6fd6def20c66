//! Parts of the solver on problems of cases: stages, sides, sums of the shear, readings of figures, films of any engine.

mod engines;
mod figures_of_points;
mod shear;
mod sides;
mod stages;

/// A circular contact on a coarse mesh.
const CASE: &str = r#"
    [contact]
    kind = "circular"
    radius = "10 mm"
    load = "20 N"
    [bodies]
    body_1 = "steel"
    body_2 = "steel"
    [motion]
    entrainment_speed = "1 m/s"
    slide_to_roll_ratio = 0.0
    [lubricant]
    temperature = "40 degC"
    density = { law = "dowson-higginson", rho_0 = "870 kg/m^3" }
    viscosity = { law = "barus", mu_0 = "40 mPa.s", alpha = "10 1/GPa" }
    [mesh]
    preset = "coarse"
"#;
