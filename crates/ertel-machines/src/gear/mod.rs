//! Pairs of cylindrical gears.
