//! Every kind of vertex feature in an energy: free of the unit of length, the same on any number of threads, and of some use.

use homolog_contract::parameters::{FeatureKind, FeatureParameters, MatchParameters, Method, Precisions, preset};
use homolog_matching::{SurfaceMesh, energy_model, shapes};
use homolog_mesh::canonicalize;
use nalgebra::{Isometry3, Point3, Vector3};

/// A bent and tapered ellipsoid without symmetry.
fn bean() -> SurfaceMesh {
    let mesh = shapes::ellipsoid(Vector3::new(18.0, 8.0, 6.0), 3);
    let bent = |p: &Point3<f64>| {
        let taper = 1.0 - 0.015 * p.x;
        Point3::new(p.x, p.y * taper + 0.02 * p.x * p.x, p.z * taper + 0.6 * (0.3 * p.x).sin())
    };
    mesh.with_vertices(mesh.vertices().iter().map(bent).collect()).unwrap()
}

/// A deformation of `mesh`, moved rigidly: vertex `i` corresponds to vertex `i`.
fn deformed(mesh: &SurfaceMesh) -> SurfaceMesh {
    let motion = Isometry3::new(Vector3::new(30.0, -7.0, 4.0), Vector3::new(0.4, 1.9, -0.7));
    let moved =
        |p: &Point3<f64>| motion * (p + 0.5 * Vector3::new((0.2 * p.y).sin(), (0.25 * p.x).sin(), (0.3 * p.x).cos()));
    mesh.with_vertices(mesh.vertices().iter().map(moved).collect()).unwrap()
}

fn scaled(mesh: &SurfaceMesh, factor: f64) -> SurfaceMesh {
    mesh.with_vertices(mesh.vertices().iter().map(|p| p * factor).collect()).unwrap()
}

fn parameters(kinds: &[FeatureKind], precisions: Precisions) -> MatchParameters {
    let mut parameters = preset(Method::Balanced);
    let like = parameters.features[0].clone();
    parameters.features = kinds.iter().map(|&kind| FeatureParameters { kind, ..like.clone() }).collect();
    parameters.energy.precisions = precisions;
    parameters
}

/// The requests: each kind alone, and eight together with learned precisions.
fn requests() -> Vec<MatchParameters> {
    let mut all: Vec<_> = FeatureKind::ALL.iter().map(|kind| parameters(&[*kind], Precisions::Equal)).collect();
    all.push(parameters(&FeatureKind::ALL[2..], Precisions::Learned));
    all
}

#[test]
fn scaling_by_a_power_of_two_and_the_number_of_threads_change_no_potential() {
    let mesh = bean();
    let pair = [mesh.clone(), deformed(&mesh)];
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for parameters in requests() {
        let unary = |factor: f64| {
            let [source, target] = pair.each_ref().map(|mesh| scaled(mesh, factor));
            energy_model(&source, &target, &parameters).unwrap().unary
        };
        let expected = unary(1.0);
        let kinds: Vec<_> = parameters.features.iter().map(|f| f.kind.name()).collect();
        for power in [-10, 7] {
            assert!(expected == unary(2f64.powi(power)), "{kinds:?} at 2^{power}");
        }
        assert!(expected == alone.install(|| unary(1.0)), "{kinds:?} on one thread");
    }
}

#[test]
fn every_kind_ranks_true_labels_before_others() {
    let mesh = bean();
    let target = deformed(&mesh);
    // Variables and labels are in canonical numbering.
    let numbers = |mesh: &SurfaceMesh| canonicalize(mesh).numbering.originals().to_vec();
    let (of_source, of_target) = (numbers(&mesh), numbers(&target));
    let mut label = vec![0; of_target.len()];
    of_target.iter().enumerate().for_each(|(x, &original)| label[original as usize] = x);
    for parameters in requests() {
        let model = energy_model(&mesh, &target, &parameters).unwrap();
        let worse = |i: usize| {
            let row = model.unary_row(i);
            let truth = row[label[of_source[i] as usize]];
            row.iter().filter(|theta| **theta > truth).count() as f64 / row.len() as f64
        };
        let mean = (0..of_source.len()).map(worse).sum::<f64>() / of_source.len() as f64;
        let kinds: Vec<_> = parameters.features.iter().map(|f| f.kind.name()).collect();
        println!("{kinds:?}: {:.1} % of labels are worse than the true one", 100.0 * mean);
        assert!(mean > 0.7, "{kinds:?}: {mean}");
    }
}
