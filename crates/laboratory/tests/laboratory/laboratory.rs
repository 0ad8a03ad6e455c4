//! The committed fixtures equal what the phantoms generate; with `UPDATE_FIXTURES=1` the test rewrites them.

use homolog_formats::{FileContent, ReadLimits, read, write_nifti, write_nifti_gz, write_ply, write_stl, write_vtk};
use homolog_laboratory::phantom::Phantom;
use homolog_mesh::volume::LabelVolume;
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Matrix4, Point3, Vector3};

/// Edge length of the surfaces, mm: coarse, so that the files are small.
const EDGE_MM: f64 = 2.5;
/// Maximum total size of the fixtures, bytes.
const MAX_BYTES: usize = 100_000;
/// Math libraries of different platforms may round the last bits of a coordinate differently.
const TOLERANCE_MM: f64 = 1e-5;

fn subject(seed: u64) -> LabelVolume {
    Phantom::new(seed).volume(1.0).unwrap().into_label_volume().unwrap()
}

/// A ring about the z axis, label 3, and an island beside it; the world axes are neither those of the grid nor of its
/// handedness.
fn ring() -> LabelVolume {
    let dims = [24, 20, 12];
    let label = |k: usize| {
        let [x, y, z] = [k % 24, k / 24 % 20, k / 480].map(|c| c as f64);
        let ring = ((x - 9.5).hypot(y - 9.5) - 5.5).hypot(z - 5.5) < 2.6;
        let island = x > 20.0 && x < 23.0 && (y - 9.5).abs() < 2.0 && (z - 5.5).abs() < 2.0;
        if ring || island { 3 } else { 0 }
    };
    let affine = Matrix4::new(
        0.0, -1.0, 0.0, 12.0, //
        -0.8, 0.0, 0.6, -7.5, //
        0.6, 0.0, 0.8, 3.0, //
        0.0, 0.0, 0.0, 1.0,
    );
    LabelVolume::new(dims, (0..24 * 20 * 12).map(label).collect(), affine).unwrap()
}

/// A coarse surface and a small tetrahedron beside it, both with separate vertices for every face.
fn unwelded() -> SurfaceMesh {
    let mesh = Phantom::new(1).surface(3.5).unwrap().mesh;
    let mut vertices: Vec<_> = mesh.triangles().into_iter().flatten().map(|v| mesh.vertices()[v as usize]).collect();
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
    let shift = Vector3::new(40.0, 0.0, 0.0);
    vertices.extend([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3].map(|k: usize| corners[k] + shift));
    let n = vertices.len() as u32;
    SurfaceMesh::new(vertices, FaceArity::Triangle, (0..n).collect()).unwrap()
}

fn all() -> Vec<(&'static str, Vec<u8>)> {
    let surface = Phantom::new(1).surface(EDGE_MM).unwrap().mesh;
    vec![
        ("subject-1.nii.gz", write_nifti_gz(&subject(1))),
        ("subject-2.nii.gz", write_nifti_gz(&subject(2))),
        ("ring.nii.gz", write_nifti_gz(&ring())),
        ("surface-1.ply", write_ply(&surface)),
        ("surface-1.stl", write_stl(&surface)),
        ("surface-1.vtk", write_vtk(&surface)),
        ("unwelded-1.vtk", write_vtk(&unwelded())),
    ]
}

fn content(bytes: &[u8]) -> FileContent {
    read(bytes, None, &ReadLimits::default()).unwrap().content
}

#[test]
fn fixtures_are_what_the_phantoms_generate() {
    let files = all();
    if std::env::var_os("UPDATE_FIXTURES").is_some() {
        for (name, bytes) in &files {
            std::fs::write(crate::fixtures::folder().join(name), bytes).unwrap();
        }
    }
    let mut n_bytes = 0;
    for (name, bytes) in &files {
        let committed = crate::fixtures::fixture(name);
        n_bytes += committed.len();
        match (content(&committed), content(bytes)) {
            (FileContent::Labels(committed), FileContent::Labels(made)) => {
                // Compared uncompressed, so that the version of the compressor makes no difference.
                assert!(write_nifti(&committed) == write_nifti(&made), "{name} has different voxels");
            }
            (FileContent::Mesh(committed), FileContent::Mesh(made)) => {
                assert_eq!(committed.mesh.indices(), made.mesh.indices(), "{name} has different faces");
                let pairs = committed.mesh.vertices().iter().zip(made.mesh.vertices());
                let farthest = pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
                assert!(farthest < TOLERANCE_MM, "{name}: a vertex moved by {farthest} mm");
            }
            _ => panic!("{name} has another format"),
        }
    }
    assert!(n_bytes < MAX_BYTES, "the fixtures have {n_bytes} bytes");
}
