//! Axial profile of a roller: its drop from a cylinder.

use super::measured::Treatment;
use serde::Serialize;

/// The logarithm follows its tangent from where 1 − c t² is this: it would be infinite at the very end where c = 1.
const TANGENT_FROM: f64 = 1e-5;

/// Relief of a roller of length l, as the drop z(y) ≥ 0 from the cylinder, m; y from the middle of the roller along its axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Profile {
    /// A cylinder with rounded ends: z = 0 up to |y| = s/2, an arc beyond with a common tangent.
    Straight {
        /// Length s of the straight part, m.
        straight_length: f64,
        /// Radius of the arcs, m.
        end_radius: f64,
    },
    /// One arc from end to end.
    Crown {
        /// Its radius, m.
        crown_radius: f64,
    },
    /// z = A ln{1/[1 − c t²]},  t = (2|y| − s)/(l − s) where that is positive.
    ///
    /// Lundberg and Johns-Gohar: s = 0, A = 2w/(πE'), c = 1 − e^(−½)b/l; ISO/TS 16281: c = 1.
    Logarithmic {
        /// A, m.
        amplitude: f64,
        /// s, m.
        straight_length: f64,
        /// c.
        share: f64,
    },
    /// Drops at positions.
    Table(ProfileTable),
}

/// z and dz/dy of an arc of the radius r that begins at t = 0: z = r − √(r² − t²) without cancellation.
fn arc(t: f64, radius: f64) -> [f64; 2] {
    let root = (radius * radius - t * t).sqrt();
    [t * t / (radius + root), t / root]
}

impl Profile {
    /// The profile under which the line pressure of a roller of the length l (m) is uniform at a load per length w (N/m), when its
    /// Hertz half-width is b (m), for the reduced modulus E' (Pa).
    ///
    /// ```text
    ///   z = 2w/(πE') ln{1/[1 − (1 − e^(−½) b/l)(2y/l)²]},   at the ends 2w/(πE') [½ + ln 2 + ln(l/2b)]
    /// ```
    /// Source: Lundberg 1939, who gives the drop at the ends as 2w/(πE') [1.1932 + ln(l/2b)]; the form that is finite there is that of
    /// Johns and Gohar (Tribology International 14, 1981, 131-136) with 0.3033 for ½e^(−½). The constant follows from the potential
    /// of a strip of Hertz pressure, whose mean of ln|x| is ln(b/2) − ½.
    pub fn lundberg(length: f64, line_load: f64, half_width: f64, reduced_modulus: f64) -> Profile {
        Profile::Logarithmic {
            amplitude: 2.0 * line_load / (std::f64::consts::PI * reduced_modulus),
            straight_length: 0.0,
            share: 1.0 - (-0.5_f64).exp() * half_width / length,
        }
    }

    /// The reference profile of ISO/TS 16281 for a roller of the length l and the diameter D, m.
    ///
    /// ```text
    ///   l ≤ 2.5 D:  z = 0.00035 D ln{1/[1 − (2y/l)²]}
    ///   l > 2.5 D:  z = 0.0005 D ln{1/[1 − ((2|y| − (l − 2.5 D))/(2.5 D))²]} beyond |y| = (l − 2.5 D)/2, else 0
    /// ```
    /// Source: ISO/TS 16281:2008, eqs. 42 to 44, as two programs for bearings quote them: a public implementation of the standard has both
    /// factors and the length 2.5 D, the manual of MESYS 0.00035 D for short rollers. The standard itself was not at hand.
    pub fn iso_16281(length: f64, diameter: f64) -> Profile {
        let reach = 2.5 * diameter;
        let (factor, straight_length) = match length <= reach {
            true => (0.000_35, 0.0),
            false => (0.000_5, length - reach),
        };
        Profile::Logarithmic {
            amplitude: factor * diameter,
            straight_length,
            share: 1.0,
        }
    }

