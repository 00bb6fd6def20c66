//! Series of bearings, and what they are called elsewhere.

use super::{Boundary, Special};

/// Series of the catalogue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Series {
    /// Deep groove ball bearings 60.
    DeepGroove60,
    /// 62.
    DeepGroove62,
    /// 63.
    DeepGroove63,
    /// Angular contact ball bearings 72..B.
    Angular72B,
    /// 73..B.
    Angular73B,
    /// Cylindrical roller bearings NU10.
    CylindricalNu10,
    /// NU2..E.
    CylindricalNu2,
    /// NU3..E.
    CylindricalNu3,
    /// Tapered roller bearings 302.
    Tapered302,
    /// 303.
    Tapered303,
    /// 320..X.
    Tapered320X,
    /// 322.
    Tapered322,
    /// 323.
    Tapered323,
}

impl Series {
    /// All of them.
    pub const ALL: [Series; 13] = [
        Series::DeepGroove60,
        Series::DeepGroove62,
        Series::DeepGroove63,
        Series::Angular72B,
        Series::Angular73B,
        Series::CylindricalNu10,
        Series::CylindricalNu2,
        Series::CylindricalNu3,
        Series::Tapered302,
        Series::Tapered303,
        Series::Tapered320X,
        Series::Tapered322,
        Series::Tapered323,
    ];

    /// Whether its bearings have tapered rollers.
    pub fn is_tapered(self) -> bool {
        matches!(
            self,
            Series::Tapered302
                | Series::Tapered303
                | Series::Tapered320X
                | Series::Tapered322
                | Series::Tapered323
        )
    }

    /// Letters before and after the bore code.
    pub(super) fn affixes(self) -> [&'static str; 2] {
        match self {
            Series::DeepGroove60 => ["60", ""],
            Series::DeepGroove62 => ["62", ""],
            Series::DeepGroove63 => ["63", ""],
            Series::Angular72B => ["72", "B"],
            Series::Angular73B => ["73", "B"],
            Series::CylindricalNu10 => ["NU10", ""],
            Series::CylindricalNu2 => ["NU2", "E"],
            Series::CylindricalNu3 => ["NU3", "E"],
            Series::Tapered302 => ["302", ""],
            Series::Tapered303 => ["303", ""],
            Series::Tapered320X => ["320", "X"],
            Series::Tapered322 => ["322", ""],
            Series::Tapered323 => ["323", ""],
        }
    }

    /// Rows of `dimensions.csv`: bore code, d, D and B (mm), further dimensions, C and C_0 (kN).
    fn rows(self) -> impl Iterator<Item = Vec<f64>> {
        let series = self.affixes().concat();
        let lines = include_str!("dimensions.csv").lines();
        lines.filter_map(move |line| {
            let numbers = line.strip_prefix(&series)?.strip_prefix(',')?;
            Some(
                numbers
                    .split(',')
                    .map(|number| number.parse().expect("a number"))
                    .collect(),
            )
        })
    }

    /// Nominal contact angle of ratings, rad; `None` of tapered roller bearings, whose angles differ.
    pub fn nominal_angle(self) -> Option<f64> {
        match self {
            Series::DeepGroove60
            | Series::DeepGroove62
            | Series::DeepGroove63
            | Series::CylindricalNu10
            | Series::CylindricalNu2
            | Series::CylindricalNu3 => Some(0.0),
            Series::Angular72B | Series::Angular73B => Some(40_f64.to_radians()),
            Series::Tapered302
            | Series::Tapered303
            | Series::Tapered320X
            | Series::Tapered322
            | Series::Tapered323 => None,
        }
    }

    /// Bore codes of the catalogue.
    pub fn codes(self) -> impl Iterator<Item = u8> {
        self.rows().map(|row| row[0] as u8)
    }

    fn row(self, code: u8) -> Option<Vec<f64>> {
        self.rows().find(|row| row[0] == f64::from(code))
    }

    /// Dimensions of a bore code.
    pub(super) fn boundary(self, code: u8) -> Option<Boundary> {
        let row = self.row(code)?;
        // The last two columns are ratings.
        let special = match row[4..row.len() - 2] {
            [inner, outer] => Special::Raceways {
                inner: inner * 1e-3,
                outer: outer * 1e-3,
            },
            [cup_width, width, degrees] => Special::Taper {
                cup_width: cup_width * 1e-3,
                width: width * 1e-3,
                contact_angle: degrees.to_radians(),
            },
            _ => Special::None,
        };
        Some(Boundary {
            bore: row[1] * 1e-3,
            outside: row[2] * 1e-3,
            width: row[3] * 1e-3,
            special,
        })
    }

    /// C and C_0, kN, where the table has them.
    pub(super) fn ratings(self, code: u8) -> Option<[f64; 2]> {
        match self.row(code)?[..] {
            [.., dynamic, fixed] if dynamic > 0.0 => Some([dynamic, fixed]),
            _ => None,
        }
    }

    /// By how much ratings C and C_0 of estimated geometries miss those of a maker, relative: twice the root mean square over the bearings of a series, rounded up
    /// (the tests of the catalogue).
    pub fn rating_spread(self) -> f64 {
        match self {
            Series::DeepGroove60 | Series::DeepGroove62 | Series::DeepGroove63 => 0.13,
            Series::Angular72B | Series::Angular73B => 0.24,
            // Makers fill the width of the wide and of the old designs in different ways.
            Series::CylindricalNu10 => 1.25,
            Series::CylindricalNu2 | Series::CylindricalNu3 => 0.15,
            Series::Tapered302
            | Series::Tapered303
            | Series::Tapered320X
            | Series::Tapered322
            | Series::Tapered323 => 0.23,
        }
    }
}
