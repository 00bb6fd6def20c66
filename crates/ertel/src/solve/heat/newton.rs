//! Temperatures for given pressures and films, by Newton's method.
//!
//! The derivative of the heat of shearing by the temperature is in the Jacobian: a film that heats up thins, and
//! heats itself less. Without it, temperatures would swing to and fro where heating is strong.

use ertel_fem::linear::block_ilu::{BlockIlu, BlockIluError, BlockMatrix};
use ertel_fem::linear::gmres::{GmresError, GmresParams, gmres};

use super::system::{HeatSystem, assemble};
use crate::film::{FilmFluid, FilmNodes};
use crate::forms::energy::{Heat, Source};
use crate::solve::discretisation::Discretisation;
use crate::solve::system::State;

/// Settings.
#[derive(Clone, Copy, Debug)]
pub struct HeatParams {
    /// Relative residual of each linear solve.
    pub linear_tolerance: f64,
    /// Krylov iterations allowed.
    pub max_krylov: usize,
    /// Largest change of a temperature in one step, K.
    pub largest_step: f64,
}

impl Default for HeatParams {
    fn default() -> Self {
        HeatParams {
            linear_tolerance: 1e-3,
            max_krylov: 200,
            largest_step: 60.0,
        }
    }
}

/// Effort.
#[derive(Clone, Copy, Debug, Default)]
pub struct HeatStats {
    /// Steps of Newton's method.
    pub iterations: usize,
    /// Krylov iterations.
    pub krylov_iterations: usize,
}

/// A step failed.
#[derive(Debug, thiserror::Error)]
pub enum HeatError {
    /// The preconditioner broke down.
    #[error(transparent)]
    Factorisation(#[from] BlockIluError),
    /// The linear solver did not converge.
    #[error(transparent)]
    Krylov(#[from] GmresError),
    /// A temperature or a source is not a number.
    #[error("the heat of the film is not finite")]
    NotFinite,
}

/// Newton's method on one discretisation, with what it keeps.
pub struct HeatNewton<'a> {
    d: &'a Discretisation,
    fluid: &'a FilmFluid,
    heat: &'a Heat,
    params: HeatParams,
    source: Source<'a>,
    /// ω, of the last assembly.
    cross_flow: Vec<f64>,
    matrix: BlockMatrix,
    /// Effort so far.
    pub stats: HeatStats,
}

impl<'a> HeatNewton<'a> {
    /// Prepares it.
    ///
    /// # Panics
    /// When the discretisation has no temperatures, or other nodes across the film than the fluid.
    pub fn new(
        d: &'a Discretisation,
        fluid: &'a FilmFluid,
        heat: &'a Heat,
        params: HeatParams,
    ) -> HeatNewton<'a> {
        let space = d.heat.as_ref().expect("a discretisation with heat");
        let nodes = fluid.nodes().map(FilmNodes::n);
        assert_eq!(nodes, Some(space.column.film.n()), "nodes across the film");
        HeatNewton {
            d,
            fluid,
            heat,
            params,
            source: None,
            cross_flow: Vec::new(),
            matrix: BlockMatrix::new(space.column.n(), space.graph.clone()),
            stats: HeatStats::default(),
        }
    }

    /// The same with further heat.
    pub fn with_source(self, source: Source<'a>) -> HeatNewton<'a> {
        HeatNewton { source, ..self }
    }

    /// One step; returns the largest change of a temperature, K.
    ///
    /// # Errors
    /// When the linear system cannot be solved.
    pub fn step(&mut self, state: &mut State) -> Result<f64, HeatError> {
        if self.cross_flow.is_empty() {
            self.cross_flow = self.assembled(state).cross_flow;
        }
        let system = assemble(
            self.d,
            self.fluid,
            self.heat,
            state,
            self.source,
            &self.cross_flow,
            Some(&mut self.matrix),
        );
        let right: Vec<f64> = system.residual.iter().map(|r| -r).collect();
        if right.iter().any(|r| !r.is_finite()) {
            return Err(HeatError::NotFinite);
        }
        let mut ilu = BlockIlu::new(&self.matrix)?;
        let mut change = vec![0.0; right.len()];
        let info = gmres(
            |x, y| self.matrix.multiply(x, y),
            |x| ilu.solve(x),
            &right,
            &mut change,
            GmresParams {
                tolerance: self.params.linear_tolerance,
                max_iterations: self.params.max_krylov,
            },
        )?;
        self.cross_flow = system.cross_flow;
        self.stats.krylov_iterations += info.iterations;
        self.stats.iterations += 1;
        let largest = change.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let share = (self.params.largest_step / largest).min(1.0);
        for (t, dt) in state.temperature.iter_mut().zip(&change) {
            *t += share * dt;
        }
        Ok(share * largest)
    }

    /// The energy equation at a state, without its Jacobian.
    fn assembled(&self, state: &State) -> HeatSystem {
        assemble(
            self.d,
            self.fluid,
            self.heat,
            state,
            self.source,
            &self.cross_flow,
            None,
        )
    }
}
