//! `[lubricant]`, the laws of lubricants and solids, and their keys.

use ertel_quantity::Dimension as D;

use super::Kind::{
    AnyCase, Choice, Fluid, Law as OfLaw, LawOr, Number, Numbers, Quantities, Quantity, Scalar,
    Table, Tables, Text, Texts,
};
use super::{
    DENSITY, KELVIN, KINEMATIC, PER_KELVIN, PER_PRESSURE, PRESSURE, TEMPERATURE, VISCOSITY,
};
use super::{Law, Laws, Row, rows};
use crate::usual::{
    COEFFICIENT, FILM_CONDUCTIVITY, GLASS_VISCOSITY, KINEMATIC_VISCOSITIES, OIL_DENSITY,
    OIL_VISCOSITY, SHEAR_STRESS, SOLID_CONDUCTIVITY, SPECIFIC_HEATS,
};

const PRESSURE_LAW: super::Kind = Choice(&["roelands", "barus"]);

/// The decimal mark of a table.
pub(super) const DECIMAL: super::Kind = Choice(&["point", "comma"]);
/// A conductivity, or its law.
pub(super) const CONDUCTIVITY: super::Kind = LawOr(&CONDUCTIVITIES, D::THERMAL_CONDUCTIVITY);
/// A heat capacity, or its law.
pub(super) const HEAT_CAPACITY: super::Kind = LawOr(&HEAT_CAPACITIES, D::SPECIFIC_HEAT);

