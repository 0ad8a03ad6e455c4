//! Variables of whole subjects whose effects are tested: sizes of the subject, of its labels and of its structures, and
//! the relative poses of structures.

use crate::subjects::{RelativePose, StructureFindings, SubjectFindings};
use std::collections::BTreeSet;

/// The name and unit of each variable, and its value for every row. A variable that a row does not have is left out.
pub(crate) fn variables(rows: &[&SubjectFindings]) -> Vec<(String, Vec<f64>)> {
    let rows = || rows.iter();
    let mut variables: Vec<(String, Vec<f64>)> = Vec::new();
    let mut add = |name: String, values: Option<Vec<f64>>| variables.extend(values.map(|values| (name, values)));
    add("volume, mm³".to_owned(), rows().map(|s| s.facts.volume_mm3).collect());
    add("area, mm²".to_owned(), Some(rows().map(|s| s.facts.area_mm2).collect()));
    add("centroid size, mm".to_owned(), Some(rows().map(|s| s.size_mm).collect()));
    let labels: BTreeSet<u32> = rows().flat_map(|subject| subject.labels.keys().copied()).collect();
    for label in labels {
        add(
            format!("volume of label {label}, mm³"),
            rows().map(|s| s.labels.get(&label).and_then(|l| l.volume_mm3)).collect(),
        );
        add(format!("area of label {label}, mm²"), rows().map(|s| s.labels.get(&label).map(|l| l.area_mm2)).collect());
    }
    for (k, StructureFindings { name, .. }) in
        rows().next().iter().flat_map(|first| first.structures.iter().enumerate())
    {
        let of = |value: &dyn Fn(&StructureFindings) -> Option<f64>| -> Option<Vec<f64>> {
            rows().map(|s| value(s.structures.get(k)?)).collect()
        };
        let pose = |value: &dyn Fn(&RelativePose) -> f64| of(&|structure| structure.pose.as_ref().map(value));
        add(format!("volume of {name}, mm³"), of(&|structure| structure.facts.volume_mm3));
        add(format!("area of {name}, mm²"), of(&|structure| Some(structure.facts.area_mm2)));
        for (axis, word) in ["x", "y", "z"].into_iter().enumerate() {
            add(format!("shift of {name} along {word}, mm"), pose(&|pose| pose.shift_mm[axis]));
        }
        add(format!("rotation of {name}, degrees"), pose(&|pose| pose.rotation_degrees));
    }
    variables
}