    /// z (m) and dz/dy at y (m) of a roller of the given length (m).
    pub fn drop(&self, length: f64, y: f64) -> [f64; 2] {
        let signed = |[z, slope]: [f64; 2]| [z, y.signum() * slope];
        match self {
            Profile::Straight {
                straight_length,
                end_radius,
            } => match y.abs() - 0.5 * straight_length {
                t if t <= 0.0 => [0.0; 2],
                t => signed(arc(t, *end_radius)),
            },
            Profile::Crown { crown_radius } => arc(y, *crown_radius),
            Profile::Logarithmic {
                amplitude,
                straight_length,
                share,
            } => {
                let t = (2.0 * y.abs() - straight_length) / (length - straight_length);
                if t <= 0.0 {
                    return [0.0; 2];
                }
                let last = ((1.0 - TANGENT_FROM) / share).sqrt();
                let at = t.min(last);
                let rest = 1.0 - share * at * at;
                let slope = amplitude * 2.0 * share * at / rest;
                let z = -amplitude * rest.ln() + slope * (t - at);
                signed([z, slope * 2.0 / (length - straight_length)])
            }
            Profile::Table(table) => table.drop(y),
        }
    }

    /// Where the curvature jumps by design, m; symmetric about the middle.
    pub fn kinks(&self) -> Vec<f64> {
        match self {
            Profile::Straight {
                straight_length, ..
            }
            | Profile::Logarithmic {
                straight_length, ..
            } if *straight_length > 0.0 => vec![-0.5 * straight_length, 0.5 * straight_length],
            Profile::Straight { .. }
            | Profile::Logarithmic { .. }
            | Profile::Crown { .. }
            | Profile::Table(_) => Vec::new(),
        }
    }

    /// Whether both ends are alike.
    pub fn is_symmetric(&self) -> bool {
        match self {
            Profile::Straight { .. } | Profile::Crown { .. } | Profile::Logarithmic { .. } => true,
            Profile::Table(table) => table.is_symmetric(),
        }
    }

    /// Its name in reports.
    pub fn name(&self) -> &'static str {
        match self {
            Profile::Straight { .. } => "straight with rounded ends",
            Profile::Crown { .. } => "circular crown",
            Profile::Logarithmic { .. } => "logarithmic",
            Profile::Table(_) => "table",
        }
    }
}

/// Drops at positions along the axis, interpolated by the monotone piecewise cubic of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5,
/// 1984, 300-304): through every point, slopes continuous, no dips between points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProfileTable {
    position: Vec<f64>,
    drop: Vec<f64>,
    #[serde(skip)]
    slope: Vec<f64>,
    /// Preparation of a measured trace, if any was needed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub treatment: Option<Treatment>,
}

/// Why a table is not a valid profile.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ProfileTableError {
    /// Positions and drops do not pair up.
    #[error(
        "{drops} drops for {positions} positions; both lists need one entry per point, at least three"
    )]
    Lengths {
        /// Number of positions.
        positions: usize,
        /// Number of drops.
        drops: usize,
    },
    /// Positions do not increase.
    #[error("position {0} is not larger than the previous one; positions must increase")]
    Order(usize),
    /// A drop smaller than one nearer to the middle.
    #[error(
        "drop {0} is smaller than one nearer to the middle by more than scatter: drops must grow towards both ends"
    )]
    Dip(usize),
    /// The table does not reach the ends.
    #[error("the table covers {0:.6e} m to {1:.6e} m, the roller from {2:.6e} m to {3:.6e} m")]
    Short(f64, f64, f64, f64),
}

