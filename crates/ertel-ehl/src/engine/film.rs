//! The interface of a film for post-processing: fields at the points of a quadrature, and at any place.

use crate::film::TemperatureProfile;
use crate::forms::energy::FilmPlace;

/// The film of a solution.
pub trait Film: Sync {
    /// Fields at the points over which the contact area is summed.
    fn points(&self) -> &PointTable;

    /// Fields at (X, Y); `None` outside the contact area.
    fn at(&self, place: [f64; 2]) -> Option<PointFields>;

    /// Whether the points represent a place, too.
    fn covers(&self, place: [f64; 2]) -> bool {
        self.at(place).is_some()
    }
}

/// Fields at a point of the contact area.
#[derive(Clone, Debug, Default)]
pub struct PointFields {
    /// (X, Y).
    pub place: [f64; 2],
    /// P of the oil.
    pub pressure: f64,
    /// ∇P of the oil.
    pub pressure_gradient: [f64; 2],
    /// P of the asperities, which bear the rest of the load.
    pub asperity_pressure: f64,
    /// G, the undeformed gap.
    pub gap: f64,
    /// δ, the deflection.
    pub deflection: f64,
    /// H; of rough surfaces the distance of the mean planes.
    pub film: f64,
    /// The gap that flows minus H; zero between smooth surfaces.
    pub excess: f64,
    /// F, the missing oil of a partly filled gap: before a starved contact and behind the film (see [`crate::forms::oil_layer`]).
    pub missing: f64,
    /// Temperature across the film, where it varies.
    pub temperature: Option<Box<TemperatureProfile>>,
}

impl PointFields {
    /// The gap that flows.
    pub fn flowing(&self) -> f64 {
        self.film + self.excess
    }

    /// P of oil and asperities together.
    pub fn total_pressure(&self) -> f64 {
        self.pressure + self.asperity_pressure
    }

    /// θ, the share of the gap that is filled with oil.
    pub fn filling(&self) -> f64 {
        1.0 - self.missing / self.flowing()
    }

    /// Quantities of the film for the energy equation, its flow not held fixed.
    pub fn film_place(&self) -> FilmPlace {
        let profile = self.temperature.as_deref().copied().unwrap_or_default();
        FilmPlace {
            at: self.place,
            pressure: self.pressure,
            pressure_rate: 0.0,
            pressure_gradient: self.pressure_gradient,
            film: self.flowing(),
            filling: self.filling(),
            temperature: profile.temperature,
            held_conductance: None,
        }
    }
}

/// One row of the table: a quadrature point.
#[derive(Clone, Debug)]
pub struct Point {
    /// Weight of the point: the area that it represents, or the length in line contacts, in half-widths.
    pub area: f64,
    /// Shares of that within the reach of the bodies, and within the shorter distance of
    /// [`Region::shorter`](super::region::Region::shorter).
    pub within: [f64; 2],
    /// Whether it lies in the Hertz zone.
    pub in_zone: bool,
    /// Fields there.
    pub fields: PointFields,
}

/// Fields at all quadrature points, in groups (elements, cells) that are summed one after the other: sums do not depend on threads.
#[derive(Clone, Debug)]
pub struct PointTable {
    groups: Vec<Vec<Point>>,
}

impl PointTable {
    /// From the points of each group.
    pub fn new(groups: Vec<Vec<Point>>) -> PointTable {
        PointTable { groups }
    }

    /// The groups.
    pub fn groups(&self) -> &[Vec<Point>] {
        &self.groups
    }

    /// Means over the Hertz zone. If no element is as small as the zone (thick films), the values nearest its centre; NaN
    /// where no point has the values.
    pub fn mean_in_zone<const N: usize>(
        &self,
        values: impl Fn(&PointFields) -> Option<[f64; N]>,
    ) -> [f64; N] {
        let (mut sums, mut total) = ([0.0; N], 0.0);
        let (mut nearest, mut centre) = (f64::INFINITY, [f64::NAN; N]);
        for point in self.iter() {
            let Some(values) = values(&point.fields) else {
                continue;
            };
            let [x, y] = point.fields.place;
            if x.hypot(y) < nearest {
                (nearest, centre) = (x.hypot(y), values);
            }
            if point.in_zone {
                total += point.area;
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += point.area * value;
                }
            }
        }
        match total > 0.0 {
            true => sums.map(|sum| sum / total),
            false => centre,
        }
    }

    /// All points.
    pub fn iter(&self) -> impl Iterator<Item = &Point> {
        self.groups.iter().flatten()
    }
}
