//! How a study is run, what follows it, and its outcome.

use crate::case::study::MOST_POINTS;
use crate::study::UnresolvedFigures;
use crate::study::journal::Record;
use crate::warning::Merged;

/// How a study is run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SweepParams {
    /// Points solved at the same time; `None`: as many as cores.
    pub jobs: Option<usize>,
    /// Threads of each of them; `None`: one.
    pub threads: Option<usize>,
    /// Part of the points to be solved.
    pub shard: Option<Shard>,
    /// Whether each point's results are written into a separate folder.
    pub folders: bool,
    /// Whether points that failed are solved again.
    pub retry: bool,
}

/// Part `index` of `n`, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    index: usize,
    /// Of how many.
    n: usize,
}

impl Shard {
    /// Part `index` of `n`; `None` for more parts than the largest study has points, and for an index outside 1 to `n`.
    pub fn new(index: usize, n: usize) -> Option<Shard> {
        (1 <= index && index <= n && n <= MOST_POINTS).then_some(Shard { index, n })
    }

    /// Name of its folder among those of all parts: `03-of-12`.
    pub fn name(self) -> String {
        let Shard { index, n } = self;
        let width = n.to_string().len();
        format!("{index:0width$}-of-{n}")
    }

    /// Its share of the plan's order: neighbours in the tree stay together.
    pub(super) fn range(self, n_points: usize) -> std::ops::Range<usize> {
        (self.index - 1) * n_points / self.n..self.index * n_points / self.n
    }
}

/// Follows a study; called from the threads that solve its points.
pub trait SweepObserver: Sync {
    /// The solving begins.
    fn begin(&self, _n_points: usize, _n_kept: usize) {}

    /// A point is finished.
    fn finished(&self, _progress: &SweepProgress<'_>) {}

    /// Whether the user wants to stop.
    fn cancelled(&self) -> bool {
        false
    }
}

impl SweepObserver for crate::engine::NoObserver {}

/// How far a study is.
#[derive(Clone, Debug)]
pub struct SweepProgress<'a> {
    /// Points that are finished, in this run or an earlier one.
    pub n_finished: usize,
    /// Points of the study, or of the part being run.
    pub n_points: usize,
    /// Index of the point just finished, from 0.
    pub index: usize,
    /// Its values.
    pub label: &'a str,
    /// Its outcome.
    pub record: &'a Record,
    /// Estimate of the remaining wall time, s.
    pub seconds_left: f64,
}

/// Outcome of a study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SweepSummary {
    /// Points of the study, or of the part that was run.
    pub n_points: usize,
    /// Points that the journal had already.
    pub n_kept: usize,
    /// Points finished in this run.
    pub n_new: usize,
    /// Points of the journal that were solved again because others start from them.
    pub n_again: usize,
    /// Lines of the journal that could not be read.
    pub n_damaged: usize,
    /// Index, values and reason of the points without solution.
    pub failures: Vec<(usize, String, String)>,
    /// Points with figures that the mesh does not resolve.
    pub n_unresolved: usize,
    /// Names of these figures, and of the other unresolved ones.
    pub unresolved: UnresolvedFigures,
    /// Warnings, those of one kind together.
    pub warnings: Vec<Merged>,
    /// Wall time, s.
    pub wall_seconds: f64,
    /// Time of the new points, all together, s.
    pub point_seconds: f64,
    /// Whether the user stopped it.
    pub interrupted: bool,
}
