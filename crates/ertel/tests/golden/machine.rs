//! Properties of a machine that decide the last bits of a result.

use std::fmt;
use std::hash::Hasher;

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use xxhash_rust::xxh3::Xxh3Default;

use super::compare::Mode;
use super::record::{MACHINE, Record};

/// Properties that decide the last bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Machine {
    /// Architecture, and the vector instructions by which kernels are chosen (faer, gemm, nano-gemm, pulp, matrixmultiply).
    kernels: String,
    /// Hash of products of matrices, in which the sizes of caches show by those of blocks.
    products: String,
    /// Hash of values of the system's mathematical functions.
    functions: String,
}

impl Machine {
    /// The one that this program runs on.
    pub fn this() -> Machine {
        Machine {
            kernels: kernels(),
            products: products(),
            functions: functions(),
        }
    }

    /// Writes it into a record.
    pub fn note(&self, record: &mut Record) {
        for (key, value) in self.parts() {
            record.put(MACHINE, key, value);
        }
    }

    /// How to compare with a record, and the machine that it comes from.
    pub fn mode(&self, record: &Record) -> (Mode, String) {
        let part = |key| record.get(MACHINE, key).unwrap_or("unknown").to_owned();
        let other = Machine {
            kernels: part("kernels"),
            products: part("products"),
            functions: part("functions"),
        };
        let mode = match other == *self {
            true => Mode::Exact,
            false => Mode::WithinBars,
        };
        (mode, other.to_string())
    }

    fn parts(&self) -> [(&'static str, &str); 3] {
        [
            ("kernels", &self.kernels),
            ("products", &self.products),
            ("functions", &self.functions),
        ]
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Machine {
            kernels,
            products,
            functions,
        } = self;
        write!(f, "{kernels}, products {products}, functions {functions}")
    }
}

/// Architecture and vector instructions.
fn kernels() -> String {
    let mut text = std::env::consts::ARCH.to_owned();
    #[cfg(target_arch = "x86_64")]
    for (name, found) in [
        ("avx2", std::arch::is_x86_feature_detected!("avx2")),
        ("fma", std::arch::is_x86_feature_detected!("fma")),
        ("avx512f", std::arch::is_x86_feature_detected!("avx512f")),
    ] {
        if found {
            text.push('+');
            text.push_str(name);
        }
    }
    text
}

/// Numbers without a pattern in [−1, 1].
fn scattered(n: usize) -> impl Iterator<Item = f64> {
    // Steps of the golden section.
    (0..n).map(|i| 2.0 * (i as f64 * 0.618_033_988_749_894_9).fract() - 1.0)
}

/// Products of matrices in both precisions, with sums long enough to be cut into blocks.
fn products() -> String {
    const ROWS: usize = 150;
    const TERMS: usize = 1500;
    const COLUMNS: usize = 90;
    let numbers: Vec<f64> = scattered(ROWS * TERMS).collect();
    let mut hash = Xxh3Default::new();
    let a = Mat::from_fn(ROWS, TERMS, |i, j| numbers[i * TERMS + j]);
    let b = Mat::from_fn(TERMS, COLUMNS, |i, j| numbers[j * TERMS + i]);
    let mut c = Mat::zeros(ROWS, COLUMNS);
    matmul(&mut c, Accum::Replace, &a, &b, 1.0, Par::Seq);
    c.col_iter().for_each(|column| {
        column
            .iter()
            .for_each(|v: &f64| hash.write_u64(v.to_bits()))
    });
    let a = Mat::from_fn(ROWS, TERMS, |i, j| numbers[i * TERMS + j] as f32);
    let b = Mat::from_fn(TERMS, COLUMNS, |i, j| numbers[j * TERMS + i] as f32);
    let mut c = Mat::zeros(ROWS, COLUMNS);
    matmul(&mut c, Accum::Replace, &a, &b, 1.0, Par::Seq);
    c.col_iter().for_each(|column| {
        column
            .iter()
            .for_each(|v: &f32| hash.write_u32(v.to_bits()))
    });
    format!("{:016x}", hash.finish())
}

/// The functions that the system's library computes.
fn functions() -> String {
    const FUNCTIONS: [fn(f64) -> f64; 16] = [
        f64::exp,
        f64::exp_m1,
        |x| x.abs().ln(),
        |x| x.abs().ln_1p(),
        |x| x.abs().log10(),
        |x| x.abs().powf(0.68),
        f64::sin,
        f64::cos,
        f64::tan,
        f64::atan,
        f64::sinh,
        f64::tanh,
        f64::asinh,
        f64::cbrt,
        |x| x.hypot(0.7),
        |x| x.atan2(0.3),
    ];
    let mut hash = Xxh3Default::new();
    for function in FUNCTIONS {
        for x in scattered(2000) {
            hash.write_u64(function(20.0 * x).to_bits());
        }
    }
    format!("{:016x}", hash.finish())
}
