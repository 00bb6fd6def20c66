//! Radial internal clearance by class.

/// Clearance classes of ISO 5753-1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClearanceClass {
    /// C2: less than normal.
    C2,
    /// CN.
    #[default]
    Normal,
    /// C3.
    C3,
    /// C4.
    C4,
}

impl ClearanceClass {
    /// The class that a suffix names, and the text before and after it: `C3` of `2RSC3`, `C3P6QE6`, `C3WT`, and `P63` for the class P6 with C3.
    pub(super) fn within(suffix: &str) -> (Option<ClearanceClass>, Vec<&str>) {
        let classes = [
            ("C2", ClearanceClass::C2),
            ("CN", ClearanceClass::Normal),
            ("C0", ClearanceClass::Normal),
            ("C3", ClearanceClass::C3),
            ("C4", ClearanceClass::C4),
        ];
        for (name, class) in classes {
            // A further digit would make it another suffix.
            let ends = |at: usize| !suffix[at + 2..].starts_with(|c: char| c.is_ascii_digit());
            if let Some(at) = suffix.find(name).filter(|at| ends(*at)) {
                return (Some(class), vec![&suffix[..at], &suffix[at + 2..]]);
            }
        }
        // Tolerance class and clearance in one, as ISO 5753 has it: P63 is P6 with C3.
        let merged = [
            ("P62", ClearanceClass::C2),
            ("P63", ClearanceClass::C3),
            ("P64", ClearanceClass::C4),
            ("P52", ClearanceClass::C2),
            ("P53", ClearanceClass::C3),
            ("P54", ClearanceClass::C4),
        ];
        match merged.iter().find(|(name, _)| *name == suffix) {
            Some((_, class)) => (Some(*class), vec![&suffix[..2]]),
            None => (None, vec![suffix]),
        }
    }
}

/// Deep groove ball bearings: bore over and up to, mm; least and largest clearance of C2, CN, C3 and C4, µm. DIN 620-4 in Schaeffler,
/// Rolling Bearings, catalogue HR 1, 2006.
const DEEP_GROOVE: [[f64; 10]; 11] = [
    [6.0, 10.0, 0.0, 7.0, 2.0, 13.0, 8.0, 23.0, 14.0, 29.0],
    [10.0, 18.0, 0.0, 9.0, 3.0, 18.0, 11.0, 25.0, 18.0, 33.0],
    [18.0, 24.0, 0.0, 10.0, 5.0, 20.0, 13.0, 28.0, 20.0, 36.0],
    [24.0, 30.0, 1.0, 11.0, 5.0, 20.0, 13.0, 28.0, 23.0, 41.0],
    [30.0, 40.0, 1.0, 11.0, 6.0, 20.0, 15.0, 33.0, 28.0, 46.0],
    [40.0, 50.0, 1.0, 11.0, 6.0, 23.0, 18.0, 36.0, 30.0, 51.0],
    [50.0, 65.0, 1.0, 15.0, 8.0, 28.0, 23.0, 43.0, 38.0, 61.0],
    [65.0, 80.0, 1.0, 15.0, 10.0, 30.0, 25.0, 51.0, 46.0, 71.0],
    [80.0, 100.0, 1.0, 18.0, 12.0, 36.0, 30.0, 58.0, 53.0, 84.0],
    [100.0, 120.0, 2.0, 20.0, 15.0, 41.0, 36.0, 66.0, 61.0, 97.0],
    [120.0, 140.0, 2.0, 23.0, 18.0, 48.0, 41.0, 81.0, 71.0, 114.0],
];

/// Cylindrical roller bearings with a cage: the same of CN, C3 and C4; same source.
const CYLINDRICAL: [[f64; 8]; 9] = [
    [0.0, 24.0, 20.0, 45.0, 35.0, 60.0, 50.0, 75.0],
    [24.0, 30.0, 20.0, 45.0, 35.0, 60.0, 50.0, 75.0],
    [30.0, 40.0, 25.0, 50.0, 45.0, 70.0, 60.0, 85.0],
    [40.0, 50.0, 30.0, 60.0, 50.0, 80.0, 70.0, 100.0],
    [50.0, 65.0, 40.0, 70.0, 60.0, 90.0, 80.0, 110.0],
    [65.0, 80.0, 40.0, 75.0, 65.0, 100.0, 90.0, 125.0],
    [80.0, 100.0, 50.0, 85.0, 75.0, 110.0, 105.0, 140.0],
    [100.0, 120.0, 50.0, 90.0, 85.0, 125.0, 125.0, 165.0],
    [120.0, 140.0, 60.0, 105.0, 100.0, 145.0, 145.0, 190.0],
];

/// Least and largest radial internal clearance before mounting, m, of deep groove ball bearings or cylindrical roller bearings of the bore
/// (m); `None` outside of the tables.
pub fn radial_clearance(rollers: bool, class: ClearanceClass, bore: f64) -> Option<[f64; 2]> {
    let place = class as usize;
    let micrometres = match rollers {
        false => entry(&DEEP_GROOVE, 1e3 * bore, place),
        true => entry(&CYLINDRICAL, 1e3 * bore, place.checked_sub(1)?),
    };
    Some(micrometres?.map(|c| c * 1e-6))
}

/// The clearances of a class, by its place, in the row of a bore (mm).
fn entry<const N: usize>(table: &[[f64; N]], bore: f64, place: usize) -> Option<[f64; 2]> {
    // A bore on a limit belongs to the row that ends there.
    let is_it = |row: &&[f64; N]| bore > row[0] - 1e-9 && bore <= row[1] + 1e-9;
    let row = table.iter().find(is_it)?;
    Some([row[2 + 2 * place], row[3 + 2 * place]])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of the tables of HR 1: a bore of 30 mm is "over 24 including 30".
    #[test]
    fn rows() {
        let at = |rollers, class, bore| {
            let [low, high] = radial_clearance(rollers, class, bore).unwrap();
            [(low * 1e6).round(), (high * 1e6).round()]
        };
        assert_eq!(at(false, ClearanceClass::Normal, 0.030), [5.0, 20.0]);
        assert_eq!(at(false, ClearanceClass::C3, 0.035), [15.0, 33.0]);
        assert_eq!(at(false, ClearanceClass::C2, 0.010), [0.0, 7.0]);
        assert_eq!(at(true, ClearanceClass::Normal, 0.030), [20.0, 45.0]);
        assert_eq!(at(true, ClearanceClass::C4, 0.100), [105.0, 140.0]);
        assert_eq!(radial_clearance(true, ClearanceClass::C2, 0.030), None);
        assert_eq!(radial_clearance(false, ClearanceClass::C3, 0.5), None);
    }
}
