//! Which contacts finite volumes solve.

/// Properties of a contact that decide whether finite volumes solve it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct About {
    /// The bodies are half-spaces.
    pub has_half_spaces: bool,
    /// Properties of its heat, where its temperature varies.
    pub heat: Option<HeatAbout>,
}

/// Properties of the heat of a contact that decide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HeatAbout {
    /// A roller whose surfaces slide along its axis or spin.
    pub slides_along_roller: bool,
    /// A body spins so fast that the point about which it turns lies near the contact.
    pub turns_nearby: bool,
    /// Conductivity or heat capacity of a body change with its temperature.
    pub bodies_vary: bool,
    /// Temperatures within the bodies are asked for.
    pub asks_for_bodies: bool,
}

/// Why finite volumes do not solve a contact, in words that follow "finite volumes"; `None` where they do.
pub fn why_not(about: &About) -> Option<&'static str> {
    let heat = about.heat.unwrap_or_default();
    let reasons = [
        (
            !about.has_half_spaces,
            "need half-spaces, not finite-element bodies",
        ),
        (
            heat.slides_along_roller,
            "do not solve for the heat of rollers whose surfaces slide along the axis or spin",
        ),
        (
            heat.turns_nearby,
            "do not solve for the heat of a body whose spin moves the edge of the contact at more than half of its speed at the centre",
        ),
        (
            heat.bodies_vary,
            "do not solve for the heat of bodies whose conductivity or heat capacity changes with temperature",
        ),
        (
            heat.asks_for_bodies,
            "find no temperatures within the bodies ([thermal] field)",
        ),
    ];
    reasons
        .into_iter()
        .find(|(applies, _)| *applies)
        .map(|(_, reason)| reason)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Heat is no reason in itself, but what finite volumes cannot do with it is.
    #[test]
    fn supported_heat() {
        let about = |heat| About {
            has_half_spaces: true,
            heat,
        };
        assert_eq!(why_not(&about(None)), None);
        assert_eq!(why_not(&about(Some(HeatAbout::default()))), None);
        let roller = HeatAbout {
            slides_along_roller: true,
            ..HeatAbout::default()
        };
        assert!(why_not(&about(Some(roller))).is_some_and(|reason| reason.contains("roller")));
        let turns = HeatAbout {
            turns_nearby: true,
            ..HeatAbout::default()
        };
        assert!(why_not(&about(Some(turns))).is_some_and(|reason| reason.contains("spin")));
    }
}
