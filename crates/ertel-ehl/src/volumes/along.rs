//! Fourier transforms of real values along rows, padded with zeros.

use std::sync::Arc;

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

/// Transforms along rows, padded with zeros.
#[derive(Clone)]
pub struct Along {
    padded: usize,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
}

/// Rows and waves that a thread takes at a time.
pub(super) const ROWS: usize = 8;

/// The next length at least as large that transforms fast.
pub(super) fn smooth(least: usize) -> usize {
    let is_smooth = |n: &usize| {
        let mut n = *n;
        for p in [2, 3, 5] {
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        n == 1
    };
    (least..).find(is_smooth).unwrap_or(least)
}

/// Shares of the first and of the last value of a row at the nodes before and after it, from its ends on.
pub type Ramps = [Vec<f64>; 2];

impl Along {
    /// Over an even length.
    pub fn new(padded: usize) -> Along {
        let mut planner = RealFftPlanner::<f64>::new();
        Along {
            padded,
            forward: planner.plan_fft_forward(padded),
            backward: planner.plan_fft_inverse(padded),
        }
    }

    /// Waves of a row.
    pub fn waves(&self) -> usize {
        self.padded / 2 + 1
    }

    /// Spectra of rows of n values, one after the other.
    pub fn spectra(&self, values: &[f64], n: usize, ramps: &Ramps, spectra: &mut [Complex64]) {
        let room = || {
            (
                self.forward.make_input_vec(),
                self.forward.make_scratch_vec(),
            )
        };
        // One row is not worth another thread.
        if values.len() == n {
            self.spectrum(values, ramps, &mut room(), spectra);
            return;
        }
        (spectra.par_chunks_exact_mut(self.waves()))
            .zip(values.par_chunks_exact(n))
            .with_min_len(ROWS)
            .for_each_init(room, |room, (spectrum, values)| {
                self.spectrum(values, ramps, room, spectrum);
            });
    }

    /// Spectrum of a row.
    fn spectrum(
        &self,
        values: &[f64],
        [before, after]: &Ramps,
        (row, scratch): &mut (Vec<f64>, Vec<Complex64>),
        spectrum: &mut [Complex64],
    ) {
        if values.iter().all(|value| *value == 0.0) {
            spectrum.fill(Complex64::default());
            return;
        }
        let n = values.len();
        row[..n].copy_from_slice(values);
        row[n..].fill(0.0);
        for (m, share) in before.iter().enumerate() {
            row[self.padded - 1 - m] = share * values[0];
        }
        for (m, share) in after.iter().enumerate() {
            row[n + m] = share * values[n - 1];
        }
        (self.forward)
            .process_with_scratch(row, spectrum, scratch)
            .expect("lengths agree");
    }

    /// So many rows of n values, times the padded length, from the spectra that `fill` writes.
    pub fn values(
        &self,
        [n, rows]: [usize; 2],
        fill: impl Fn(usize, &mut [Complex64]) + Sync,
    ) -> Vec<f64> {
        let room = || {
            (
                self.backward.make_input_vec(),
                self.backward.make_output_vec(),
                self.backward.make_scratch_vec(),
            )
        };
        let last = self.waves() - 1;
        let each = |(spectrum, row, scratch): &mut (Vec<_>, Vec<_>, Vec<_>),
                    (j, values): (usize, &mut [f64])| {
            fill(j, spectrum);
            // Imaginary parts are rounding only.
            spectrum[0].im = 0.0;
            spectrum[last].im = 0.0;
            (self.backward)
                .process_with_scratch(spectrum, row, scratch)
                .expect("lengths agree");
            values.copy_from_slice(&row[..n]);
        };
        let mut values = vec![0.0; n * rows];
        if rows == 1 {
            each(&mut room(), (0, &mut values));
            return values;
        }
        (values.par_chunks_exact_mut(n))
            .enumerate()
            .with_min_len(ROWS)
            .for_each_init(room, each);
        values
    }

    /// Spectrum of a function of the offset that is even, by its values at 0, 1, …: real except for rounding.
    pub fn of_even(&self, values: &[f64]) -> Vec<Complex64> {
        self.of_row(|row| {
            row[..values.len()].copy_from_slice(values);
            for (place, value) in row.iter_mut().rev().zip(&values[1..]) {
                *place = *value;
            }
        })
    }

    /// Spectrum of the padded row that `fill` writes.
    pub fn of_row(&self, fill: impl FnOnce(&mut [f64])) -> Vec<Complex64> {
        let mut row = self.forward.make_input_vec();
        fill(&mut row);
        let mut spectrum = self.forward.make_output_vec();
        (self.forward.process(&mut row, &mut spectrum)).expect("lengths agree");
        spectrum
    }
}
