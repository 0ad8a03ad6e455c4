//! Left and right structures of another atlas, matched with the default parameters.

use crate::fixtures::real;
use homolog_contract::parameters::resolve;
use homolog_contract::result::{ResultDocument, UnreliableReason};
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, run_match};
use serde_json::json;

mod real_data {
    use super::*;

    fn matched(source: &str, target: &str) -> ResultDocument {
        let read = |name: &str| std::fs::read(real(&format!("structures/{name}.vtk"))).unwrap();
        let (source, target) = (read(source), read(target));
        let parameters = resolve(&json!({
            "input": { "repair": ["weld", "largest_component"] },
            "registration": { "allow_reflection": true },
        }))
        .unwrap();
        let file = |bytes| InputFile { bytes, name: None };
        run_match(file(&source), file(&target), &parameters, &IntakeLimits::default(), &Silent).unwrap().document
    }

    #[test]
    #[ignore = "needs real data (structures)"]
    fn the_two_sides_of_a_structure_are_matched_by_a_reflection() {
        let found = matched("Model_17_left_hippocampus", "Model_53_right_hippocampus");
        let reliability = found.reliability.unwrap();
        assert!(!reliability.reasons.contains(&UnreliableReason::UnlikeShape), "{reliability:?}");
        let mirrored = found.poses.first().unwrap().mirrored;
        assert!(mirrored, "the best pose does not mirror");
    }
}
