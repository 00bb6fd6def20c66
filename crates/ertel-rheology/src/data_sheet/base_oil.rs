//! Kinds of base oils, and what is estimated of each.

use super::{Estimate, Spread};

/// Factor s and exponent t of the formula of Gold and others.
const SLOPES_OF_MINERAL_OIL: [f64; 2] = [0.9904, 0.1390];
const SLOPES_OF_PAO: [f64; 2] = [0.7382, 0.1335];
const SLOPES_OF_ESTER: [f64; 2] = [0.6605, 0.1360];
const SLOPES_OF_PAG: [f64; 2] = [0.5489, 0.1485];

/// Measured initial slopes over the formula of Gold and others, mean of 44 ([`BaseOil::pressure_viscosity`]).
const SLOPES_OVER_FORMULA: f64 = 1.36;
/// The same of the five mineral oils with a viscosity index below 20, mean of 15.
const SLOPES_OF_LOW_INDEX: f64 = 1.42;

/// Kind of the base oil.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BaseOil {
    /// Mineral oil.
    Mineral,
    /// Polyalphaolefin.
    Pao,
    /// Synthetic ester.
    Ester,
    /// Polyalkylene glycol.
    Pag,
    /// Naphthenic mineral oil, of a low viscosity index.
    Naphthenic,
    /// Mineral oil of Group III of the API, of a viscosity index of 120 and above.
    GroupIII,
}

impl BaseOil {
    /// The kinds with their names in data files.
    pub const NAMES: [(&'static str, BaseOil); 6] = [
        ("mineral", Self::Mineral),
        ("PAO", Self::Pao),
        ("ester", Self::Ester),
        ("PAG", Self::Pag),
        ("naphthenic", Self::Naphthenic),
        ("Group III", Self::GroupIII),
    ];

    /// Its name in data files.
    #[must_use]
    pub fn name(self) -> &'static str {
        let found = Self::NAMES.iter().find(|(_, kind)| *kind == self);
        found.map_or("", |(name, _)| name)
    }

    /// The kind by one of its names in small letters and digits: `polyalphaolefin`, `groupiv`; `None` of kinds without correlations.
    ///
    /// Groups are those of API 1509, appendix E: I and II are mineral oils with a viscosity index of 80 to 120, III with one of 120 and
    /// above, IV polyalphaolefins, V all others, naphthenic oils among them.
    pub(crate) fn by_other_name(plain: &str) -> Option<Self> {
        let group = ["apigroup", "group", "apigruppe", "gruppe"]
            .iter()
            .find_map(|mark| plain.strip_prefix(mark));
        match group.unwrap_or(plain) {
            "mineral" | "mineraloil" | "mineraloel" | "paraffinic" | "paraffinicoil" => {
                Some(Self::Mineral)
            }
            "i" | "ii" | "1" | "2" if group.is_some() => Some(Self::Mineral),
            "naphthenic" | "naphthenicoil" | "naphthenisch" => Some(Self::Naphthenic),
            "iii" | "3" if group.is_some() => Some(Self::GroupIII),
            "pao" | "polyalphaolefin" | "polyalphaolefine" => Some(Self::Pao),
            "iv" | "4" if group.is_some() => Some(Self::Pao),
            "ester" | "esters" | "polyolester" | "diester" | "poe" => Some(Self::Ester),
            "pag" | "polyalkyleneglycol" | "polyglycol" | "polyglykol" => Some(Self::Pag),
            _ => None,
        }
    }

