//! Unary potentials on demand, without a table of all variables by all labels.

use crate::{FeaturePotentials, MrfModel};

/// A source of unary potentials.
pub trait UnaryPotentials: Sync {
    /// Writes the potentials of `variable` at `labels` into `values`, one each.
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]);

    /// Writes the potentials of `variable` at every label into `row`.
    fn row(&self, variable: usize, row: &mut [f32]);
}

/// Unary potentials, and a bias that is added to them but not part of the energy.
#[derive(Clone, Copy)]
pub struct UnaryInput<'e> {
    /// `θ_i(x)`.
    pub unary: &'e dyn UnaryPotentials,
    /// Added to the potentials while messages are passed; excluded from every reported energy.
    pub bias: Option<&'e dyn UnaryPotentials>,
}

impl<'e> UnaryInput<'e> {
    /// Potentials without a bias.
    pub fn plain(unary: &'e dyn UnaryPotentials) -> Self {
        UnaryInput { unary, bias: None }
    }

    /// `θ_i` plus bias over all labels into `row`; `bias` is scratch of the same length.
    pub(super) fn row(&self, variable: usize, row: &mut [f32], bias: &mut [f32]) {
        self.unary.row(variable, row);
        if let Some(feedback) = self.bias {
            feedback.row(variable, bias);
            row.iter_mut().zip(bias).for_each(|(theta, bias)| *theta += *bias);
        }
    }
}

impl UnaryPotentials for MrfModel {
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]) {
        let row = self.unary_row(variable);
        values.iter_mut().zip(labels).for_each(|(value, &x)| *value = row[x as usize]);
    }

    fn row(&self, variable: usize, row: &mut [f32]) {
        row.copy_from_slice(self.unary_row(variable));
    }
}

impl UnaryPotentials for FeaturePotentials {
    fn at(&self, variable: usize, labels: &[u32], values: &mut [f32]) {
        self.fill_at(variable, labels, values);
    }

    fn row(&self, variable: usize, row: &mut [f32]) {
        self.fill_row(variable, row);
    }
}
