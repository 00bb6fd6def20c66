//! Which figures of the points of a curve or a study are not to be used.

use super::{Cell, CurveSolution, point_fields};
use crate::figures::words_of;

/// Columns of a table that name them: requested figures, and all figures.
const COLUMNS: [&str; 2] = ["unresolved", "uncertain_figures"];

/// Figures that are named; of more only the number.
const MOST: usize = 6;

/// How many points do not resolve each figure, by its name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct UnresolvedFigures {
    counts: Vec<(String, usize)>,
    n_rows: usize,
}

impl UnresolvedFigures {
    /// Adds a point by the text of its columns.
    pub fn add<'a>(&mut self, field: impl Fn(&str) -> Option<&'a str>) {
        let texts = COLUMNS.map(|column| field(column).unwrap_or(""));
        let mut names: Vec<&str> = texts.iter().flat_map(|text| text.split(' ')).collect();
        names.retain(|name| !name.is_empty());
        names.sort_unstable();
        names.dedup();
        self.n_rows += usize::from(!names.is_empty());
        for name in names {
            match self.counts.iter_mut().find(|(own, _)| own == name) {
                Some((_, n)) => *n += 1,
                None => self.counts.push((name.to_owned(), 1)),
            }
        }
    }

    /// Of the points of a curve.
    pub fn of_curve(curve: &CurveSolution) -> UnresolvedFigures {
        let mut found = UnresolvedFigures::default();
        for point in &curve.points {
            let fields = point_fields(point, point.case.contact.kind.is_line());
            found.add(
                |column| match fields.iter().find(|(own, _)| own == column) {
                    Some((_, Cell::Text(text))) => Some(text.as_str()),
                    _ => None,
                },
            );
        }
        found
    }

    /// In one line, those of most points first; `None` where all are resolved.
    pub fn line(&self, n_points: usize) -> Option<String> {
        let mut counts: Vec<&(String, usize)> = self.counts.iter().collect();
        counts.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
        let named = counts
            .iter()
            .take(MOST)
            .map(|(name, n)| format!("{} in {n}", words_of(name)));
        let mut text = named.collect::<Vec<_>>().join(", ");
        if text.is_empty() {
            return None;
        }
        if counts.len() > MOST {
            text += &format!(" and {} more", counts.len() - MOST);
        }
        let rows = match self.n_rows {
            1 => format!("1 of {n_points} points has"),
            n => format!("{n} of {n_points} points have"),
        };
        Some(format!(
            "{rows} figures that are not to be used (error bar too wide, or friction beyond that of lubricants): {text} (columns `unresolved`, `uncertain_figures`)"
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_by_the_number_of_points() {
        let mut found = UnresolvedFigures::default();
        assert_eq!(found.line(3), None);
        for texts in [
            ["film_minimum", "film_minimum friction_torque"],
            ["", "friction_torque"],
            ["", ""],
        ] {
            found.add(|column| Some(texts[usize::from(column == "uncertain_figures")]));
        }
        let line = found.line(3).expect("two");
        assert!(
            line.starts_with("2 of 3 points have figures that are not to be used (error bar too wide, or friction beyond that of lubricants): friction torque in 2, minimum film thickness in 1 ("),
            "{line}"
        );
    }
}
