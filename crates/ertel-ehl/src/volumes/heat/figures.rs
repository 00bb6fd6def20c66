//! Temperatures and heat of a film on patches, in numbers.

use crate::engine::Problem;
use crate::engine::heat::{Extremes, HeatSums};
use crate::film::{FilmNodes, Nodal};
use crate::volumes::film::share;
use crate::volumes::level::Level;

/// Heat of the whole contact, over all grids.
pub fn sums<Plan>(problem: &Problem<Plan>, levels: &[Level]) -> HeatSums {
    let mut sum = HeatSums::default();
    let area = problem.scales.area(&problem.shape);
    for (l, level) in levels.iter().enumerate() {
        let Some(warm) = &level.warm else { continue };
        let grid = &level.system.grid;
        let rubbing = (problem.heat.as_ref())
            .map_or_else(Vec::new, |heat| level.system.rubbing(&level.state, heat));
        for [i, j] in grid.nodes() {
            let k = grid.index(i, j);
            let weight = area * grid.cell(j) * share(levels, l, i, j);
            if weight == 0.0 {
                continue;
            }
            let [shear, compression, size] = warm.account.made[k];
            sum.shear += weight * shear;
            sum.rubbing += weight * rubbing.get(k).copied().unwrap_or(0.0);
            sum.compression += weight * compression;
            sum.compression_size += weight * size;
            for b in 0..2 {
                sum.to_bodies[b] += weight * warm.temperatures.flux[b][k];
            }
            sum.by_film += weight * warm.account.carried[k];
        }
    }
    sum
}

/// Extreme temperatures over the nodes of all grids.
pub fn extremes(levels: &[Level], nodes: &FilmNodes) -> Extremes {
    let f = nodes.n();
    let mut extremes = Extremes::default();
    for (l, level) in levels.iter().enumerate() {
        let Some(warm) = &level.warm else { continue };
        let grid = &level.system.grid;
        for [i, j] in grid.nodes() {
            if share(levels, l, i, j) == 0.0 {
                continue;
            }
            let mut values = Nodal::default();
            values[..f].copy_from_slice(&warm.temperatures.film[grid.index(i, j) * f..][..f]);
            // No minus zero.
            let place = grid.place(i, j).map(|x| x + 0.0);
            extremes.include(nodes, &values, place);
        }
    }
    extremes
}
