//! The film of a state, with the table of its points.

use rayon::prelude::*;

use super::discretisation::Discretisation;
use super::points::{fields_at, fields_from};
use super::region::Elements;
use super::state::State;
use super::streams::Streams;
use crate::contact::{Planar, Shape};
use crate::engine::region::Region;
use crate::engine::{Film, Point, PointFields, PointTable};

/// Elements that a thread takes at a time.
const BATCH: usize = 16;

/// The film of a state, with the table of its points.
pub struct Evaluated<'a> {
    d: &'a Discretisation,
    state: &'a State,
    streams: Streams,
    points: PointTable,
}

impl<'a> Evaluated<'a> {
    /// Of a state of a contact of this shape, whose bodies may end elsewhere than those the mesh was made for, and the mean velocity of its surfaces.
    pub fn new(
        shape: &Shape,
        flow: &Planar,
        d: &'a Discretisation,
        state: &'a State,
    ) -> Evaluated<'a> {
        let streams = Streams::new(d, state, flow);
        let whole = Region::of(shape);
        let shorter = whole.shorter(shape);
        let elements = Elements::new(d);
        let tables = [&d.pressure_table, &d.deflection_table];
        let of_element = |cell: usize| {
            let shares = [&whole, &shorter].map(|region| elements.share(region, cell));
            let row = |q: usize| {
                let heat = d.heat.as_ref();
                let mut fields = PointFields {
                    temperature: heat.map(|heat| Box::new(heat.profile_at(d, state, cell, q))),
                    ..fields_from(d, state, cell, q, tables)
                };
                fields.missing += streams.missing(&fields);
                Point {
                    area: d.rule.weights[q] * d.contact.maps[cell].determinant,
                    within: shares.each_ref().map(|share| share.at(q)),
                    in_zone: d.contact.shape.zone.contains(fields.place),
                    fields,
                }
            };
            (0..d.rule.len()).map(row).collect::<Vec<Point>>()
        };
        let elements: Vec<Vec<Point>> = (0..d.contact.n_elements())
            .into_par_iter()
            .with_min_len(BATCH)
            .map(of_element)
            .collect();
        Evaluated {
            d,
            state,
            streams,
            points: PointTable::new(elements),
        }
    }
}

impl Film for Evaluated<'_> {
    fn points(&self) -> &PointTable {
        &self.points
    }

    fn at(&self, place: [f64; 2]) -> Option<PointFields> {
        let mut fields = fields_at(self.d, self.state, place)?;
        fields.missing += self.streams.missing(&fields);
        Some(fields)
    }
}
