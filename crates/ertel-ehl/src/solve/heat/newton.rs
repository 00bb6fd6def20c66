//! Temperatures for given pressures and films, by Newton's method.
//!
//! The derivative of the heat of shearing by the temperature is in the Jacobian: a film that heats up thins, and
//! heats itself less. Without it, temperatures would oscillate where heating is strong.
//!
//! Far from the solution that is no help. At a given stress a warm layer shears faster and heats up further, and where that outweighs
//! conduction, between films of very unequal temperature, the Jacobian is nearly singular: single nodes would go off by 1e5 K. A step
//! cut down as a whole to their limit would move nothing, so each temperature is limited separately; below the coldest of the start,
//! where viscosities grow without bound, to much less. Where that leads to heat that is not finite, half of the way is taken back.
//!
//! Where the linear equations cannot be solved, the steps are those of an implicit Euler method in time, with a time step at each
//! point in which its heat of shearing would warm it by θ (pseudo-transient continuation: Kelley and Keyes, SIAM J. Numer. Anal. 35
//! (1998) 508-523): |Q|/θ is added to the derivative of −Q. θ grows again from step to step, back to Newton's method itself.
//!
//! A factorisation serves for further steps as long as it costs few iterations more than when it was new.

use ertel_fem::linear::block_ilu::{BlockIlu, BlockMatrix};
use ertel_fem::linear::gmres::{GmresParams, gmres};

use super::system::{HeatSystem, Kept, assemble};
use crate::engine::HeatError;
use crate::engine::coupling::Relaxation;
use crate::film::{FilmFluid, FilmNodes};
use crate::forms::energy::{Heat, Source};
use crate::solve::discretisation::Discretisation;
use crate::solve::state::State;
use crate::solve::streams::Streams;
use crate::solve::tuning::heat::{
    BEYOND_BOUNDS, FIRST_WARMING, LONGEST_WARMING, MOST_HALVINGS, SHORTEST_WARMING, SPARE_KRYLOV,
    WARMING_FACTOR,
};

/// Settings.
#[derive(Clone, Copy, Debug)]
pub struct HeatParams {
    /// Relative residual of each linear solve.
    pub linear_tolerance: f64,
    /// Krylov iterations allowed.
    pub max_krylov: usize,
    /// Largest change of a temperature in one step, K.
    pub largest_step: f64,
    /// The same downwards from the coldest of the start, K.
    pub largest_cooling: f64,
}

impl Default for HeatParams {
    fn default() -> Self {
        HeatParams {
            linear_tolerance: 1e-3,
            max_krylov: 200,
            largest_step: 60.0,
            largest_cooling: 2.0,
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

/// Newton's method on one discretisation, with its stored data.
pub struct HeatNewton<'a> {
    d: &'a Discretisation,
    fluid: &'a FilmFluid,
    heat: &'a Heat,
    params: HeatParams,
    source: Source<'a>,
    /// ω, of the last assembly.
    cross_flow: Vec<f64>,
    /// Ψ of the frozen flow; empty: none is.
    conductances: Vec<f64>,
    /// Oil behind the film of that flow.
    streams: Option<Streams>,
    matrix: BlockMatrix,
    /// 1/θ, 1/K; 0 in Newton's method.
    damping: f64,
    /// A factorisation, and the Krylov iterations that it cost when it was new.
    factors: Option<(BlockIlu, usize)>,
    /// Coldest temperature of the start, K.
    coldest: Option<f64>,
    relaxation: Relaxation,
    /// Temperatures before the last step.
    before: Vec<f64>,
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
            streams: None,
            matrix: BlockMatrix::new(space.column.n(), space.graph.clone()),
            damping: 0.0,
            factors: None,
            coldest: None,
            before: Vec::new(),
            relaxation: Relaxation::default(),
            stats: HeatStats::default(),
        }
    }

