//! The film as an optical interferogram: an image, and a picture with axes.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use ertel_fem::element::Lagrange;
use rayon::prelude::*;

use super::layout::Layout;
use super::maps::window_map;
use super::sampling::value;
use crate::contact::Symmetry;
use crate::interference::Interferometer;
use crate::solution::Solution;
use ertel_plot::drawing::{Drawing, DrawingError, Raster};
use ertel_plot::frame::Frame;
use ertel_plot::png::encode;

/// Image pixels per unit of the picture.
const SCALE: f64 = 2.0;
/// Each pixel is the mean of this many points in each direction.
const POINTS: usize = 2;
/// Colour outside the computed area.
const NOTHING: [u8; 3] = [128; 3];

/// An interferogram: rows from the top, red, green and blue of each pixel.
pub struct Image {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
    /// Layout of the image.
    layout: Layout,
}

impl Image {
    /// The interferogram of a point contact; `density` is that of the oil at ambient pressure, kg/m³.
    pub fn new(solution: &Solution, light: &Interferometer, density: f64) -> Image {
        let window = window_map(solution);
        let [[x0, x1], [y0, y1]] = window;
        let layout = Layout::of(window);
        let [width, height] = layout.size().map(|s| (SCALE * s).round().max(1.0) as usize);
        // Points along x and y.
        let fine = match layout.is_turned {
            true => [POINTS * height, POINTS * width],
            false => [POINTS * width, POINTS * height],
        };
        let grid = Grid {
            n: fine,
            origin: [x0, y0],
            step: [(x1 - x0) / fine[0] as f64, (y1 - y0) / fine[1] as f64],
        };
        let film = film(solution, &grid);
        let ratio = match light.follows_density {
            true => density_ratio(solution, &grid, density),
            false => vec![1.0; fine[0] * fine[1]],
        };
        let rows: Vec<Vec<u8>> = (0..height)
            .into_par_iter()
            .map(|row| {
                let pixel = |column: usize| {
                    let points = (0..POINTS * POINTS).map(|k| {
                        let (right, down) =
                            (POINTS * column + k % POINTS, POINTS * row + k / POINTS);
                        // The first image row is the top: the inlet, or the last row of the grid.
                        let (i, j) = match layout.is_turned {
                            true => (down, right),
                            false => (right, fine[1] - 1 - down),
                        };
                        (film[j * fine[0] + i], ratio[j * fine[0] + i])
                    });
                    colour(light, &points.collect::<Vec<_>>())
                };
                (0..width).flat_map(pixel).collect()
            })
            .collect();
        Image {
            width,
            height,
            pixels: rows.concat(),
            layout,
        }
    }

    /// As a PNG file.
    ///
    /// # Errors
    /// Those of the encoder.
    pub fn png(&self) -> Result<Vec<u8>, DrawingError> {
        encode(self.width as u32, self.height as u32, &self.pixels, None)
    }

    /// The image, whose PNG file is `png`, with axes.
    pub fn drawing(&self, title: &str, png: &[u8]) -> Drawing {
        let [width, height] = self.layout.size();
        let frame = Frame {
            left: 62.0,
            top: 16.0,
            width,
            height,
        };
        let mut drawing = Drawing::new(
            frame.left + frame.width + 24.0,
            frame.top + height + 52.0,
            title,
        );
        let placed = self.layout.within(frame);
        drawing.image(
            [frame.left, frame.top, frame.width, frame.height],
            Raster {
                width: self.width,
                height: self.height,
                pixels: self.pixels.clone(),
                png: STANDARD.encode(png),
            },
        );
        placed.draw_motion(&mut drawing);
        placed.draw_axes(&mut drawing);
        drawing
    }
}

/// The sampling points of the film, in Hertz half-widths; the first is at the lower left.
struct Grid {
    n: [usize; 2],
    origin: [f64; 2],
    step: [f64; 2],
}

impl Grid {
    /// Index of the first point of an axis that is not below a value.
    fn from(&self, axis: usize, value: f64) -> usize {
        let place = ((value - self.origin[axis]) / self.step[axis] - 0.5).ceil();
        (place.max(0.0) as usize).min(self.n[axis])
    }

    fn at(&self, axis: usize, i: usize) -> f64 {
        self.origin[axis] + self.step[axis] * (i as f64 + 0.5)
    }

