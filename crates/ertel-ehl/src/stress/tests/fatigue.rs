//! Shear over a passage and what it means for fatigue, against values computed by other means.

use super::super::depths::crest;
use super::super::{
    Criterion, Depths, HertzLoad, Level, LineLoad, Load, Residual, Response, Stress, Volume,
    dang_van, fatemi_socie, lundberg_palmgren,
};
use super::{hertz_line, passage, worst};

/// Ratio of the semi-axes, t, τ_0/p_0, z_0 and x_0 over the minor one: the formulas of Lundberg and Palmgren (1947), met by a search in the exact field.
#[rustfmt::skip]
const ROLLING: [[f64; 5]; 10] = [
    [0.0, 1.0, 0.25, 0.5, 0.866025392],
    [0.02, 1.0001999, 0.24997501, 0.49985012, 0.865996589],
    [0.1, 1.0049389, 0.249381147, 0.496323052, 0.86532361],
    [0.15, 1.01094899, 0.248624246, 0.49192079, 0.864498657],
    [0.3, 1.04077558, 0.244816787, 0.471173889, 0.860841103],
    [0.4, 1.06809273, 0.241276848, 0.453633771, 0.858055162],
    [0.6, 1.13324719, 0.232758637, 0.416540453, 0.853144879],
    [0.7, 1.16888121, 0.228114744, 0.398634369, 0.851280769],
    [0.9, 1.24301195, 0.218613013, 0.365725729, 0.848781712],
    [1.0, 1.28077641, 0.213890902, 0.350864113, 0.848070476],
];
/// Line, closed form: µ, largest half range of σ_xz below 0.05 a, its depth, mean of its extremes there, largest |σ_xz| below the surface, limit p_0/k of shakedown
/// (Johnson 1985, 9.1).
#[rustfmt::skip]
const LINE: [[f64; 6]; 7] = [
    [0.0, 0.249999995, 0.500000135, 0.0, 0.25, 4.0],
    [0.02, 0.249999995, 0.500000131, -0.00598076111, 0.256009024, 3.90611231],
    [0.08, 0.249999995, 0.500000077, -0.0239230456, 0.274354266, 3.64492236],
    [0.1, 0.249999995, 0.500000044, -0.0299038079, 0.280567188, 3.56420865],
    [0.2, 0.249999995, 0.499999768, -0.0598076305, 0.312269252, 3.2023646],
    [0.25, 0.249999995, 0.499999557, -0.0747595523, 0.328471597, 3.04440326],
    [0.4, 0.249999995, 0.499998605, -0.119615386, 0.378240244, 2.5],
];
/// b/a, µ, largest half range of σ_xz below 0.1 a and its depth, by a periodic integral of elementary functions; to 1e-5, the depth to 5e-4.
#[rustfmt::skip]
const ELLIPSE: [[f64; 4]; 8] = [
    [1.0, 0.0, 0.213891237, 0.350902127],
    [1.0, 0.05, 0.213902033, 0.350774925],
    [1.0, 0.2, 0.214067288, 0.348960556],
    [2.0, 0.0, 0.237194602, 0.435085014],
    [2.0, 0.1, 0.237202001, 0.434838875],
    [2.0, 0.2, 0.237223455, 0.434101335],
    [4.0, 0.05, 0.246315387, 0.479059383],
    [4.0, 0.1, 0.246315901, 0.478993175],
];
/// Line, ν = 0.3: µ, z/a, radius of the smallest sphere, largest shear, index for α = 0.2 and 0.4; by convex optimisation, to 4 digits.
#[rustfmt::skip]
const DANG_VAN: [[f64; 6]; 14] = [
    [0.0, 0.1, 0.234070627, 0.164694119, 0.117857036, 0.0801667636],
    [0.0, 0.3, 0.333976894, 0.236156981, 0.177905148, 0.130177682],
    [0.0, 0.786, 0.334159023, 0.236286093, 0.186787305, 0.148144408],
    [0.0, 1.2, 0.28304619, 0.200143853, 0.161283087, 0.132113106],
    [0.05, 0.3, 0.334895162, 0.236804353, 0.179957842, 0.133942909],
    [0.05, 0.5, 0.353825424, 0.250192271, 0.194834675, 0.150675689],
    [0.05, 1.2, 0.283128538, 0.200201771, 0.161917434, 0.133210813],
    [0.1, 0.1, 0.252628453, 0.17863221, 0.134250897, 0.0996008956],
    [0.1, 0.5, 0.354704349, 0.250803846, 0.196614124, 0.153804843],
    [0.1, 0.786, 0.334622696, 0.236608848, 0.189179729, 0.152500222],
    [0.2, 0.1, 0.301050039, 0.212847591, 0.171686661, 0.143096768],
    [0.2, 0.3, 0.348179718, 0.246147068, 0.194047511, 0.154045559],
    [0.2, 0.786, 0.336025105, 0.237580516, 0.191490356, 0.156433745],
    [0.2, 1.2, 0.284350468, 0.201056741, 0.163964981, 0.136540716],
];
/// Line, ν = 0.3: criterion (0: half range of σ_xz, 1: largest shear), µ, τ_u/p_0, relative lives with depths from 0.1 a and from 0.3 a; by quadrature.
#[rustfmt::skip]
const LIVES: [[f64; 5]; 36] = [
    [0.0, 0.0, 0.0, 1.0, 1.0],
    [0.0, 0.0, 0.02, 2.29064153, 2.19306109],
    [0.0, 0.0, 0.05, 9.16638596, 8.1950952],
    [0.0, 0.0, 0.075, 34.3395363, 28.9468495],
    [0.0, 0.0, 0.125, 938.420779, 704.264192],
    [0.0, 0.0, 0.15, 8305.415, 5908.13958],
    [1.0, 0.0, 0.0, 1.0, 1.0],
    [1.0, 0.0, 0.02, 2.01589885, 1.96130753],
    [1.0, 0.0, 0.05, 6.33391844, 5.94108489],
    [1.0, 0.0, 0.075, 18.2235726, 16.6720443],
    [1.0, 0.0, 0.125, 220.899828, 195.745935],
    [1.0, 0.0, 0.15, 1006.21667, 885.186619],
    [0.0, 0.05, 0.0, 0.999440095, 0.999831092],
    [0.0, 0.05, 0.02, 2.28936221, 2.19266968],
    [0.0, 0.05, 0.05, 9.16135802, 8.19349262],
    [0.0, 0.05, 0.075, 34.3212448, 28.9406822],
    [0.0, 0.05, 0.125, 937.963767, 704.079946],
    [0.0, 0.05, 0.15, 8301.57293, 5906.39188],
    [1.0, 0.05, 0.0, 0.761062395, 0.845595794],
    [1.0, 0.05, 0.02, 1.5379277, 1.64649367],
    [1.0, 0.05, 0.05, 4.86148747, 4.93038323],
    [1.0, 0.05, 0.075, 14.0819577, 13.6979138],
    [1.0, 0.05, 0.125, 173.074926, 157.661293],
    [1.0, 0.05, 0.15, 791.888111, 706.608349],
    [0.0, 0.1, 0.0, 0.997753038, 0.999323965],
    [0.0, 0.1, 0.02, 2.28550768, 2.19149446],
    [0.0, 0.1, 0.05, 9.14621104, 8.18868079],
    [0.0, 0.1, 0.075, 34.2661507, 28.9221639],
    [0.0, 0.1, 0.125, 936.588247, 703.526665],
    [0.0, 0.1, 0.15, 8290.01584, 5901.1431],
    [1.0, 0.1, 0.0, 0.505254185, 0.658454238],
    [1.0, 0.1, 0.02, 1.01154341, 1.26295777],
    [1.0, 0.1, 0.05, 3.15804185, 3.6850271],
    [1.0, 0.1, 0.075, 9.06610182, 9.98123134],
    [1.0, 0.1, 0.125, 109.375185, 107.687563],
    [1.0, 0.1, 0.15, 492.627674, 462.866156],
];

