//! The linear systems of Newton's method: the bordered condensed one by preconditioned GMRES, or the
//! monolithic one by sparse LU; factors are kept while they serve.

use ertel_fem::platform::Instant;

use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::linear::gmres::{GmresParams, gmres};

use super::discretisation::Discretisation;
use super::monolithic::Monolithic;
use super::newton_level::{FilmModel, Method, NewtonLevel, NewtonParams, NewtonStats};
use super::preconditioner::Preconditioner;
use super::state::State;
use super::system::System;
use crate::elastic::Accuracy as Deflections;
use crate::engine::SolveError;
use crate::solve::tuning::newton::{MOST_STALE_ITERATIONS, STALE_EFFORT};

/// Newton step at all pressure nodes and of H0.
pub(super) struct Step {
    pub pressure: Vec<f64>,
    pub separation: f64,
    pub krylov_iterations: usize,
    /// Krylov iterations for each factor of a thousand in the error.
    effort: f64,
}

/// Factors kept from one linear solve to the next.
enum Factors {
    Bordered(Bordered),
    Monolithic(Box<Monolithic>),
}

/// Solves the linear systems of a run; reuses the factors as long as they converge.
pub(super) struct StepSolver<'a, 'b> {
    level: &'a NewtonLevel<'a>,
    factors: Option<Factors>,
    /// Tolerance of Newton's method.
    target: f64,
    pub stats: &'b mut NewtonStats,
}

/// Preconditioner of the bordered system: the factorised sparse part, and its response to a unit
/// separation by which H0 is eliminated.
struct Bordered {
    sparse: Preconditioner,
    response: Vec<f64>,
    schur: f64,
}

/// How accurate a linear solve must be.
#[derive(Clone, Copy)]
enum Accuracy {
    /// For a Newton step, when the run ends at updates of `end`.
    Step { end: f64 },
    /// For a test of the growth of steps.
    Test,
}

impl Accuracy {
    /// Relative error of a step of about the size `update` (Eisenstat and Walker 1996): quadratic convergence
    /// takes an update u to about u², so a share of u is small enough; and what is far below the end of the run
    /// is wasted. At most 1e-3; 1e-2 takes about as many iterations.
    fn tolerance(self, update: f64) -> f64 {
        match self {
            Accuracy::Step { end } => (0.03 * update).max(0.1 * end / update).clamp(1e-9, 1e-3),
            Accuracy::Test => 3e-2,
        }
    }
}

impl<'a, 'b> StepSolver<'a, 'b> {
    /// Solver without factors yet; counts its effort in `stats`.
    pub fn new(
        level: &'a NewtonLevel<'a>,
        params: &NewtonParams,
        stats: &'b mut NewtonStats,
    ) -> StepSolver<'a, 'b> {
        StepSolver {
            level,
            factors: None,
            target: params.update_tolerance.min(params.residual_tolerance),
            stats,
        }
    }

    /// The preconditioner in force.
    pub fn into_preconditioner(self) -> Option<Preconditioner> {
        match self.factors? {
            Factors::Bordered(bordered) => Some(bordered.sparse),
            Factors::Monolithic(_) => None,
        }
    }

    /// Linearised equations at a state.
    pub fn assemble(&mut self, model: &FilmModel, state: &State) -> System {
        let clock = Instant::now();
        let d = self.level.discretisation;
        let system = System::assemble(d, &model.fluid, &model.constants, state, None);
        self.stats.seconds.assembly += clock.elapsed().as_secs_f64();
        system
    }

    fn refresh(&mut self, system: &System) -> Result<(), SolveError> {
        let clock = Instant::now();
        let d = self.level.discretisation;
        self.factors = Some(match &self.level.method {
            Method::Condensed(near) => {
                let mut sparse = Preconditioner::new(d, near, system)?;
                let mut response = system.by_separation.clone();
                sparse.solve(&mut response);
                let schur = -dot(&d.load, &response);
                Factors::Bordered(Bordered {
                    sparse,
                    response,
                    schur,
                })
            }
            Method::Monolithic(bodies) => {
                Factors::Monolithic(Box::new(Monolithic::new(d, bodies, system)?))
            }
        });
        self.stats.factorisations += 1;
        self.stats.seconds.factorisation += clock.elapsed().as_secs_f64();
        Ok(())
    }

    /// −J⁻¹F of a system at its own state.
    pub fn newton_step(&mut self, system: &System, state: &State) -> Result<Step, SolveError> {
        let tolerance = Accuracy::Step { end: self.target };
        if matches!(self.factors, Some(Factors::Bordered(_)))
            && let Ok(step) = self.solve(system, system, state, tolerance, MOST_STALE_ITERATIONS)
        {
            let dimension = self.level.discretisation.contact.surface.dim;
            if step.effort > STALE_EFFORT[dimension - 1] {
                self.factors = None;
            }
            return Ok(step);
        }
        self.refresh(system)?;
        self.solve(system, system, state, tolerance, 200)
    }

