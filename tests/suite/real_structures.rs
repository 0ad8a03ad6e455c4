//! What is known of one structure is used for it alone: real left and right structures of another atlas.

use crate::real_data::real;
use homolog_contract::parameters::resolve;
use homolog_contract::result::ResultDocument;
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, run_match};
use serde_json::json;

/// The default match of two surfaces of the folder, of either handedness; `None` where the folder is absent.
fn matched(source: &str, target: &str, anatomy: &str) -> Option<ResultDocument> {
    let [source, target] = [source, target].map(|name| real(&format!("structures/{name}.vtk")));
    let (source, target) = (std::fs::read(source?).unwrap(), std::fs::read(target?).unwrap());
    let parameters = resolve(&json!({
        "input": { "repair": ["weld", "largest_component"] },
        "registration": { "allow_reflection": true },
        "displacement": { "anatomy": anatomy },
    }))
    .unwrap();
    let file = |bytes| InputFile { bytes, name: None };
    let output = run_match(file(&source), file(&target), &parameters, &IntakeLimits::default(), &Silent).unwrap();
    Some(output.document)
}

#[test]
fn hippocampi_are_known_as_such_whatever_their_side() {
    let pair = ["Model_17_left_hippocampus", "Model_53_right_hippocampus"];
    let Some(known) = matched(pair[0], pair[1], "hippocampus") else { return };
    let anatomy = known.anatomy.expect("two hippocampi are known");
    assert!(anatomy.slide_mm > 0.0 && anatomy.slide_mm < 3.0, "{anatomy:?}");
    let unknown = matched(pair[0], pair[1], "any").unwrap();
    assert_eq!(unknown.anatomy, None);
    assert_eq!(known.transform, unknown.transform, "what slides are the images, not the pose");
    assert_ne!(known.correspondences, unknown.correspondences);
}

#[test]
fn other_structures_are_left_alone() {
    for [source, target] in [
        ["Model_12_left_putamen", "Model_51_right_putamen"],
        ["Model_11_left_caudate_nucleus", "Model_17_left_hippocampus"],
        ["Model_18_left_amygdala", "Model_53_right_hippocampus"],
    ] {
        let Some(found) = matched(source, target, "hippocampus") else { return };
        assert_eq!(found.anatomy, None, "{source} on {target}");
    }
}