    /// The same with further heat.
    pub fn with_source(self, source: Source<'a>) -> HeatNewton<'a> {
        HeatNewton { source, ..self }
    }

    /// Holds the flow that the pressure drives at a state, in the steps from there, instead of the pressure gradient.
    pub fn hold_flow(&mut self, state: &State) {
        self.relaxation = Relaxation::default();
        self.conductances.clear();
        self.streams = Some(Streams::new(self.d, state, &self.heat.mean_velocity()));
        self.conductances = self.assembled(state).conductances;
    }

    fn kept(&self) -> Kept<'_> {
        Kept {
            cross_flow: &self.cross_flow,
            conductances: &self.conductances,
            streams: self.streams.as_ref(),
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
        let (largest_step, largest_cooling) =
            (self.params.largest_step, self.params.largest_cooling);
        let start = state.temperature.iter().copied();
        let inlet = self.heat.inlet_temperature;
        let coldest = *(self.coldest).get_or_insert_with(|| start.fold(inlet, f64::min));
        let mut halvings = 0;
        let (change, cross_flow) = loop {
            match self.solve(state) {
                Ok(found) => break found,
                Err(HeatError::NotFinite | HeatError::Overheated)
                    if halvings < MOST_HALVINGS && !self.before.is_empty() =>
                {
                    halvings += 1;
                    for (t, before) in state.temperature.iter_mut().zip(&self.before) {
                        *t = 0.5 * (*t + before);
                    }
                }
                // Steps in time change the matrix, not these.
                Err(e @ (HeatError::NotFinite | HeatError::Overheated)) => return Err(e),
                Err(e) if self.damping * SHORTEST_WARMING >= 1.0 => return Err(e),
                _ => self.damping = (WARMING_FACTOR * self.damping).max(1.0 / FIRST_WARMING),
            }
        };
        self.cross_flow = cross_flow;
        self.stats.iterations += 1;
        self.before.clone_from(&state.temperature);
        let share = match max_abs(&change) > largest_step || self.damping > 0.0 {
            true => {
                self.relaxation = Relaxation::default();
                1.0
            }
            false => self.relaxation.share(&change),
        };
        for (t, dt) in state.temperature.iter_mut().zip(&change) {
            let dt = share * dt;
            let lowest = t.min(coldest) - largest_cooling;
            *t = (*t + dt.clamp(-largest_step, largest_step)).max(lowest);
        }
        if self.damping == 0.0 {
            let largest = max_abs(&change);
            self.relaxation.taken(share, change);
            return Ok(largest);
        }
        self.damping /= WARMING_FACTOR * WARMING_FACTOR;
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
                streams: self.streams.as_ref(),
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
        let (change, iterations) = self.solve_linear(&right)?;
        self.stats.krylov_iterations += iterations;
        Ok((change, system.cross_flow))
    }

    /// Solves the linear equations with the last factorisation, if that is still good for it, else with a new one; returns the
    /// iterations, too.
    fn solve_linear(&mut self, right: &[f64]) -> Result<(Vec<f64>, usize), HeatError> {
        let matrix = &self.matrix;
        let tolerance = self.params.linear_tolerance;
        let solve = |ilu: &mut BlockIlu, max_iterations| {
            let mut change = vec![0.0; right.len()];
            let params = GmresParams {
                tolerance,
                max_iterations,
                ..GmresParams::default()
            };
            let multiply = |x: &[f64], y: &mut [f64]| matrix.multiply(x, y);
            gmres(multiply, |x| ilu.solve(x), right, &mut change, params)
                .map(|info| (change, info.iterations))
        };
        if let Some((mut ilu, when_new)) = self.factors.take()
            && let Ok(solved) = solve(&mut ilu, when_new + SPARE_KRYLOV)
        {
            self.factors = Some((ilu, when_new));
            return Ok(solved);
        }
        let mut ilu = BlockIlu::new(matrix)?;
        let solved = solve(&mut ilu, self.params.max_krylov)?;
        self.factors = Some((ilu, solved.1));
        Ok(solved)
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
