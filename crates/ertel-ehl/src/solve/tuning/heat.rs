//! Heat: warming steps, coupling with the film.

/// θ of the first time step of the temperatures, K: less than viscosities fall by e over, so that no layer feeds its own heating.
pub const FIRST_WARMING: f64 = 20.0;

/// The shortest time step, K.
pub const SHORTEST_WARMING: f64 = 1.0;

/// The longest, beyond which there is none, K.
pub const LONGEST_WARMING: f64 = 1e4;

/// Factor by which time steps are shortened or lengthened.
pub const WARMING_FACTOR: f64 = 2.0;

/// Times that half of a step of the temperatures is taken back.
pub const MOST_HALVINGS: usize = 8;

/// Krylov iterations that cost less than a new factorisation.
pub const SPARE_KRYLOV: usize = 12;

/// Residual, W/m² times half-widths squared, beyond which no matrix in single precision is factorised: the sun's surface radiates 6e7 W/m².
pub const BEYOND_BOUNDS: f64 = 1e30;

/// Steps for the temperatures in one round.
pub const MOST_STEPS: usize = 40;

/// Smallest ratio of one step for the temperatures to the one before that is trusted.
pub const LEAST_SHRINKING: f64 = 0.2;

/// Roughest tolerance of the film equations in a round of film and temperature.
pub const ROUGHEST: f64 = 1e-3;

/// Relative residual of the mass matrix's solution for the flow across the film.
pub const TOLERANCE: f64 = 1e-9;

/// Iterations of it at most: each shrinks the residual by 3 at the least (Wathen, IMA J. Numer. Anal. 7 (1987) 449-457).
pub const MOST_ITERATIONS: usize = 40;

/// Pressure over p_h above which an element belongs to the area under pressure.
pub const PRESSED: f64 = 1e-8;
