use std::path::Path;

use crate::near::near;
use approx::assert_relative_eq;
use ertel_input::InputError;

use super::Case;
use crate::contains::contains;
use crate::params::{ElasticModel, Formulation, LinearSolver, MeshPreset, PenaltyScaling};

const STEEL: &str = concat!(
    "\ntitle = \"Steel ball on steel disc\"\n",
    include_str!("../../tests/common/cases/ball.toml")
);

fn read(text: &str) -> Result<Case, InputError> {
    Case::from_text("steel.toml", text, Path::new(""))
}

fn with(old: &str, new: &str) -> Result<Case, InputError> {
    assert!(STEEL.contains(old), "{old}");
    read(&STEEL.replacen(old, new, 1))
}

fn message(result: Result<Case, InputError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn the_case_of_the_thesis_in_si() {
    let case = read(STEEL).unwrap();
    assert_eq!(case.title, "Steel ball on steel disc");
    assert_eq!(case.contact.radius_y, case.contact.radius);
    assert_eq!((case.contact.radius, case.contact.load), (0.016, 100.0));
    for body in [&case.body_1, &case.body_2] {
        assert_eq!(body.elasticity.youngs_modulus, 210e9);
        assert_eq!(body.elasticity.poissons_ratio, 0.3);
    }
    assert_eq!(case.body_1.name, "steel");
    assert_eq!(case.motion.entrainment_speed, 0.8);
    let lubricant = &case.lubricant;
    assert_eq!(lubricant.temperature, 313.15);
    let ambient = lubricant.viscosity.viscosity(0.0, lubricant.temperature);
    assert_relative_eq!(ambient, 0.04, max_relative = 1e-12);
    let density = lubricant.density.density(0.0, lubricant.temperature);
    assert_relative_eq!(density, 870.0, max_relative = 1e-12);
    // Hertz figures of an independent script: a = 218.279 um, p_h = 1.00212 GPa.
    assert_relative_eq!(case.hertz().half_width, 218.279e-6, max_relative = 1e-5);
    assert_relative_eq!(case.hertz().pressure, 1.00212e9, max_relative = 1e-5);
    assert!(case.warnings.is_empty(), "{:?}", case.warnings);
    assert_eq!(case.source, STEEL);
}

#[test]
fn a_line_contact_has_a_load_per_length() {
    let text = STEEL.replace("circular", "line");
    let line = text.replace("\"100 N\"", "\"0.2 kN/mm\"");
    let case = read(&line).unwrap();
    assert!(case.contact.kind.is_line());
    assert_relative_eq!(case.contact.load, 2e5, max_relative = 1e-15);
    assert!(message(read(&text)).contains("needs a force per length"));
    assert!(message(read(&format!("{line}\n[mesh]\nside = 4"))).contains("line contact has none"));
}

#[test]
fn a_hertz_pressure_stands_for_the_load() {
    for pressure in ["1 kPa", "0.5 GPa", "5 GPa"] {
        let case = with(
            "load = \"100 N\"",
            &format!("hertz_pressure = \"{pressure}\""),
        )
        .unwrap();
        let expected = match pressure {
            "1 kPa" => 1e3,
            "0.5 GPa" => 5e8,
            _ => 5e9,
        };
        assert_relative_eq!(case.hertz().pressure, expected, max_relative = 1e-12);
    }
}

#[test]
fn surface_speeds_stand_for_entrainment_and_slide_to_roll() {
    let case = with(
        "entrainment_speed = \"0.8 m/s\"\nslide_to_roll_ratio = 0.0",
        "body_2_speed = \"1.2 m/s\"\nbody_1_speed = \"800 mm/s\"",
    )
    .unwrap();
    assert_relative_eq!(case.motion.entrainment_speed, 1.0, max_relative = 1e-15);
    assert_relative_eq!(case.motion.slide_to_roll_ratio, 0.4, max_relative = 1e-14);
}

#[test]
fn opposite_sliding_is_allowed_and_mentioned() {
    let case = with("slide_to_roll_ratio = 0.0", "slide_to_roll_ratio = -1.5").unwrap();
    assert_eq!(case.motion.slide_to_roll_ratio, -1.5);
    assert!(case.warnings.is_empty());
    let case = with("slide_to_roll_ratio = 0.0", "slide_to_roll_ratio = -3").unwrap();
    assert!(case.warnings[0].contains("opposite directions"));
}

#[test]
fn a_fluid_by_name_needs_a_temperature() {
    let head = &STEEL[..STEEL.find("[lubricant]").unwrap()];
    let short = format!("lubricant = \"squalane-pip\"\ntemperature = \"313 K\"\n{head}");
    let case = read(&short).unwrap();
    assert_eq!(case.lubricant.name.as_deref(), Some("squalane-pip"));
    assert_eq!(case.lubricant.temperature, 313.0);
    // Habchi 2008, Table 4.1: mu_R = 70.5 mPa.s at 313 K.
    let ambient = case.lubricant.viscosity.viscosity(0.0, 313.0);
    assert_relative_eq!(ambient, 0.0705, max_relative = 1e-12);

    let long = format!("{head}[lubricant]\nname = \"squalane-pip\"\ntemperature = \"313 K\"\n");
    let same = read(&long).unwrap().lubricant;
    assert_relative_eq!(same.viscosity.viscosity(0.0, 313.0), ambient);

    let without = short.replace("temperature = \"313 K\"\n", "");
    let error = message(read(&without));
    contains(&error, "missing key `temperature` at the top level");
    let twice = format!("temperature = \"313 K\"\n{long}");
    assert!(message(read(&twice)).contains("temperature"));
    let unknown = message(read(&long.replace("squalane", "squalene")));
    contains(&unknown, "did you mean `squalane-pip`?");
}

#[test]
fn a_named_fluid_can_be_given_another_law() {
    let head = &STEEL[..STEEL.find("[lubricant]").unwrap()];
    let case = read(&format!(
        "{head}[lubricant]\nname = \"squalane-pip\"\ntemperature = \"313 K\"\n\
         viscosity = {{ law = \"barus\", mu_0 = \"20 mPa.s\", alpha = \"15 1/GPa\" }}\n"
    ))
    .unwrap();
    // exp(15) at 1 GPa.
    let viscosity = case.lubricant.viscosity.viscosity(1e9, 313.0);
    assert_relative_eq!(viscosity, 0.02 * 15.0_f64.exp(), max_relative = 1e-12);
}

#[test]
fn everything_optional_is_read() {
    let case = read(&format!(
        r#"{STEEL}
[mesh]
preset = "fine"
hertz_size = 0.07
constriction_size = 0.03
rim_size = 0.02
edge_size = 0.4
growth = 0.3
depth_growth = 0.4
body_width = 40
body_depth = 50
inlet = -4.5
outlet = 1.5
side = 3
pressure_order = 5
elastic_order = 1
[solver]
formulation = "gls"
isotropic_diffusion = 0.5
elastic_stabilisation = false
penalty = 1e7
penalty_scaling = "inverse-element-squared"
elasticity = "two-bodies"
linear = "monolithic"
tolerance = 1e-6
max_iterations = 20
error_estimate = false
[output]
folder = "here"
pictures = ["pdf", "png"]
body_field = true
netcdf = true
"#
    ))
    .unwrap();
    let mesh = &case.mesh;
    assert_eq!(mesh.preset, MeshPreset::Fine);
    assert_eq!((mesh.hertz_size, mesh.constriction_size), (0.07, 0.03));
    assert_eq!(
        (mesh.edge_size, mesh.growth, mesh.depth_growth),
        (0.4, 0.3, 0.4)
    );
    assert_eq!((mesh.body_width, mesh.body_depth), (Some(40.0), Some(50.0)));
    assert_eq!(
        (mesh.inlet, mesh.outlet, mesh.side),
        (Some(-4.5), Some(1.5), Some(3.0))
    );
    assert_eq!((mesh.pressure_order, mesh.elastic_order), (5, Some(1)));
    assert_eq!(mesh.rim_size, Some(0.02));
    let solver = &case.solver;
    assert_eq!(solver.formulation, Formulation::Gls);
    assert!(!solver.elastic_stabilisation);
    assert_eq!((solver.isotropic_diffusion, solver.penalty), (0.5, 1e7));
    assert_eq!(
        solver.penalty_scaling,
        PenaltyScaling::InverseElementSquared
    );
    assert_eq!(solver.elasticity, Some(ElasticModel::TwoBodies));
    assert_eq!(solver.linear, LinearSolver::Monolithic);
    assert_eq!((solver.tolerance, solver.max_iterations), (1e-6, 20));
    assert!(!solver.error_estimate);
    assert_eq!(case.output.folder.as_deref(), Some("here".as_ref()));
    let pictures = case.output.pictures;
    assert_eq!(
        (pictures.svg, pictures.pdf, pictures.png),
        (false, true, true)
    );
    assert!(case.output.body_field && case.output.netcdf);
}

#[test]
fn hertz_pressure_out_of_range_reports_valid_loads() {
    // 1 kPa and 5 GPa on 16 mm steel: 9.937e-17 N and 12420 N by an independent evaluation.
    for load in ["\"1e-18 N\"", "\"1 MN\""] {
        let error = message(with("\"100 N\"", load));
        contains(&error, "must be between 9.937e-17 N and 12420 N");
    }
    with("\"100 N\"", "\"1e-7 N\"").unwrap();
    with("\"100 N\"", "\"12420 N\"").unwrap();
}

/// A silicone rubber ball on silicone rubber: E' = 2 E/(2 (1 − ν²)) = 3.2 MPa, p_h = 192.5 kPa and a = 1.796 mm by hand.
///
/// Habchi 2008, eq. 2.27.
#[test]
fn soft_bodies_are_read() {
    let rubber = "{ youngs_modulus = \"2.4 MPa\", poissons_ratio = 0.5 }";
    let text = STEEL
        .replace("\"steel\"", rubber)
        .replace(
            "{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }",
            rubber,
        )
        .replace("\"16 mm\"", "\"9.5 mm\"")
        .replace("\"100 N\"", "\"1.3 N\"");
    let case = read(&text).unwrap();
    assert_relative_eq!(case.reduced_modulus(), 3.2e6, max_relative = 1e-12);
    assert_relative_eq!(case.hertz().pressure, 192.4e3, max_relative = 2e-3);
    assert_relative_eq!(case.hertz().half_width, 1.796e-3, max_relative = 2e-3);
    let error = message(read(&format!(
        "{text}\n[solver]\nelasticity = \"equivalent\"\n"
    )));
    assert!(error.contains("lock near Poisson's ratio 0.5"), "{error}");
}

/// Ra 0.4 and 0.31 um: σ = √(0.5² + 0.3875²) = 0.63257 um by hand; Rz 2.4 um is Ra 0.4 um.
#[test]
fn roughness_by_ra_and_rz() {
    let of = |keys: &str| read(&format!("{STEEL}\n[surface_roughness]\n{keys}\n"));
    let case = of("body_1_ra = \"0.4 um\"\nbody_2_ra = \"0.31 um\"").unwrap();
    assert_relative_eq!(case.roughness.unwrap(), 0.632_58e-6, max_relative = 1e-5);
    assert_eq!(case.roughness_rules.len(), 2);
    assert!(
        case.roughness_rules[0].contains("σ = 500 nm = 1.25 Ra"),
        "{:?}",
        case.roughness_rules
    );
    let case = of("body_1_rz = \"2.4 um\"\nbody_2_rq = \"0.3875 um\"").unwrap();
    assert_relative_eq!(case.roughness.unwrap(), 0.632_58e-6, max_relative = 1e-5);
    assert!(
        case.roughness_rules[0].contains("-25 to +50 %"),
        "{:?}",
        case.roughness_rules
    );
    for (keys, words) in [
        ("body_1_ra = \"0.4 um\"", "missing key `body_2_rms_height`"),
        (
            "body_1_ra = \"0.4 um\"\nbody_1_rz = \"3 um\"\nbody_2_ra = \"0.4 um\"",
            "give the same quantity",
        ),
        ("body_1_ra = 0.4\nbody_2_ra = 0.4", "body_1_ra = \"0.4 um\""),
    ] {
        let error = message(of(keys));
        assert!(error.contains(words), "{error}");
    }
}

#[test]
fn a_contact_as_large_as_its_body_is_refused() {
    let soft = STEEL.replace(
        "\"steel\"",
        "{ youngs_modulus = \"1 MPa\", poissons_ratio = 0.4 }",
    );
    let soft = soft.replace("210 GPa", "1 MPa").replace("100 N", "5 kN");
    assert!(message(read(&soft)).contains("exceeds the radius"));
}

#[test]
fn shear_thinning_comes_with_the_fluid_and_can_be_disabled() {
    let head = &STEEL[..STEEL.find("[lubricant]").unwrap()];
    let squalane = format!("{head}[lubricant]\nname = \"squalane-pip\"\ntemperature = \"313 K\"\n");
    let case = read(&squalane).unwrap();
    // Habchi 2008, eq. 4.3 with Table 4.1 at 1 MPa: 0.46850, by an independent script.
    let law = case.shear_thinning().unwrap();
    let share = 1.0 / law.relative_fluidity(1e12, 0.0);
    assert_relative_eq!(share, 0.4684993, max_relative = 1e-6);
    assert_eq!(case.echo().fluid.shear_thinning.as_deref(), Some("carreau"));

    let left_out = read(&format!("{squalane}[solver]\nnewtonian = true\n")).unwrap();
    assert!(left_out.lubricant.shear_thinning.is_some());
    assert_eq!(left_out.shear_thinning(), None);

    let eyring = "shear_thinning = { law = \"ree-eyring\", tau_0 = \"5 MPa\" }";
    let replaced = read(&format!("{squalane}{eyring}\n")).unwrap();
    assert_eq!(replaced.shear_thinning().unwrap().name(), "ree-eyring");
    let added = read(&format!("{STEEL}{eyring}\n")).unwrap();
    assert_eq!(added.shear_thinning().unwrap().name(), "ree-eyring");
    assert_eq!(read(STEEL).unwrap().shear_thinning(), None);
}

/// Values of a mineral oil replace those that the case needs and does not give; its given conductivity stays.
#[test]
fn heat_and_shear_are_estimated_where_asked() {
    let steel = STEEL.replace(
        "{ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }",
        "\"steel\"",
    );
    let head = &steel[..steel.find("[lubricant]").unwrap()];
    let keys = |case: &Case| -> Vec<String> {
        let estimates = case.echo().fluid.estimates;
        estimates.into_iter().map(|estimate| estimate.key).collect()
    };
    let hot = "shear_thinning = { law = \"estimate\" }\n[thermal]\n";
    let sheet = "[lubricant]\ntemperature = \"40 degC\"\niso_vg = 46\nbase_oil = \"mineral\"\n";
    let asked = read(&format!("{head}{sheet}{hot}")).unwrap();
    let heat = asked.heat().unwrap().unwrap();
    near(heat.conductivity.conductivity(0.0, 313.15), 0.137, 1e-12);
    let by_kind = [
        "shear_thinning.tau_0",
        "shear_thinning.limit.lambda",
        "thermal_conductivity.k_0",
        "heat_capacity.rho_c_0",
    ];
    assert_eq!(keys(&asked)[5..], by_kind);
    let noted = |key: &str| asked.inputs().iter().any(|i| i.key == key && i.estimated);
    assert!(noted("lubricant.thermal_conductivity.k_0") && noted("lubricant.shear_thinning.tau_0"));
    let unasked = read(&format!("{head}{sheet}")).unwrap();
    assert_eq!(keys(&unasked), keys(&asked)[..5]);
    assert_eq!(unasked.lubricant.thermal_conductivity, None);
    let isothermal = format!("{head}{sheet}[thermal]\n[solver]\nisothermal = true\n");
    assert_eq!(keys(&read(&isothermal).unwrap()), keys(&unasked));

    let laws = read(&format!("{steel}base_oil = \"PAO\"\n{hot}")).unwrap();
    assert_eq!(keys(&laws), by_kind);
    assert_eq!(laws.echo().fluid.name, "given by its laws");
    let named = format!("lubricant = \"pao-650\"\ntemperature = \"348 K\"\n{head}[thermal]\n");
    let named = read(&named).unwrap();
    assert_eq!(keys(&named), by_kind[2..]);
    assert!((named.inputs().iter()).any(|i| i.key == "lubricant.heat_capacity.rho_c_0"));
    let given = format!("{head}{sheet}thermal_conductivity = \"0.12 W/(m.K)\"\n[thermal]\n");
    assert_eq!(keys(&read(&given).unwrap())[5..], by_kind[3..]);
    let unknown = message(read(&format!("{steel}[thermal]\n")));
    contains(&unknown, "`base_oil` in [lubricant] names its kind");
}

#[test]
fn a_blend_is_named_by_its_parts() {
    let head = &STEEL[..STEEL.find("[lubricant]").unwrap()];
    let blend = "[lubricant]\ntemperature = \"40 degC\"\nblend = [{ name = \"iso-vg-220-mineral\", share = 0.6 }, { name = \"pao-40\", share \
                 = 0.4 }]\n";
    let case = read(&format!("{head}{blend}")).unwrap();
    let name = "blend of iso-vg-220-mineral 60 %, pao-40 40 %";
    assert_eq!(case.echo().fluid.name, name);
    let mu = case.lubricant.ambient_viscosity();
    // Between 0.19 and 0.35 Pa·s of the parts; ertel-rheology has the law.
    assert!((0.2..0.3).contains(&mu), "{mu}");
    let replaced = read(&format!(
        "{head}{blend}thermal_conductivity = \"0.14 W/(m.K)\"\n"
    ))
    .unwrap();
    assert!(replaced.lubricant.thermal_conductivity.is_some());
}

const SPEEDS: &str = "
[curve]
quantity = \"motion.entrainment_speed\"
";

fn curve(lines: &str) -> Result<Case, InputError> {
    read(&format!("{STEEL}{SPEEDS}{lines}"))
}

#[test]
fn a_curve_is_one_case_for_each_value() {
    let case = curve("values = [\"100 mm/s\", \"2 m/s\",\n  \"0.3 m/s\"]").unwrap();
    let curve = case.curve.unwrap();
    assert_eq!(curve.quantity.key(), "entrainment_speed");
    assert_eq!(curve.quantity.unit(), "m/s");
    assert!(!curve.folders);
    let values: Vec<f64> = curve.points.iter().map(|p| p.value()).collect();
    assert_eq!(values, [0.1, 2.0, 0.3]);
    for point in &curve.points {
        assert_eq!(point.case.motion.entrainment_speed, point.value());
        assert_eq!(point.case.contact, case.contact);
        // The kept text is a case file of this point alone.
        let again = read(&point.case.source).unwrap();
        assert!(again.curve.is_none());
        assert_eq!(again.motion, point.case.motion);
        assert_eq!(again.lubricant, point.case.lubricant);
    }
}

#[test]
fn ranges_are_spaced_evenly_in_differences_or_ratios() {
    let values = |lines: &str| -> Vec<f64> {
        let points = curve(lines).unwrap().curve.unwrap().points;
        points.iter().map(|p| p.value()).collect()
    };
    let range = "from = \"10 mm/s\"\nto = \"1 m/s\"\npoints = 3\n";
    assert_eq!(values(range), [0.01, 0.505, 1.0]);
    assert_eq!(
        values(&format!("{range}spacing = \"log\"")),
        [0.01, 0.1, 1.0]
    );
    let falling = "from = \"1 m/s\"\nto = \"0.8 m/s\"\npoints = 2";
    assert_eq!(values(falling), [1.0, 0.8]);
}

#[test]
fn temperatures_and_line_loads_vary_in_their_units() {
    let text = STEEL.replace("load = \"100 N\"", "load = \"100 kN/m\"");
    let text = text.replace("circular", "line");
    let lines = "[curve]\nquantity = \"contact.load\"\nvalues = [\"50 N/mm\", \"80 kN/m\"]";
    let points = read(&format!("{text}{lines}")).unwrap().curve.unwrap();
    assert_eq!(points.quantity.unit(), "N/m");
    assert_relative_eq!(points.points[0].case.contact.load, 5e4);
    let lines = "[curve]\nquantity = \"lubricant.temperature\"\nfrom = \"20 degC\"\nto = \"333.15 K\"\npoints = 3";
    let points = read(&format!("{STEEL}{lines}")).unwrap().curve.unwrap();
    let temperatures: Vec<f64> = (points.points.iter())
        .map(|p| p.case.lubricant.temperature)
        .collect();
    assert_eq!(temperatures, [293.15, 313.15, 333.15]);
}

/// Results that need a body are refused with half-spaces, and select a body where the case does not choose.
#[test]
fn half_spaces_have_no_inside() {
    for (lines, line) in [
        (
            "[solver]\nelasticity = \"half-space\"\nlinear = \"monolithic\"\n",
            19,
        ),
        (
            "[output]\nbody_field = true\n[solver]\nelasticity = \"half-space\"\n",
            18,
        ),
    ] {
        let error = read(&format!("{STEEL}{lines}")).unwrap_err();
        assert_eq!(error.line(), Some(line), "{error}");
        assert!(error.message().contains("finite-element body"), "{error}");
        contains(&error.help()[0], "elasticity = \"equivalent\"");
        let unnamed = lines.replace("elasticity = \"half-space\"\n", "");
        let case = read(&format!("{STEEL}{unnamed}")).unwrap();
        assert_eq!(case.elastic_model(), ElasticModel::Equivalent);
    }
    assert_eq!(
        read(STEEL).unwrap().elastic_model(),
        ElasticModel::HalfSpace
    );
}

/// Files from before half-spaces run, with a warning about keys of a body.
#[test]
fn keys_of_a_body_are_idle_on_half_spaces() {
    let idle = "[mesh]\nbody_width = 40\nbody_depth = 50\ndepth_growth = 0.4\nelastic_order = 2\n";
    let warnings = read(&format!("{STEEL}{idle}")).unwrap().warnings;
    let [keys, order] = &warnings[..] else {
        panic!("{warnings:?}")
    };
    for words in [
        "mesh.body_width",
        "mesh.body_depth",
        "mesh.depth_growth",
        "no effect",
        "solver.elasticity = \"equivalent\"",
    ] {
        assert!(keys.contains(words), "{keys}");
    }
    assert!(order.contains("the order of the pressure"), "{order}");
    for quiet in [
        format!("{STEEL}[solver]\nelasticity = \"equivalent\"\n{idle}"),
        format!("{STEEL}[mesh]\nelastic_order = 3\n"),
        STEEL.to_owned(),
    ] {
        let warnings = read(&quiet).unwrap().warnings;
        assert!(warnings.is_empty(), "{warnings:?}");
    }
}

/// Displacements of bodies are linear or quadratic; deflections of half-spaces may have any order.
#[test]
fn elastic_orders_of_bodies_are_one_or_two() {
    for solver in ["elasticity = \"two-bodies\"", "linear = \"monolithic\""] {
        let lines = |order| format!("{STEEL}[mesh]\nelastic_order = {order}\n[solver]\n{solver}\n");
        let error = read(&lines(3)).unwrap_err();
        assert_eq!(
            (error.line(), error.key()),
            (Some(18), "mesh.elastic_order")
        );
        read(&lines(2)).unwrap();
    }
    let half_space = read(&format!("{STEEL}[mesh]\nelastic_order = 5\n")).unwrap();
    assert_eq!(half_space.mesh.elastic_order, Some(5));
}

/// The limit once counted displacements: numbers of that size are still taken.
#[test]
fn limits_of_unknowns_have_bounds() {
    for n in [1_000, 80_000, 2_000_000] {
        let case = read(&format!("{STEEL}[mesh]\nmax_unknowns = {n}\n")).unwrap();
        assert_eq!(case.mesh.max_unknowns, Some(n));
    }
    for n in [999, 2_000_001] {
        let error = message(read(&format!("{STEEL}[mesh]\nmax_unknowns = {n}\n")));
        assert!(error.contains("from 1000 to 2000000"), "{error}");
    }
}

/// Interferograms of a curve are drawn only in folders of its points, and a warning says so.
#[test]
fn a_curve_draws_interferograms_in_folders_alone() {
    let curve = "[curve]\nquantity = \"contact.load\"\nvalues = [\"20 N\", \"40 N\"]\n";
    let optics = "[output.interferogram]\nwavelength = \"600 nm\"\nrefractive_index = 1.47\nphase_change = \"180 deg\"\n";
    let warned = |more: &str| {
        let case = read(&format!("{STEEL}{optics}{curve}{more}")).unwrap();
        case.warnings.iter().any(|w| w.contains("folders = true"))
    };
    assert!(warned(""));
    assert!(!warned("folders = true\n"));
}
