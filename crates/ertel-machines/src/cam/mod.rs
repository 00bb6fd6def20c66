//! Cams and their followers.