    /// −J⁻¹F with the Jacobian of `jacobian` and the residual of `system`, coarsely.
    pub fn simplified_step(
        &mut self,
        jacobian: &System,
        system: &System,
        state: &State,
    ) -> Result<Step, SolveError> {
        if self.factors.is_none() {
            self.refresh(jacobian)?;
        }
        self.solve(jacobian, system, state, Accuracy::Test, 200)
    }

    fn solve(
        &mut self,
        jacobian: &System,
        system: &System,
        state: &State,
        accuracy: Accuracy,
        max_iterations: usize,
    ) -> Result<Step, SolveError> {
        let clock = Instant::now();
        let level = self.level;
        let d = level.discretisation;
        let defect = level.load - d.integral(&state.pressure);
        let (unknowns, separation, krylov_iterations, effort) =
            match self.factors.as_mut().expect("refreshed before") {
                Factors::Bordered(b) => {
                    let equations = (jacobian, &system.residual[..], defect, level.load);
                    b.solve(d, equations, accuracy, max_iterations)?
                }
                Factors::Monolithic(m) => {
                    let (p, h) = m.solve(&system.residual, defect);
                    (p, h, 0, 0.0)
                }
            };
        self.stats.krylov_iterations += krylov_iterations;
        self.stats.seconds.krylov += clock.elapsed().as_secs_f64();
        let mut pressure = vec![0.0; d.pressure.n_nodes()];
        scatter(d, &unknowns, &mut pressure);
        Ok(Step {
            pressure,
            separation,
            krylov_iterations,
            effort,
        })
    }
}

impl Bordered {
    /// Krylov iterations on the bordered condensed system: the equations, given by Jacobian, residual, what is
    /// missing of the load, and the load, are multiplied by the preconditioner, so that errors are
    /// measured as pressures. The residual says little about them: the inlet, where a pressure moves much
    /// fluid, outweighs by decades the Hertz zone, where it moves none.
    fn solve(
        &mut self,
        d: &Discretisation,
        (jacobian, residual, load_defect, load): (&System, &[f64], f64, f64),
        accuracy: Accuracy,
        max_iterations: usize,
    ) -> Result<(Vec<f64>, f64, usize, f64), SolveError> {
        let n = d.n_pressure;
        // The load row is scaled like the residual: one number represents the whole contact.
        let row_scale = jacobian.residual_scale / load;
        let mut rhs: Vec<f64> = residual.iter().map(|v| -v).collect();
        rhs.push(row_scale * load_defect);
        let mut products = jacobian.products(d, Deflections::Krylov);
        let mut apply = |x: &[f64], y: &mut [f64]| {
            products.multiply(&x[..n], &mut y[..n]);
            for (yi, b) in y[..n].iter_mut().zip(&jacobian.by_separation) {
                *yi += b * x[n];
            }
            y[n] = row_scale * dot(&d.load, &x[..n]);
        };
        let mut precondition = |x: &mut [f64]| {
            let (pressures, separation) = x.split_at_mut(n);
            self.sparse.solve(pressures);
            let h = (separation[0] / row_scale - dot(&d.load, pressures)) / self.schur;
            for (p, r) in pressures.iter_mut().zip(&self.response) {
                *p -= h * r;
            }
            separation[0] = h;
        };
        let mut x = vec![0.0; n + 1];
        precondition(&mut rhs);
        let update = rhs[..n].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
        let params = GmresParams {
            tolerance: accuracy.tolerance(update),
            max_iterations,
            ..GmresParams::default()
        };
        let product = |x: &[f64], y: &mut [f64]| {
            apply(x, y);
            precondition(y);
        };
        let info = gmres(product, |_: &mut [f64]| {}, &rhs, &mut x, params)?;
        let separation = x[n];
        x.truncate(n);
        let effort = info.iterations as f64 * 1e-3_f64.ln() / params.tolerance.ln();
        Ok((x, separation, info.iterations, effort))
    }
}

/// Values of the unknowns at their nodes, zero on the edge.
pub(super) fn scatter(d: &Discretisation, unknowns: &[f64], nodal: &mut [f64]) {
    for (value, dof) in nodal.iter_mut().zip(&d.pressure_dofs) {
        *value = if *dof == CONSTRAINED {
            0.0
        } else {
            unknowns[*dof as usize]
        };
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
