//! One case of the map, solved: what came out, and what it cost.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use cpu_time::ProcessTime;
use ertel::contact::ContactKind;
use ertel::engine::{Observer, SolveError};
use ertel::params::{MeshParams, MeshPreset};
use ertel::run::{groups, solve};
use ertel::solution::{Estimate, IterationRecord};
use ertel::warning::{Warning, texts};

use crate::cases::{Family, MapCase};

/// How a case ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Ending {
    /// With a solution.
    Converged,
    /// Without, and why.
    Failed(String),
    /// The time was over.
    TimedOut,
}

/// A solved case.
#[derive(Clone, Debug)]
pub struct Record {
    pub name: String,
    pub kind: ContactKind,
    pub family: Family,
    pub ending: Ending,
    /// Moes' load group.
    pub m: f64,
    /// Moes' material group, with the initial slope of the viscosity's logarithm.
    pub l: f64,
    /// Hertz pressure, Pa.
    pub pressure: f64,
    /// Entrainment speed, m/s.
    pub speed: f64,
    pub film_central: Option<Estimate>,
    pub film_minimum: Option<Estimate>,
    /// Traction coefficient, where the surfaces slide.
    pub traction: Option<f64>,
    /// Error of the heat balance over the generated heat.
    pub heat_balance: Option<f64>,
    pub warnings: Vec<Warning>,
    /// Newton iterations of all stages.
    pub newton: usize,
    /// Krylov iterations of all stages.
    pub krylov: usize,
    pub stages: usize,
    pub n_pressure_dofs: usize,
    pub n_displacement_dofs: usize,
    pub wall: f64,
    pub cpu: f64,
}

/// Settings of a run.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Replaces the default mesh.
    pub preset: Option<MeshPreset>,
    /// A case that takes more CPU time is stopped.
    pub limit: Option<Duration>,
    /// Print every Newton iteration.
    pub verbose: bool,
}

/// Counts the work, watches the clock.
struct Watch {
    start: Instant,
    cpu: ProcessTime,
    settings: Settings,
    newton: usize,
    krylov: usize,
    stages: usize,
    dofs: [usize; 2],
}

impl Observer for Watch {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, n_displacement: usize) {
        self.stages += 1;
        self.dofs = [n_pressure, n_displacement];
        if self.settings.verbose {
            println!(
                "  stage {}/{n_levels}: P {n_pressure}, U {n_displacement}",
                level + 1
            );
        }
    }

    fn iteration(&mut self, r: &IterationRecord) {
        self.newton += 1;
        self.krylov += r.krylov_iterations;
        if self.settings.verbose {
            println!(
                "    order {} penalty {:.0e} it {:2} residual {:.2e} update {:.2e} step {:.3} krylov {} hc {:.3} nm",
                r.pressure_order,
                r.penalty_share,
                r.iteration,
                r.residual,
                r.update,
                r.step,
                r.krylov_iterations,
                r.film_central * 1e9
            );
        }
    }

    fn cancelled(&self) -> bool {
        let limit = self.settings.limit;
        limit.is_some_and(|limit| self.cpu.elapsed() > limit)
    }
}

/// Solves a case cold.
pub fn run(map_case: &MapCase, settings: Settings) -> Record {
    let mut case = match map_case.read() {
        Ok(case) => case,
        Err(error) => panic!("{}: {error}", map_case.name),
    };
    if let Some(preset) = settings.preset {
        case.mesh = MeshParams::preset(preset, map_case.kind);
    }
    let lubricant = &case.lubricant;
    let slope = lubricant
        .viscosity
        .pressure_viscosity_slope(lubricant.temperature);
    let g = groups(&case, slope.max(0.0));
    let mut watch = Watch {
        start: Instant::now(),
        cpu: ProcessTime::now(),
        settings,
        newton: 0,
        krylov: 0,
        stages: 0,
        dofs: [0; 2],
    };
    // A panic is a failure of one case, not of the map.
    let outcome = catch_unwind(AssertUnwindSafe(|| solve(&case, &mut watch)));
    let (wall, cpu) = (
        watch.start.elapsed().as_secs_f64(),
        watch.cpu.elapsed().as_secs_f64(),
    );
    let (ending, solution) = match outcome {
        Ok(Ok(solution)) => (Ending::Converged, Some(solution)),
        Ok(Err(SolveError::Interrupted)) => (Ending::TimedOut, None),
        Ok(Err(error)) => (Ending::Failed(error.to_string()), None),
        Err(_) => (Ending::Failed("panic".to_owned()), None),
    };
    let summary = solution.as_ref().map(|s| &s.summary);
    Record {
        name: map_case.name.clone(),
        kind: map_case.kind,
        family: map_case.family,
        ending,
        m: g.moes_load,
        l: g.moes_material,
        pressure: case.hertz().pressure,
        speed: case.motion.entrainment_speed,
        film_central: summary.map(|s| s.film_central),
        film_minimum: summary.map(|s| s.film_minimum),
        traction: (solution.as_ref())
            .filter(|_| case.motion.slide_to_roll_ratio != 0.0)
            .map(|s| s.traction.coefficient.value),
        heat_balance: (solution.as_ref())
            .and_then(|s| s.thermal.as_ref())
            .map(|t| t.balance.error),
        warnings: solution
            .as_ref()
            .map_or_else(|| case.warnings.clone(), |s| s.warnings.clone()),
        newton: watch.newton,
        krylov: watch.krylov,
        stages: watch.stages,
        n_pressure_dofs: watch.dofs[0],
        n_displacement_dofs: watch.dofs[1],
        wall,
        cpu,
    }
}

