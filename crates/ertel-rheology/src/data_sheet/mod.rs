//! Estimates for oils of which only the data sheet is known.
//!
//! What a data sheet does not give is taken from published correlations and from typical values. Each is an
//! [`Estimate`]: a number with the range in which the truth is expected, and where both come from.

mod index_table;
mod viscosity_index;

pub use viscosity_index::{viscosity_at_40, viscosity_at_100, viscosity_index};

use ertel_quantity::{COVERAGE, Uncertainty};

/// Viscosity grades of ISO 3448: kinematic viscosity at 40 degC in mm²/s, within 10 %.
pub const ISO_VG: [f64; 20] = [
    2.2, 3.2, 4.6, 6.8, 10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0,
    680.0, 1000.0, 1500.0, 2200.0, 3200.0,
];
/// Their names, which round the first four.
pub(crate) const ISO_VG_NAMES: [f64; 20] = [
    2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0,
    680.0, 1000.0, 1500.0, 2200.0, 3200.0,
];
/// Share by which the viscosity of an oil may leave that of its grade.
pub const ISO_VG_TOLERANCE: f64 = 0.1;

/// Density of water at 15 degC (kg/m³), to which relative densities refer.
pub const WATER_AT_15: f64 = 999.1;

/// A number that a data sheet does not give.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The number in SI.
    pub value: f64,
    /// How far below it the truth may lie, as a share of it.
    pub below: f64,
    /// How far above.
    pub above: f64,
    /// Key in the bibliography, and the place.
    pub source: &'static str,
    /// How the truth is spread over the range.
    pub spread: Spread,
    /// What the range rests on.
    pub basis: &'static str,
}

/// How the truth is spread over the range of an estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spread {
    /// Normally about the number: the range holds 95 % of such oils.
    Normal,
    /// Evenly between the ends of the range.
    Even,
}

impl Estimate {
    /// The range as an uncertainty of the number, SI; where the range has two arms, with their mean to either side.
    #[must_use]
    pub fn uncertainty(&self) -> Uncertainty {
        let half_width = 0.5 * (self.below + self.above) * self.value.abs();
        match self.spread {
            Spread::Normal => Uncertainty::Normal {
                standard: half_width / COVERAGE,
            },
            Spread::Even => Uncertainty::Uniform { half_width },
        }
    }
}

/// Measured initial slopes over the formula of Gold and others, mean of 44 ([`BaseOil::pressure_viscosity`]).
const SLOPES_OVER_FORMULA: f64 = 1.36;

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
}

impl BaseOil {
    /// The kinds with their names in data files.
    pub const NAMES: [(&'static str, BaseOil); 4] = [
        ("mineral", Self::Mineral),
        ("PAO", Self::Pao),
        ("ester", Self::Ester),
        ("PAG", Self::Pag),
    ];

    /// Its name in data files.
    #[must_use]
    pub fn name(self) -> &'static str {
        let found = Self::NAMES.iter().find(|(_, kind)| *kind == self);
        found.map_or("", |(name, _)| name)
    }

    /// The kind by one of its names in small letters and digits: `polyalphaolefin`, `groupiv`; `None` of kinds without correlations.
    pub(crate) fn by_other_name(plain: &str) -> Option<Self> {
        match plain {
            "mineral" | "mineraloil" | "mineraloel" | "paraffinic" | "groupi" | "apigroupi"
            | "gruppei" => Some(Self::Mineral),
            "pao" | "polyalphaolefin" | "polyalphaolefine" | "groupiv" | "apigroupiv"
            | "gruppeiv" => Some(Self::Pao),
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
    /// | base oil | s | t |
    /// |---|---|---|
    /// | mineral | 0.9904 | 0.1390 |
    /// | PAO | 0.7382 | 0.1335 |
    /// | ester | 0.6605 | 0.1360 |
    /// | PAG | 0.5489 | 0.1485 |
    ///
    /// The paper was not at hand. The constants are those of a public program, which exchanges the names s and t (as
    /// it stands there its coefficient of a mineral oil of 100 mm²/s would be 133 1/GPa). A second program of the same
    /// author exchanges PAO and ester.
    ///
    /// The factor 1.36 is not theirs. 44 independent initial slopes (38 of mineral oils, 4 of PAO, 2 of esters) lie 1.05 to
    /// 1.64 times above `s ν^t`, on average 1.36 times with a standard deviation of 0.14: presumably the paper means the
    /// coefficient between ambient pressure and 200 MPa, which is smaller than the initial slope that the laws take.
    ///
    /// Theory: Pressure-viscosity coefficient.
    pub fn pressure_viscosity(self, nu: f64) -> Estimate {
        let (s, t) = match self {
            Self::Mineral => (0.9904, 0.1390),
            Self::Pao => (0.7382, 0.1335),
            Self::Ester => (0.6605, 0.1360),
            Self::Pag => (0.5489, 0.1485),
        };
        // Two standard deviations of the 44 slopes; no slope of a polyglycol is among them: down to the formula itself.
        let (share, basis) = match self {
            Self::Pag => (
                0.3,
                "no measured slope of a polyalkylene glycol was found: the formula times 1.36 as for the other oils, with a range \
                 that holds the formula itself",
            ),
            _ => (
                0.21,
                "44 measured initial slopes of 19 oils are 1.05 to 1.64 times the formula, on average 1.36 times \
                 (stachowiak_batchelor, table 2.3; kreuz_pao; baomaokuan_bearing)",
            ),
        };
        Estimate {
            value: SLOPES_OVER_FORMULA * s * (nu * 1e6).powf(t) * 1e-8,
            below: share,
            above: share,
            spread: Spread::Normal,
            source: "gold2001, constants read in feup_gear, times 1.36",
            basis,
        }
    }

    /// Share of the density at 15 degC that an oil loses for each kelvin (1/K).
    pub fn expansion(self) -> Estimate {
        Estimate {
            value: match self {
                Self::Mineral => 5.8e-4,
                Self::Pao => 5.5e-4,
                Self::Ester => 8.1e-4,
                Self::Pag => 7.1e-4,
            },
            below: 0.2,
            above: 0.2,
            spread: Spread::Even,
            source: "feup_gear, one gear oil of each kind",
            basis: "the oils of one kind there differ by up to 20 %",
        }
    }

    /// Density at 15 degC (kg/m³).
    pub fn density_at_15(self) -> Estimate {
        Estimate {
            value: match self {
                Self::Mineral => 902.0,
                Self::Pao => 859.0,
                Self::Ester => 915.0,
                Self::Pag => 1059.0,
            },
            below: 0.05,
            above: 0.05,
            spread: Spread::Even,
            source: "feup_gear, one gear oil of each kind",
            basis: "the oils of one kind there differ by up to 5 %",
        }
    }

    /// Viscosity index; `None` for kinds whose oils differ too much.
    pub fn viscosity_index(self) -> Option<Estimate> {
        let typical = |value, below, above, basis| {
            Some(Estimate {
                value,
                below,
                above,
                spread: Spread::Even,
                source: "gearpie, grades 32 to 680",
                basis,
            })
        };
        match self {
            Self::Mineral => typical(95.0, 0.1, 0.1, "grades there have 86 to 103"),
            Self::Pao => typical(150.0, 0.06, 0.27, "grades there have 141 to 190"),
            Self::Ester | Self::Pag => None,
        }
    }
}

#[cfg(test)]
mod tests;
