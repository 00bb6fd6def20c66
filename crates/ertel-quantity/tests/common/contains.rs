//! Comparison of texts in tests of several crates.

/// Checks that a text contains words.
#[track_caller]
pub fn contains(text: &str, words: &str) {
    assert!(text.contains(words), "`{words}` is not in\n{text}");
}
