//! Every vertex index of an answer refers to the upload.

use super::{InputFile, run_match};
use crate::intake::IntakeLimits;
use homolog_contract::parameters::resolve;
use homolog_contract::result::Correspondences;
use homolog_formats::ply::write_ply;
use homolog_laboratory::phantom::PhantomPair;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Silent;
use nalgebra::Point3;
use serde_json::json;

fn correspondences(source: &SurfaceMesh, target: &SurfaceMesh) -> Correspondences {
    let files = [source, target].map(write_ply);
    let [source, target] = files.each_ref().map(|bytes| InputFile { bytes, name: None });
    let parameters = resolve(&json!({"both_directions": true})).unwrap();
    let output = run_match(source, target, &parameters, &IntakeLimits::default(), &Silent).unwrap();
    output.document.correspondences.unwrap()
}

/// `mesh` preceded by `n` unused vertices.
fn behind_unused(mesh: &SurfaceMesh, n: u32) -> SurfaceMesh {
    let mut vertices = vec![Point3::new(900.0, -50.0, 7.0); n as usize];
    vertices.extend(mesh.vertices());
    let indices = mesh.indices().iter().map(|&v| v + n).collect();
    SurfaceMesh::new(vertices, mesh.arity(), indices).unwrap()
}

fn shifted(columns: &Correspondences, source: u32, target: u32) -> Correspondences {
    let mut columns = columns.clone();
    columns.source.iter_mut().for_each(|v| *v += source);
    columns.target.iter_mut().for_each(|v| *v += target);
    columns.triangle.iter_mut().flatten().for_each(|v| *v += target);
    columns.inverse = columns.inverse.map(|inverse| Box::new(shifted(&inverse, target, source)));
    columns
}

#[test]
fn unused_vertices_in_front_shift_every_index_by_their_number() {
    let [source, target] = PhantomPair::against_template(0).unwrap().meshes(2.0).unwrap();
    let clean = correspondences(&source, &target);
    for (n_source, n_target) in [(0, 100), (37, 0), (37, 100)] {
        let found = correspondences(&behind_unused(&source, n_source), &behind_unused(&target, n_target));
        assert!(found == shifted(&clean, n_source, n_target), "{n_source} and {n_target} unused vertices");
    }
}
