//! Stresses in the bodies of a solved contact, from its pressure and wall shear.

use crate::contact::{Hertz, Shape};
use crate::layers::Coated;
use crate::solution::{Bar, ContactFields, Field, Figure, Measured, Reading, SurfaceField};
use crate::stress::{
    Body, BodyStresses, Contact, Depths, Extreme, GridLoad, HertzLoad, Interface, LineLoad, Load,
    StressParams, Stresses, analyse, dry_contact,
};

/// Cells of a grid along x and along y: odd, so that the middle of the contact is the centre of a cell, and twice the number transforms fast.
const CELLS: usize = 125;
/// Cells of the grid that bars are from.
const COARSE_CELLS: usize = 63;
/// Reach of a grid along and across the motion over the dry contact, which is more if there is pressure beyond.
const REACH: [f64; 2] = [2.2, 1.6];
/// Pressure over the Hertz pressure that a grid must hold.
const PRESSED: f64 = 2e-3;
/// Points of a passage of a line contact, and how far it reaches in half-widths.
const POINTS: i32 = 800;
const PASSAGE: f64 = 8.0;
/// Steps of the mean pressure of the dry contact over a cell, along each side.
const PARTS: usize = 6;
/// Default of the largest depth and of the cut over the smaller half-width.
const DEPTH: f64 = 3.0;
const CUT: f64 = 0.1;
/// Least depth over the cut, where one of both is a default.
const LEAST_REST: f64 = 4.0;

/// Loads of both bodies and of the dry contact, along with the share of the load that is on them.
struct Loads {
    bodies: [Load; 2],
    dry: Load,
    /// ∫p and ∫q of both bodies.
    sums: [f64; 3],
}

/// Stresses in both bodies under the fields on the contact area; `load`: N, N/m of lines, `relative_error`: of the pressure, `coated`: both
/// bodies.
pub fn stresses(
    params: &StressParams,
    (shape, hertz, load): (&Shape, &Hertz, f64),
    (surface, relative_error): (&SurfaceField, f64),
    coated: &[Coated; 2],
) -> Stresses {
    let fields = ContactFields::new(shape, surface, None);
    let is_line = shape.is_line();
    let [fine, coarse] = match is_line {
        true => line_loads(&fields, hertz),
        false => [CELLS, COARSE_CELLS].map(|n| grid_loads(&fields, shape, hertz, n)),
    };
    let contact = Contact {
        relative_error,
        ..passing(params, shape, hertz, &fine.bodies[0])
    };
    let reference = |body: &Coated| contact.reference([&fine.dry, &coarse.dry], body);
    let mut dry = reference(&coated[0]);
    let bodies = [0, 1].map(|body: usize| {
        // It depends on Poisson's ratio of the substrate and on the depths.
        let [one, two] = coated
            .each_ref()
            .map(|body| (body.substrate.poissons_ratio, contact.depths(body)));
        if body == 1 && one != two {
            dry = reference(&coated[1]);
        }
        let own = Body {
            load: &fine.bodies[body],
            coarse: &coarse.bodies[body],
            coated: &coated[body],
            traction: fine.sums[1 + body] / fine.sums[0],
            hardness: params.hardness[body].as_ref(),
            residual: params.residual[body].as_ref(),
        };
        analyse(&contact, &own, &dry)
    });
    let rows = fine.bodies[0].rows().len();
    let planes = bodies.iter().map(|body| body.layers.len()).max();
    let poisson = coated[0].substrate.poissons_ratio;
    let bare = Depths::new(contact.depth, params.planes);
    Stresses {
        bodies,
        dry: dry_contact(
            &dry_load(shape, hertz, poisson),
            &bare,
            shape.zone.turn.is_none(),
        ),
        depth: contact.depth,
        fatigue_limit: params.fatigue_limit,
        dang_van_weight: params.dang_van,
        load_share: fine.sums[0] / load,
        points: rows * contact.x.len() * planes.unwrap_or(0),
    }
}

/// Adds the figures of the bodies to those of the contact.
pub fn note(measured: &mut Measured, stresses: &Stresses) {
    let [one, two] = &stresses.bodies;
    let figures = [
        Figure::VonMisesBody1,
        Figure::LargestShearBody1,
        Figure::TensionBody1,
        Figure::OrthogonalShearBody1,
        Figure::InterfaceShearBody1,
        Figure::InterfacePullBody1,
    ];
    let over_depth = [
        Figure::DangVanBody1,
        Figure::NearSurfaceDangVanBody1,
        Figure::UtilisationBody1,
    ];
    note_body(measured, one, figures, over_depth);
    let figures = [
        Figure::VonMisesBody2,
        Figure::LargestShearBody2,
        Figure::TensionBody2,
        Figure::OrthogonalShearBody2,
        Figure::InterfaceShearBody2,
        Figure::InterfacePullBody2,
    ];
    let over_depth = [
        Figure::DangVanBody2,
        Figure::NearSurfaceDangVanBody2,
        Figure::UtilisationBody2,
    ];
    note_body(measured, two, figures, over_depth);
}

