//! Labels by name: by the names in the file, or else by the tables of well-known segmentations.
//!
//! Names are compared by their words, in any order and case, with `l`, `lh` and `r`, `rh` for left and right:
//! `hippocampus-left` equals `Left-Hippocampus` and `Hippocampus_L`. A table is used for a volume without names if it
//! knows all labels of the volume and the volume has the requested label. A prefix such as
//! `freesurfer:hippocampus-left` selects a table without such evidence.

use super::IntakeError;
use homolog_contract::parameters::LabelChoice;
use homolog_mesh::volume::LabelVolume;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// Largest number of names that a refusal suggests.
const MAX_NEAREST: usize = 3;
/// Least similarity of a suggested name, from 0 to 1.
const LEAST_SIMILARITY: f64 = 0.5;
/// Largest number of characters of a name that a refusal repeats.
const MAX_SHOWN: usize = 64;

/// The numbers and names of a segmentation.
#[derive(Debug)]
pub struct LabelTable {
    /// Name used before a colon, such as `freesurfer`.
    pub name: &'static str,
    /// The program or atlas, for people.
    pub title: &'static str,
    /// Number and name, in the order of the file; a number may have several names.
    rows: Vec<(u32, &'static str)>,
}

/// Name, title and content of each table; the files state source and license.
const TABLES: [(&str, &str, &str); 5] = [
    ("freesurfer", "FreeSurfer", include_str!("label_tables/freesurfer.tsv")),
    ("totalsegmentator", "TotalSegmentator", include_str!("label_tables/totalsegmentator.tsv")),
    ("totalsegmentator-mr", "TotalSegmentator MR", include_str!("label_tables/totalsegmentator-mr.tsv")),
    ("aal", "AAL", include_str!("label_tables/aal.tsv")),
    ("aal-spm", "AAL of SPM", include_str!("label_tables/aal-spm.tsv")),
];

/// The tables of well-known segmentations.
pub fn label_tables() -> &'static [LabelTable] {
    static READ: OnceLock<Vec<LabelTable>> = OnceLock::new();
    READ.get_or_init(|| {
        let row = |line: &'static str| {
            let (number, name) = line.split_once('\t')?;
            Some((number.parse().ok()?, name))
        };
        let table = |(name, title, text): (_, _, &'static str)| LabelTable {
            name,
            title,
            rows: text.lines().filter(|line| !line.starts_with('#')).filter_map(row).collect(),
        };
        TABLES.into_iter().map(table).collect()
    })
}

impl LabelTable {
    /// The first name of a number.
    pub fn name_of(&self, number: u32) -> Option<&'static str> {
        self.rows.iter().find(|(of, _)| *of == number).map(|(_, name)| *name)
    }

    fn knows_all(&self, present: &BTreeSet<u32>) -> bool {
        present.iter().all(|label| self.name_of(*label).is_some())
    }

    fn numbers_of(&self, words: &[String]) -> BTreeSet<u32> {
        self.rows.iter().filter(|(_, name)| words_of(name) == words).map(|(number, _)| *number).collect()
    }
}

/// The table that names the labels of a volume if the file has no names: the only table that knows all of them,
/// provided that there are several.
pub(super) fn table_of(present: &BTreeSet<u32>) -> Option<&'static LabelTable> {
    let mut known = label_tables().iter().filter(|table| table.knows_all(present));
    known.next().filter(|_| present.len() > 1 && known.next().is_none())
}

/// A name similar to an unknown one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NearName {
    /// A name of a table and its number.
    OfTable {
        /// The name.
        name: &'static str,
        /// The number.
        number: u32,
        /// The program or atlas.
        title: &'static str,
    },
    /// A name in the file, which is not repeated: its text may name a patient.
    OfFile {
        /// Its number.
        number: u32,
    },
}

impl std::fmt::Display for NearName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NearName::OfTable { name, number, title } => write!(f, "{name} ({number} in {title})"),
            NearName::OfFile { number } => write!(f, "the file's name of label {number}"),
        }
    }
}

/// Whether two names have the same words, in any order and case, with `l` and `lh` for left, `r` and `rh` for right.
pub fn are_one_name(a: &str, b: &str) -> bool {
    words_of(a) == words_of(b)
}

/// The numbers of the labels selected by a request in a volume with these names in its file.
///
/// # Errors
/// [`IntakeError::UnknownLabelName`]; [`IntakeError::AmbiguousLabelName`].
pub fn chosen_numbers(
    labels: &[LabelChoice],
    names: &BTreeMap<u32, String>,
    volume: &LabelVolume,
) -> Result<Vec<u32>, IntakeError> {
    chosen(labels, names, volume).map(|found| found.numbers)
}

/// Labels by number, and a sentence on each number found through a table.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct ChosenLabels {
    pub numbers: Vec<u32>,
    pub notes: Vec<String>,
}

