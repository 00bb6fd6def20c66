//! Effect of starvation on the film, SI.

use serde::Serialize;

use super::{Estimate, Figure, Measured};
use crate::contact::Supply;

/// The film compared with that of the same contact when flooded.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Starvation {
    /// How much oil reaches the contact.
    pub supply: Supply,
    /// Central film of the flooded contact, m; `None` where that was not found.
    pub film_central_flooded: Option<Estimate>,
    /// Minimum film of the flooded contact, m; likewise.
    pub film_minimum_flooded: Option<Estimate>,
    /// Central film over that of the flooded contact: 1 is flooded.
    #[serde(rename = "starved_ratio_central")]
    pub ratio_central: Option<Estimate>,
    /// The same of the minimum films.
    #[serde(rename = "starved_ratio_minimum")]
    pub ratio_minimum: Option<Estimate>,
    /// Where the gap is fully flooded from, on the centreline, x < 0, m; `None` where a layer of oil fills it to the edge of the contact area.
    pub meniscus_position: Option<Estimate>,
}

impl Starvation {
    /// Of a solution for a supply, without the flooded films; `None` where the contact is flooded anyway.
    pub fn of(measured: &Measured, supply: &Supply) -> Option<Starvation> {
        match supply {
            Supply::Flooded => return None,
            Supply::OilLayer { .. } | Supply::Meniscus { .. } => {}
        }
        Some(Starvation {
            supply: *supply,
            film_central_flooded: None,
            film_minimum_flooded: None,
            ratio_central: None,
            ratio_minimum: None,
            meniscus_position: measured.find(Figure::MeniscusPosition),
        })
    }
}

impl Measured {
    /// With the meniscus where the case puts it; a layer of oil has one where it fills the gap.
    pub fn with_meniscus(mut self, supply: &Supply) -> Measured {
        match supply {
            Supply::Flooded | Supply::OilLayer { .. } => {}
            Supply::Meniscus { distance } => {
                self.set_exactly(Figure::MeniscusPosition, -distance);
            }
        }
        self
    }
}