/// No residual stress.
const NONE: Stress = Stress([0.0; 6]);

fn dry(ratio: Option<f64>, friction: f64) -> Load {
    Load::Hertz(HertzLoad {
        half_width: 1.0,
        half_width_y: ratio,
        pressure: 1.0,
        friction,
        poisson: 0.3,
    })
}

/// The largest half range below a depth, its depth, and the level there.
fn half_range(levels: &[Level], depths: &Depths, from: f64) -> (f64, f64, usize) {
    let (value, t) = depths.largest(from, |i| levels[i].half_range.value);
    (value, depths.at(t), t.round() as usize)
}

#[test]
fn formulas_of_lundberg_and_palmgren() {
    let deviation = worst(ROLLING.iter().flat_map(|[ratio, _, shear, depth, _]| {
        let found = lundberg_palmgren(*ratio);
        [found[0] - shear, found[1] - depth]
    }));
    println!("Lundberg and Palmgren: {deviation:.1e}");
    assert!(deviation < 1e-8);
    // The exact field has them, too.
    let depths = Depths::new(1.0, 120);
    for [ratio, _, shear, depth, _] in [ROLLING[0], ROLLING[5], ROLLING[9]] {
        let load = dry((ratio > 0.0).then(|| 1.0 / ratio), 0.0);
        let levels = load.levels(&passage(1.5, 300), &Response::bare(0.3, &depths));
        let found = half_range(&levels, &depths, 0.1);
        assert!(
            (found.0 - shear).abs() < 1e-5 && (found.1 - depth).abs() < 5e-4,
            "{found:?}"
        );
    }
}

