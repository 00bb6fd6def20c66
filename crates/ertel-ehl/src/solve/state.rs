//! State of a contact on a level, and the coefficients of its Reynolds equation.

use super::contact_surface::Cell;
use crate::contact::{OilLayer, Planar};
use crate::forms::oil_layer::filling_length;
use crate::forms::reynolds::ElementConstants;
use crate::params::{Formulation, PenaltyScaling};

/// Coefficients of the Reynolds equation that do not vary over a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FilmConstants {
    /// λ.
    pub lambda: f64,
    /// ū, the mean velocity of the surfaces over the entrainment speed.
    pub entrainment: Planar,
    /// Galerkin, SUPG or GLS.
    pub formulation: Formulation,
    /// ρ_id.
    pub isotropic_diffusion: f64,
    /// ρ_r, on elements at a ridge of the pressure.
    pub ridge_diffusion: f64,
    /// Whether the stabilisation includes the deflection.
    pub elastic_stabilisation: bool,
    /// ξ₀ in force.
    pub penalty: f64,
    /// Its scaling.
    pub penalty_scaling: PenaltyScaling,
    /// Predicted central film H_f.
    pub film_scale: f64,
    /// Whether the penalty scales with the gap: far out a flow by pressure as H³ outweighs any constant, and behind a contact the film pulls as hard
    /// as it pushes before it, unless the outlet edge is near (of a ball of H_f = 2.7, with this edge at 300 half-widths, 22 % of the film are lost).
    pub far_outlet: bool,
}

impl FilmConstants {
    pub(super) fn on_element(
        &self,
        cell: Cell,
        order: usize,
        oil_layer: Option<OilLayer>,
        share_at_ridge: f64,
    ) -> ElementConstants {
        let size = cell.size;
        let penalty = match self.penalty_scaling {
            PenaltyScaling::ElementSquared => self.penalty * size * size,
            PenaltyScaling::Constant => self.penalty,
            PenaltyScaling::Film => {
                let film = self.film_scale;
                let squared = match self.far_outlet {
                    true => cell.curvature * film.max(cell.gap).powi(2),
                    false => film * film,
                };
                self.penalty * (squared / self.lambda).max(1.0)
            }
            PenaltyScaling::InverseElementSquared => self.penalty / (size * size),
        };
        ElementConstants {
            lambda: self.lambda,
            entrainment: self.entrainment,
            size,
            order,
            penalty,
            formulation: self.formulation,
            isotropic_diffusion: self.isotropic_diffusion,
            ridge_diffusion: self.ridge_diffusion * share_at_ridge,
            diffusion_tensor: cell.diffusion_tensor,
            slenderness: cell.diffusion_tensor.map_or(1.0, slenderness),
            elastic_stabilisation: self.elastic_stabilisation,
            oil_layer,
            filling_length: filling_length(size, order),
        }
    }
}

/// r² of cells whose smallest share of a diffusion is 1/r²: the inverse of the smaller eigenvalue of T.
fn slenderness([xx, xy, yy]: [f64; 3]) -> f64 {
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    1.0 / (mean - half.hypot(xy))
}

/// State of the contact on a level.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// Pressure at every pressure node (zero on the edge).
    pub pressure: Vec<f64>,
    /// Deflection at every deflection node.
    pub deflection: Vec<f64>,
    /// Film constant H0.
    pub rigid_separation: f64,
    /// Temperatures, K, column by column; empty where heat is left out.
    pub temperature: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::slenderness;
    use approx::assert_relative_eq;

    /// Cells of T = diag(1, 1/100), turned by 30 degrees or not, are ten times as long one way as the other.
    #[test]
    fn slenderness_is_that_of_the_tensor() {
        assert_relative_eq!(slenderness([1.0, 0.0, 0.01]), 100.0, max_relative = 1e-12);
        let (c2, s2): (f64, f64) = (0.75, 0.25);
        let turned = [c2 + 0.01 * s2, 0.99 * (c2 * s2).sqrt(), s2 + 0.01 * c2];
        assert_relative_eq!(slenderness(turned), 100.0, max_relative = 1e-12);
    }
}
