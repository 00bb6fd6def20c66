//! Heat and shear by the kind of the base oil.

use crate::near::near;
use approx::assert_relative_eq;

use super::Files;
use crate::provenance::Status;
use crate::{Fluid, database};
use ertel_input::{Document, InputError, Inputs};

const SHEET: &str = "kinematic_viscosity_40 = '46 cSt'\nkinematic_viscosity_100 = '6.9 cSt'\n\
     density_15 = '870 kg/m^3'\nbase_oil = 'mineral'\n";
const LAWS: &str = "viscosity = { law = 'roelands', mu_0 = '40 mPa.s', alpha = '22 1/GPa' }\n\
     density = { law = 'dowson-higginson', rho_0 = '870 kg/m^3' }\n";
const THINNING: &str = "shear_thinning = { law = 'estimate' }\n";

fn document(text: &str) -> Document {
    Document::parse("case.toml", format!("[lubricant]\n{text}")).unwrap()
}

fn oil(text: &str) -> Result<Fluid, InputError> {
    let document = document(text);
    let mut table = document.root().required_table("lubricant")?;
    let mut fluid = Fluid::from_table(&mut table, "lubricant", Files::Embedded(&[]))?;
    fluid.estimate_heat(&table, "")?;
    table.finish()?;
    Ok(fluid)
}

fn estimated(fluid: &Fluid) -> Vec<&str> {
    let data = fluid.provenance.iter();
    data.filter(|datum| datum.status == Status::Estimated)
        .map(|datum| datum.key.as_str())
        .collect()
}

/// The paraffinic mineral oil of Larsson and Andersson by hand: 0.137 [1 + 1.72/1.54] W/(m·K) at 1 GPa; 1.71e6 (1 + 9.3e-4 · 18.15)
/// J/(m³·K) at 40 degC, over 870 (1 - 5.8e-4 · 25) kg/m³. The stress at 1 GPa ends at 5 + 56 MPa, at 1 MPa the fluidity is sinh(0.2)/0.2
/// times that of the limit, tanh⁻¹.
#[test]
fn a_sheet_is_heated_and_sheared() {
    let oil = oil(&format!("{SHEET}{THINNING}")).unwrap();
    let k = oil.thermal_conductivity.as_ref().unwrap();
    assert_relative_eq!(k.conductivity(0.0, 313.15), 0.137, max_relative = 1e-12);
    near(k.conductivity(1e9, 313.15), 0.290_012_987, 1e-8);
    let c = oil.heat_capacity.as_ref().unwrap();
    assert_relative_eq!(
        c.heat_capacity(0.0, 313.15),
        1.71e6 * (1.0 + 9.3e-4 * 18.15) / (870.0 * 0.9855),
        max_relative = 1e-9
    );
    let thinning = oil.shear_thinning.as_ref().unwrap();
    assert_eq!(thinning.describe(), "ree-eyring with limiting stress");
    assert_relative_eq!(
        thinning.limit.as_ref().unwrap().limiting_stress(1e9),
        61e6,
        max_relative = 1e-9
    );
    let keys = [
        "density.beta",
        "pressure_viscosity_coefficient",
        "shear_thinning.tau_0",
        "shear_thinning.limit.lambda",
        "thermal_conductivity.k_0",
        "heat_capacity.rho_c_0",
    ];
    assert_eq!(estimated(&oil), keys);
}

/// Without the keys that ask for it there is nothing of it, and given numbers stay.
#[test]
fn nothing_is_estimated_unasked() {
    let document = document(SHEET);
    let mut table = document.root().required_table("lubricant").unwrap();
    let sheet = Fluid::from_table(&mut table, "lubricant", Files::Embedded(&[])).unwrap();
    assert_eq!(sheet.shear_thinning, None);
    assert_eq!(sheet.thermal_conductivity, None);
    assert_eq!(estimated(&sheet).len(), 2);
    let given = oil(&format!("{SHEET}thermal_conductivity = '0.12 W/(m.K)'\n")).unwrap();
    let k = given.thermal_conductivity.as_ref().unwrap();
    assert_eq!(k.constant_value(), Some(0.12));
    assert_eq!(estimated(&given).last(), Some(&"heat_capacity.rho_c_0"));
}

/// The kind may be given with laws, too; without it shear is refused with the choices, and heat stays missing.
#[test]
fn laws_with_a_kind() {
    let with_kind = oil(&format!("{LAWS}base_oil = 'PAO'\n{THINNING}")).unwrap();
    assert!(with_kind.thermal_conductivity.is_some());
    let limit = with_kind.shear_thinning.unwrap().limit.unwrap();
    assert_relative_eq!(limit.limiting_stress(1e9), 46e6, max_relative = 1e-9);
    assert_eq!(oil(LAWS).unwrap().thermal_conductivity, None);
    let error = oil(&format!("{LAWS}{THINNING}")).unwrap_err();
    assert_eq!(error.line(), Some(4), "{error}");
    let said = error.to_string();
    assert!(
        said.contains("mineral, PAO, ester, PAG, naphthenic, Group III"),
        "{said}"
    );
    let error = oil(&format!(
        "{SHEET}shear_thinning = {{ law = 'estimate', tau_0 = '5 MPa' }}\n"
    ));
    assert!(error.unwrap_err().to_string().contains("tau_0"));
}

