//! Rolling bearings.
