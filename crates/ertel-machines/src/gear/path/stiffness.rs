//! Stiffness of a pair of teeth.

use super::Operation;
use super::beam::Beams;
use crate::gear::geometry::{GearError, GearPair, Meshing, in_range};

/// Stiffness of one pair of teeth per face width, along the path of contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ToothStiffness {
    /// The same everywhere, N/m².
    Given(f64),
    /// The single stiffness c' of ISO 6336-1 everywhere.
    Iso6336 {
        /// Gear blank factor C_R; 1 of solid discs.
        blank_factor: f64,
    },
    /// From the energies of bending, shear and compression of the teeth as a rack cuts them, of their foundations on rings, and of the Hertz contact; external spur
    /// gears. It changes along the path: a pair is softest where it touches a tip.
    Beams {
        /// Radii of the bores of the pinion and the wheel, m.
        bore_radii: [f64; 2],
    },
}

/// Places on the path at which the stiffness of beams is computed; linear between them.
const PLACES: usize = 400;

/// Stiffness per face width (N/m²) over the path of contact.
pub(super) struct StiffnessCurve {
    a: f64,
    length: f64,
    values: Vec<f64>,
}

impl StiffnessCurve {
    /// Stiffness at the place s (m).
    pub fn at(&self, s: f64) -> f64 {
        let last = self.values.len() - 1;
        let place = ((s - self.a) / self.length).clamp(0.0, 1.0) * last as f64;
        let before = (place as usize).min(last.saturating_sub(1));
        let after = (before + 1).min(last);
        let share = place - before as f64;
        self.values[before] * (1.0 - share) + self.values[after] * share
    }
}

impl ToothStiffness {
    /// The stiffness of the teeth of a pair.
    pub(super) fn curve(
        self,
        pair: &GearPair,
        operation: &Operation,
    ) -> Result<StiffnessCurve, GearError> {
        let (a, length) = (pair.points.a, pair.points.e - pair.points.a);
        let values = match self {
            ToothStiffness::Given(stiffness) => {
                in_range("tooth stiffness", stiffness, stiffness > 0.0, "positive")?;
                vec![stiffness]
            }
            ToothStiffness::Iso6336 { blank_factor } => {
                let tangential = operation.pinion_torque / pair.reference_radii[0];
                let load = tangential / pair.face_width;
                vec![iso_single_stiffness(pair, load, blank_factor)?]
            }
            ToothStiffness::Beams { bore_radii } => {
                let beams = Beams::new(pair, operation, bore_radii)?;
                let place = |i: usize| a + length * i as f64 / PLACES as f64;
                (0..=PLACES)
                    .map(|i| beams.stiffness(pair, place(i)))
                    .collect()
            }
        };
        Ok(StiffnessCurve { a, length, values })
    }
}

/// Single stiffness c' of steel teeth per face width, N/m², under the tangential load per face width F_t/b (N/m) with the gear blank factor C_R.
///
/// q' = 0.04723 + 0.15551/z_n1 + 0.25791/z_n2 − 0.00635 x_1 − 0.11654 x_1/z_n1 − 0.00193 x_2 − 0.24188 x_2/z_n2 + 0.00529 x_1² + 0.00182 x_2²
/// c' = C_M C_R C_B cos β/q',  C_M = 0.8,  C_B = [1 + 0.5 (1.2 − h_fP*)][1 − 0.02 (20° − α_n)],  z_n = z/(cos² β_b cos β)
///
/// with q' in mm·µm/N. Of internal wheels z_n2 = ∞. Below F_t/b = 100 N/mm times (F_t/b/100)^1/4.
/// Range: x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2.
///
/// Source: ISO 6336-1:2006, 9.3, method B, as in three open programs (GEARpie; python-gearbox; Drivetrain). GEARpie has x_1 for x_2 in the term of z_n2 and
/// Drivetrain in that of x_2²; python-gearbox has neither, and the worked example of ISO/TR 6336-30 agrees.
///
/// # Errors
///
/// Profile shifts outside the range, and numbers that are not positive.
pub fn iso_single_stiffness(
    pair: &GearPair,
    load: f64,
    blank_factor: f64,
) -> Result<f64, GearError> {
    let [x_1, x_2] = pair.shifts;
    let sum = x_1 + x_2;
    if x_1 < x_2 || !(-0.5..=2.0).contains(&sum) {
        return Err(GearError::Sharing {
            law: "by the stiffness of ISO 6336-1",
            requirement: "x_1 ≥ x_2 and −0.5 ≤ x_1 + x_2 ≤ 2",
        });
    }
    let positive = |name, value: f64| in_range(name, value, value > 0.0, "positive");
    positive("blank factor", blank_factor)?;
    positive("load per face width", load)?;
    let beta = pair.dimensions.helix_angle;
    let virtual_teeth = |z: f64| z / (pair.base_helix_angle.cos().powi(2) * beta.cos());
    let per_z_1 = virtual_teeth(pair.teeth[0]).recip();
    let per_z_2 = match pair.dimensions.meshing {
        Meshing::External => virtual_teeth(pair.teeth[1]).recip(),
        Meshing::Internal => 0.0,
    };
    let flexibility = 0.04723 + 0.15551 * per_z_1 + 0.25791 * per_z_2
        - 0.00635 * x_1
        - 0.11654 * x_1 * per_z_1
        - 0.00193 * x_2
        - 0.24188 * x_2 * per_z_2
        + 0.00529 * x_1 * x_1
        + 0.00182 * x_2 * x_2;
    let angle = pair.dimensions.normal_pressure_angle.to_degrees();
    let rack =
        (1.0 + 0.5 * (1.2 - pair.dimensions.basic_rack.dedendum)) * (1.0 - 0.02 * (20.0 - angle));
    let light = (load / 1e5).min(1.0).powf(0.25);
    // 1 N/(mm µm) = 1e9 N/m².
    Ok(1e9 * 0.8 * blank_factor * rack * beta.cos() * light / flexibility)
}
