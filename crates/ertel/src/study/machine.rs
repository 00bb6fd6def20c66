//! A machine: its contacts side by side on all cores, each from the one that the plan of a study says.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::time::Instant;

use super::curve::CurveObserver;
use super::plan::Plan;
use super::point::{Ends, Interrupted, PointSolution, Task};
use super::walk::Walk;
use crate::case::{MachineContacts, Study, WholeMachine};
use crate::solution::Solution;
use crate::solve::Observer;

/// What became of the contacts of a machine.
#[derive(Clone, Debug)]
pub struct MachineSolution {
    /// The machine.
    pub machine: Arc<WholeMachine>,
    /// What became of each contact that stands for others, by its place among the contacts; `None` where nothing presses, another contact
    /// stands for it, or the user stopped before.
    pub contacts: Vec<Option<PointSolution>>,
    /// Wall time, s.
    pub wall_seconds: f64,
}

impl MachineSolution {
    /// What became of the contact that stands for this one.
    pub fn of(&self, contact: usize) -> Option<&PointSolution> {
        let like = self.machine.contacts[contact].like?;
        self.contacts[like].as_ref()
    }

    /// Its solution, if it has one.
    pub fn solution(&self, contact: usize) -> Option<&Solution> {
        self.of(contact)?.outcome.solution()
    }

    /// The contacts that were solved, with their places.
    pub fn solved(&self) -> impl Iterator<Item = (usize, &PointSolution)> {
        let contacts = self.contacts.iter().enumerate();
        contacts.filter_map(|(i, point)| Some((i, point.as_ref()?)))
    }

    /// Contacts to be solved, those alike counted once.
    pub fn n_contacts(&self) -> usize {
        distinct(&self.machine).len()
    }

    /// Those of them without solution.
    pub fn n_failed(&self) -> usize {
        let failed = self
            .solved()
            .filter(|(_, p)| p.outcome.solution().is_none());
        failed.count()
    }

    /// Whether the user stopped it before the last contact.
    pub fn is_partial(&self) -> bool {
        self.solved().count() < self.n_contacts()
    }
}

/// Places of the contacts that are solved.
fn distinct(machine: &WholeMachine) -> Vec<usize> {
    let contacts = machine.contacts.iter().enumerate();
    let own = contacts.filter(|(i, contact)| contact.like == Some(*i));
    own.map(|(i, _)| i).collect()
}

/// Solves the contacts of a machine. A contact that fails is kept with its reason. When the observer cancels, the contacts until then are returned.
///
/// Fields and iterations are kept only where the machine asks for folders.
pub fn solve_machine(
    contacts: &MachineContacts,
    observer: &mut dyn CurveObserver,
) -> MachineSolution {
    let clock = Instant::now();
    let MachineContacts { machine, study } = contacts;
    let n = study.points.len();
    let plan = Plan::new(study);
    let walk = Walk::<Ends>::new(&plan, &vec![true; n]);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let shared = Shared {
        study,
        plan: &plan,
        walk: &walk,
        fields: machine.folders,
        cancelled: AtomicBool::new(false),
    };
    let mut found = vec![None; machine.contacts.len()];
    let places = distinct(machine);
    std::thread::scope(|scope| {
        let (sender, receiver) = std::sync::mpsc::channel();
        for _ in 0..cores.min(n).max(1) {
            let (shared, sender) = (&shared, sender.clone());
            scope.spawn(move || shared.work(&sender));
        }
        drop(sender);
        for message in receiver {
            match message {
                Message::Begun(index) => {
                    observer.point(index, n, &study.points[index].label);
                }
                Message::Ended(index, point) => {
                    observer.finished(index, &point);
                    found[places[index]] = Some(*point);
                }
                Message::Alive => {}
            }
            if observer.cancelled() {
                shared.cancelled.store(true, Ordering::Relaxed);
            }
        }
    });
    MachineSolution {
        machine: machine.clone(),
        contacts: found,
        wall_seconds: clock.elapsed().as_secs_f64(),
    }
}

/// What a thread tells.
enum Message {
    Begun(usize),
    Ended(usize, Box<PointSolution>),
    /// An iteration: the moment to ask whether the user wants to stop.
    Alive,
}

/// What the threads share.
struct Shared<'a> {
    study: &'a Study,
    plan: &'a Plan,
    walk: &'a Walk<Ends>,
    fields: bool,
    cancelled: AtomicBool,
}

impl Shared<'_> {
    /// Solves contacts until there are none, on one thread each.
    fn work(&self, sender: &Sender<Message>) {
        let solve = || {
            // Interrupted or not, what is solved counts.
            let _ = self.walk.run(|index, from| {
                let _ = sender.send(Message::Begun(index));
                let points = &self.study.points;
                let task = Task {
                    point: &points[index],
                    place: (index, points.len()),
                    label: points[index].label.clone(),
                    ahead: self.plan.ahead(index).map(|i| &points[i].case).collect(),
                    beside: [false; 2],
                    fields: self.fields,
                };
                let (point, ends) = task.solve(from, &mut Teller(self, sender))?;
                let _ = sender.send(Message::Ended(index, Box::new(point)));
                Ok::<_, Interrupted>(ends)
            });
        };
        match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
            Ok(pool) => pool.install(solve),
            Err(_) => solve(),
        }
    }
}

/// Tells the thread that waits, and stops the solver when the user wants.
struct Teller<'a, 'b>(&'a Shared<'b>, &'a Sender<Message>);

impl Observer for Teller<'_, '_> {
    fn iteration(&mut self, _record: &crate::solution::IterationRecord) {
        let _ = self.1.send(Message::Alive);
    }

    fn cancelled(&self) -> bool {
        self.0.cancelled.load(Ordering::Relaxed)
    }
}

impl CurveObserver for Teller<'_, '_> {}