impl Record {
    pub fn converged(&self) -> bool {
        self.ending == Ending::Converged
    }

    /// `ok`, `time`, or `FAIL` with the reason.
    pub fn status(&self) -> String {
        match &self.ending {
            Ending::Converged => "ok".to_owned(),
            Ending::TimedOut => "out of time".to_owned(),
            Ending::Failed(reason) => format!("FAIL {reason}"),
        }
    }

    /// One line of progress.
    pub fn line(&self) -> String {
        let film = |e: Option<Estimate>| match e {
            Some(e) => {
                let bar = e.error.map_or("      ".to_owned(), |b| {
                    format!("±{:4.1}%", 100.0 * b / e.value)
                });
                format!("{:9.3} {bar}", e.value * 1e9)
            }
            None => " ".repeat(16),
        };
        format!(
            "{:<36} {:5.2} GPa  h {} {} nm{}  N {:3} K {:4}  {:6.2} s {:6.2} cpu  {}{}",
            self.name,
            self.pressure / 1e9,
            film(self.film_central),
            film(self.film_minimum),
            self.sliding(),
            self.newton,
            self.krylov,
            self.wall,
            self.cpu,
            self.status(),
            if self.warnings.is_empty() {
                String::new()
            } else {
                format!(" ({} warnings)", self.warnings.len())
            }
        )
    }

    /// Traction and heat balance, where there are such.
    fn sliding(&self) -> String {
        let traction = self.traction.map(|t| format!("  mu {t:7.4}"));
        let balance = self
            .heat_balance
            .map(|b| format!("  heat {:+.2}%", 100.0 * b));
        [traction, balance].into_iter().flatten().collect()
    }

    pub const CSV_HEAD: &str = "name,kind,viscosity,M,L,hertz_pressure_GPa,speed_m_s,converged,film_central_nm,bar_central_nm,film_minimum_nm,bar_minimum_nm,traction_coefficient,heat_balance,newton,krylov,stages,pressure_dofs,displacement_dofs,wall_s,cpu_s,reason,warnings";

    /// One line of the CSV table.
    pub fn csv(&self) -> String {
        let nm = |v: Option<f64>| v.map_or(String::new(), |v| format!("{:.4}", v * 1e9));
        let quoted = |t: &str| format!("\"{}\"", t.replace('"', "'"));
        let kind = match self.kind {
            ContactKind::Line => "line",
            ContactKind::Circular => "circular",
            ContactKind::Elliptical => "elliptical",
            ContactKind::Roller => "roller",
        };
        let reason = if self.converged() {
            String::new()
        } else {
            self.status()
        };
        [
            self.name.clone(),
            kind.to_owned(),
            self.family.name().to_owned(),
            format!("{:.4}", self.m),
            format!("{:.4}", self.l),
            format!("{:.4}", self.pressure / 1e9),
            format!("{:.4e}", self.speed),
            self.converged().to_string(),
            nm(self.film_central.map(|e| e.value)),
            nm(self.film_central.and_then(|e| e.error)),
            nm(self.film_minimum.map(|e| e.value)),
            nm(self.film_minimum.and_then(|e| e.error)),
            self.traction.map_or(String::new(), |t| format!("{t:.6}")),
            self.heat_balance
                .map_or(String::new(), |b| format!("{b:.2e}")),
            self.newton.to_string(),
            self.krylov.to_string(),
            self.stages.to_string(),
            self.n_pressure_dofs.to_string(),
            self.n_displacement_dofs.to_string(),
            format!("{:.3}", self.wall),
            format!("{:.3}", self.cpu),
            quoted(&reason),
            quoted(&texts(&self.warnings).join("; ")),
        ]
        .join(",")
    }
}