impl ProfileTable {
    /// From positions and drops in m; positions from 0 on describe both sides of the middle.
    ///
    /// # Errors
    /// Lists of different lengths, positions that do not increase, drops that do not grow towards the ends, and tables that do not cover
    /// the `length` (m).
    pub fn new(
        position: &[f64],
        drop: &[f64],
        length: f64,
    ) -> Result<ProfileTable, ProfileTableError> {
        if position.len() != drop.len() || position.len() < 3 {
            return Err(ProfileTableError::Lengths {
                positions: position.len(),
                drops: drop.len(),
            });
        }
        if let Some(i) = (1..position.len()).find(|i| position[*i] <= position[i - 1]) {
            return Err(ProfileTableError::Order(i + 1));
        }
        let lowest = (0..drop.len())
            .min_by(|a, b| drop[*a].total_cmp(&drop[*b]))
            .expect("three points");
        let dips = |i: &usize| match *i <= lowest {
            true => *i > 0 && drop[*i] > drop[*i - 1],
            false => drop[*i] < drop[*i - 1],
        };
        if let Some(i) = (0..drop.len()).find(dips) {
            return Err(ProfileTableError::Dip(i + 1));
        }
        let half = position[0] == 0.0;
        if half && lowest != 0 && drop[lowest] < drop[0] {
            return Err(ProfileTableError::Dip(1));
        }
        let mirrored = || (1..position.len()).rev().filter(|_| half);
        let all: Vec<[f64; 2]> = mirrored()
            .map(|i| [-position[i], drop[i]])
            .chain(position.iter().zip(drop).map(|(y, z)| [*y, *z]))
            .collect();
        let [first, last] = [all[0][0], all[all.len() - 1][0]];
        let end = 0.5 * length;
        // A table may end with the roller, but for rounding.
        let reach = end * (1.0 - 1e-9);
        if first > -reach || last < reach {
            return Err(ProfileTableError::Short(first, last, -end, end));
        }
        let (position, drop): (Vec<f64>, Vec<f64>) = all.into_iter().map(|[y, z]| (y, z)).unzip();
        let slope = slopes(&position, &drop);
        Ok(ProfileTable {
            position,
            drop,
            slope,
            treatment: None,
        })
    }

    fn is_symmetric(&self) -> bool {
        let n = self.position.len();
        (0..n).all(|i| {
            self.position[i] == -self.position[n - 1 - i] && self.drop[i] == self.drop[n - 1 - i]
        })
    }

    /// z and dz/dy at y, m; beyond the ends along the tangent.
    fn drop(&self, y: f64) -> [f64; 2] {
        let (x, z, s) = (&self.position, &self.drop, &self.slope);
        let last = x.len() - 1;
        let after = x.partition_point(|p| *p <= y);
        if after == 0 || after > last {
            let end = if after == 0 { 0 } else { last };
            return [z[end] + s[end] * (y - x[end]), s[end]];
        }
        let i = after - 1;
        let h = x[i + 1] - x[i];
        let t = (y - x[i]) / h;
        let chord = (z[i + 1] - z[i]) / h;
        // Hermite: z = z_i + h t [s_i + t (c_2 + t c_3)]
        let second = 3.0 * chord - 2.0 * s[i] - s[i + 1];
        let third = s[i] + s[i + 1] - 2.0 * chord;
        [
            z[i] + h * t * (s[i] + t * (second + t * third)),
            s[i] + t * (2.0 * second + 3.0 * t * third),
        ]
    }
}

