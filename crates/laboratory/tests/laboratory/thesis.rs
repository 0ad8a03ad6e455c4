//! Phantoms matched by the preset `thesis`: labels and poses are found, by feedback from a minority of inliers.

use homolog_contract::parameters::{Method, preset};
use homolog_contract::result::Feedback;
use homolog_laboratory::phantom::{PairRecipe, PhantomPair};
use homolog_matching::{MatchOutcome, SurfaceMesh, match_surfaces};
use homolog_primitives::observe::Silent;
use homolog_registration::{RigidTransform, absolute_orientation};
use nalgebra::Point3;

/// Mean edge of the source, mm: about 800 vertices. The target is a tenth coarser, so that no vertex has an exact counterpart.
const EDGE_MM: f64 = 1.4;

/// A phantom and its copy, deformed by 4 % of the diagonal, rotated and sampled anew; for every source vertex its place on the copy.
fn deformed_copy(subject: u64) -> (SurfaceMesh, SurfaceMesh, Vec<Point3<f64>>) {
    let pair = PhantomPair::new(PairRecipe {
        subject,
        target_subject: subject,
        deform_share: 0.04,
        deform_seed: 40 + subject,
        pose_seed: Some(60 + subject),
        permute_seed: Some(80 + subject),
    })
    .unwrap();
    let source = pair.source_surface(EDGE_MM).unwrap().mesh;
    let target = pair.target_surface(1.1 * EDGE_MM).unwrap().0.mesh;
    let truth = source.vertices().iter().map(|p| pair.place(p)).collect();
    (source, target, truth)
}

fn matched(source: &SurfaceMesh, target: &SurfaceMesh, method: Method) -> MatchOutcome {
    match_surfaces(source, target, &preset(method), &Silent).unwrap()
}

fn degrees_off(outcome: &MatchOutcome, source: &SurfaceMesh, truth: &[Point3<f64>]) -> f64 {
    let pose = absolute_orientation(source.vertices(), truth, None, false).unwrap();
    RigidTransform::of_matrix(&outcome.transform.matrix).angle_to(&pose).to_degrees()
}

#[test]
fn thesis_finds_labels_and_poses_of_deformed_copies() {
    for subject in 1..=3 {
        let (source, target, truth) = deformed_copy(subject);
        let found = matched(&source, &target, Method::Thesis);
        let c = &found.correspondences;
        let reach = 3.0 * target.mean_edge_length();
        let near = |(i, x): &(&u32, &u32)| (truth[**i as usize] - target.vertices()[**x as usize]).norm() <= reach;
        let right = c.source.iter().zip(&c.target).filter(near).count();
        assert!(10 * right >= 8 * c.source.len(), "subject {subject}: {right} of {}", c.source.len());
        let off = degrees_off(&found, &source, &truth);
        assert!(off < 10.0, "subject {subject}: {off} degrees");
        // Clamping turns a minority of inliers into a majority, and the rounds say so.
        let (before, after) = (&found.rounds[0], found.rounds.iter().find(|round| round.chosen).unwrap());
        assert_eq!(before.feedback, Feedback::None);
        assert!(after.support > before.support && 2 * after.support as usize > c.source.len(), "{:?}", found.rounds);
    }
}