/// Without friction the path of the deviator under a circle fits into a sphere as wide as the range of σ_xz: p_0/k = 4.68, Johnson (1985, section 9.2) has 4.7;
/// under a line 4.0.
#[test]
fn shakedown_by_the_smallest_sphere() {
    let depths = Depths::new(1.0, 60);
    for (ratio, known) in [(Some(1.0), 0.213_890_9), (None, 0.25)] {
        let levels = dry(ratio, 0.0).levels(&passage(3.0, 300), &Response::bare(0.3, &depths));
        let radius = |level: &Level| dang_van(level.middle(), NONE, 0.3).radius / 2.0_f64.sqrt();
        let largest = levels.iter().map(radius).fold(0.0, f64::max);
        assert!((largest / known - 1.0).abs() < 3e-3, "{ratio:?} {largest}");
    }
}

#[test]
fn orthogonal_shear_of_lines_with_traction() {
    let depths = Depths::new(2.0, 120);
    let mut deviations = [0.0_f64; 2];
    for [mu, amplitude, depth, mean, below, limit] in
        LINE.map(|r| [r[0], r[1], r[2], r[3], r[4], r[5]])
    {
        let levels =
            Load::Line(hertz_line(mu)).levels(&passage(2.0, 800), &Response::bare(0.3, &depths));
        let (value, at, t) = half_range(&levels, &depths, 0.05);
        let (largest, _) = crest(levels.len() - 1, |i| levels[i + 1].middle_orthogonal);
        let whole = (levels.iter()).fold(largest, |m, level| m.max(level.middle_orthogonal));
        deviations[0] = worst([
            deviations[0],
            value - amplitude,
            (1.0 / whole - limit) / limit,
            // Not where the largest value below is that next to the surface.
            if below > mu { largest - below } else { 0.0 },
        ]);
        deviations[1] = worst([
            deviations[1],
            at - depth,
            levels[t].rows[0].mean.abs() - mean.abs(),
        ]);
    }
    println!(
        "orthogonal shear of lines: {:.1e}, depth {:.1e}",
        deviations[0], deviations[1]
    );
    assert!(deviations[0] < 1e-4 && deviations[1] < 2e-3);
}

#[test]
fn orthogonal_shear_of_ellipses_with_traction() {
    let depths = Depths::new(1.0, 120);
    let mut deviations = [0.0_f64; 2];
    for [ratio, mu, amplitude, depth] in ELLIPSE {
        let levels = dry(Some(ratio), mu).levels(&passage(1.5, 300), &Response::bare(0.3, &depths));
        let (value, at, _) = half_range(&levels, &depths, 0.1);
        deviations = [
            worst([deviations[0], value - amplitude]),
            worst([deviations[1], at - depth]),
        ];
    }
    println!(
        "orthogonal shear of ellipses: {:.1e}, depth {:.1e}",
        deviations[0], deviations[1]
    );
    assert!(deviations[0] < 1e-5 && deviations[1] < 1e-3);
}

