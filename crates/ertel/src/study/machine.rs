//! A machine: its contacts in parallel on all cores, each from the one given by the plan of a study.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;

use ertel_fem::platform::Instant;
use ertel_input::InputError;

use super::curve::CurveObserver;
use super::plan::Plan;
use super::point::{Ends, Interrupted, Task};
use super::walk::Walk;
use crate::case::{Case, MachineContacts, Study};
use crate::engine::Observer;
use crate::machine::{SolvedMachine, solve_by};
use crate::point::{MachineSolution, PointSolution, distinct};
use crate::run::Start;
use crate::solution::IterationRecord;

/// Results of the contacts that start from no other contact of their machine, by their places: starting points for the next point of a curve
/// or a study.
pub(super) type RootStarts = BTreeMap<usize, Arc<Start>>;

/// Solves a whole machine on all cores, at the temperature of its heat balance where the case requests it; `None` for a case that is no machine.
///
/// # Errors
/// Laws of the lubricant that do not reach a temperature on the way.
pub fn solve_in_balance(
    case: &Case,
    observer: &mut dyn CurveObserver,
) -> Result<Option<SolvedMachine>, InputError> {
    solve_by(case, |contacts| solve_machine(contacts, observer))
}

/// Solves the contacts of a machine on all cores. A contact that fails is kept with its reason. When the observer cancels, the contacts until then are
/// returned.
///
/// Fields and iterations are kept only where the machine requests folders.
pub fn solve_machine(
    contacts: &MachineContacts,
    observer: &mut dyn CurveObserver,
) -> MachineSolution {
    let (solution, _) = solve_contacts(contacts, &RootStarts::new(), cores(), observer);
    solution
}

/// As many contacts as are solved side by side.
pub(crate) fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// As [`solve_machine`], as many contacts at a time as there are `workers`, and those that start from no other one of the machine from `starts`;
/// returns the results of the latter. The result does not depend on the number of workers.
pub(super) fn solve_contacts(
    contacts: &MachineContacts,
    starts: &RootStarts,
    workers: usize,
    observer: &mut dyn CurveObserver,
) -> (MachineSolution, RootStarts) {
    let clock = Instant::now();
    let MachineContacts { machine, study } = contacts;
    let n = study.points.len();
    let plan = Plan::new(study);
    let walk = Walk::<Ends>::new(&plan, &vec![true; n]);
    let places = distinct(machine);
    let shared = Shared {
        study,
        plan: &plan,
        walk: &walk,
        starts,
        places: &places,
        fields: machine.folders,
        cancelled: AtomicBool::new(false),
    };
    let mut found = vec![None; machine.contacts.len()];
    let mut reached = starts.clone();
    let mut keep = |ended: Ended, observer: &mut dyn CurveObserver| {
        observer.finished(ended.index, &ended.point);
        let place = places[ended.index];
        reached.extend(ended.root.map(|root| (place, root)));
        found[place] = Some(*ended.point);
    };
    let workers = workers.clamp(1, n.max(1));
    if workers == 1 {
        // Interrupted or not, what is solved counts.
        let _ = walk.run(|index, from| {
            let (ended, ends) = shared.solve(index, from, observer)?;
            keep(ended, observer);
            Ok::<_, Interrupted>(ends)
        });
    } else {
        std::thread::scope(|scope| {
            let (sender, receiver) = std::sync::mpsc::channel();
            for _ in 0..workers {
                let (shared, sender) = (&shared, sender.clone());
                scope.spawn(move || shared.work(&sender));
            }
            drop(sender);
            for message in receiver {
                match message {
                    Message::Begun(index) => {
                        observer.point(index, n, &study.points[index].label);
                    }
                    Message::Ended(ended) => keep(ended, observer),
                    Message::Alive => {}
                }
                if observer.cancelled() {
                    shared.cancelled.store(true, Ordering::Relaxed);
                }
            }
        });
    }
    let solution = MachineSolution {
        machine: machine.clone(),
        contacts: found,
        wall_seconds: clock.elapsed().as_secs_f64(),
    };
    (solution, reached)
}

