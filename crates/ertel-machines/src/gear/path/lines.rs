//! Contact lines in the plane of action of spur and helical teeth.

use crate::gear::geometry::GearPair;

/// Places (m) of all pairs of teeth that touch in addition to the one at the place s (m) in the same transverse section: s + k p_bt, strictly inside the path.
///
/// Where one pair leaves as another enters, both ends are outside: B and D belong to the contact of fewer pairs.
pub(super) fn others(pair: &GearPair, s: f64) -> impl Iterator<Item = f64> {
    let (a, e) = (pair.points.a, pair.points.e);
    let slack = 1e-9 * pair.base_pitch;
    let pitch = pair.base_pitch;
    // The place itself may be far outside the path: a slice of a wide helical face.
    let first = ((a - s) / pitch).floor() as i64;
    let last = ((e - s) / pitch).ceil() as i64;
    (first..=last)
        .filter(|k| *k != 0)
        .map(move |k| s + k as f64 * pitch)
        .filter(move |place| *place > a + slack && *place < e - slack)
}

/// Length (m) of all contact lines at the moment at which one of them crosses the middle of the face width at the place s (m).
///
/// A line is at s + y tan β_b at the distance y from the middle, and touches where that is between A and E:
/// l = Σ_k |{y}|/cos β_b over s + k p_bt. Of straight teeth b times the number of pairs.
pub fn line_length(pair: &GearPair, s: f64) -> f64 {
    let b = pair.face_width;
    let beta_b = pair.base_helix_angle;
    if beta_b == 0.0 {
        let inside = s >= pair.points.a && s <= pair.points.e;
        return b * (others(pair, s).count() as f64 + f64::from(u8::from(inside)));
    }
    let half_shift = 0.5 * b * beta_b.tan();
    let (a, e, pitch) = (pair.points.a, pair.points.e, pair.base_pitch);
    let first = ((a - half_shift - s) / pitch).floor() as i64;
    let last = ((e + half_shift - s) / pitch).ceil() as i64;
    let along_path = |k: i64| {
        let middle = s + k as f64 * pitch;
        ((middle + half_shift).min(e) - (middle - half_shift).max(a)).max(0.0)
    };
    (first..=last).map(along_path).sum::<f64>() / beta_b.sin()
}

/// Mean length of the contact lines over a mesh, m: b ε_α/cos β_b.
pub fn mean_line_length(pair: &GearPair) -> f64 {
    pair.face_width * pair.contact_ratio / pair.base_helix_angle.cos()
}
