//! Temperatures for given pressures and films, by Newton's method.
//!
//! The derivative of the heat of shearing by the temperature is in the Jacobian: a film that heats up thins, and
//! heats itself less. Without it, temperatures would swing to and fro where heating is strong.
//!
//! Far from the solution that is no help. At a given stress a warm layer shears faster and heats up further, and where that outweighs
//! conduction, between films of very unequal temperature, the Jacobian is nearly singular: single nodes would go off by 1e5 K, and a
//! step cut down to what they bear moves nothing. There the steps are those of an implicit Euler method in time, with a time step
//! at each point in which its heat of shearing would warm it by θ (pseudo-transient continuation: Kelley and Keyes, SIAM J. Numer.
//! Anal. 35 (1998) 508-523): |Q|/θ is added to the derivative of −Q. θ grows as steps get short, back to Newton's method itself.

use ertel_fem::linear::block_ilu::{BlockIlu, BlockIluError, BlockMatrix};
use ertel_fem::linear::gmres::{GmresError, GmresParams, gmres};

use super::system::{HeatSystem, Kept, assemble};
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

/// θ of the first time step, K: less than viscosities fall by e over, so that no layer feeds its own heating.
const FIRST_WARMING: f64 = 20.0;

/// The shortest time step, K, and the longest, beyond which there is none.
const SHORTEST_WARMING: f64 = 1.0;
const LONGEST_WARMING: f64 = 1e4;

/// Factor by which time steps are shortened or lengthened.
const WARMING_FACTOR: f64 = 2.0;

/// Residual, W/m² times half-widths squared, beyond which no matrix in single precision is factorised: the sun's surface radiates 6e7 W/m².
const BEYOND_BOUNDS: f64 = 1e30;

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
    /// The heat of shearing is beyond all bounds, as where a pressure gradient asks for more than the limiting stress.
    #[error(
        "shearing heats the film beyond all bounds: at the pressures found so far its stress is far above what its law bears (a limiting \
         stress, or Eyring's, that grows exponentially beyond)"
    )]
    Overheated,
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
    /// Ψ of the flow that is held; empty: none is.
    conductances: Vec<f64>,
    matrix: BlockMatrix,
    /// 1/θ, 1/K; 0 in Newton's method.
    damping: f64,
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
            conductances: Vec::new(),
            matrix: BlockMatrix::new(space.column.n(), space.graph.clone()),
            damping: 0.0,
            stats: HeatStats::default(),
        }
    }

    /// The same with further heat.
    pub fn with_source(self, source: Source<'a>) -> HeatNewton<'a> {
        HeatNewton { source, ..self }
    }

    /// Holds the flow that the pressure drives at a state, in the steps from there, instead of the pressure gradient.
    pub fn hold_flow(&mut self, state: &State) {
        self.conductances.clear();
        self.conductances = self.assembled(state).conductances;
    }

    fn kept(&self) -> Kept<'_> {
        Kept {
            cross_flow: &self.cross_flow,
            conductances: &self.conductances,
        }
    }

    /// One step; returns the largest change of a temperature, K, as far as it says how near the solution is: that of a time step
    /// says nothing.
    ///
    /// # Errors
    /// When the linear system cannot be solved.
    pub fn step(&mut self, state: &mut State) -> Result<f64, HeatError> {
        if self.cross_flow.is_empty() {
            self.cross_flow = self.assembled(state).cross_flow;
        }
        let largest_step = self.params.largest_step;
        let (change, cross_flow) = loop {
            let solved = self.solve(state);
            let shortest = self.damping * SHORTEST_WARMING >= 1.0;
            match solved {
                Ok(found) if shortest || max_abs(&found.0) <= largest_step => break found,
                // Steps in time change the matrix, not these.
                Err(e @ (HeatError::NotFinite | HeatError::Overheated)) => return Err(e),
                Err(e) if shortest => return Err(e),
                _ => self.damping = (WARMING_FACTOR * self.damping).max(1.0 / FIRST_WARMING),
            }
        };
        self.cross_flow = cross_flow;
        self.stats.iterations += 1;
        let largest = max_abs(&change);
        let share = (largest_step / largest).min(1.0);
        for (t, dt) in state.temperature.iter_mut().zip(&change) {
            *t += share * dt;
        }
        if self.damping == 0.0 {
            return Ok(share * largest);
        }
        if largest < 0.5 * largest_step {
            self.damping /= WARMING_FACTOR;
        }
        if self.damping * LONGEST_WARMING < 1.0 {
            self.damping = 0.0;
        }
        Ok(f64::INFINITY)
    }

    /// The change of temperatures by the linear equations at a state, and ω there.
    fn solve(&mut self, state: &State) -> Result<(Vec<f64>, Vec<f64>), HeatError> {
        let system = assemble(
            self.d,
            self.fluid,
            self.heat,
            state,
            self.source,
            Kept {
                cross_flow: &self.cross_flow,
                conductances: &self.conductances,
            },
            Some((&mut self.matrix, self.damping)),
        );
        let right: Vec<f64> = system.residual.iter().map(|r| -r).collect();
        if right.iter().any(|r| !r.is_finite()) {
            return Err(HeatError::NotFinite);
        }
        if max_abs(&right) > BEYOND_BOUNDS {
            return Err(HeatError::Overheated);
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
        self.stats.krylov_iterations += info.iterations;
        Ok((change, system.cross_flow))
    }

    /// The energy equation at a state, without its Jacobian.
    fn assembled(&self, state: &State) -> HeatSystem {
        assemble(
            self.d,
            self.fluid,
            self.heat,
            state,
            self.source,
            self.kept(),
            None,
        )
    }
}

fn max_abs(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |m, x| m.max(x.abs()))
}
