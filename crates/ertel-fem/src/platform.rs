//! Differences between a computer and a browser (`wasm32-unknown-unknown`): threads, the clock, and the order in which bodies are eliminated.

#[cfg(not(target_arch = "wasm32"))]
mod native {
    use faer::Par;

    pub(crate) use crate::linear::ordering::nested_dissection as dissect;
    pub use std::time::Instant;

    /// All cores, for one large dense operation.
    pub fn all_cores() -> Par {
        Par::rayon(0)
    }
}

#[cfg(target_arch = "wasm32")]
mod browser {
    use std::sync::OnceLock;
    use std::time::Duration;

    use faer::Par;

    // The library of the other order reads a clock.
    pub(crate) use crate::linear::ordering::minimum_degree as dissect;

    static CLOCK: OnceLock<fn() -> f64> = OnceLock::new();

    /// Sets the clock, seconds from any origin; WebAssembly has none. Without it all times are 0; a second clock is ignored.
    pub fn set_clock(seconds: fn() -> f64) {
        let _ = CLOCK.set(seconds);
    }

    /// A moment of the clock that [`set_clock`] set.
    #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
    pub struct Instant(f64);

    impl Instant {
        /// This moment.
        pub fn now() -> Instant {
            Instant(CLOCK.get().map_or(0.0, |seconds| seconds()))
        }

        /// Time since this moment.
        pub fn elapsed(&self) -> Duration {
            Duration::try_from_secs_f64(Instant::now().0 - self.0).unwrap_or_default()
        }
    }

    /// One core: there are no threads.
    pub fn all_cores() -> Par {
        Par::Seq
    }
}

#[cfg(target_arch = "wasm32")]
use browser as own;
#[cfg(target_arch = "wasm32")]
pub use browser::set_clock;
#[cfg(not(target_arch = "wasm32"))]
use native as own;

pub use own::Instant;
pub(crate) use own::{all_cores, dissect};
