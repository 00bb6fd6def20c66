//! Which contacts finite volumes solve.

/// What of a contact decides whether finite volumes solve it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct About {
    /// All is the same along y.
    pub is_line: bool,
    /// The bodies are half-spaces.
    pub has_half_spaces: bool,
    /// Its temperature varies.
    pub heats: bool,
}

/// Why finite volumes do not solve a contact, in words that follow "finite volumes"; `None` where they do.
pub fn why_not(about: &About) -> Option<&'static str> {
    let reasons = [
        (about.is_line, "do not solve line contacts"),
        (
            !about.has_half_spaces,
            "need half-spaces, no finite-element bodies",
        ),
        (
            about.heats,
            "solve isothermal contacts alone ([solver] isothermal = true leaves the heat out)",
        ),
    ];
    reasons
        .into_iter()
        .find(|(applies, _)| *applies)
        .map(|(_, reason)| reason)
}
