//! The contacts by which error bars are tried: a row of `contacts.csv` each, drawn once at random (log-uniform sizes, Hertz pressures of 0.3 to 1.8 GPa, speeds,
//! viscosities) and not chosen since, but that two tilts of rollers are a tenth of those drawn, with which the contact runs over the end.
//!
//! `angle_deg` is that of the motion to the principal directions of an ellipse, or the tilt of a roller; zero where the contact has neither.

/// A contact: its name, its family, and its case file without `[mesh]`.
pub struct Trial {
    pub name: String,
    pub family: String,
    pub text: String,
}

const ROWS: &str = include_str!("contacts.csv");

/// All of the table.
pub fn contacts() -> Vec<Trial> {
    ROWS.lines()
        .skip(1)
        .enumerate()
        .map(|(n, row)| contact(n + 1, row))
        .collect()
}

fn contact(n: usize, row: &str) -> Trial {
    let cells: Vec<&str> = row.split(',').collect();
    let [
        family,
        rx,
        ry,
        length,
        angle,
        load,
        speed,
        viscosity,
        alpha,
        sliding,
        spin,
        layer,
        law,
        stress,
        parameter,
    ] = cells[..]
    else {
        panic!("row {n} of contacts.csv has {} columns", cells.len());
    };
    let geometry = match family {
        // Designed for half as much again as it carries.
        "roller" => {
            let design = 1.5 * load.parse::<f64>().expect("a load");
            format!(
                "kind = \"roller\"\nradius = \"{rx} mm\"\nlength = \"{length} mm\"\nmisalignment = \"{angle} deg\"\n\
                 profile = {{ kind = \"logarithmic\", design_load = \"{design} N\" }}"
            )
        }
        _ if rx == ry => format!("kind = \"circular\"\nradius = \"{rx} mm\""),
        _ => format!(
            "kind = \"elliptical\"\nradius_x = \"{rx} mm\"\nradius_y = \"{ry} mm\"\nentrainment_angle = \"{angle} deg\""
        ),
    };
    let thinning = match law {
        "ree-eyring" => format!("tau_0 = \"{stress} MPa\""),
        "limiting-stress" => format!("tau_l0 = \"{stress} MPa\", lambda = {parameter}"),
        "carreau" => {
            format!("g_c = \"{stress} MPa\", n = {parameter}, beta_c = 2.0, mu_2 = \"0 Pa.s\"")
        }
        _ => String::new(),
    };
    let thinning = match thinning.is_empty() {
        true => String::new(),
        false => format!("shear_thinning = {{ law = \"{law}\", {thinning} }}\n"),
    };
    let spin = match spin {
        "0" => String::new(),
        _ => format!("body_2_spin = \"{spin} rad/s\"\n"),
    };
    let (heat, beta) = match family {
        "thermal" => (
            "thermal_conductivity = \"0.14 W/(m.K)\"\nheat_capacity = \"2000 J/(kg.K)\"\n",
            ", beta = \"0.04 1/K\", reference_temperature = \"40 degC\"",
        ),
        _ => ("", ""),
    };
    let more = match (family, layer) {
        ("thermal", _) => "[thermal]\n".to_owned(),
        (_, "0") => String::new(),
        _ => format!("[inlet]\noil_layer = \"{layer} nm\"\n"),
    };
    Trial {
        name: format!("{n} {family}"),
        family: family.to_owned(),
        text: format!(
            "[contact]\n{geometry}\nload = \"{load} N\"\n[bodies]\nbody_1 = \"steel\"\nbody_2 = \"steel\"\n\
             [motion]\nentrainment_speed = \"{speed} m/s\"\nslide_to_roll_ratio = {sliding}\n{spin}[lubricant]\ntemperature = \"40 degC\"\n\
             density = {{ law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }}\n\
             viscosity = {{ law = \"roelands\", mu_0 = \"{viscosity} mPa.s\", alpha = \"{alpha} 1/GPa\"{beta} }}\n{thinning}{heat}{more}"
        ),
    }
}