/// Laws, each as `name: required keys, optional optional keys`.
macro_rules! laws {
    ($($(#[$doc:meta])* $name:ident of $keys:ident { $($law:literal: $needs:literal $(, optional $optional:literal)?;)* })*) => {$(
        $(#[$doc])* pub static $name: Laws = Laws {
            laws: &[$(Law { name: $law, needs: $needs, optional: concat!($($optional)?) }),*],
            keys: $keys,
        };
    )*};
}

laws! {
    /// Laws of the density.
    DENSITIES of DENSITY_KEYS {
        "constant": "`rho_0`";
        "dowson-higginson": "`rho_0`",
            optional "`c_1`, `c_2` (default: the law's values 0.6 and 1.7 1/GPa); together `reference_temperature`, `beta`";
        "tait": "`rho_0`, `k_0r`, `k_0r_prime`", optional "together `reference_temperature`, `beta_k`, `beta_k_prime`, `a_v`";
        "murnaghan": "`rho_0`, `k_0r`, `k_0r_prime`", optional "together `reference_temperature`, `beta_k`, `beta_k_prime`, `a_v`";
        "table": "`file`, or `isotherms` and `units`", optional "of a file `columns`, `decimal`";
    }
    /// Laws of the viscosity.
    VISCOSITIES of VISCOSITY_KEYS {
        "constant": "`mu_0`";
        "barus": "`mu_0`, `alpha`";
        "cheng": "`mu_0`, `alpha`, `beta`, `gamma`, `reference_temperature`";
        "roelands": "`mu_0`, and `alpha` or `z`",
            optional "`p_0` (default: the law's value 1/5.1e-9 Pa); together `reference_temperature`, `beta`";
        "wlf": "`mu_g`, `t_g0`, `a_1`, `a_2`, `b_1`, `b_2`, `c_1`, `c_2`";
        "doolittle": "`mu_0`, `b`, `r_0`, and `equation_of_state` unless the density is `tait`",
            optional "together `reference_temperature`, `epsilon`";
        "yasutomi": "`mu_g`, `t_g0`, `a_1`, `a_2`, `b_1` (1/Pa), `b_2` (negative), `c_1`, `c_2`";
        "mcewen": "`mu_0`, `alpha`, `q`";
        "paluch": "`mu_0` or `mu_inf`, `c_f`, `p_inf`";
        "mcewen-paluch": "`mu_0`, `a_0`, `q`, `c_f`, `p_inf`";
        "walther": "`a`, `b`, `alpha`, `reference_temperature`, and a density law in addition",
            optional "`pressure`: `\"roelands\"` (the default) or `\"barus\"`; `alpha_exponent`, −10 to 10, the power of the absolute temperature \
                with which the index of Roelands, or α of Barus, changes (default 0)";
        "table": "`file`, or `isotherms` and `units`", optional "of a file `columns`, `decimal`";
    }
    /// Laws of shear thinning.
    SHEAR_LAWS of SHEAR_KEYS {
        "carreau": "`g_c` (a stress), `n` (0.01 to 1), `beta_c` (0.2 to 50), `mu_2`", optional "`reference_temperature`, `limit`";
        "carreau-yasuda": "`g` (shear modulus; the relaxation time is mu_1/g), `n` (0.01 to 1), `a` (0.2 to 50), `mu_2`",
            optional "`reference_temperature`, `limit`";
        "ree-eyring": "`tau_0`", optional "`limit`";
        "rabinowitsch": "`tau_0`, `n` (0.01 to below 1; 1/3 is the cubic law)", optional "`limit`";
        "limiting-stress": "`tau_l0`, `lambda` (0 to 10)";
        "estimate": "the kind of the base oil, from `base_oil` next to it or from the database: `ree-eyring` with a limit";
    }
    /// Laws of the thermal conductivity.
    CONDUCTIVITIES of CONDUCTIVITY_KEYS {
        "constant": "`k_0`";
        "linear": "`k_0`, `reference_temperature`, `a_t`", optional "of lubricants `a_p`";
        "larsson-andersson": "`k_0`, `d_1`, `d_2`";
        "scaling": "`b`, `c`, `s`, `a`, `q`, `reference_temperature`";
        "table": "`file`, or `isotherms` and `units`", optional "of a file `columns`, `decimal`";
    }
    /// Laws of the heat capacity.
    HEAT_CAPACITIES of HEAT_CAPACITY_KEYS {
        "constant": "`c_0`";
        "linear": "`c_0`, `reference_temperature`, `a_t`", optional "of lubricants `a_p`";
        "larsson-andersson": "`rho_c_0` (per volume), `reference_temperature`, `beta_0`, `b_1`, `b_2`, `k_1`, `k_2`";
        "scaling": "`rho_c_0`, `m` (per volume), `reference_temperature`", optional "`w` (4)";
        "table": "`file`, or `isotherms` and `units`", optional "of a file `columns`, `decimal`";
    }
}

rows! {
    /// `[lubricant]`; from `kinematic_viscosity_40` on, values of data sheets.
    pub LUBRICANT {
        temperature: TEMPERATURE => "temperature of the film, required";
        name: Fluid => "a fluid of the database (`ertel fluids` lists them), or your own file, see below";
        blend: Tables(BLEND) => "blend of oils, each with its mass fraction; see [blends](lubricant-laws.md#blends)";
        density: OfLaw(&DENSITIES) => "density [law](lubricant-laws.md#density); with `name` optional, instead of that of the fluid";
        viscosity: OfLaw(&VISCOSITIES) => "viscosity [law](lubricant-laws.md#viscosity), likewise";
        shear_thinning: OfLaw(&SHEAR_LAWS) => "[law](lubricant-laws.md#shear_thinning) of shear thinning, likewise; without it the lubricant is
            Newtonian";
        thermal_conductivity: CONDUCTIVITY, usual [FILM_CONDUCTIVITY] => r"constant or
            [law](lubricant-laws.md#thermal_conductivity-and-heat_capacity), for thermal contacts";
        heat_capacity: HEAT_CAPACITY, usual [SPECIFIC_HEATS] => "likewise";
        validity: Table(VALIDITY) => "pressures and temperatures outside which a warning is given, see [other keys of a
            fluid](lubricant-laws.md#other-keys-of-a-fluid)";
        correlation: Tables(CORRELATION) => "[correlations](#uncertain-inputs) between uncertain constants";
        kinematic_viscosity_40: KINEMATIC, usual [KINEMATIC_VISCOSITIES] => r"kinematic viscosity at 40 °C; if absent, the middle of the grade
            `iso_vg`, ± 10 %";
        iso_vg: Number => r"grade of ISO 3448: 2, 3, 5, 7, 10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460, 680, 1000, 1500, 2200, 3200";
        kinematic_viscosity_100: KINEMATIC, usual [KINEMATIC_VISCOSITIES] => r"kinematic viscosity at 100 °C; with `viscosity_index` alone, the
            one at 40 °C follows; if absent, it follows from the viscosity index";
        kinematic_viscosity_20, kinematic_viscosity_25, kinematic_viscosity_30, kinematic_viscosity_50, kinematic_viscosity_60,
            kinematic_viscosity_80: KINEMATIC, usual [KINEMATIC_VISCOSITIES] => r"kinematic viscosity at that temperature in °C: any two of these
            keys and the next, or one with `viscosity_index` or `iso_vg`, instead of those at 40 and 100 °C";
        dynamic_viscosity_20, dynamic_viscosity_25, dynamic_viscosity_30, dynamic_viscosity_40, dynamic_viscosity_50, dynamic_viscosity_60,
            dynamic_viscosity_80, dynamic_viscosity_100: VISCOSITY => r"dynamic viscosity at that temperature, divided by the density there";
        kinematic_viscosity: KINEMATIC, usual [KINEMATIC_VISCOSITIES] => r"kinematic viscosity at `viscosity_temperature`, instead of one of the keys above";
        dynamic_viscosity: VISCOSITY, usual [OIL_VISCOSITY] => r"the same of the dynamic viscosity";
        viscosity_temperature: TEMPERATURE => "temperature of `kinematic_viscosity` or `dynamic_viscosity`, −50 to 200 °C";
        viscosity_index: Number, bounds [-200.0, 500.0] => r"viscosity index of ASTM D2270{}; if absent, 95 for a mineral oil, 150 for a PAO;
            required for others";
        density_15, density_20: DENSITY, usual [OIL_DENSITY] => r"density at 15 or 20 °C; if absent, 902, 859, 915, 1059, 902 or 880 kg/m³ for the base
            oils below, ± 5 %";
        relative_density_15: Number => "density at 15 °C relative to that of water at 15 °C, dimensionless";
        base_oil: AnyCase(&["mineral", "PAO", "ester", "PAG", "naphthenic", "Group III"]) => r#"kind of the base oil:
            `"mineral"`, `"PAO"`, `"ester"`, `"PAG"`, `"naphthenic"` or `"Group III"`, in any case of letters, also `"Group I"` and `"Group II"`
            (mineral) and `"Group IV"` (PAO) of API 1509; needed for estimates. It may be given with
            laws, too, for estimates of [heat and shear](#heat-and-shear-by-the-kind-of-oil). There is no correlation with a source for
            silicones, PFPE and water-glycol: the error message lists what to give instead, and for other names the nearest kind"#;
        pressure_viscosity_coefficient: PER_PRESSURE, usual [COEFFICIENT] => r"measured initial slope of ln μ at `reference_temperature`; if
            absent, correlation of Gold and others for the type of base oil, centred in 44 measured slopes, ± 21 % (PAG ± 30 %, Group III about −34 to +40 %)";
        pressure_viscosity_coefficient_20, pressure_viscosity_coefficient_25, pressure_viscosity_coefficient_30,
            pressure_viscosity_coefficient_40, pressure_viscosity_coefficient_50, pressure_viscosity_coefficient_60,
            pressure_viscosity_coefficient_80, pressure_viscosity_coefficient_100: PER_PRESSURE, usual [COEFFICIENT] => r"the same at that
            temperature in °C: one of them instead of the former, or two; with one, the index of Roelands' law is the same at every
            temperature";
        reference_temperature: TEMPERATURE => r"temperature of `pressure_viscosity_coefficient`, preferably the temperature of the contact;
            40 °C if absent";
        pressure_law: PRESSURE_LAW, default "roelands" => "law of the pressure dependence";
    }
    BLEND {
        name: Fluid, aside "part of the blend, a fluid of the database or your own file";
        share: Number, aside "its share of the mass, above 0 and below 1";
    }
    VALIDITY {
        pressure: Quantities(&[D::PRESSURE]), aside "lowest and highest pressure";
        temperature: Quantities(&[D::TEMPERATURE]), aside "lowest and highest temperature";
        source: Text, aside "where these are from";
    }
/// Keys of the law `table`, of every property.
    pub(super) TABLE_KEYS {
        file: Text, aside "table of states";
        columns: Texts, aside "titles of its columns";
        decimal: DECIMAL, aside "its decimal mark";
        units: Table(UNITS), aside "units of the isotherms";
        isotherms: Tables(ISOTHERMS), aside "states at one temperature each";
    }
    ISOTHERMS {
        temperature: TEMPERATURE, aside "temperature of the isotherm";
        pressure: Numbers, aside "pressures above ambient, increasing";
        viscosity, density, thermal_conductivity, heat_capacity: Numbers, aside "the property at these pressures";
    }
    UNITS {
        pressure: Text, aside "unit of the pressures";
        viscosity, density, thermal_conductivity, heat_capacity: Text, aside "unit of the property";
    }
    DENSITY_KEYS {
        law: Text, aside "density law";
        rho_0: DENSITY, usual [OIL_DENSITY], aside "density at ambient pressure and the reference temperature";
        c_1, c_2: PER_PRESSURE, aside "coefficients of Dowson and Higginson";
        beta: PER_KELVIN, aside "thermal expansion";
        k_0r: PRESSURE, aside "bulk modulus at ambient pressure and the reference temperature";
        k_0r_prime: Number, aside "its slope over pressure";
        reference_temperature: TEMPERATURE, aside "where the constants hold";
        beta_k, beta_k_prime: PER_KELVIN, aside "temperature coefficients of the bulk modulus and of its slope";
        a_v: PER_KELVIN, aside "thermal expansion of the volume";
    }
    VISCOSITY_KEYS {
        law: Text, aside "viscosity law";
        mu_0: VISCOSITY, usual [OIL_VISCOSITY], aside "viscosity at ambient pressure and the reference temperature";
        alpha: PER_PRESSURE, usual [COEFFICIENT], aside "pressure-viscosity coefficient, the initial slope of ln μ";
        alpha_exponent: Number, bounds [-10.0, 10.0], aside "power of the absolute temperature with which the index of Roelands, or α, changes";
        // Of Cheng a temperature, of Roelands its reciprocal.
        beta: Quantity(&[D::INVERSE_TEMPERATURE, D::TEMPERATURE_DIFFERENCE]), aside "coefficient β of the temperature";
        gamma: Quantity(&[D::TEMPERATURE_PER_PRESSURE]), aside "coefficient γ of p/T";
        reference_temperature: TEMPERATURE, aside "where the constants hold";
        z: Number, aside "index Z of Roelands, instead of `alpha`";
        p_0: PRESSURE, aside "pressure p₀ of Roelands";
        mu_g: VISCOSITY, usual [GLASS_VISCOSITY], aside "viscosity at the glass transition";
        t_g0: TEMPERATURE, aside "glass transition at ambient pressure";
        a_0: PER_PRESSURE, aside "a₀ of McEwen's factor";
        a_1: KELVIN, aside "A₁ of the glass transition T_g0 + A₁ ln(1 + A₂ p)";
        a_2: PER_PRESSURE, aside "A₂ of the glass transition";
        // Of WLF and of Yasutomi the other way round.
        b_1, b_2: Scalar, aside "constants of F, the change of free volume with pressure";
        c_1: Number, aside "C₁";
        c_2: KELVIN, aside "C₂";
        a: Number, aside "A of Walther";
        b: Number, aside "B of Doolittle or Walther";
        r_0: Number, aside "R₀, the share of the occupied volume";
        epsilon: PER_KELVIN, aside "ε, thermal expansion of the occupied volume";
        equation_of_state: Table(DENSITY_KEYS), aside "law of Tait for the volume, without `rho_0`";
        q: Number, aside "exponent q of McEwen";
        mu_inf: VISCOSITY, aside "viscosity factor μ∞, instead of `mu_0`";
        c_f: Number, aside "fragility C_F";
        p_inf: PRESSURE, aside "pressure p∞ at which the viscosity diverges";
        pressure: PRESSURE_LAW, aside "law of the pressure dependence";
    }
    SHEAR_KEYS {
        law: Text, aside "law of shear thinning";
        g_c, g: PRESSURE, usual [SHEAR_STRESS], aside "stress at which the lubricant begins to thin";
        n: Number, aside "exponent n";
        a, beta_c: Number, aside "exponent of the transition to the power law";
        mu_2: VISCOSITY, aside "viscosity of the second plateau at ambient pressure, `\"0 Pa.s\"` for none";
        reference_temperature: TEMPERATURE, aside "where `mu_2` holds";
        tau_0: PRESSURE, usual [SHEAR_STRESS], aside "stress at which the lubricant begins to thin";
        tau_l0: PRESSURE, usual [SHEAR_STRESS], aside "limiting shear stress at ambient pressure";
        lambda: Number, aside "rise of the limiting shear stress over pressure, 0 to 10";
        limit: Table(LIMIT), aside "limiting shear stress of a law, `tau_l0 + lambda p`";
    }
    LIMIT {
        tau_l0: PRESSURE, usual [SHEAR_STRESS], aside "limiting shear stress at ambient pressure";
        lambda: Number, aside "its rise over pressure, 0 to 10";
    }
    CONDUCTIVITY_KEYS {
        law: Text, aside "law of the thermal conductivity";
        k_0: Quantity(&[D::THERMAL_CONDUCTIVITY]), usual [FILM_CONDUCTIVITY, SOLID_CONDUCTIVITY], aside "conductivity at ambient pressure";
        reference_temperature: TEMPERATURE, aside "where the constants hold";
        a_t: PER_KELVIN, aside "slope over temperature";
        a_p, d_1, d_2: PER_PRESSURE, aside "coefficients of the pressure";
        b, c: Quantity(&[D::THERMAL_CONDUCTIVITY]), aside "constants of the scaling";
        s, a, q: Number, aside "constants of the scaling";
    }
    HEAT_CAPACITY_KEYS {
        law: Text, aside "law of the heat capacity";
        c_0: Quantity(&[D::SPECIFIC_HEAT]), usual [SPECIFIC_HEATS], aside "heat capacity at ambient pressure";
        rho_c_0: Quantity(&[D::VOLUMETRIC_HEAT]), aside "heat capacity per volume at ambient pressure";
        m: Quantity(&[D::VOLUMETRIC_HEAT]), aside "slope m of the scaling, per volume";
        w: Number, default "4", aside "exponent w of the volume";
        reference_temperature: TEMPERATURE, aside "where the constants hold";
        a_t: PER_KELVIN, aside "slope over temperature";
        a_p, k_1, k_2: PER_PRESSURE, aside "coefficients of the pressure";
        beta_0: PER_KELVIN, aside "temperature coefficient β₀ at ambient pressure";
        b_1: PER_PRESSURE, aside "its relative slope with pressure";
        b_2: Quantity(&[D::INVERSE_PRESSURE_SQUARED]), aside "its relative curvature with pressure";
    }
    /// `[[correlation]]`.
    pub CORRELATION {
        of: Text, aside "key path of a quantity with an uncertainty";
        with: Text, aside "key path of another one";
        coefficient: Number, aside "coefficient of their correlation, -1 to 1";
    }
}

impl Laws {
    /// The keys of all laws: their own, and those of tables.
    pub fn tables(&self) -> Vec<&'static [Row]> {
        let of_tables = self.laws.iter().find(|law| law.name == "table");
        let of_tables = of_tables.map(|_| TABLE_KEYS);
        std::iter::once(self.keys).chain(of_tables).collect()
    }

    /// The keys of one of the laws.
    pub fn keys_of(&self, law: &Law) -> Vec<&'static str> {
        let words = |text: &'static str| text.split('`').skip(1).step_by(2);
        let is_key =
            |word: &&str| (self.tables().into_iter().flatten()).any(|row| row.keys.contains(word));
        (words(law.needs).chain(words(law.optional)))
            .filter(is_key)
            .collect()
    }
}
