//! A validation study and its pictures.

use std::path::PathBuf;

use super::place::Published;
use super::{Check, Profile, Quantity, Run};
use ertel::reference::FilmFormula;

/// A validation study.
#[derive(Clone, Debug)]
pub struct Study {
    /// Name of its folder.
    pub name: String,
    /// One line.
    pub title: String,
    /// Source of the published values.
    pub source: String,
    /// Every file that it was read from.
    pub files: Vec<PathBuf>,
    /// Computations.
    pub runs: Vec<Run>,
    /// Comparisons.
    pub checks: Vec<Check>,
    /// Pictures.
    pub pictures: Vec<Picture>,
}

/// Content of a picture.
#[derive(Clone, Debug, PartialEq)]
pub enum PictureKind {
    /// Pressure and film on the centreline of a run.
    Centreline(usize),
    /// Deflection on the centreline of all runs, and Hertz theory.
    Deflection,
    /// Its deviation from Hertz theory.
    DeflectionError,
    /// Central film of these runs over the load group, one curve per material group, with a
    /// formula.
    FilmOverLoad(FilmFormula, Vec<usize>),
    /// Pressure and film on the centreline of these runs, panels in rows of so many.
    Profiles(Vec<usize>, usize),
    /// A profile on the centreline of these runs over each other, and again within this range of X.
    Overlay(Profile, Vec<usize>, [f64; 2]),
    /// Temperature across the film of these runs, panels in rows of so many.
    CrossFilm(Vec<usize>, usize),
    /// Temperatures on the centreline of these runs, likewise.
    Temperatures(Vec<usize>, usize),
    /// Map of a field over the contact of a run, by its name among [`pictures`](ertel::output::pictures::pictures).
    Map(usize, &'static str),
    /// Films of the curves of these runs, dashed those without shear thinning or heat.
    FilmCurves(Vec<usize>),
    /// Films of the curve of a run, likewise, with the smallest one on the centreline.
    FilmShape(usize),
    /// Traction coefficients of the curves of these runs, likewise.
    TractionCurves(Vec<usize>),
    /// Films of a run over time compared with published ones, panels in rows of so many.
    Instants(usize, Vec<Published>, usize),
    /// A quantity over the penalty, one colour per scaling, one look per mesh.
    Penalty(Quantity),
}

/// A picture to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// File name after that of the study.
    pub name: String,
    /// Its content, in a sentence.
    pub caption: String,
    /// Its content.
    pub kind: PictureKind,
    /// Range of the left axis, in the unit shown there, instead of one around the values.
    pub range: Option<[f64; 2]>,
}
