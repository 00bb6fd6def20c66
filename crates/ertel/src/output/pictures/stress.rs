//! Stresses in both bodies, in the plane of motion through the middle of the contact.

use super::super::figure::BODIES;
use super::field::{bar_ticks, closed, draw_bar};
use super::layout::draw_ticks;
use super::maps::shades;
use crate::solution::Solution;
use crate::stress::{Section, Stresses};
use crate::words::pressure_unit;
use ertel_plot::Side;
use ertel_plot::axis::Axis;
use ertel_plot::contour::Triangulation;
use ertel_plot::drawing::{
    Anchor, Drawing, INK, LABEL_SIZE, Stroke, TICK_SIZE, number, text_width,
};
use ertel_plot::frame::{FRAME_WIDTH, Frame, label_x_axis, label_y_axis};

/// Width of the frame, px, and limits of its height.
const WIDTH: f64 = 440.0;
const HEIGHTS: [f64; 2] = [200.0, 700.0];
/// Gap before the colour bar and its width, px.
const BAR: [f64; 2] = [22.0, 16.0];

/// The stress after von Mises, if there are stresses: body 2 above, body 1 below.
pub fn stress_map(title: &str, solution: &Solution) -> Option<Drawing> {
    let stresses = solution.stresses.as_ref()?;
    Some(map(title, stresses, solution.hertz.half_width))
}

fn map(title: &str, stresses: &Stresses, half_width: f64) -> Drawing {
    let sections = stresses.bodies.each_ref().map(|body| &body.section);
    let top = (sections.iter())
        .flat_map(|section| section.stress.iter().map(|s| s.von_mises()))
        .fold(0.0, f64::max);
    let (factor, unit) = pressure_unit(top);
    let (levels, colours) = shades([0.0, factor * top], colorous::VIRIDIS);
    let x = &sections[0].x;
    let [low, high] = [x[0], x[x.len() - 1]].map(|x| x / half_width);
    let depth = stresses.depth / half_width;
    let [x, z] = [
        Axis::linear("*x*/*a*", low, high),
        Axis::linear("*z*/*a*", -depth, depth),
    ];
    let frame = Frame {
        left: 62.0,
        top: 16.0,
        width: WIDTH,
        height: (WIDTH * 2.0 * depth / (high - low)).clamp(HEIGHTS[0], HEIGHTS[1]),
    };
    let ticks = bar_ticks([0.0, factor * top]);
    let widest = (ticks.iter()).fold(0.0, |w: f64, t| w.max(text_width(&t.1, TICK_SIZE)));
    let bar = Frame {
        left: frame.left + frame.width + BAR[0],
        width: BAR[1],
        ..frame
    };
    let right = bar.left + bar.width + widest;
    let mut drawing = Drawing::new(right + 40.0, frame.top + frame.height + 52.0, title);
    drawing.begin_clip(frame.left, frame.top, frame.width, frame.height);
    for (section, up) in sections.into_iter().zip([-1.0, 1.0]) {
        let at = |x_z: [f64; 2]| {
            let [along, deep] = x_z.map(|l| l / half_width);
            [frame.x(&x, along), frame.y(&z, up * deep)]
        };
        draw_section(&mut drawing, section, factor, (&levels, &colours), at);
    }
    drawing.end_clip();
    draw_axes(&mut drawing, frame, &x, &z);
    draw_bar(&mut drawing, bar, &colours, &ticks, false);
    let label = format!("Stress after von Mises ({unit})");
    let at = [right + 26.0, bar.top + 0.5 * bar.height];
    drawing.turned_text(at, &label, LABEL_SIZE, Anchor::Middle, INK, -90.0);
    drawing
}

/// The surface, the names of the bodies, and the axes.
fn draw_axes(drawing: &mut Drawing, frame: Frame, x: &Axis, z: &Axis) {
    let surface = format!(
        "M{} {}h{}",
        number(frame.left),
        number(frame.y(z, 0.0)),
        number(frame.width)
    );
    drawing.stroke(&surface, Stroke::solid("#ffffff", 1.2));
    for (role, y) in [
        (BODIES[1], frame.top + 18.0),
        (BODIES[0], frame.top + frame.height - 9.0),
    ] {
        drawing.text(
            [frame.left + 8.0, y],
            role,
            LABEL_SIZE,
            Anchor::Start,
            "#ffffff",
        );
    }
    drawing.stroke(&frame.outline(), Stroke::solid(INK, FRAME_WIDTH));
    label_x_axis(drawing, frame, x, false);
    draw_ticks(drawing, [frame, frame], x, z);
    label_y_axis(drawing, frame, z, Side::Left, INK);
}

fn draw_section(
    drawing: &mut Drawing,
    section: &Section,
    factor: f64,
    (levels, colours): (&[f64], &[String]),
    at: impl Fn([f64; 2]) -> [f64; 2],
) {
    let n = section.x.len();
    let points: Vec<[f64; 2]> = (section.depth.iter())
        .flat_map(|z| section.x.iter().map(|x| [*x, *z]))
        .map(at)
        .collect();
    let triangles: Vec<[u32; 3]> = (section.rows())
        .flat_map(|j| (0..n - 1).map(move |i| (j * n + i) as u32))
        .flat_map(|a| {
            let (b, c, d) = (a + 1, a + n as u32, a + n as u32 + 1);
            [[a, b, d], [a, d, c]]
        })
        .collect();
    let values: Vec<f64> = (section.stress.iter())
        .map(|s| factor * s.von_mises())
        .collect();
    let mesh = Triangulation::new(&points, &triangles);
    drawing.fill(&closed(&mesh.whole(&values).loops), &colours[0]);
    for (region, colour) in mesh.regions(&values, levels).iter().zip(&colours[1..]) {
        drawing.fill(&closed(&region.loops), colour);
    }
}
