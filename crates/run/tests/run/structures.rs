//! The prior learned from hippocampi applies to hippocampi alone: on phantoms, and on real left and right structures of
//! another atlas.

use crate::fixtures::{fixture, real};
use homolog_contract::parameters::{MatchParameters, resolve};
use homolog_contract::result::ResultDocument;
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, run_match};
use serde_json::json;

/// The default match of two surfaces of either handedness.
fn matched(source: &[u8], target: &[u8], anatomy: &str) -> ResultDocument {
    let parameters = resolve(&json!({
        "input": { "repair": ["weld", "largest_component"] },
        "registration": { "allow_reflection": true },
        "displacement": { "anatomy": anatomy },
    }))
    .unwrap();
    run(source, target, &parameters)
}

fn run(source: &[u8], target: &[u8], parameters: &MatchParameters) -> ResultDocument {
    let file = |bytes| InputFile { bytes, name: None };
    run_match(file(source), file(target), parameters, &IntakeLimits::default(), &Silent).unwrap().document
}

#[test]
fn without_a_recognized_anatomy_the_answer_is_that_without_the_prior() {
    for [source, target] in [["subject-1.nii.gz", "subject-2.nii.gz"], ["ring.nii.gz", "subject-1.nii.gz"]] {
        let [with, without] = ["hippocampus", "any"].map(|anatomy| {
            let parameters = resolve(&json!({ "displacement": { "anatomy": anatomy } })).unwrap();
            run(&fixture(source), &fixture(target), &parameters)
        });
        assert_eq!(with.anatomy, None, "{source} on {target}");
        assert_eq!((with.transform, with.correspondences), (without.transform, without.correspondences));
    }
}

mod real_data {
    use super::*;

    fn structure(name: &str) -> Vec<u8> {
        std::fs::read(real(&format!("structures/{name}.vtk"))).unwrap()
    }

    /// The prior is used on `source` and `target`, and moves corresponding points but not the pose.
    fn check_recognized(source: &[u8], target: &[u8]) {
        let with = matched(source, target, "hippocampus");
        let anatomy = with.anatomy.expect("two hippocampi are recognized");
        assert!(anatomy.slide_mm > 0.0 && anatomy.slide_mm < 3.0, "{anatomy:?}");
        let without = matched(source, target, "any");
        assert_eq!(without.anatomy, None);
        assert_eq!(with.transform, without.transform, "the prior moves corresponding points, not the pose");
        assert_ne!(with.correspondences, without.correspondences);
    }

    #[test]
    #[ignore = "needs real data (structures)"]
    fn hippocampi_are_recognized_whatever_their_side() {
        check_recognized(&structure("Model_17_left_hippocampus"), &structure("Model_53_right_hippocampus"));
    }

    #[test]
    #[ignore = "needs real data (structures)"]
    fn the_prior_is_not_used_on_other_structures() {
        for [source, target] in [
            ["Model_12_left_putamen", "Model_51_right_putamen"],
            ["Model_11_left_caudate_nucleus", "Model_17_left_hippocampus"],
            ["Model_18_left_amygdala", "Model_53_right_hippocampus"],
        ] {
            let found = matched(&structure(source), &structure(target), "hippocampus");
            assert_eq!(found.anatomy, None, "{source} on {target}");
        }
    }
}