/// The path has the 1200 steps of these values: from 0.01 a to 0.02 a the index of a path changes by up to 1e-3.
#[test]
fn dang_van_of_lines() {
    let mut deviation = 0.0;
    for [mu, z, radius, shear, first, second] in DANG_VAN {
        let load = hertz_line(mu);
        let path: Vec<Stress> = (passage(12.0, 1200).iter())
            .map(|x| load.at(*x, z, 0.3))
            .collect();
        let found = [0.2, 0.4].map(|alpha| dang_van(&path, NONE, alpha));
        deviation = worst([
            deviation,
            found[0].radius / radius - 1.0,
            found[0].shear / shear - 1.0,
            found[0].index / first - 1.0,
            found[1].index / second - 1.0,
        ]);
    }
    println!("Dang Van: {deviation:.1e}");
    assert!(deviation < 1e-4);
}

#[test]
fn relative_lives_of_lines() {
    let depths = Depths::new(6.0, 120);
    let levels = |mu: f64| {
        Load::Line(hertz_line(mu)).levels(&passage(3.0, 600), &Response::bare(0.3, &depths))
    };
    let reference = levels(0.0);
    let mut deviation = 0.0;
    for mu in [0.0, 0.05, 0.1] {
        let own = levels(mu);
        let [own, other] = [&own, &reference].map(|levels| Volume {
            depths: &depths,
            levels,
            is_line: true,
            top: 0.0,
        });
        for [which, _, limit, first, second] in LIVES.into_iter().filter(|row| row[1] == mu) {
            let criterion = Criterion::ALL[which as usize];
            let life = |cut| own.integral_life(&other, criterion, cut, limit).unwrap();
            deviation = worst([deviation, life(0.1) / first - 1.0, life(0.3) / second - 1.0]);
        }
        // No stress exceeds a limit that is higher than all of them.
        assert_eq!(
            own.integral_life(&other, Criterion::LargestShear, 0.1, 0.5),
            None
        );
    }
    println!("relative lives: {deviation:.1e}");
    assert!(deviation < 1e-3);
}

/// Pure shear that alternates: the plane of the shear has no normal stress. With a constant tension the plane is loaded by it, too.
#[test]
fn plane_of_fatemi_and_socie() {
    let cycle = |normal: f64| [1.0, -1.0].map(|s| Stress([normal, 0.0, normal, 0.0, s, 0.0]));
    assert!((fatemi_socie(&cycle(0.0), NONE, 1.0, 1e9) - 1.0).abs() < 1e-8);
    let found = fatemi_socie(&cycle(2.0), NONE, 0.5, 10.0);
    let [plane, turned] = [0.0_f64, 4.0].map(|degrees| {
        let (s, c) = (2.0 * degrees.to_radians()).sin_cos();
        c * (1.0 + 0.5 * (2.0 + s) / 10.0)
    });
    assert!(found >= plane.max(turned) && found < 1.01 * plane.max(turned));
}