/// A contact that is finished.
struct Ended {
    index: usize,
    point: Box<PointSolution>,
    /// Its result, where it starts from no other contact.
    root: Option<Arc<Start>>,
}

/// A message from a worker thread.
enum Message {
    Begun(usize),
    Ended(Ended),
    /// An iteration: the moment to ask whether the user wants to stop.
    Alive,
}

/// State shared by the threads.
struct Shared<'a> {
    study: &'a Study,
    plan: &'a Plan,
    walk: &'a Walk<Ends>,
    starts: &'a RootStarts,
    places: &'a [usize],
    fields: bool,
    cancelled: AtomicBool,
}

impl Shared<'_> {
    /// Solves contacts until there are none, on one thread each.
    fn work(&self, sender: &Sender<Message>) {
        let solve = || {
            // Interrupted or not, what is solved counts.
            let _ = self.walk.run(|index, from| {
                let (ended, ends) = self.solve(index, from, &mut Reporter(self, sender))?;
                let _ = sender.send(Message::Ended(ended));
                Ok::<_, Interrupted>(ends)
            });
        };
        match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
            Ok(pool) => pool.install(solve),
            Err(_) => solve(),
        }
    }

    /// Solves a contact from the one that the plan says, or from where it was at another point.
    fn solve(
        &self,
        index: usize,
        from: Ends,
        observer: &mut dyn CurveObserver,
    ) -> Result<(Ended, Ends), Interrupted> {
        let points = &self.study.points;
        let is_root = self.plan.parents[index].is_none();
        let from = match is_root {
            true => Ends::of_contact(self.starts.get(&self.places[index]).cloned()),
            false => from,
        };
        let task = Task {
            point: &points[index],
            place: (index, points.len()),
            label: points[index].label.clone(),
            simpler: [false; 2],
            fields: self.fields,
            workers: 1,
        };
        let (point, ends) = task.solve(from, observer)?;
        let ended = Ended {
            index,
            point: Box::new(point),
            root: is_root.then(|| ends.own()).flatten(),
        };
        Ok((ended, ends))
    }
}

/// Reports to the waiting thread, and stops the solver when the user wants.
struct Reporter<'a, 'b>(&'a Shared<'b>, &'a Sender<Message>);

impl Observer for Reporter<'_, '_> {
    fn iteration(&mut self, _record: &IterationRecord) {
        let _ = self.1.send(Message::Alive);
    }

    fn cancelled(&self) -> bool {
        self.0.cancelled.load(Ordering::Relaxed)
    }
}

impl CurveObserver for Reporter<'_, '_> {
    fn point(&mut self, index: usize, _n_points: usize, _label: &str) {
        let _ = self.1.send(Message::Begun(index));
    }
}

/// Reports the contacts of a machine as parts of a point of a curve or a study.
pub(super) struct MachineObserver<'a> {
    pub(super) observer: &'a mut dyn CurveObserver,
    /// Place of the point, and number of points.
    pub(super) place: (usize, usize),
    /// Its values.
    pub(super) label: &'a str,
}

impl Observer for MachineObserver<'_> {
    fn level(&mut self, level: usize, n_levels: usize, n_pressure: usize, n_displacement: usize) {
        (self.observer).level(level, n_levels, n_pressure, n_displacement);
    }

    fn grid(&mut self, grid: usize, n_pressure: usize) {
        self.observer.grid(grid, n_pressure);
    }

    fn iteration(&mut self, record: &IterationRecord) {
        self.observer.iteration(record);
    }

    fn round(&mut self, round: usize, change: f64, rise: f64) {
        self.observer.round(round, change, rise);
    }

    fn cancelled(&self) -> bool {
        self.observer.cancelled()
    }
}

impl CurveObserver for MachineObserver<'_> {
    fn point(&mut self, _index: usize, _n_points: usize, contact: &str) {
        let (index, n_points) = self.place;
        let label = format!("{}: {contact}", self.label);
        self.observer.point(index, n_points, &label);
    }
}
