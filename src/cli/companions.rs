//! Label names from a file beside a volume: label descriptions of ITK-SNAP, as ASHS writes them, and color tables of 3D
//! Slicer (`.ctbl`) and FreeSurfer.

use super::output::note;
use homolog_contract::parameters::{InputParameters, LabelChoice, MatchParameters};
use homolog_run::intake::are_one_name;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Extensions of a companion file with the name of the volume.
const ENDINGS: [&str; 5] = ["ctbl", "txt", "label", "labels", "ctab"];
/// Names of companion files that may stand beside any volume.
const NAMES: [&str; 1] = ["snaplabels.txt"];
/// Extensions of volumes; the name of the volume precedes them.
const OF_VOLUMES: [&str; 11] =
    [".seg.nrrd", ".nii.gz", ".nii", ".mgz", ".mgh.gz", ".mgh", ".nrrd", ".nhdr", ".mha.gz", ".mha", ".mhd"];
/// Longest companion file, bytes; FreeSurfer's file of all its labels is a tenth of this.
const MAX_BYTES: u64 = 1 << 20;

/// Label names and the file that contains them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Companion {
    pub(super) path: PathBuf,
    pub(super) names: BTreeMap<u32, String>,
}

/// The file with label names beside a volume, if it exists.
pub(super) fn companion(volume: &Path) -> Option<Companion> {
    let file = volume.file_name()?.to_str()?;
    let lower = file.to_lowercase();
    let ending = OF_VOLUMES.iter().find(|ending| lower.ends_with(*ending))?;
    let stem = &file[..file.len() - ending.len()];
    let own = ENDINGS.iter().map(|ending| format!("{stem}.{ending}"));
    own.chain(NAMES.iter().map(|name| (*name).to_owned())).find_map(|name| {
        let path = volume.with_file_name(name);
        let size = fs::metadata(&path).ok().filter(fs::Metadata::is_file)?.len();
        let names = table(&String::from_utf8_lossy(&fs::read(&path).ok().filter(|_| size <= MAX_BYTES)?));
        (!names.is_empty()).then_some(Companion { path, names })
    })
}

/// The names in a table: rows of a number, six numbers and a name in quotation marks (ITK-SNAP), or of a number, a name
/// and a color (3D Slicer, FreeSurfer). Other lines are skipped; 0 is the background.
fn table(text: &str) -> BTreeMap<u32, String> {
    let row = |line: &str| {
        let line = line.trim();
        let words: Vec<&str> = line.split_whitespace().collect();
        let number: u32 = words.first()?.parse().ok().filter(|number| *number > 0)?;
        let are_numbers = |words: &[&str]| words.iter().all(|word| word.parse::<f64>().is_ok());
        if let Some((before, rest)) = line.split_once('"') {
            let is_snap = before.split_whitespace().count() == 7 && are_numbers(&words[1..7]);
            return is_snap.then(|| (number, rest.trim_end_matches('"').to_owned()));
        }
        let (name, color) = (words.get(1)?, words.get(2..)?);
        ((3..=4).contains(&color.len()) && are_numbers(color)).then(|| (number, (*name).to_owned()))
    };
    text.lines().filter_map(row).collect()
}

/// The parameters with the labels of each input by number, where a companion file has their names.
pub(super) fn with_numbers(parameters: &MatchParameters, [source, target]: [&Path; 2]) -> MatchParameters {
    let mut found = parameters.clone();
    found.input.source.labels = numbers(&parameters.input.of_source(), source).or(found.input.source.labels);
    found.input.target.labels = numbers(&parameters.input.of_target(), target).or(found.input.target.labels);
    found
}

/// The labels of one input, by number where a companion file has their names; `None` if the file has none of them.
pub(super) fn numbers(input: &InputParameters, volume: &Path) -> Option<Vec<LabelChoice>> {
    let labels = input.labels.as_ref().filter(|l| l.iter().any(|l| matches!(l, LabelChoice::Name(_))))?;
    let Companion { path, names } = companion(volume)?;
    let mut is_changed = false;
    let mut numbers = Vec::new();
    for label in labels {
        let of_name = |name: &str| names.iter().filter(|(_, own)| are_one_name(own, name)).map(|(&n, _)| n).collect();
        let found: Vec<u32> = if let LabelChoice::Name(name) = label { of_name(name) } else { Vec::new() };
        if let (LabelChoice::Name(name), false) = (label, found.is_empty()) {
            let listed: Vec<String> = found.iter().map(u32::to_string).collect();
            note(&format!("{name:?} is label {} by {}", listed.join(", "), path.display()));
            is_changed = true;
            numbers.extend(found.into_iter().map(LabelChoice::Number));
        } else {
            numbers.push(label.clone());
        }
    }
    is_changed.then_some(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_kinds_of_tables_are_read_and_other_lines_are_not() {
        let snap = "# ITK-SnAP Label Description File\n    0     0    0    0        0  0  0    \"Clear Label\"\n\
                    \x20   1   255    0    0        1  1  1    \"CA1\"\n    8  255 0 0 0.5 1 1 \"Left ERC\"\n";
        let expected = BTreeMap::from([(1, "CA1".to_owned()), (8, "Left ERC".to_owned())]);
        assert_eq!(table(snap), expected);
        let slicer =
            "# Color table file out.ctbl\n# 3 values\n0 Background 0 0 0 0\n17 Left-Hippocampus 220 216 20 255\n";
        assert_eq!(table(slicer), BTreeMap::from([(17, "Left-Hippocampus".to_owned())]));
        assert_eq!(table("17 apples and pears\n1,2,3\n17\n-3 a 1 1 1 1\n"), BTreeMap::new());
    }

    #[test]
    fn the_file_beside_a_volume_is_found_by_the_name_of_the_volume() {
        let folder = tempfile::tempdir().unwrap();
        let volume = folder.path().join("sub-1.nii.gz");
        assert_eq!(companion(&volume), None);
        fs::write(folder.path().join("snaplabels.txt"), "1 255 0 0 1 1 1 \"CA1\"\n").unwrap();
        assert_eq!(companion(&volume).unwrap().names[&1], "CA1");
        fs::write(folder.path().join("sub-1.ctbl"), "2 CA2 255 0 0 255\n").unwrap();
        assert_eq!(companion(&volume).unwrap().names, BTreeMap::from([(2, "CA2".to_owned())]));
        assert_eq!(companion(&folder.path().join("mesh.ply")), None);
        let input = |label: &str| InputParameters {
            labels: Some(vec![LabelChoice::Name(label.to_owned()), LabelChoice::Number(9)]),
            ..homolog_contract::parameters::preset(homolog_contract::parameters::Method::Balanced).input
        };
        assert_eq!(numbers(&input("ca2"), &volume), Some(vec![LabelChoice::Number(2), LabelChoice::Number(9)]));
        assert_eq!(numbers(&input("ca3"), &volume), None);
    }
}