/// Of the database: the kind of an entry, one that the user names for an entry without, and one that contradicts.
#[test]
fn fluids_of_the_database() {
    let change = |name: &str, text: &str| {
        let document = document(text);
        let mut table = document.root().required_table("lubricant").unwrap();
        let mut fluid = database::fluid(name).unwrap();
        fluid.override_from(&mut table, Files::Embedded(&[]))?;
        fluid.estimate_heat(&table, "")?;
        Ok::<_, InputError>(fluid)
    };
    let oil = change("iso-vg-46-pao", THINNING).unwrap();
    assert!(oil.heat_capacity.is_some() && oil.shear_thinning.is_some());
    assert!(estimated(&oil).contains(&"shear_thinning.tau_0"));
    assert!(change("mourier-oil", THINNING).is_err());
    let named = change("mourier-oil", &format!("base_oil = 'mineral'\n{THINNING}")).unwrap();
    assert!(named.thermal_conductivity.is_some());
    let error = change("iso-vg-46-pao", "base_oil = 'mineral'\n").unwrap_err();
    assert_eq!(error.line(), Some(2), "{error}");
    assert!(error.message().contains("`PAO`, not `mineral`"), "{error}");
}

/// Estimates are inputs with the range as their uncertainty: evenly over -30 to +12 % of 0.137 W/(m·K).
#[test]
fn estimates_are_uncertain_inputs() {
    let inputs = Inputs::default();
    let document = document(&format!("{SHEET}{THINNING}"));
    let mut root = document.root_noted_by(Some(inputs.recorder()));
    let mut table = root.required_table("lubricant").unwrap();
    let mut fluid = Fluid::from_table(&mut table, "lubricant", Files::Embedded(&[])).unwrap();
    fluid.estimate_heat(&root, "lubricant").unwrap();
    let (noted, _) = inputs.into_noted();
    let of = |key: &str| noted.iter().find(|input| input.key == key).unwrap();
    let k = of("lubricant.thermal_conductivity.k_0");
    assert!(k.estimated && !k.written);
    assert_relative_eq!(
        k.uncertainty.unwrap().standard(),
        0.21 * 0.137 / 3_f64.sqrt(),
        max_relative = 1e-9
    );
    assert_eq!(of("lubricant.shear_thinning.tau_0").value, 5e6);
    assert_eq!(of("lubricant.shear_thinning.limit.lambda").value, 0.056);
}

/// `ertel fluids show` lists exactly the estimates that a case gets.
#[test]
fn estimates_are_listed_beforehand() {
    for (name, n) in [
        ("iso-vg-46-mineral", 4),
        ("fva-3", 3),
        ("pao-4", 2),
        ("pao-650", 2),
        ("water", 0),
    ] {
        let listed = database::fluid(name).unwrap().estimates_by_kind();
        assert_eq!(listed.len(), n, "{name}");
        assert!(listed.iter().all(|datum| datum.status == Status::Estimated));
    }
    let with_all = oil(&format!("{SHEET}{THINNING}")).unwrap();
    assert!(with_all.estimates_by_kind().is_empty());
    let sheet = document(SHEET);
    let mut table = sheet.root().required_table("lubricant").unwrap();
    let listed = Fluid::from_table(&mut table, "", Files::Embedded(&[])).unwrap();
    for datum in listed.estimates_by_kind() {
        assert!(with_all.provenance.contains(&datum), "{}", datum.key);
    }
}

/// Every oil of the database that has a temperature can be heated and sheared, by its own data or those of its kind; the others have a law
/// without temperature, or no kind that is known.
#[test]
fn oils_of_the_database_have_heat_and_shear() {
    let without = |name: &str| {
        let mut fluid = database::fluid(name).unwrap();
        let empty = Document::parse("case.toml", "").unwrap();
        fluid.estimate_heat(&empty.root(), "").unwrap();
        let heat = fluid.thermal_conductivity.is_some() && fluid.heat_capacity.is_some();
        let shear = fluid.shear_thinning.is_some() || fluid.base_oil.is_some();
        (!heat, !shear)
    };
    for name in database::fluid_names() {
        let is_oil = [
            "iso-vg", "pao", "ester", "pag", "nynas", "fva", "gear", "turbine",
        ]
        .iter()
        .any(|part| name.contains(part));
        if is_oil {
            assert_eq!(without(name), (false, false), "{name}");
        }
    }
}