fn note_body(
    measured: &mut Measured,
    body: &BodyStresses,
    figures: [Figure; 6],
    over_depth: [Figure; 3],
) {
    let mut note = |figure, reading, error| {
        measured.figures.note(figure, reading);
        measured.bars.set(
            figure,
            Bar {
                value: error,
                place: None,
            },
        );
    };
    let worst = |pick: fn(&Interface) -> &Extreme| {
        let all = body.interfaces.iter().map(pick);
        all.max_by(|a, b| a.value.total_cmp(&b.value))
    };
    let extremes = [
        Some(&body.von_mises),
        Some(&body.largest_shear),
        Some(&body.tension),
        Some(&body.orthogonal_half_range),
        worst(|interface| &interface.shear),
        worst(|interface| &interface.pull),
    ];
    for (figure, extreme) in figures.into_iter().zip(extremes) {
        if let Some(extreme) = extreme {
            let reading = Reading::new(extreme.value).at([extreme.x, extreme.y]);
            note(figure, reading, extreme.error);
        }
    }
    let found = [
        Some(&body.dang_van),
        Some(&body.near_surface_dang_van),
        body.utilisation.as_ref(),
    ];
    for (figure, found) in over_depth.into_iter().zip(found) {
        if let Some(found) = found {
            note(figure, Reading::new(found.value), found.error);
        }
    }
}

/// Depths and passage of a contact.
fn passing<'a>(params: &'a StressParams, shape: &Shape, hertz: &Hertz, load: &Load) -> Contact<'a> {
    let half = shape.zone.half_extents().map(|h| h * hertz.half_width);
    let smaller = match (shape.is_line(), hertz.half_width_y) {
        (true, _) | (_, None) => hertz.half_width,
        (_, Some(b)) => b.min(hertz.half_width),
    };
    // Lives are computed from twice the cut on, too.
    let (depth, cut) = match (params.depth, params.cut_depth) {
        (Some(depth), Some(cut)) => (depth, cut),
        (Some(depth), None) => (depth, (CUT * smaller).min(depth / LEAST_REST)),
        (None, cut) => {
            let cut = cut.unwrap_or(CUT * smaller);
            ((DEPTH * smaller).max(LEAST_REST * cut), cut)
        }
    };
    Contact {
        params,
        depth,
        cut,
        x: match load {
            Load::Grid(load) => load.centres[0].clone(),
            _ => passage(hertz.half_width),
        },
        is_line: shape.is_line() || shape.zone.roller.is_some(),
        pressure: hertz.pressure,
        reach: REACH[0] * half[0],
        relative_error: 0.0,
    }
}

/// The frictionless dry contact in closed form; of a roller that of a line.
fn dry_load(shape: &Shape, hertz: &Hertz, poisson: f64) -> HertzLoad {
    let is_line = shape.is_line() || shape.zone.roller.is_some();
    HertzLoad {
        half_width: hertz.half_width,
        half_width_y: (!is_line).then(|| hertz.half_width_y.unwrap_or(hertz.half_width)),
        pressure: hertz.pressure,
        friction: 0.0,
        poisson,
    }
}

/// Points along a line, denser in the contact.
fn passage(half_width: f64) -> Vec<f64> {
    let end = (PASSAGE / 2.0).asinh();
    (-POINTS / 2..=POINTS / 2)
        .map(|i| 2.0 * half_width * (end * 2.0 * f64::from(i) / f64::from(POINTS)).sinh())
        .collect()
}

/// The shear of the film at the walls, on body 1 and on body 2 along the motion: the film drags body 1 as body 2 drags the film.
const WALLS: [(Field, f64); 2] = [
    (Field::ShearStressBody1, 1.0),
    (Field::ShearStressBody2, -1.0),
];
/// The same across the motion.
const WALLS_ACROSS: [(Field, f64); 2] = [
    (Field::ShearStressAcrossBody1, 1.0),
    (Field::ShearStressAcrossBody2, -1.0),
];

/// Share of the largest pressure and shear by which a load with fewer nodes may differ: below the differences between grids, at a tenth of the time.
const THINNING: f64 = 1e-5;

