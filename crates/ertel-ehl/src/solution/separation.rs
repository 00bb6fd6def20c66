//! Lubrication regime by the lambda ratio.

use serde::Serialize;

use crate::warning::{Warning, WarningKind};

/// Lambda ratio below which lubrication is called boundary lubrication. Zhu and Wang (2012, Proc. IMechE Part J 226, 1010-1022,
/// doi 10.1177/1350650112461867, abstract) find from measurements and deterministic computations that mixed lubrication begins at
/// 0.01 to 0.05: at 0.05 to 0.1 films still carry more than 10 to 15 % of the load. The older bound, 0.5 to 1, comes from stochastic
/// models that neglect the flattening of asperities. The upper end of the range is taken, since λ is based here on the minimum film
/// and there with the mean one.
pub const BOUNDARY_BELOW: f64 = 0.05;

/// Lambda ratio from which the film separates the surfaces: the common bound, the safe one. After Zhu and Wang (2012, abstract) little
/// or no contact of asperities is found from 0.6 to 1.2 on.
pub const FULL_FROM: f64 = 3.0;

/// How much the asperities carry, by the bounds [`BOUNDARY_BELOW`] and [`FULL_FROM`] of the lambda ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Separation {
    /// The asperities carry nearly all of the load.
    Boundary,
    /// Film and asperities share the load.
    Mixed,
    /// The film carries the load.
    Full,
}

impl Separation {
    /// Of a lambda ratio.
    pub fn of(lambda: f64) -> Separation {
        match lambda {
            l if l < BOUNDARY_BELOW => Separation::Boundary,
            l if l < FULL_FROM => Separation::Mixed,
            _ => Separation::Full,
        }
    }

    /// For reports.
    pub fn name(self) -> &'static str {
        match self {
            Separation::Boundary => "boundary lubrication",
            Separation::Mixed => "mixed lubrication",
            Separation::Full => "full film",
        }
    }
}

/// Says so if the film does not separate the surfaces; film thickness and composite rms roughness in m.
pub fn roughness_warning(film: &str, thickness: f64, roughness: f64) -> Option<Warning> {
    let lambda = thickness / roughness;
    match Separation::of(lambda) {
        Separation::Full => None,
        separation => {
            let text = format!(
                "{film} is {lambda:.2} times the roughness: {}; the surfaces are computed as smooth",
                separation.name()
            );
            Some(Warning::beyond(WarningKind::Roughness, -lambda, text))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3, the common bound; 0.05 after Zhu and Wang (2012). Gears at 0.7 run in mixed lubrication.
    #[test]
    fn surfaces_part_at_three_roughnesses() {
        for (nm, words) in [
            (31.0, None),
            (
                29.0,
                Some("the film is 2.90 times the roughness: mixed lubrication"),
            ),
            (7.0, Some("0.70 times the roughness: mixed")),
            (0.51, Some("0.05 times the roughness: mixed")),
            (0.49, Some("0.05 times the roughness: boundary")),
        ] {
            let warning = roughness_warning("the film", nm * 1e-9, 10e-9);
            match (&warning, words) {
                (Some(warning), Some(words)) => assert!(warning.contains(words), "{warning}"),
                _ => assert_eq!(warning.as_deref(), words, "{nm} nm"),
            }
        }
    }
}
