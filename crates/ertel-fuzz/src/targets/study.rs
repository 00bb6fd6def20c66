//! Studies, with axes and with tables of points.

use std::path::Path;

use ertel::case::Study;
use ertel::study::StudyEcho;
use ertel::study::plan::Plan;

use super::case::set_up;
use super::{Verdict, check_place};
use crate::finding::Defect;

/// Points of a study that are set up.
const MOST_SET_UP: usize = 3;
/// Points up to which all are read, and the message about a point that a study does not have.
const MOST_READ: usize = 2000;
const NO_SUCH_POINT: &str = "not all of those asked for";
/// Points up to which the starts are planned: that takes their square in time.
const MOST_PLANNED: usize = 500;

/// Reads `study.toml` with all that it names.
pub fn run(folder: &Path) -> Result<Verdict, Defect> {
    let path = folder.join("study.toml");
    // Every point is read as a case, 0.2 ms each: of long studies one point has to do.
    let study = match Study::read_some(&path, Some(&[MOST_READ])) {
        Err(error) if error.message().contains(NO_SUCH_POINT) => Study::read(&path),
        read => read,
    };
    let study = match study {
        Ok(study) => study,
        Err(error) => return check_place(&error, folder),
    };
    if study.points.len() <= MOST_PLANNED {
        let plan = Plan::new(&study);
        if plan.order.len() != study.points.len() {
            return Err(Defect::wrong(
                "a plan that leaves points out",
                format!("{:?}", plan.order),
            ));
        }
        StudyEcho::new(&study);
    }
    for point in study.points.iter().take(MOST_SET_UP) {
        set_up(&point.case)?;
    }
    Ok(Verdict::Taken)
}