/// Loads of a line contact on all its nodes, and on every second one.
fn line_loads(fields: &ContactFields, hertz: &Hertz) -> [Loads; 2] {
    let mut order: Vec<usize> = (0..fields.points.len()).collect();
    let x = |i: &usize| fields.points[*i][0];
    order.sort_by(|a, b| x(a).total_cmp(&x(b)));
    order.dedup_by(|a, b| x(a) <= x(b));
    let of = |field: Field, i: usize| fields.values(field).map_or(0.0, |values| values[i]);
    let loads = WALLS.map(|(wall, sign)| {
        let values = (order.iter())
            .map(|i| [of(Field::Pressure, *i), sign * of(wall, *i)])
            .collect();
        LineLoad::new(order.iter().map(x).collect(), values)
    });
    let integral = |field: Field| -> f64 {
        let trapezoid = |pair: &[usize]| {
            let length = x(&pair[1]) - x(&pair[0]);
            0.5 * length * (of(field, pair[0]) + of(field, pair[1]))
        };
        order.windows(2).map(trapezoid).sum()
    };
    let sums = [
        integral(Field::Pressure),
        WALLS[0].1 * integral(WALLS[0].0),
        WALLS[1].1 * integral(WALLS[1].0),
    ];
    let with = |bodies: [LineLoad; 2]| Loads {
        bodies: bodies.map(Load::Line),
        dry: Load::Hertz(dry_load(&Shape::LINE, hertz, 0.0)),
        sums,
    };
    let coarse = [loads[0].coarser(), loads[1].coarser()];
    [loads, coarse].map(|loads| with(loads.map(|load| load.thinned(THINNING))))
}

/// Loads on a grid of n × n cells around the middle of the contact.
fn grid_loads(fields: &ContactFields, shape: &Shape, hertz: &Hertz, n: usize) -> Loads {
    let a = hertz.half_width;
    let half = reach(fields, shape, hertz);
    let centres = half.map(|half| {
        let cell = 2.0 * half / n as f64;
        (0..n)
            .map(|i| (i as f64 - 0.5 * (n - 1) as f64) * cell)
            .collect::<Vec<f64>>()
    });
    let grids = fields.on_grid(&centres[0], &centres[1]);
    let values = |field: Field, sign: f64| -> Vec<f64> {
        let found = grids.iter().find(|grid| grid.field == field);
        found.map_or(vec![0.0; n * n], |grid| {
            let inside = |v: &f64| if v.is_nan() { 0.0 } else { sign * v };
            grid.values.iter().map(inside).collect()
        })
    };
    let pressure = values(Field::Pressure, 1.0);
    let loads = [0, 1].map(|body: usize| {
        let [along, across] = [WALLS[body], WALLS_ACROSS[body]];
        GridLoad {
            centres: centres.clone(),
            values: [
                pressure.clone(),
                values(along.0, along.1),
                values(across.0, across.1),
            ],
        }
    });
    let [dx, dy] = loads[0].spacing();
    let mean = |x: f64, y: f64| {
        let step = |i: usize, cell: f64| ((i as f64 + 0.5) / PARTS as f64 - 0.5) * cell;
        let parts = (0..PARTS * PARTS)
            .map(|i| [x + step(i % PARTS, dx), y + step(i / PARTS, dy)])
            .map(|place| shape.zone.pressure(place.map(|x| x / a)));
        hertz.pressure * parts.sum::<f64>() / (PARTS * PARTS) as f64
    };
    let dry = (0..n * n)
        .map(|i| mean(centres[0][i % n], centres[1][i / n]))
        .collect();
    let sum = |values: &[f64]| dx * dy * values.iter().sum::<f64>();
    Loads {
        sums: [
            sum(&pressure),
            sum(&loads[0].values[1]),
            sum(&loads[1].values[1]),
        ],
        bodies: loads.map(Load::Grid),
        dry: Load::Grid(GridLoad {
            centres,
            values: [dry, vec![0.0; n * n], vec![0.0; n * n]],
        }),
    }
}

/// Half the lengths of a grid: around the dry contact and all that is pressed; across a roller to its ends.
fn reach(fields: &ContactFields, shape: &Shape, hertz: &Hertz) -> [f64; 2] {
    let a = hertz.half_width;
    let zone = shape.zone.half_extents();
    let pressure = fields.values(Field::Pressure).unwrap_or_default();
    [0, 1].map(|axis: usize| {
        if let (1, Some(roller)) = (axis, &shape.zone.roller) {
            return a * roller.half_length();
        }
        (fields.points.iter().zip(pressure))
            .filter(|(_, p)| **p > PRESSED * hertz.pressure)
            .map(|(at, _)| at[axis].abs())
            .fold(REACH[axis] * zone[axis] * a, f64::max)
    })
}
