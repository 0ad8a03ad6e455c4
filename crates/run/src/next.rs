//! The next step after an answer, in one or two sentences, for every method and verdict.

use homolog_contract::parameters::Method;
use homolog_contract::result::{ResultDocument, UnreliableReason};

/// The next step. Parameters have the names of requests; the command line replaces them by its options.
pub fn next_step(document: &ResultDocument) -> String {
    let verdict = document.verdict();
    let is_default = document.provenance.parameters.method == Method::Balanced;
    match verdict.reliable {
        Some(true) if is_default => {
            "Look at both surfaces in corresponding colors; where no color jumps, use this answer.".to_owned()
        }
        Some(true) => "Look at both surfaces in corresponding colors; where no color jumps, use this answer. The default method \
                       finds the same pose and correspondence."
            .to_owned(),
        Some(false) => {
            let mut steps: Vec<&str> = verdict.reasons.iter().map(|reason| reason.advice()).collect();
            if !is_default && !verdict.reasons.contains(&UnreliableReason::SecondOpinion) {
                steps.push("If both files are right, match again with the default method (method: balanced).");
            }
            steps.join(" ")
        }
        None if is_default => {
            "Judge by the picture: where colors jump, the answer is wrong. Check that both files show one structure in full.".to_owned()
        }
        None => "Match again with the default method (method: balanced), whose answer beside this one is the check; or judge by the \
                 picture: where colors jump, the answer is wrong."
            .to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intake::IntakeLimits;
    use crate::{InputFile, run_match};
    use homolog_contract::parameters::preset;
    use homolog_formats::ply::write_ply;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    #[test]
    fn every_method_and_verdict_has_a_next_step() {
        let file = write_ply(&ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2));
        let input = InputFile { bytes: &file, name: None };
        let found =
            run_match(input, input, &preset(Method::Rigid), &IntakeLimits::default(), &Silent).unwrap().document;
        for method in Method::ALL {
            let mut document = found.clone();
            document.provenance.parameters.method = method;
            document.warnings.clear();
            let is_default = method == Method::Balanced;
            document.reliability = None;
            let unchecked = next_step(&document);
            assert_eq!(unchecked.contains("method: balanced"), !is_default, "{method:?}: {unchecked}");
            document.reliability = found.reliability.clone();
            let checked = document.reliability.as_mut().unwrap();
            (checked.reliable, checked.reasons) = (true, Vec::new());
            let right = next_step(&document);
            assert!(
                right.contains("use this answer") && right.contains("default method") != is_default,
                "{method:?}: {right}"
            );
            for reason in [UnreliableReason::UnlikeShape, UnreliableReason::SecondOpinion, UnreliableReason::TooCoarse]
            {
                let checked = document.reliability.as_mut().unwrap();
                (checked.reliable, checked.reasons) = (false, vec![reason]);
                let wrong = next_step(&document);
                assert!(wrong.starts_with(reason.advice()), "{method:?}: {wrong}");
                assert_eq!(
                    wrong.contains("balanced"),
                    !is_default || reason == UnreliableReason::SecondOpinion,
                    "{wrong}"
                );
            }
        }
    }
}
