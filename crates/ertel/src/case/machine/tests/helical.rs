//! Helical gears against flanks in space: two involute helicoids whose shape and motion are found from their points alone.

use crate::near::near;
use approx::assert_relative_eq;

use super::bad::refused;
use super::{GEAR, check, read, row, with};

const HELICAL: &str = include_str!("data/helical_gear.toml");

type Vector = [f64; 3];

fn sum<const N: usize>(parts: [(f64, Vector); N]) -> Vector {
    [0, 1, 2].map(|k| parts.iter().map(|(c, v)| c * v[k]).sum())
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

fn unit(a: Vector) -> Vector {
    sum([(1.0 / dot(a, a).sqrt(), a)])
}

/// An involute helicoid: a string unwound from a base cylinder in every section z, turned with z.
struct Flank {
    /// x of the axis, along z through y = 0.
    axis: f64,
    base_radius: f64,
    /// Angle at which the string leaves the cylinder at the contact in z = 0.
    angle: f64,
    /// How much string is off there.
    unwound: f64,
    /// Turn with z.
    twist: f64,
    /// About the axis, rad/s.
    omega: f64,
}

impl Flank {
    /// The point with u radians of string off, in the section z.
    fn point(&self, [u, z]: [f64; 2]) -> Vector {
        let r = self.base_radius;
        let angle = self.angle - self.unwound / r + self.twist * z + u;
        let (s, c) = angle.sin_cos();
        [self.axis + r * (c + u * s), r * (s - u * c), z]
    }

    /// First and second differences at the contact: by u, by z, and uu, uz, zz.
    fn differences(&self) -> ([Vector; 2], [Vector; 3]) {
        let at = [self.unwound / self.base_radius, 0.0];
        let step = [1e-4, 1e-5];
        let p = |i: f64, j: f64| self.point([at[0] + i * step[0], at[1] + j * step[1]]);
        let [h, k] = step;
        let first = [
            sum([(0.5 / h, p(1.0, 0.0)), (-0.5 / h, p(-1.0, 0.0))]),
            sum([(0.5 / k, p(0.0, 1.0)), (-0.5 / k, p(0.0, -1.0))]),
        ];
        let middle = p(0.0, 0.0);
        let second = |c: f64, a: Vector, b: Vector| sum([(c, a), (-2.0 * c, middle), (c, b)]);
        let q = 0.25 / (h * k);
        let mixed = sum([
            (q, p(1.0, 1.0)),
            (q, p(-1.0, -1.0)),
            (-q, p(1.0, -1.0)),
            (-q, p(-1.0, 1.0)),
        ]);
        let uu = second(1.0 / (h * h), p(1.0, 0.0), p(-1.0, 0.0));
        let zz = second(1.0 / (k * k), p(0.0, 1.0), p(0.0, -1.0));
        (first, [uu, mixed, zz])
    }

    fn normal(&self) -> Vector {
        let ([u, z], _) = self.differences();
        unit(cross(u, z))
    }

    /// Curvature of the normal section along a tangent, in the direction of `normal`.
    fn curvature(&self, tangent: Vector, normal: Vector) -> f64 {
        let ([u, z], [uu, uz, zz]) = self.differences();
        // tangent = a u + b z by least squares
        let (e, f, g) = (dot(u, u), dot(u, z), dot(z, z));
        let (p, q) = (dot(tangent, u), dot(tangent, z));
        let det = e * g - f * f;
        let (a, b) = ((g * p - f * q) / det, (e * q - f * p) / det);
        a * a * dot(uu, normal) + 2.0 * a * b * dot(uz, normal) + b * b * dot(zz, normal)
    }

    fn velocity(&self, at: Vector) -> Vector {
        cross([0.0, 0.0, self.omega], [at[0] - self.axis, at[1], at[2]])
    }
}

/// Angles of the pair above by the textbook's formulas: β, α_t and β_b, the last by sin β_b = sin β cos α_n.
fn angles(helix: f64) -> [f64; 3] {
    let (beta, alpha) = (helix.to_radians(), 20.0_f64.to_radians());
    let transverse = (alpha.tan() / beta.cos()).atan();
    [beta, transverse, (beta.sin() * alpha.cos()).asin()]
}

/// The pair touching at s on the line of action, which leaves the base circle of the pinion at α_t below the pitch point's side.
fn flanks(helix: f64, s: f64) -> [Flank; 2] {
    let [beta, alpha, beta_b] = angles(helix);
    let r = [20.0, 40.0].map(|z| 0.5 * 4e-3 / beta.cos() * z);
    let omega = 1500.0 * std::f64::consts::PI / 30.0;
    let flank = |k: usize, axis, angle, side: f64, unwound| Flank {
        axis,
        base_radius: r[k] * alpha.cos(),
        angle,
        unwound,
        // Wheels on parallel axes have opposite hands.
        twist: side * beta_b.tan() / (r[k] * alpha.cos()),
        omega: -side * omega * r[0] / r[k],
    };
    [
        flank(0, 0.0, alpha, 1.0, r[0] * alpha.sin() + s),
        flank(
            1,
            r[0] + r[1],
            std::f64::consts::PI + alpha,
            -1.0,
            r[1] * alpha.sin() - s,
        ),
    ]
}

/// The flanks meet with one normal, along a line in which neither is curved; across it their curvatures are those of the case, and so are
/// the speeds. Along the line both run alike.
#[test]
fn flanks_in_space() {
    for (helix, s) in [(25.0, 5e-3), (25.0, -4e-3), (10.0, 0.0), (40.0, 2e-3)] {
        let text = HELICAL
            .replace("25 deg", &format!("{helix} deg"))
            .replace("\"5 mm\"", &format!("\"{} mm\"", 1e3 * s));
        let case = read(&text).unwrap();
        assert!(case.contact.kind.is_line());
        let pair = flanks(helix, s);
        let places = [0, 1].map(|k: usize| {
            let flank: &Flank = &pair[k];
            flank.point([flank.unwound / flank.base_radius, 0.0])
        });
        for k in 0..3 {
            assert_relative_eq!(places[0][k], places[1][k], epsilon = 1e-12);
        }
        let normal = pair[0].normal();
        let other = pair[1].normal();
        assert_relative_eq!(dot(normal, other).abs(), 1.0, epsilon = 1e-6);

        let [_, alpha, beta_b] = angles(helix);
        let action = [alpha.sin(), -alpha.cos(), 0.0];
        // In the plane of action, at β_b to the axes.
        let line = sum([(beta_b.cos(), [0.0, 0.0, 1.0]), (-beta_b.sin(), action)]);
        let across = unit(cross(normal, line));
        let mut bend = 0.0;
        for flank in &pair {
            assert_relative_eq!(dot(flank.normal(), line), 0.0, epsilon = 1e-6);
            assert!(flank.curvature(line, normal).abs() < 1e-2, "1/m");
            // The bodies lie on either side of the common tangent plane.
            bend += flank.curvature(across, normal).abs();
        }
        assert!(pair[0].curvature(across, normal) * pair[1].curvature(across, normal) < 0.0);
        assert_relative_eq!(1.0 / bend, case.contact.radius, max_relative = 1e-5);

        let velocities = [0, 1].map(|k: usize| pair[k].velocity(places[0]));
        let [pinion, wheel] = velocities.map(|v| dot(v, across).abs());
        let motion = &case.motion;
        near(motion.entrainment_speed, 0.5 * (pinion + wheel), 1e-6);
        let ratio = (pinion - wheel) / (0.5 * (pinion + wheel));
        assert_relative_eq!(motion.slide_to_roll_ratio, ratio, epsilon = 1e-6);
        near(dot(velocities[0], line), dot(velocities[1], line), 1e-9);
        near(dot(velocities[0], normal), dot(velocities[1], normal), 1e-6);
        let along = row(&case, "axial speed").split(' ').next().unwrap();
        let along: f64 = along.parse().unwrap();
        assert_relative_eq!(dot(velocities[0], line).abs(), along, max_relative = 1e-5);
    }
}

/// The zone of action is a rectangle of path and face width, which contact lines at β_b pass one base pitch after the other. Their lengths
/// in it, clipped and counted at many instants, press with w against the torque, on the arm r_b cos β_b.
#[test]
fn contact_lines_carry_the_torque() {
    // Overlaps of 1.345, and of 0.336 on a narrow face.
    for width in [0.04, 0.01] {
        let text = HELICAL.replace("40 mm", &format!("{} mm", 1e3 * width));
        let case = read(&text).unwrap();
        let [beta, alpha, beta_b] = angles(25.0);
        let r = [20.0, 40.0].map(|z| 0.5 * 4e-3 / beta.cos() * z);
        let reach =
            |r: f64| ((r + 4e-3).powi(2) - (r * alpha.cos()).powi(2)).sqrt() - r * alpha.sin();
        let path = reach(r[0]) + reach(r[1]);
        let pitch = std::f64::consts::PI * 4e-3 / beta.cos() * alpha.cos();
        assert_relative_eq!(
            row(&case, "transverse contact ratio")
                .parse::<f64>()
                .unwrap(),
            path / pitch,
            max_relative = 1e-5
        );
        let (n_instants, n_steps) = (200, 500);
        let mut mean = 0.0;
        for instant in 0..n_instants {
            for line in -20..20 {
                let start = (f64::from(line) + f64::from(instant) / f64::from(n_instants)) * pitch;
                for step in 0..n_steps {
                    let z = (f64::from(step) + 0.5) / f64::from(n_steps) * width;
                    if (0.0..path).contains(&(start + z * beta_b.tan())) {
                        mean += width / f64::from(n_steps) / beta_b.cos();
                    }
                }
            }
        }
        mean /= f64::from(n_instants);
        let arm = r[0] * alpha.cos() * beta_b.cos();
        assert_relative_eq!(case.contact.load * mean * arm, 100.0, max_relative = 5e-3);
        let overlap = width * beta.sin() / (std::f64::consts::PI * 4e-3);
        assert_relative_eq!(
            row(&case, "overlap ratio").parse::<f64>().unwrap(),
            overlap,
            max_relative = 1e-5
        );
    }
    // A given share: X T_1/(r_b1 b), 0.5 · 100/(44.135117 mm · cos 21.8802° · 40 mm).
    let case = with(HELICAL, "position", "load_share = 0.5\nposition").unwrap();
    let [beta, alpha, _] = angles(25.0);
    let base = 0.04 / beta.cos() * alpha.cos();
    near(case.contact.load, 0.5 * 100.0 / base / 0.04, 1e-12);
}

/// Without a helix the pair is the spur gear, to the last bit; and without a share of the load, the mean of the pairs in mesh carries.
#[test]
fn straight_teeth_are_a_spur_gear() {
    let alike = |spur: &str| {
        let helical = spur
            .replace("spur-gear", "helical-gear\"\nhelix_angle = \"0 deg")
            .replace("module", "normal_module")
            .replace("pressure_angle", "normal_pressure_angle");
        let [a, b] = [spur, &helical].map(|text| read(text).unwrap());
        assert_eq!(a.contact, b.contact);
        (helical, a, b)
    };
    for place in ["pitch point", "5 mm", "-3.3 mm"] {
        let spur = GEAR.replace("pitch point", place);
        let (helical, a, b) = alike(&spur);
        assert_eq!(a.motion, b.motion);
        let mean = with(&helical, "load_share = 1\n", "").unwrap();
        near(mean.contact.load * 1.635_2, a.contact.load, 1e-4);
    }
    for angle in [14.5, 17.3, 22.5, 25.0] {
        let spur = GEAR.replace("20 deg", &format!("{angle} deg"));
        alike(&spur);
    }
}

/// α_t = atan(tan 20°/cos 25°) = 21.8802°; r_1 = 40 mm/cos 25° = 44.135117 mm; β_b = asin(sin 25° cos 20°) = 23.3990°;
/// R_1 = r_1 sin α_t + 5 = 21.447730 mm, R_2 = 27.895461 mm, R = 12.125206/cos β_b = 13.211668 mm; ε_α = 1.431921, and w is
/// 100/(44.135117 mm · cos α_t · 40 mm · ε_α) = 42,629.00 N/m; u_1 = 157.0796 · 0.02144773 = 3.369002 m/s, u_2 = 2.190904 m/s.
#[test]
fn by_hand() {
    let case = read(HELICAL).unwrap();
    let (pinion, wheel) = (3.369_002, 2.190_904);
    let mean = 0.5 * (pinion + wheel);
    check(&case, 13.211_668, 42_629.0, mean, (pinion - wheel) / mean);
    assert!(row(&case, "transverse pressure").starts_with("21.880"));
    assert!(row(&case, "base helix").starts_with("23.399"));
}

#[test]
fn bad_helical_gears_are_refused() {
    for (old, new, words) in [
        (
            "\"5 mm\"",
            "\"20 mm\"",
            &["`position` must be from -", "machine.toml:11"][..],
        ),
        (
            "helix_angle = \"25 deg\"\n",
            "",
            &["missing key `helix_angle`"],
        ),
        ("25 deg", "60 deg", &["helix_angle", "between 0"]),
        (
            "normal_module",
            "module",
            &["unknown key `module`", "did you mean `normal_module`?"],
        ),
        (
            "position",
            "addendum_pinion = \"1 mm\"\naddendum_wheel = \"1 mm\"\nposition",
            &["do not take over", "longer addenda"],
        ),
    ] {
        let text = match new.starts_with("addendum") {
            true => HELICAL.replace("5 mm", "1 mm"),
            false => HELICAL.to_owned(),
        };
        refused(&text, old, new, words);
    }
}
