//! Hardness over depth, and the yield strength that it stands for.

/// Vickers hardness over depth, linear between the given depths and constant outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Hardness {
    /// Depths, m, ascending, and the hardness there, HV.
    points: Vec<[f64; 2]>,
}

/// Yield strength per Vickers hardness, Pa/HV: H = 3 σ_y with H in kgf/mm² (Tabor 1951).
pub const YIELD_PER_HARDNESS: f64 = 9.80665e6 / 3.0;
/// Hardness at the case depth, HV (ISO 18203).
pub const CASE_HARDNESS: f64 = 550.0;

/// Steps of a smooth profile, and the multiples of its length to which it reaches.
const STEPS: usize = 60;
const REACH: f64 = 4.0;

impl Hardness {
    /// The same at all depths, as of through-hardened steel.
    pub fn uniform(hardness: f64) -> Hardness {
        Hardness {
            points: vec![[0.0, hardness]],
        }
    }

    /// From a table, depths ascending.
    ///
    /// # Errors
    /// Which rule is broken: there are two points or more, depths ascend from zero or more, and no hardness is below that of the last depth,
    /// the core.
    pub fn of_table(points: Vec<[f64; 2]>) -> Result<Hardness, &'static str> {
        if points.len() < 2 {
            return Err(
                "a table of hardness needs at least two depths; a body of one hardness has `uniform`",
            );
        }
        if points[0][0] < 0.0 || points.windows(2).any(|pair| pair[1][0] <= pair[0][0]) {
            return Err("the depths of a table of hardness must ascend, from zero or more");
        }
        let core = points[points.len() - 1][1];
        if points.iter().any(|p| p[1] < core) {
            return Err(
                "the hardness must fall to a core value: that of the last depth must be the lowest",
            );
        }
        Ok(Hardness { points })
    }

    /// A case-hardened layer: core + (surface − core) exp(−(z/s)²), with s so that the hardness at the case depth is 550 HV.
    ///
    /// # Errors
    /// If that is not between core and surface.
    pub fn of_case(surface: f64, core: f64, depth: f64) -> Result<Hardness, &'static str> {
        if core >= surface {
            return Err("the hardness must fall to a core value: `core` must be below `surface`");
        }
        if CASE_HARDNESS <= core || CASE_HARDNESS >= surface {
            return Err(
                "the case depth is where the hardness is 550 HV, which must be between `core` and `surface`",
            );
        }
        let length = depth / ((surface - core) / (CASE_HARDNESS - core)).ln().sqrt();
        let point = |i: usize| {
            let z = REACH * i as f64 / STEPS as f64;
            [z * length, core + (surface - core) * (-z * z).exp()]
        };
        Ok(Hardness {
            points: (0..=STEPS).map(point).collect(),
        })
    }

    /// Hardness at a depth, HV.
    pub fn at(&self, z: f64) -> f64 {
        between(&self.points, 1, z)
    }
}

/// A column of rows that begin with ascending depths at a depth, linear between them and constant outside.
pub(super) fn between<const N: usize>(rows: &[[f64; N]], column: usize, z: f64) -> f64 {
    let next = rows.partition_point(|row| row[0] <= z);
    match (next.checked_sub(1).map(|i| &rows[i]), rows.get(next)) {
        (Some(low), Some(high)) => {
            let share = (z - low[0]) / (high[0] - low[0]);
            low[column] + share * (high[column] - low[column])
        }
        (Some(row), None) | (None, Some(row)) => row[column],
        (None, None) => f64::NAN,
    }
}
