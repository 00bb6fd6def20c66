//! Equilibration of a sparse matrix: rows and columns scaled until their largest entries are about one.
//!
//! ```text
//!   A' = R A C,   A⁻¹b = C A'⁻¹ R b        R, C diagonal, powers of two
//! ```
//! Each sweep divides every entry by the roots of the largest in its row and in its column (Ruiz 2001, RAL-TR-2001-034).
//! Powers of two leave the digits of the entries alone. It brings matrices whose entries differ by more than single precision
//! spans, 1e±38, into its reach.

/// Factors of rows and columns.
#[derive(Clone, Debug)]
pub struct Equilibration {
    /// Diagonal of R.
    pub rows: Vec<f64>,
    /// Diagonal of C.
    pub columns: Vec<f64>,
}

/// Sweeps; each halves the logarithm of what is left of the differences.
const SWEEPS: usize = 12;

impl Equilibration {
    /// Factors for the `n` rows and columns of a matrix of entries (row, column) with `values`; equal places need
    /// not be added up. `None` where an entry is not finite.
    pub fn new(n: usize, entries: &[(u32, u32)], values: &[f64]) -> Option<Equilibration> {
        if values.iter().any(|v| !v.is_finite()) {
            return None;
        }
        // In binary logarithms: products of factors and entries could overflow.
        let sizes: Vec<f64> = values.iter().map(|v| v.abs().log2()).collect();
        let (mut rows, mut columns) = (vec![0.0; n], vec![0.0; n]);
        for _ in 0..SWEEPS {
            let mut largest = [vec![f64::NEG_INFINITY; n], vec![f64::NEG_INFINITY; n]];
            for ((i, j), size) in entries.iter().zip(&sizes) {
                let (i, j) = (*i as usize, *j as usize);
                let size = rows[i] + size + columns[j];
                largest[0][i] = largest[0][i].max(size);
                largest[1][j] = largest[1][j].max(size);
            }
            for (factors, largest) in [&mut rows, &mut columns].into_iter().zip(&largest) {
                for (factor, largest) in factors.iter_mut().zip(largest) {
                    if largest.is_finite() {
                        *factor -= 0.5 * largest;
                    }
                }
            }
        }
        let power = |v: Vec<f64>| v.into_iter().map(|v| v.round().exp2()).collect();
        Some(Equilibration {
            rows: power(rows),
            columns: power(columns),
        })
    }

    /// R A C.
    pub fn scale(&self, entries: &[(u32, u32)], values: &[f64]) -> Vec<f64> {
        let entries = entries.iter().zip(values);
        entries
            .map(|((i, j), v)| v * self.rows[*i as usize] * self.columns[*j as usize])
            .collect()
    }
}

/// The power of two by which a vector is divided to bring its largest entry to about one.
pub fn unit_of(v: &[f64]) -> f64 {
    let largest = v.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    match largest.is_normal() {
        true => largest.log2().round().exp2(),
        false => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows and columns in units that differ by sixty decades: the largest entries of all become one, within a
    /// factor of two, and zeros stay.
    #[test]
    fn brings_the_largest_entries_to_one() {
        let n = 6;
        let mut entries = Vec::new();
        let mut values = Vec::new();
        for i in 0..n as u32 {
            for j in 0..n as u32 {
                let unit = 10f64.powi(12 * i as i32 - 30) * 10f64.powi(-10 * j as i32);
                entries.push((i, j));
                values.push(
                    unit * (1.0 + f64::from(i * j)).sin() * f64::from(u8::from(i != 3 || j != 2)),
                );
            }
        }
        let scaled = Equilibration::new(n, &entries, &values)
            .unwrap()
            .scale(&entries, &values);
        for k in 0..n {
            let row = (0..n).fold(0.0_f64, |m, j| m.max(scaled[k * n + j].abs()));
            let column = (0..n).fold(0.0_f64, |m, i| m.max(scaled[i * n + k].abs()));
            assert!((0.5..=2.0).contains(&row) && (0.5..=2.0).contains(&column));
        }
        assert_eq!(scaled[3 * n + 2], 0.0);
        assert!(Equilibration::new(1, &[(0, 0)], &[f64::NAN]).is_none());
    }

    #[test]
    fn units_are_powers_of_two() {
        assert_eq!(unit_of(&[0.0, -4.1e0, 1.0]), 4.0);
        assert_eq!(unit_of(&[0.0]), 1.0);
    }
}