/// By hand: the residual stress shifts the path of the deviator and its centre alike, so that Dang Van's index changes by α (σ_x + σ_y)/3. On a plane at an angle
/// from the surface, alternating shear has the half range |cos 2θ| and the largest normal stress |sin 2θ| + σ_x cos²θ.
#[test]
fn residual_stress_in_criteria() {
    let load = hertz_line(0.1);
    let path: Vec<Stress> = (passage(6.0, 400).iter())
        .map(|x| load.at(*x, 0.4, 0.3))
        .collect();
    let residual = Stress([-0.5, 0.2, 0.0, 0.0, 0.0, 0.0]);
    let [bare, own] = [NONE, residual].map(|residual| dang_van(&path, residual, 0.3));
    assert!((own.index - bare.index + 0.3 * 0.1).abs() < 1e-9);
    assert!((own.radius - bare.radius).abs() < 1e-9 && (own.shear - bare.shear).abs() < 1e-9);
    let cycle = [1.0, -1.0].map(|s| Stress([0.0, 0.0, 0.0, 0.0, s, 0.0]));
    let known = (0..20_000)
        .map(|i| std::f64::consts::PI * f64::from(i) / 20_000.0)
        .map(|a| {
            let normal = (2.0 * a).sin().abs() + 2.0 * a.cos().powi(2);
            (2.0 * a).cos().abs() * (1.0 + 0.5 * normal / 10.0)
        })
        .fold(0.0, f64::max);
    let found = fatemi_socie(&cycle, Stress([2.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 0.5, 10.0);
    assert!((found / known - 1.0).abs() < 1e-3, "{found} {known}");
    // Under compression along the surface the plane of the surface decides.
    let pressed = fatemi_socie(&cycle, Stress([-3.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 0.5, 10.0);
    assert!((1.0..known).contains(&pressed), "{pressed}");
}

/// At the surface under Hertz's line, ν = 0.3, stresses are −p, −0.6 p, −p: with σ_x = σ_y = r the stress after von Mises is √(0.16 p² − 0.4 p r + r²), largest at p = 0 for
/// −½ and at p = 1 for +½. A depth that is given twice is a jump.
#[test]
fn residual_stress_and_von_mises() {
    let response = Response::bare(0.3, &Depths::new(1.0, 10));
    let level = &dry(None, 0.0).levels(&passage(1.5, 300), &response)[0];
    for (r, known) in [(-0.5, 0.5), (0.5, (0.16_f64 + 0.2 + 0.25).sqrt())] {
        let found = level.von_mises_with(Stress([r, r, 0.0, 0.0, 0.0, 0.0]));
        assert!((found - known).abs() < 1e-6, "{found} {known}");
    }
    let coat = vec![[0.0, -2e9, -1e9], [2e-6, -1e9, -1e9], [2e-6, 3e8, 1e8]];
    let residual = Residual::of_table(coat).unwrap();
    let at = |depth, below| residual.at(depth, below).0[0];
    assert!((at(1e-6, true) + 1.5e9).abs() < 10.0);
    assert!((at(2e-6, false) + 1e9).abs() < 10.0 && (at(2e-6, true) - 3e8).abs() < 10.0);
    for bad in [
        vec![[0.0, 1.0, 1.0]],
        vec![[1.0, 1.0, 1.0], [0.5, 1.0, 1.0]],
        vec![[0.0, 1.0, 1.0], [0.0, 2.0, 1.0], [0.0, 3.0, 1.0]],
        vec![[0.0, f64::NAN, 1.0], [0.5, 1.0, 1.0]],
        vec![[-1.0, 1.0, 1.0], [0.5, 1.0, 1.0]],
    ] {
        assert!(Residual::of_table(bad).is_err());
    }
}

/// Under a ripple r cos kx of the pressure the shear of a passage is r kz e^(−kz) in all directions of the plane of motion: Dang Van's index without hydrostatic stress is r/e at
/// the depth 1/k. The largest one near the surface finds it, and a cut above it does not.
#[test]
fn index_near_the_surface_of_a_ripple() {
    let k = 50.0;
    let nodes: Vec<f64> = passage(5.0, 10_000);
    let values = nodes.iter().map(|x| [0.2 * (k * x).cos(), 0.0]).collect();
    let load = Load::Line(LineLoad::new(nodes, values));
    let depths = Depths::new(1.0, 200);
    let levels = load.levels(&passage(0.15, 120), &Response::bare(0.3, &depths));
    let index = |i: usize| dang_van(levels[i].middle(), NONE, 0.0).index;
    let (value, at) = depths.largest_above(0.1, index);
    assert!(
        (value / (0.2 * (-1.0_f64).exp()) - 1.0).abs() < 0.01,
        "{value}"
    );
    assert!((k * depths.at(at) - 1.0).abs() < 0.15, "{}", depths.at(at));
    let (above, _) = depths.largest_above(0.5 / k, index);
    assert!(
        (above / (0.2 * 0.5 * (-0.5_f64).exp()) - 1.0).abs() < 0.1,
        "{above}"
    );
}
