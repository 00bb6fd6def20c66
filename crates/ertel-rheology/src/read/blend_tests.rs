//! Blends from a table.

use std::path::Path;

use crate::near::near;
use approx::assert_relative_eq;

use crate::Fluid;
use crate::data_sheet::{BaseOil, Blend};
use crate::database;
use ertel_input::{Document, InputError, Inputs};

fn read(blend: &str) -> Result<Fluid, InputError> {
    let document = Document::parse("case.toml", format!("[lubricant]\nblend = {blend}\n"))?;
    let mut table = document.root().required_table("lubricant")?;
    let fluid = Fluid::from_blend(&mut table, Path::new(""))?;
    table.finish()?;
    Ok(fluid)
}

#[test]
fn a_blend_of_the_database() {
    let text =
        "[{ name = 'iso-vg-220-mineral', share = 0.6 }, { name = 'pao-40', share = '40 %' }]";
    let fluid = read(text).unwrap();
    assert_eq!(fluid.name, "blend of iso-vg-220-mineral 60 %, pao-40 40 %");
    let parts = ["iso-vg-220-mineral", "pao-40"].map(|name| database::fluid(name).unwrap());
    let blend = Blend::new(&[(0.6, &parts[0]), (0.4, &parts[1])]).unwrap();
    assert_eq!(fluid.viscosity, blend.viscosity);
    assert_eq!(fluid.density, Some(blend.density));
    assert_eq!(fluid.base_oil, None);
    // The narrower of 20 to 150 and 20 to 107 degC.
    let (low, high) = fluid.validity.as_ref().unwrap().temperature.unwrap();
    assert_relative_eq!(low, 293.15, max_relative = 1e-12);
    assert_relative_eq!(high, 380.15, max_relative = 1e-12);
    let estimated = "iso-vg-220-mineral.pressure_viscosity_coefficient";
    assert!(fluid.provenance.iter().any(|datum| datum.key == estimated));
    let same = "[{ name = 'pao-4', share = 0.333 }, { name = 'pao-10', share = 0.333 }, { name = 'pao-40', share = 0.333 }]";
    assert_eq!(read(same).unwrap().base_oil, Some(BaseOil::Pao));
}

/// Estimated data of a part are inputs of the blend: its own coefficient moves that of the blend by its share of the volume.
#[test]
fn estimates_of_the_parts_are_inputs() {
    let text = "[lubricant]\nblend = [{ name = 'iso-vg-220-mineral', share = 0.6 }, { name = 'pao-40', share = 0.4 }]\n";
    let document = Document::parse("case.toml", text).unwrap();
    let key = "lubricant.blend.iso-vg-220-mineral.pressure_viscosity_coefficient";
    let slope = |value: Option<f64>| {
        let inputs = Inputs::replacing(value.map(|v| (key.to_owned(), v)).into_iter().collect());
        let mut root = document.root_noted_by(Some(inputs.recorder()));
        let mut table = root.required_table("lubricant").unwrap();
        let fluid = Fluid::from_blend(&mut table, Path::new("")).unwrap();
        let (noted, _) = inputs.into_noted();
        let noted = noted.into_iter().find(|input| input.key == key).unwrap();
        (noted, fluid.pressure_viscosity_slope(313.15))
    };
    let (noted, own) = slope(None);
    assert!(noted.estimated && noted.uncertainty.is_some());
    let (_, moved) = slope(Some(noted.value + 1e-9));
    let parts = ["iso-vg-220-mineral", "pao-40"].map(|name| database::fluid(name).unwrap());
    let blend = Blend::new(&[(0.6, &parts[0]), (0.4, &parts[1])]).unwrap();
    near(moved - own, 1e-9 * blend.volume_shares[0], 1e-6);
}

#[test]
fn invalid_blends_are_refused() {
    for (blend, said) in [
        ("[]", "two oils or more"),
        ("[{ name = 'pao-4', share = 0.5 }]", "two oils or more"),
        (
            "[{ name = 'pao-4', share = 0.5 }, { name = 'pao-10', share = 0.4 }]",
            "sum to 0.9, not to 1",
        ),
        (
            "[{ name = 'pao-4', share = 0.5 }, { name = 'pao-4', share = 0.5 }]",
            "twice",
        ),
        (
            "[{ name = 'pao-4', share = 0.5 }, { name = 'pao-5', share = 0.5 }]",
            "pao-5",
        ),
        (
            "[{ name = 'pao-4', share = 1.5 }, { name = 'pao-10', share = -0.5 }]",
            "share",
        ),
        (
            "[{ name = 'pao-4', share = 0.5 }, { name = 'water', share = 0.5 }]",
            "40 and 100 degC",
        ),
        (
            "[{ name = 'pao-4', share = 0.5 }, { name = 'pao-10' }]",
            "share",
        ),
        ("[{ name = 'pao-4', volume = 0.5 }]", "share"),
    ] {
        let error = read(blend).unwrap_err();
        assert_eq!(error.line(), Some(2), "{error}");
        assert!(error.to_string().contains(said), "{blend}: {error}");
    }
}