    /// Writes values at the points within a triangle; `value` takes the barycentric coordinates.
    fn fill(&self, corners: [[f64; 2]; 3], field: &mut [f64], value: impl Fn([f64; 3]) -> f64) {
        let [a, b, c] = corners;
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let area = u[0] * v[1] - u[1] * v[0];
        let range = |axis: usize| {
            let at = corners.map(|corner| corner[axis]);
            let low = at.into_iter().fold(f64::INFINITY, f64::min);
            let high = at.into_iter().fold(f64::NEG_INFINITY, f64::max);
            let margin = 1e-9 * (high - low);
            self.from(axis, low - margin)..self.from(axis, high + margin)
        };
        for j in range(1) {
            for i in range(0) {
                let p = [self.at(0, i) - a[0], self.at(1, j) - a[1]];
                let s = (p[0] * v[1] - p[1] * v[0]) / area;
                let t = (u[0] * p[1] - u[1] * p[0]) / area;
                let shares = [1.0 - s - t, s, t];
                // Points on edges belong to both sides; rounding cannot omit any.
                if shares.iter().all(|share| *share >= -1e-9) {
                    field[j * self.n[0] + i] = value(shares);
                }
            }
        }
    }

    /// The other half of a contact solved for y ≤ 0.
    fn mirror(&self, field: &mut [f64]) {
        let [nx, ny] = self.n;
        for j in ny / 2..ny {
            let (lower, upper) = field.split_at_mut(j * nx);
            upper[..nx].copy_from_slice(&lower[(ny - 1 - j) * nx..(ny - j) * nx]);
        }
    }
}

/// Film thickness at the points, m; NaN outside the film.
fn film(solution: &Solution, grid: &Grid) -> Vec<f64> {
    let elements = &solution.elements;
    let mut field = vec![f64::NAN; grid.n[0] * grid.n[1]];
    let lagrange = Lagrange::new(2, elements.film_thickness.order);
    for (element, cell) in elements.cells.iter().enumerate() {
        let corners =
            cell.map(|i| elements.vertices[i as usize].map(|x| x / solution.hertz.half_width));
        grid.fill(corners, &mut field, |[_, s, t]| {
            value(&lagrange, &elements.film_thickness, element, [s, t, 0.0])
        });
    }
    if solution.shape.symmetry == Symmetry::Half {
        grid.mirror(&mut field);
    }
    field
}

/// ρ/ρ₀ at the points.
fn density_ratio(solution: &Solution, grid: &Grid, ambient: f64) -> Vec<f64> {
    let surface = &solution.surface;
    let mut field = vec![1.0; grid.n[0] * grid.n[1]];
    for cell in &surface.cells {
        let corners =
            cell.map(|i| surface.points[i as usize].map(|x| x / solution.hertz.half_width));
        let ratios = cell.map(|i| surface.density[i as usize] / ambient);
        grid.fill(corners, &mut field, |shares| {
            (0..3).map(|k| shares[k] * ratios[k]).sum()
        });
    }
    if solution.shape.symmetry == Symmetry::Half {
        grid.mirror(&mut field);
    }
    field
}

/// Colour of a pixel with these films and density ratios: grey for a single wavelength.
fn colour(light: &Interferometer, points: &[(f64, f64)]) -> [u8; 3] {
    if points.iter().any(|(film, _)| !film.is_finite()) {
        return NOTHING;
    }
    let channel = |wavelength: f64| {
        let shares = points
            .iter()
            .map(|(film, ratio)| light.intensity(*film, *ratio, wavelength));
        encoded(shares.sum::<f64>() / points.len() as f64)
    };
    match light.wavelengths[..] {
        [red, green, blue] => [red, green, blue].map(channel),
        [wavelength, ..] => [channel(wavelength); 3],
        [] => NOTHING,
    }
}

/// Relative brightness as encoded for screens (sRGB, IEC 61966-2-1).
fn encoded(share: f64) -> u8 {
    let value = match share {
        s if s <= 0.003_130_8 => 12.92 * s,
        s => 1.055 * s.powf(1.0 / 2.4) - 0.055,
    };
    (255.0 * value).round().clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Middle grey of the standard: 0.2140 is encoded as 127.5/255 within rounding; the ends are unchanged.
    #[test]
    fn brightness_follows_the_standard() {
        assert_eq!([0.0, 0.2140, 1.0].map(encoded), [0, 127, 255]);
    }

    #[test]
    fn triangles_fill_a_grid_without_gaps() {
        let grid = Grid {
            n: [8, 8],
            origin: [-1.0, -1.0],
            step: [0.25, 0.25],
        };
        let mut field = vec![f64::NAN; 64];
        let corners = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 0.0], [1.0, 0.0]];
        // x + 10 y is linear.
        for [a, b, c] in [[0, 1, 2], [1, 3, 2]] {
            let own = [corners[a], corners[b], corners[c]];
            grid.fill(own, &mut field, |shares| {
                (0..3)
                    .map(|k| shares[k] * (own[k][0] + 10.0 * own[k][1]))
                    .sum()
            });
        }
        grid.mirror(&mut field);
        for j in 0..8 {
            for i in 0..8 {
                let expected = grid.at(0, i) - 10.0 * grid.at(1, j).abs();
                assert!((field[8 * j + i] - expected).abs() < 1e-12);
            }
        }
    }
}