    /// Pressure-viscosity coefficient (1/Pa) from the kinematic viscosity `nu` (m²/s) at the same temperature (Gold,
    /// Schmidt, Dicke, Loos and Assmann, J. Synthetic Lubrication 18, 2001, 51-79):
    ///
    /// ```text
    /// α = 1.36 s ν^t 10⁻⁸ 1/Pa          ν in mm²/s
    /// ```
    ///
    /// The paper was not available. The constants are those of a public program, which exchanges the names s and t (as
    /// it stands there its coefficient of a mineral oil of 100 mm²/s would be 133 1/GPa). A second program of the same
    /// author exchanges PAO and ester.
    ///
    /// A naphthenic oil has the constants of a mineral one with 1.42 instead of 1.36, the mean of the 15 slopes of the five mineral oils with
    /// a viscosity index below 20; Group III lies midway between mineral oil and PAO.
    ///
    /// The factor 1.36 is not theirs. 44 independent initial slopes (38 of mineral oils, 4 of PAO, 2 of esters) lie 1.05 to
    /// 1.64 times above `s ν^t`, on average 1.36 times with a standard deviation of 0.14: presumably the paper means the
    /// coefficient between ambient pressure and 200 MPa, which is smaller than the initial slope that the laws take.
    ///
    /// Theory: Pressure-viscosity coefficient.
    pub fn pressure_viscosity(self, nu: f64) -> Estimate {
        let [s, t] = match self {
            Self::Mineral | Self::Naphthenic => SLOPES_OF_MINERAL_OIL,
            Self::Pao => SLOPES_OF_PAO,
            Self::Ester => SLOPES_OF_ESTER,
            Self::Pag => SLOPES_OF_PAG,
            Self::GroupIII => {
                return Estimate::midway(
                    &Self::Mineral.pressure_viscosity(nu),
                    &Self::Pao.pressure_viscosity(nu),
                );
            }
        };
        let factor = match self {
            Self::Naphthenic => SLOPES_OF_LOW_INDEX,
            _ => SLOPES_OVER_FORMULA,
        };
        // Two standard deviations of the slopes; no slope of a polyglycol is among them: down to the formula itself.
        let (share, basis, source) = match self {
            Self::Pag => (
                0.3,
                "no measured slope of a polyalkylene glycol was found: the formula times 1.36 as for the other oils, with a range \
                 that covers the formula without the factor",
                "gold2001, constants read in feup_gear, times 1.36",
            ),
            Self::Naphthenic => (
                0.21,
                "15 measured initial slopes of five mineral oils with a viscosity index below 20 are 1.13 to 1.61 times the formula of \
                 mineral oils, on average 1.42 times (stachowiak_batchelor, table 2.3)",
                "gold2001, constants read in feup_gear, times 1.42",
            ),
            _ => (
                0.21,
                "44 measured initial slopes of 19 oils are 1.05 to 1.64 times the formula, on average 1.36 times \
                 (stachowiak_batchelor, table 2.3; kreuz_pao; baomaokuan_bearing)",
                "gold2001, constants read in feup_gear, times 1.36",
            ),
        };
        Estimate {
            value: factor * s * (nu * 1e6).powf(t) * 1e-8,
            below: share,
            above: share,
            spread: Spread::Normal,
            source,
            basis,
        }
    }

    /// Share of the density at 15 degC that an oil loses for each kelvin (1/K); of Group III midway between mineral oil and PAO.
    pub fn expansion(self) -> Estimate {
        let value = match self {
            Self::Mineral | Self::Naphthenic => 5.8e-4,
            Self::Pao => 5.5e-4,
            Self::GroupIII => 5.65e-4,
            Self::Ester => 8.1e-4,
            Self::Pag => 7.1e-4,
        };
        Estimate::even(
            value,
            [0.2, 0.2],
            "feup_gear, one gear oil of each kind",
            "the oils of one kind there differ by up to 20 %",
        )
    }

    /// Density at 15 degC (kg/m³); of Group III midway between mineral oil and PAO.
    pub fn density_at_15(self) -> Estimate {
        let value = match self {
            Self::Mineral | Self::Naphthenic => 902.0,
            Self::Pao => 859.0,
            Self::GroupIII => 880.0,
            Self::Ester => 915.0,
            Self::Pag => 1059.0,
        };
        Estimate::even(
            value,
            [0.05, 0.05],
            "feup_gear, one gear oil of each kind",
            "the oils of one kind there differ by up to 5 %",
        )
    }

    /// Viscosity index; `None` for kinds whose oils differ too much.
    pub fn viscosity_index(self) -> Option<Estimate> {
        let typical = |value, range, basis| {
            Some(Estimate::even(
                value,
                range,
                "gearpie, grades 32 to 680",
                basis,
            ))
        };
        match self {
            Self::Mineral => typical(95.0, [0.1, 0.1], "grades there have 86 to 103"),
            Self::Pao => typical(150.0, [0.06, 0.27], "grades there have 141 to 190"),
            Self::Ester | Self::Pag | Self::Naphthenic | Self::GroupIII => None,
        }
    }
}