/// Slopes at the points: weighted harmonic means of the adjacent chords, zero at extrema; at the ends the chord.
fn slopes(x: &[f64], z: &[f64]) -> Vec<f64> {
    let chord = |i: usize| (z[i + 1] - z[i]) / (x[i + 1] - x[i]);
    let last = x.len() - 1;
    (0..=last)
        .map(|i| {
            if i == 0 || i == last {
                return chord(i.min(last - 1));
            }
            let (before, after) = (chord(i - 1), chord(i));
            if before * after <= 0.0 {
                return 0.0;
            }
            let (h, k) = (x[i] - x[i - 1], x[i + 1] - x[i]);
            let weight = (h + 2.0 * k) / (3.0 * (h + k));
            before * after / (weight * after + (1.0 - weight) * before)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const LENGTH: f64 = 0.016;

    fn table() -> ProfileTable {
        let position = [0.0, 4e-3, 6e-3, 8e-3];
        ProfileTable::new(&position, &[0.0, 0.0, 1e-6, 8e-6], LENGTH).unwrap()
    }

    fn profiles() -> [Profile; 6] {
        [
            Profile::Straight {
                straight_length: 0.012,
                end_radius: 0.02,
            },
            Profile::Crown { crown_radius: 10.0 },
            Profile::lundberg(LENGTH, 2e5, 1.2e-4, 2.3e11),
            Profile::iso_16281(LENGTH, 0.010),
            Profile::iso_16281(LENGTH, 0.004),
            Profile::Table(table()),
        ]
    }

    /// Slopes against differences on both sides, and mirror images.
    #[test]
    fn slopes_match_differences() {
        for profile in profiles() {
            for y in [-7.7e-3, -6.3e-3, -1e-3, 2e-3, 5e-3, 6.9e-3, 7.99e-3] {
                let step = 1e-8;
                let [z, slope] = profile.drop(LENGTH, y);
                let [before, after] = [-step, step].map(|d| profile.drop(LENGTH, y + d)[0]);
                let difference = (after - before) / (2.0 * step);
                assert!(
                    (slope - difference).abs() <= 1e-6 * slope.abs() + 1e-9,
                    "{profile:?} at {y}: {slope} {difference}"
                );
                let [mirrored, other_slope] = profile.drop(LENGTH, -y);
                assert_relative_eq!(mirrored, z, max_relative = 1e-12);
                assert_relative_eq!(other_slope, -slope, max_relative = 1e-12);
            }
        }
    }

    /// By hand. Arc: 0.02 − √(0.02² − 0.002²) = 1.002512e-4 m. Crown: 0.008²/20 = 3.2e-6 m (1 + 1.6e-7).
    /// ISO, D = 10 mm, at half of the half-length: 3.5e-6 ln(4/3) = 1.006887e-6 m; D = 4 mm: 2.5 D = 10 mm, straight over 6 mm, at
    /// y = 5.5 mm t = (11 − 6)/10 = 0.5: 2e-6 ln(4/3) = 5.75364e-7 m.
    #[test]
    fn drops_by_hand() {
        let [straight, crown, _, short, long, table] = profiles();
        let z = |profile: &Profile, y: f64| profile.drop(LENGTH, y)[0];
        assert_relative_eq!(z(&straight, 8e-3), 1.002_512_6e-4, max_relative = 1e-6);
        assert_eq!(z(&straight, 6e-3), 0.0);
        assert_relative_eq!(z(&crown, 8e-3), 3.2e-6, max_relative = 1e-6);
        assert_relative_eq!(z(&short, 4e-3), 1.006_887e-6, max_relative = 1e-6);
        assert_relative_eq!(z(&long, 5.5e-3), 5.753_64e-7, max_relative = 1e-6);
        assert_eq!(z(&long, 3e-3), 0.0);
        assert_relative_eq!(z(&table, 6e-3), 1e-6, max_relative = 1e-12);
        // no dip on the flat part, and nothing above the adjacent points
        for i in 0..=100 {
            let y = 8e-5 * f64::from(i);
            assert!((0.0..=8e-6).contains(&z(&table, y)) && (y > 4e-3 || z(&table, y) == 0.0));
        }
    }

    /// Lundberg's drop at the ends, 2w/(πE') (1.1932 + ln(l/2b)) (as Harris and Kotzalas 2007, section 1, quote it).
    #[test]
    fn lundberg_at_the_end() {
        let (w, b, e) = (2e5, 1.2e-4, 2.3e11);
        let [end, _] = Profile::lundberg(LENGTH, w, b, e).drop(LENGTH, 0.5 * LENGTH);
        let quoted = 2.0 * w / (std::f64::consts::PI * e) * (1.1932 + (LENGTH / (2.0 * b)).ln());
        assert_relative_eq!(end, quoted, max_relative = 1e-4);
    }

    #[test]
    fn bad_tables() {
        let bad = |y: &[f64], z: &[f64]| ProfileTable::new(y, z, LENGTH).unwrap_err();
        let y = [0.0, 4e-3, 8e-3];
        assert!(matches!(
            bad(&y, &[0.0, 1e-6]),
            ProfileTableError::Lengths { .. }
        ));
        assert_eq!(
            bad(&[0.0, 4e-3, 4e-3], &[0.0, 1e-6, 2e-6]),
            ProfileTableError::Order(3)
        );
        assert_eq!(bad(&y, &[0.0, 2e-6, 1e-6]), ProfileTableError::Dip(3));
        assert_eq!(bad(&y, &[1e-6, 0.0, 1e-6]), ProfileTableError::Dip(1));
        assert!(matches!(
            bad(&[0.0, 4e-3, 7e-3], &[0.0, 1e-6, 2e-6]),
            ProfileTableError::Short(..)
        ));
        let skew = ProfileTable::new(&[-8e-3, 1e-3, 8e-3], &[5e-6, 0.0, 2e-6], LENGTH).unwrap();
        assert!(!skew.is_symmetric() && table().is_symmetric());
    }
}
