//! Text of a file and of those whose values were put into it.

use std::ops::Range;
use std::sync::Arc;

/// The name and text of a file, kept for error messages.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub(crate) file: String,
    pub(crate) text: String,
    /// Files whose values were put into the document; their bytes count on from the end of the text, one byte apart.
    pub(crate) others: Vec<Arc<Source>>,
}

impl Source {
    /// The file that a span lies in, and where it lies there.
    pub(crate) fn resolve(&self, span: Range<usize>) -> (&Source, Range<usize>) {
        let mut offset = self.text.len() + 1;
        if span.start < offset {
            return (self, span);
        }
        for other in &self.others {
            let end = offset + other.text.len() + 1;
            if span.start < end {
                return (other, span.start - offset..span.end.max(offset) - offset);
            }
            offset = end;
        }
        (self, span)
    }

    /// The text at a span.
    pub(crate) fn slice(&self, span: Range<usize>) -> &str {
        let (source, span) = self.resolve(span);
        source.text.get(span).unwrap_or_default()
    }
}