/// The numbers of the labels selected by a request; a name selects every label that has it. `names` are the names in
/// the file.
///
/// # Errors
/// [`IntakeError::UnknownLabelName`]; [`IntakeError::AmbiguousLabelName`] if tables disagree.
pub(crate) fn chosen(
    labels: &[LabelChoice],
    names: &BTreeMap<u32, String>,
    volume: &LabelVolume,
) -> Result<ChosenLabels, IntakeError> {
    let mut found = ChosenLabels::default();
    let mut present: Option<BTreeSet<u32>> = None;
    for (place, label) in labels.iter().enumerate() {
        let name = match label {
            LabelChoice::Number(number) => {
                found.numbers.push(*number);
                continue;
            }
            LabelChoice::Name(name) => name.trim(),
        };
        let wanted = name.to_lowercase();
        let exact = |own: &str| own.trim().to_lowercase() == wanted;
        let mut of_file: Vec<u32> = names.iter().filter(|(_, own)| exact(own)).map(|(number, _)| *number).collect();
        let words = words_of(name);
        if of_file.is_empty() {
            of_file = names.iter().filter(|(_, own)| words_of(own) == words).map(|(number, _)| *number).collect();
        }
        if !of_file.is_empty() {
            found.numbers.extend(of_file);
            continue;
        }
        let present = present.get_or_insert_with(|| volume.label_counts().into_keys().collect());
        let (table, numbers) = by_table(name, place, names, present)?;
        let listed: Vec<String> = numbers.iter().map(u32::to_string).collect();
        found.notes.push(format!(
            "{} was taken for label {} by the table of {}",
            shown(name),
            listed.join(", "),
            table.title
        ));
        found.numbers.extend(numbers);
    }
    Ok(found)
}

