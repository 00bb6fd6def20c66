//! `[output.interferogram]`, end to end.

use std::process::Output;

use tempfile::TempDir;

use crate::common::{code, contains, ertel, write};

const CASE: &str = r#"
contact = { kind = "circular", radius = "10 mm", load = "10 N" }
bodies = { body_1 = "glass", body_2 = "steel" }
motion = { entrainment_speed = "1 m/s", slide_to_roll_ratio = 0.0 }
[lubricant]
temperature = "40 degC"
density = { law = "constant", rho_0 = "870 kg/m^3" }
viscosity = { law = "roelands", mu_0 = "40 mPa.s", alpha = "15 1/GPa" }
[mesh]
preset = "coarse"
[output.interferogram]
wavelength = "600 nm"
refractive_index = 1.5
spacer_thickness = "100 nm"
spacer_refractive_index = 1.2
phase_change = "180 deg"
"#;

fn solve(folder: &TempDir, case: &str, more: &str) -> Output {
    write(folder, "case.toml", case);
    ertel(folder, &format!("solve case.toml -q -o out {more}"))
}

/// Number behind `key` in a text.
fn number(text: &str, key: &str) -> f64 {
    let rest = &text[text.find(key).expect(key) + key.len()..];
    let end = rest
        .find(|c: char| !c.is_ascii_digit() && !"-.".contains(c))
        .unwrap();
    rest[..end].parse().unwrap()
}

/// Place of the tick with this label on the lower axis, px.
fn tick(svg: &str, label: &str) -> f64 {
    let line = svg
        .lines()
        .find(|l| l.starts_with("<text") && l.contains(&format!(">{label}.0</text>")));
    number(line.unwrap(), "<text x=\"")
}

/// The row through the centre is what two beams make of the film in `centreline.csv`.
#[test]
fn the_image_shows_the_film_that_was_computed() {
    let folder = tempfile::tempdir().unwrap();
    let output = solve(&folder, CASE, "");
    code(&output, 0);
    let read = |name: &str| std::fs::read(folder.path().join("out").join(name)).unwrap();
    let text = |name: &str| String::from_utf8(read(name)).unwrap();
    let svg = text("interferogram.svg");
    assert!(svg.contains("data:image/png;base64,"));
    let mut reader = png_image::Decoder::new(std::io::Cursor::new(read("interferogram.png")))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let [width, height] = [info.width as usize, info.height as usize];
    // Pixels of the image by half-widths, from the picture's ticks.
    let image = &svg[svg.find("<image").unwrap()..];
    let (left, shown) = (number(image, "x=\""), number(image, "width=\""));
    let (zero, one) = (tick(&svg, "0"), tick(&svg, "1"));
    let column = |x: f64| (zero + x * (one - zero) - left) / shown * width as f64;
    let table = text("centreline.csv");
    let mut lines = table.lines().map(|l| l.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap();
    let place = |name: &str| {
        head.iter()
            .position(|h| *h == name)
            .unwrap_or_else(|| panic!("{head:?}"))
    };
    let (x, h) = (place("x_over_a"), place("film_thickness_m"));
    let (mut n, mut n_off, mut turns) = (0, 0, 0);
    let mut former: Option<f64> = None;
    for line in lines {
        let (x, h): (f64, f64) = (line[x].parse().unwrap(), line[h].parse().unwrap());
        if x.abs() > 0.95 {
            continue;
        }
        let phase =
            4.0 * std::f64::consts::PI * (1.5 * h + 1.2 * 100e-9) / 600e-9 + std::f64::consts::PI;
        let share = 0.5 * (1.0 + phase.cos());
        let pixel = pixels[3 * (height / 2 * width + column(x) as usize)];
        let encoded = f64::from(pixel) / 255.0;
        let shown = if encoded <= 0.04045 {
            encoded / 12.92
        } else {
            ((encoded + 0.055) / 1.055).powf(2.4)
        };
        n += 1;
        n_off += usize::from((shown - share).abs() > 0.06);
        turns += usize::from(former.is_some_and(|former| (former > 0.5) != (share > 0.5)));
        former = Some(share);
    }
    assert!(n > 30 && n_off * 20 <= n, "{n_off} of {n} are off");
    assert!(turns >= 1, "no fringe to see");
    // Again: a former result is replaced.
    let rgb = CASE.replace(
        "wavelength = \"600 nm\"",
        "light = \"cie-rgb\"\nfollows_density = true",
    );
    code(&solve(&folder, &rgb, ""), 0);
}

#[test]
fn what_cannot_be_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (from, to, words) in [
        ("wavelength = \"600 nm\"", "", "`wavelength`"),
        (
            "wavelength = \"600 nm\"",
            "wavelength = \"600 mm\"",
            "wavelength",
        ),
        ("wavelength = \"600 nm\"", "wavelength = \"600 N\"", "force"),
        (
            "wavelength = \"600 nm\"",
            "wavelength = \"nan nm\"",
            "finite",
        ),
        ("wavelength = \"600 nm\"", "light = \"neon\"", "cie-rgb"),
        (
            "wavelength = \"600 nm\"",
            "wavelengths = [\"600 nm\"]",
            "three",
        ),
        (
            "wavelength = \"600 nm\"",
            "wavelength = \"600 nm\"\nlight = \"cie-rgb\"",
            "both given",
        ),
        (
            "refractive_index = 1.5",
            "refractive_index = 0.5",
            "refractive_index",
        ),
        (
            "spacer_refractive_index = 1.2",
            "",
            "spacer_refractive_index",
        ),
        ("spacer_thickness = \"100 nm\"", "", "spacer_thickness"),
        ("phase_change = \"180 deg\"", "", "phase_change"),
        (
            "phase_change = \"180 deg\"",
            "phase_change = \"180 deg\"\ncolour = 1",
            "colour",
        ),
        (
            "phase_change = \"180 deg\"",
            "phase_change = \"180 deg\"\nvisibility = 2",
            "visibility",
        ),
        (
            "kind = \"circular\", radius = \"10 mm\", load = \"10 N\"",
            "kind = \"line\", radius = \"10 mm\", load = \"10 kN/m\"",
            "point contact",
        ),
    ] {
        contains(CASE, from);
        let output = solve(&folder, &CASE.replace(from, to), "--check");
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{to}: {message}");
        assert!(
            message.contains(words) && message.contains("case.toml:"),
            "{to}: {message}"
        );
    }
    assert!(!folder.path().join("out").exists());
}
