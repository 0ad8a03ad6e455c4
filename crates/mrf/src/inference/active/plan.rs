//! Lists of near candidates between a variable and its neighbors, and the memory layout of messages.
//!
//! A variable's messages to all its neighbors are computed side by side, over the union of the neighbors' candidates:
//! neighbors on the source have similar candidates, so that one list of near labels serves all of them. The lists are
//! built once for a choice of candidates, by marking the candidates of the variable in a row over all labels and
//! reading that row at `N_r(y)`. Every iteration reads them from front to back.

use super::super::pair_table::PairTable;
use super::model::ActiveModel;
use rayon::prelude::*;
use std::ops::Range;

/// Variables per group; a group is the unit of work of a thread.
const GROUP: usize = 64;
/// Row lengths over candidates are multiples of this: numbers of 32 bits in a vector of 256 bits.
pub(super) const LANES: usize = 8;
/// Marks a label that is not a candidate.
const ABSENT: u32 = u32::MAX;

/// Memory layout of rows over candidates.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout {
    /// Start of the row of every variable, followed by the end of the last.
    pub rows: Vec<usize>,
    /// Start of the message of every directed edge `i → j`, a row over the candidates of `j`, followed by the end of
    /// the last.
    pub messages: Vec<usize>,
}

impl Layout {
    pub(super) fn new(model: &ActiveModel<'_>) -> Self {
        let stride = |variable: usize| model.candidates.labels(variable).len().next_multiple_of(LANES);
        let sums = |lengths: &mut dyn Iterator<Item = usize>| {
            let mut sums = vec![0];
            let mut sum = 0;
            sums.extend(lengths.map(|length| {
                sum += length;
                sum
            }));
            sums
        };
        let n_edges = model.variables.n_directed_edges();
        Layout {
            rows: sums(&mut (0..model.n_variables()).map(stride)),
            messages: sums(&mut (0..n_edges).map(|edge| stride(model.variables.head(edge)))),
        }
    }

    /// The row of `variable`.
    pub(super) fn row(&self, variable: usize) -> Range<usize> {
        self.rows[variable]..self.rows[variable + 1]
    }

    /// The message of `edge`.
    pub(super) fn message(&self, edge: usize) -> Range<usize> {
        self.messages[edge]..self.messages[edge + 1]
    }

    /// The messages that the variables of a group send.
    pub(super) fn sent_by(&self, model: &ActiveModel<'_>, variables: &Range<usize>) -> Range<usize> {
        let graph = model.variables;
        match variables.is_empty() {
            true => 0..0,
            false => self.messages[graph.row(variables.start).start]..self.messages[graph.row(variables.end - 1).end],
        }
    }
}

/// Lists of near candidates of consecutive variables, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Group {
    pub variables: Range<usize>,
    /// Number of different candidates of the neighbors of each variable.
    unions: Vec<u32>,
    /// End of the list of each of these candidates.
    ends: Vec<u32>,
    /// Members of `N_r(y) ∩ C_i`, as numbers of candidates of `i`.
    near: Vec<u16>,
    /// Their `[rising, falling]` factors of the pairwise potential; none without a distance term.
    factors: Vec<[f32; 2]>,
    /// For every edge `i → j` and candidate of `j` its place in the union.
    places: Vec<u16>,
}

/// The lists of one variable.
pub(super) struct NearLists<'p> {
    /// Start of the first list.
    pub start: u32,
    /// End of the list of each label of the union.
    pub ends: &'p [u32],
    pub near: &'p [u16],
    pub factors: &'p [[f32; 2]],
    /// Places in the union, neighbor after neighbor.
    pub places: &'p [u16],
}

impl Group {
    /// The lists of every variable of the group, in order.
    pub(super) fn lists<'p>(&'p self, model: &'p ActiveModel<'_>) -> impl Iterator<Item = (usize, NearLists<'p>)> {
        let (mut end, mut start, mut place) = (0, 0, 0);
        self.variables.clone().zip(&self.unions).map(move |(i, &size)| {
            let ends = &self.ends[end..end + size as usize];
            let sizes = model.variables.neighbors(i).iter().map(|&j| model.candidates.labels(j as usize).len());
            let n_places: usize = sizes.sum();
            let places = &self.places[place..place + n_places];
            let lists = NearLists { start, ends, near: &self.near, factors: &self.factors, places };
            end += size as usize;
            start = ends.last().copied().unwrap_or(start);
            place += n_places;
            (i, lists)
        })
    }

    /// Number of near label pairs that one iteration visits; a pair counts once for all messages it is part of.
    pub(super) fn pair_updates(&self, model: &ActiveModel<'_>) -> u64 {
        let pairs = self.lists(model).map(|(i, lists)| {
            let pairs = lists.ends.last().map_or(0, |&end| end - lists.start);
            u64::from(pairs) * model.variables.row(i).len() as u64
        });
        pairs.sum()
    }

    /// Memory of the lists, bytes.
    pub(super) fn bytes(&self) -> usize {
        4 * (self.unions.len() + self.ends.len()) + 2 * (self.near.len() + self.places.len()) + 8 * self.factors.len()
    }
}

/// The lists of all variables of `model`, on all cores. Cost `O(n K k̄)` with a constant of about one and a half.
pub(super) fn groups(model: &ActiveModel<'_>, table: &PairTable) -> Vec<Group> {
    let n = model.n_variables();
    let starts: Vec<usize> = (0..n).step_by(GROUP).collect();
    let scratch = || (vec![ABSENT; table.n_labels()], vec![ABSENT; table.n_labels()]);
    starts
        .into_par_iter()
        .map_init(scratch, |(number, place), start| group(model, table, start..(start + GROUP).min(n), number, place))
        .collect()
}

/// `number` and `place` are scratch over all labels; `number` is [`ABSENT`] everywhere on entry and exit.
fn group(
    model: &ActiveModel<'_>,
    table: &PairTable,
    variables: Range<usize>,
    number: &mut [u32],
    place: &mut [u32],
) -> Group {
    let weighted = model.pairwise.beta != 0.0;
    let (mut unions, mut ends, mut near) = (Vec::new(), Vec::new(), Vec::new());
    let (mut factors, mut places) = (Vec::new(), Vec::new());
    let mut union: Vec<u32> = Vec::new();
    for i in variables.clone() {
        mark(model.candidates.labels(i), number);
        let neighbors = model.variables.neighbors(i);
        union.clear();
        neighbors.iter().for_each(|&j| union.extend_from_slice(model.candidates.labels(j as usize)));
        // The stable sort merges sorted runs, and the union consists of sorted runs.
        union.sort();
        union.dedup();
        mark(&union, place);
        for &y in &union {
            for (x, pair) in table.factors(y as usize) {
                if number[x] != ABSENT {
                    near.push(number[x] as u16);
                    if weighted {
                        factors.push(pair);
                    }
                }
            }
            ends.push(near.len() as u32);
        }
        unions.push(union.len() as u32);
        for &j in neighbors {
            places.extend(model.candidates.labels(j as usize).iter().map(|&y| place[y as usize] as u16));
        }
        model.candidates.labels(i).iter().for_each(|&x| number[x as usize] = ABSENT);
    }
    Group { variables, unions, ends, near, factors, places }
}

/// Numbers `labels` in a row over all labels.
fn mark(labels: &[u32], row: &mut [u32]) {
    for (at, &x) in labels.iter().enumerate() {
        row[x as usize] = at as u32;
    }
}