fn by_table(
    name: &str,
    place: usize,
    names: &BTreeMap<u32, String>,
    present: &BTreeSet<u32>,
) -> Result<(&'static LabelTable, Vec<u32>), IntakeError> {
    let (prefix, own) = match name.split_once(':') {
        Some((prefix, own)) => (Some(prefix.trim().to_lowercase()), own.trim()),
        None => (None, name),
    };
    let is_asked = |table: &&LabelTable| match &prefix {
        Some(prefix) => table.name == prefix,
        None => names.is_empty() && table.knows_all(present),
    };
    let words = words_of(own);
    let candidates: Vec<&'static LabelTable> = label_tables().iter().filter(is_asked).collect();
    let mut found: Vec<(&'static LabelTable, Vec<u32>)> = candidates
        .iter()
        .map(|table| (*table, table.numbers_of(&words).into_iter().collect::<Vec<_>>()))
        .filter(|(_, numbers)| !numbers.is_empty())
        .collect();
    // Unless a table is named, labels without voxels were not meant.
    if prefix.is_none() {
        found.retain(|(_, numbers)| numbers.iter().any(|number| present.contains(number)));
    }
    let [first, others @ ..] = found.as_slice() else {
        let nearest =
            nearest(own, names, if candidates.is_empty() { label_tables() } else { &[] }, &candidates, present);
        return Err(IntakeError::UnknownLabelName { place, name: shown(name), nearest, has_names: !names.is_empty() });
    };
    if others.iter().any(|(_, numbers)| *numbers != first.1) {
        let meanings = found.iter().map(|(table, numbers)| (table.name, numbers.clone())).collect();
        return Err(IntakeError::AmbiguousLabelName { place, name: shown(name), meanings });
    }
    Ok((first.0, first.1.clone()))
}

/// The names most like `name`: those of the file, and of the tables that fit, or else of `all`; of labels that the volume has first.
fn nearest(
    name: &str,
    names: &BTreeMap<u32, String>,
    all: &'static [LabelTable],
    fitting: &[&'static LabelTable],
    present: &BTreeSet<u32>,
) -> Vec<NearName> {
    let wanted = words_of(name).join(" ");
    let similarity = |other: &str| strsim::normalized_damerau_levenshtein(&wanted, &words_of(other).join(" "));
    let of_file = names.iter().map(|(&number, own)| (similarity(own), NearName::OfFile { number }));
    let tables = all.iter().chain(fitting.iter().copied());
    let of_tables = tables.flat_map(|table| {
        let rows = table.rows.iter().filter(|(number, _)| present.contains(number));
        rows.map(|&(number, name)| (similarity(name), NearName::OfTable { name, number, title: table.title }))
    });
    let mut near: Vec<(f64, NearName)> =
        of_file.chain(of_tables).filter(|(like, _)| *like >= LEAST_SIMILARITY).collect();
    near.sort_by(|a, b| b.0.total_cmp(&a.0));
    near.into_iter().take(MAX_NEAREST).map(|(_, name)| name).collect()
}

/// A name as a refusal repeats it.
fn shown(name: &str) -> String {
    let text: String = name.chars().filter(|c| !c.is_control()).take(MAX_SHOWN).collect();
    format!("{text:?}")
}

/// The words of a name in order, each once, in lower case, with sides spelled out.
fn words_of(name: &str) -> Vec<String> {
    let lower = name.to_lowercase();
    let words = lower.split(|c: char| !c.is_alphanumeric() && c != '+').filter(|word| !word.is_empty());
    let mut words: Vec<String> = words
        .map(|word| match word {
            "l" | "lh" => "left".to_owned(),
            "r" | "rh" => "right".to_owned(),
            word => word.to_owned(),
        })
        .collect();
    words.sort();
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix4;
    use proptest::prelude::*;

    fn volume(labels: &[u32]) -> LabelVolume {
        LabelVolume::new([labels.len(), 1, 1], labels.to_vec(), Matrix4::identity()).unwrap()
    }

    fn numbers(name: &str, present: &[u32]) -> Result<Vec<u32>, IntakeError> {
        let choice = [LabelChoice::Name(name.to_owned())];
        chosen(&choice, &BTreeMap::new(), &volume(present)).map(|found| found.numbers)
    }

    #[test]
    fn every_table_is_read_whole_and_states_source_and_license() {
        for ((name, _, text), table) in TABLES.iter().zip(label_tables()) {
            assert_eq!(text.lines().filter(|line| !line.starts_with('#')).count(), table.rows.len(), "{name}");
            let head: String = text.lines().take_while(|line| line.starts_with('#')).collect();
            assert!(head.contains("Source:") && head.contains("icense"), "{name}");
            // A name has one number, and so do its words; otherwise requests would be ambiguous.
            for (number, row) in &table.rows {
                assert_eq!(table.numbers_of(&words_of(row)), BTreeSet::from([*number]), "{name}: {row}");
            }
        }
    }

    #[test]
    fn names_are_found_by_their_words_in_the_table_that_knows_the_volume() {
        for name in
            ["Left-Hippocampus", "hippocampus-left", "Hippocampus_L", "lh hippocampus", "freesurfer:hippocampus left"]
        {
            assert_eq!(numbers(name, &[0, 17, 53, 1006]).unwrap(), [17], "{name}");
        }
        assert_eq!(numbers("kidney-left", &[1, 2, 3, 5]).unwrap(), [3]);
        assert_eq!(numbers("entorhinal-right ctx", &[17, 53, 2006]).unwrap(), [2006]);
        assert_eq!(numbers("hippocampus left", &[4101, 4102, 2001]).unwrap(), [4101]);
        // The volume lacks the named label, or has a label that no table knows.
        assert!(matches!(numbers("amygdala-left", &[17, 53, 1006]), Err(IntakeError::UnknownLabelName { .. })));
        assert!(matches!(numbers("hippocampus-left", &[17, 9999]), Err(IntakeError::UnknownLabelName { .. })));
        assert_eq!(numbers("freesurfer:hippocampus-left", &[17, 9999]).unwrap(), [17]);
    }

    #[test]
    fn tables_that_disagree_are_named() {
        // 22 is the heart in one table, 51 in the other; the volume lacks 51.
        assert_eq!(numbers("heart", &[22, 50]).unwrap(), [22]);
        let said = numbers("sacrum", &[18, 25]).unwrap_err().to_string();
        assert!(said.contains("totalsegmentator:sacrum") && said.contains("totalsegmentator-mr:sacrum"), "{said}");
    }

    #[test]
    fn a_name_that_nothing_has_is_repeated_with_those_most_like_it() {
        let said = numbers("hipocampus-left", &[17, 53]).unwrap_err().to_string();
        assert!(said.contains("\"hipocampus-left\"") && said.contains("Left-Hippocampus (17 in FreeSurfer)"), "{said}");
        let own = BTreeMap::from([(3, "Jane Doe lesion".to_owned()), (4, "Cyst".to_owned())]);
        let said = chosen(&[LabelChoice::Name("jane doe lesions".to_owned())], &own, &volume(&[3, 4]))
            .unwrap_err()
            .to_string();
        assert!(said.contains("the file's name of label 3") && !said.contains("Jane"), "{said}");
    }

    proptest! {
        /// Any order, joining and spelling of the words of a name selects the same label.
        #[test]
        fn any_spelling_of_a_name_is_its_label(
            table in 0..TABLES.len(),
            row in any::<prop::sample::Index>(),
            order in any::<u64>(),
            joint in prop::sample::select(vec!["-", "_", " ", ", "]),
            upper in any::<bool>(),
        ) {
            let table = &label_tables()[table];
            let (number, name) = table.rows[row.index(table.rows.len())];
            let mut words = words_of(name);
            let n = words.len() as u64;
            words.rotate_left((order % n) as usize);
            let text = words.join(joint);
            let text = format!("{}:{}", table.name, if upper { text.to_uppercase() } else { text });
            prop_assert_eq!(numbers(&text, &[number]).unwrap(), vec![number]);
        }

        /// For any name the search fails only by a refusal, which repeats at most the first characters of the name.
        #[test]
        fn any_text_is_a_label_or_refused_in_one_line(name in ".{0,200}", present in prop::collection::vec(0u32..130, 1..6)) {
            if let Err(error) = numbers(&name, &present) {
                let said = error.to_string();
                prop_assert!(!said.contains('\n') && said.len() < 2000);
            }
        }
    }
}
