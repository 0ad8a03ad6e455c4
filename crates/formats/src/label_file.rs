//! The label volume of a file, with the names of its labels; overlapping structures share voxels.

use super::FormatError;
use super::budget::Budget;
use homolog_contract::input::{InputSpace, InputWarning};
use homolog_mesh::volume::LabelVolume;
use nalgebra::Matrix4;
use std::collections::{BTreeMap, HashMap};

/// The label volume of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelFile {
    /// The volume, in RAS.
    pub volume: LabelVolume,
    /// The coordinate space declared by the file.
    pub space: InputSpace,
    /// Names of labels as given in the file, for formats with names.
    pub names: BTreeMap<u32, String>,
    /// Changes of coordinates or values: a sentence each, without text of the file.
    pub notes: Vec<String>,
    /// Contradictions within the file that put the resulting volume in doubt.
    pub warnings: Vec<InputWarning>,
}

impl LabelFile {
    /// A volume without names, in scanner RAS.
    pub(super) fn unnamed(volume: LabelVolume) -> Self {
        let (names, notes, warnings) = (BTreeMap::new(), Vec::new(), Vec::new());
        LabelFile { volume, space: InputSpace::ScannerRas, names, notes, warnings }
    }
}

/// Largest number of structures that share a voxel, and of different sets of them: these bound the memory for overlaps.
const MAX_SET: usize = 64;
const MAX_SETS: usize = 1 << 14;

/// Labels to which structures are added one by one. A voxel with several labels gets a value that stands for their set.
#[derive(Debug)]
pub(super) struct Overlay<'b> {
    labels: Vec<u32>,
    /// The value of a set.
    values: HashMap<Vec<u32>, u32>,
    /// The labels for which a value stands.
    sets: BTreeMap<u32, Vec<u32>>,
    /// The value for the set of a value and one further label.
    joined: HashMap<(u32, u32), u32>,
    budget: &'b Budget,
}

impl<'b> Overlay<'b> {
    /// An empty set of structures.
    ///
    /// # Errors
    /// `TooLarge` beyond the budget.
    pub(super) fn new(n_voxels: usize, budget: &'b Budget) -> Result<Self, FormatError> {
        budget.charge_of::<u32>(n_voxels)?;
        let (values, sets, joined) = (HashMap::new(), BTreeMap::new(), HashMap::new());
        Ok(Overlay { labels: vec![0; n_voxels], values, sets, joined, budget })
    }

    /// Adds the voxel `at` to the structure `label`, which is not 0. A voxel may be added twice.
    ///
    /// # Errors
    /// `TooLarge` if the structures overlap in too many ways, or beyond the budget.
    pub(super) fn add(&mut self, at: usize, label: u32) -> Result<(), FormatError> {
        let before = self.labels[at];
        if before == 0 {
            self.labels[at] = label;
        } else if before != label {
            self.labels[at] = match self.joined.get(&(before, label)) {
                Some(&value) => value,
                None => self.join(before, label)?,
            };
        }
        Ok(())
    }

    fn join(&mut self, before: u32, label: u32) -> Result<u32, FormatError> {
        // The size of a growing table's entry, and of the labels of a set, twice.
        const ENTRY_BYTES: usize = 48;
        self.budget.charge(ENTRY_BYTES)?;
        let mut set = self.sets.get(&before).cloned().unwrap_or_else(|| vec![before]);
        let value = if set.contains(&label) {
            before
        } else {
            set.push(label);
            self.budget.charge(4 * ENTRY_BYTES + 2 * size_of_val(set.as_slice()))?;
            // The same set may be reached in a different order.
            set.sort_unstable();
            let next = u32::MAX - self.sets.len() as u32;
            let value = *self.values.entry(set.clone()).or_insert(next);
            let (n_labels, n_sets) = (set.len(), self.values.len());
            if n_labels > MAX_SET || n_sets > MAX_SETS {
                let found = if n_labels > MAX_SET { n_labels } else { n_sets } as u64;
                let limit = if n_labels > MAX_SET { MAX_SET } else { MAX_SETS } as u64;
                return Err(FormatError::TooLarge { what: "overlaps of structures", found, limit });
            }
            self.sets.insert(value, set);
            value
        };
        self.joined.insert((before, label), value);
        Ok(value)
    }

    /// The volume.
    ///
    /// # Errors
    /// `Volume` if the affine is not valid.
    pub(super) fn volume(self, dims: [usize; 3], affine: Matrix4<f64>) -> Result<LabelVolume, FormatError> {
        Ok(LabelVolume::new(dims, self.labels, affine)?.with_overlaps(self.sets))
    }
}
