//! From files to surfaces that can be matched, or refusals that say where and why.

use crate::fixtures::fixture;
use homolog_contract::parameters::{InputParameters, LabelChoice, Method, Repair, SurfaceKind, preset};
use homolog_formats::{FormatError, write_nifti, write_nifti_gz, write_ply, write_stl, write_vtk};
use homolog_mesh::repair::reversed;
use homolog_mesh::topology::{Demand, analyze, analyze_with};
use homolog_mesh::volume::LabelVolume;
use homolog_mesh::{FaceArity, Numbering, SurfaceMesh, shapes};
use homolog_run::intake::{
    InputFormat, InputKind, IntakeError, IntakeLimits, PreparedSurface, inspect, prepare_surface,
};
use nalgebra::{Matrix4, Point3};
use proptest::prelude::*;

fn defaults() -> InputParameters {
    preset(Method::Balanced).input
}

fn prepare(bytes: &[u8], parameters: &InputParameters) -> Result<PreparedSurface, IntakeError> {
    prepare_surface(bytes, None, parameters, &IntakeLimits::default())
}

fn with_repair(repair: &[Repair]) -> InputParameters {
    InputParameters { repair: Some(repair.to_vec()), ..defaults() }
}

/// A volume of 20 x 16 x 12 voxels of 1 mm; `inside` sees millimeters from its middle.
fn volume(label: impl Fn([f64; 3]) -> u32) -> LabelVolume {
    let dims = [20, 16, 12];
    let place = |k: usize| [k % 20, k / 20 % 16, k / 320];
    let middle = |k: usize| [0, 1, 2].map(|a| place(k)[a] as f64 - (dims[a] as f64 - 1.0) / 2.0);
    let labels = (0..20 * 16 * 12).map(|k| label(middle(k))).collect();
    LabelVolume::new(dims, labels, Matrix4::identity()).unwrap()
}

fn ring([x, y, z]: [f64; 3]) -> u32 {
    u32::from(((x.hypot(y) - 5.0).hypot(z)) < 2.3)
}

fn ball(p: [f64; 3]) -> u32 {
    u32::from(p.iter().map(|c| c * c).sum::<f64>() < 25.0)
}

fn ball_mesh() -> SurfaceMesh {
    prepare(&write_nifti(&volume(ball)), &defaults()).unwrap().mesh
}

#[test]
fn a_ring_is_filled_by_default_and_keeps_its_tunnel_without() {
    for surface in [SurfaceKind::Smooth, SurfaceKind::Voxel] {
        let bytes = write_nifti_gz(&volume(ring));
        let parameters = InputParameters { surface, ..defaults() };
        let prepared = prepare(&bytes, &parameters).unwrap();
        assert_eq!(prepared.report.topology.genus, Some(1));
        assert_eq!(prepared.report.repairs.len(), 1, "{:?}", prepared.report.repairs);
        assert!(prepared.report.repairs[0].detail.starts_with("closed 1 tunnel and 0 cavities"));
        assert_eq!(analyze(&prepared.mesh).fault, None);
        let kept = prepare(&bytes, &InputParameters { repair: Some(vec![]), ..parameters }).unwrap();
        assert_eq!(analyze(&kept.mesh).report.genus, Some(1));
    }
}

#[test]
fn islands_are_dropped_by_default_and_kept_without() {
    let island = |p: [f64; 3]| ball(p) + u32::from(p[0] > 8.0 && p[1].abs() < 2.0 && p[2].abs() < 2.0);
    let bytes = write_nifti(&volume(island));
    let prepared = prepare(&bytes, &defaults()).unwrap();
    assert_eq!(prepared.report.topology.n_components, 2);
    assert_eq!(prepared.report.repairs[0].repair, Repair::LargestComponent);
    assert_eq!(prepared.mesh, ball_mesh());
    let kept = prepare(&bytes, &with_repair(&[Repair::Fill])).unwrap();
    assert_eq!(analyze(&kept.mesh).report.n_components, 2);
}

#[test]
fn labels_are_chosen_or_named() {
    let bytes = write_nifti(&volume(|p| ball(p) * if p[1] > 0.0 { 7 } else { 9 }));
    let both = prepare(&bytes, &defaults()).unwrap().mesh;
    assert_eq!(both, ball_mesh());
    let choose = |labels: &[u32]| {
        let labels = Some(labels.iter().copied().map(LabelChoice::Number).collect());
        prepare(&bytes, &InputParameters { labels, ..defaults() })
    };
    assert_eq!(choose(&[9, 7]).unwrap().mesh, both);
    let half = choose(&[7]).unwrap().mesh.signed_volume();
    assert!((half / both.signed_volume() - 0.5).abs() < 0.05);
    let error = choose(&[1, 2]).unwrap_err();
    assert_eq!(error.code(), "empty-structure");
    assert_eq!(
        error.to_string(),
        "no voxel has any of the labels [1, 2]; \
         the volume has the labels [7, 9]: set input.labels to those of the structure"
    );
    let empty = prepare(&write_nifti(&volume(|_| 0)), &defaults()).unwrap_err();
    assert_eq!(
        empty.to_string(),
        "no voxel has a label other than 0; all voxels are 0: send a volume in which the structure is labeled"
    );
    let speck = write_nifti(&volume(|p| u32::from(p.iter().all(|c| c.abs() < 1.0 && *c > 0.0))));
    let vanished = prepare(&speck, &InputParameters { smoothing_mm: Some(3.0), ..defaults() }).unwrap_err();
    assert_eq!(vanished.code(), "empty-structure");
    assert_eq!(
        vanished.to_string(),
        "smoothing by 3 mm leaves nothing of a structure of 1 voxel; \
         lower input.smoothing_mm, or set input.surface to \"voxel\""
    );
}

#[test]
fn a_split_mesh_is_welded_and_answers_in_its_own_numbering() {
    let whole = ball_mesh();
    // Every face with separate vertices, after one unused vertex.
    let mut vertices = vec![Point3::new(50.0, 0.0, 0.0)];
    vertices.extend(whole.indices().iter().map(|&v| whole.vertices()[v as usize]));
    let n = vertices.len() as u32;
    let split = SurfaceMesh::new(vertices, FaceArity::Triangle, (1..n).collect()).unwrap();
    let bytes = write_ply(&split);
    let closed = InputParameters { repair: Some(Vec::new()), allow_boundary: false, ..defaults() };
    let error = prepare(&bytes, &closed).unwrap_err();
    assert!(error.to_string().contains("joins vertices 1 and 2 near"), "{error}");
    assert!(error.to_string().ends_with("send the parameters {\"input\": {\"repair\": [\"weld\"]}}"), "{error}");
    let prepared = prepare(&bytes, &defaults()).unwrap();
    assert_eq!(prepared.mesh.n_vertices(), whole.n_vertices());
    for (v, &uploaded) in prepared.numbering.originals().iter().enumerate() {
        assert_eq!(prepared.mesh.vertices()[v], split.vertices()[uploaded as usize]);
    }
    assert_eq!(prepared.uploaded().vertices(), split.vertices());
    assert_eq!(prepared.report.repairs.len(), 1);
    assert!(prepare(&write_stl(&whole), &defaults()).is_ok(), "STL is welded on reading");
}

#[test]
fn a_good_mesh_passes_unchanged_and_an_inverted_one_is_reoriented() {
    let whole = ball_mesh();
    let prepared = prepare(&write_vtk(&whole), &defaults()).unwrap();
    assert_eq!((&prepared.mesh, prepared.uploaded()), (&whole, &whole));
    assert_eq!(prepared.numbering, Numbering::identity(whole.n_vertices()));
    assert!(prepared.report.repairs.is_empty() && !prepared.report.turned_outward);
    let outward = prepare(&write_vtk(&reversed(&whole)), &defaults()).unwrap();
    assert_eq!(outward.mesh, whole);
    assert!(outward.report.turned_outward && outward.report.topology.volume_mm3.unwrap() < 0.0);
}

#[test]
fn holes_are_refused_on_request_and_twists_are_mended() {
    let whole = ball_mesh();
    let open = SurfaceMesh::new(whole.vertices().to_vec(), FaceArity::Triangle, whole.indices()[3..].to_vec()).unwrap();
    assert_eq!(prepare(&write_ply(&open), &defaults()).unwrap().mesh.n_faces(), whole.n_faces() - 1);
    let closed = InputParameters { allow_boundary: false, ..defaults() };
    let error = prepare(&write_ply(&open), &closed).unwrap_err();
    assert_eq!((error.code(), error.topology().unwrap().n_boundary_edges), ("unsuitable-surface", 3));
    assert!(error.to_string().contains("3 edges have only one face"), "{error}");
    let mut twisted = whole.indices().to_vec();
    twisted.swap(0, 1);
    let twisted = SurfaceMesh::new(whole.vertices().to_vec(), FaceArity::Triangle, twisted).unwrap();
    let error = prepare(&write_ply(&twisted), &with_repair(&[Repair::Weld])).unwrap_err();
    assert!(error.to_string().contains("3 edges lie between faces of opposite orientation"), "{error}");
    assert!(error.to_string().ends_with("send the parameters {\"input\": {\"repair\": [\"orient\"]}}"), "{error}");
    let mended = prepare(&write_ply(&twisted), &defaults()).unwrap();
    assert_eq!((analyze(&mended.mesh).fault, mended.mesh.signed_volume()), (None, whole.signed_volume()));
    assert_eq!(mended.report.repairs[0].detail, "1 face reversed");
}

#[test]
fn a_surface_of_any_topology_is_accepted_and_one_without_an_inside_is_refused() {
    let torus = shapes::torus(8.0, 3.0, 24, 12, FaceArity::Triangle);
    assert_eq!(prepare(&write_ply(&torus), &defaults()).unwrap().mesh, torus);
    // Two pieces, and a wall between two vertices of the first, at edges that have two faces already.
    let ball = ball_mesh();
    let mut vertices = ball.vertices().to_vec();
    vertices.extend(torus.vertices().iter().map(|p| p + nalgebra::Vector3::x() * 40.0));
    let mut faces = ball.indices().to_vec();
    faces.extend(torus.indices().iter().map(|v| v + ball.n_vertices() as u32));
    let [a, b] = [ball.indices()[0], ball.indices()[1]];
    faces.extend([a, b, (ball.n_vertices() / 2) as u32]);
    let mixed = SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap();
    let prepared = prepare(&write_ply(&mixed), &defaults()).unwrap();
    assert_eq!(prepared.mesh.n_faces(), mixed.n_faces());
    assert_eq!((prepared.report.topology.n_components, prepared.report.topology.n_nonmanifold_edges), (2, 1));
    // A Moebius strip of one row of faces.
    let n = 12u32;
    let around = |k: u32| std::f64::consts::TAU * f64::from(k / 2) / f64::from(n);
    let across = |k: u32| if k.is_multiple_of(2) { -1.0 } else { 1.0 };
    let vertex = |k: u32| {
        let (angle, side) = (around(k), across(k));
        let radius = 5.0 + side * (angle / 2.0).cos();
        Point3::new(radius * angle.cos(), radius * angle.sin(), side * (angle / 2.0).sin())
    };
    let strip: Vec<u32> = (0..n)
        .flat_map(|i| {
            let (a, b) = (2 * i, 2 * ((i + 1) % n));
            let (c, d) = if i + 1 == n { (b + 1, b) } else { (b, b + 1) };
            [a, c, d, a, d, a + 1]
        })
        .collect();
    let strip = SurfaceMesh::new((0..2 * n).map(vertex).collect(), FaceArity::Triangle, strip).unwrap();
    let error = prepare(&write_ply(&strip), &defaults()).unwrap_err();
    assert!(error.to_string().contains("faces of opposite orientation"), "{error}");
}

#[test]
fn faces_that_name_a_vertex_twice_are_dropped() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
        element face 5\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n\
        3 0 2 1\n3 0 1 3\n3 1 1 2\n3 0 3 2\n3 1 2 3\n";
    let error = prepare(ply.as_bytes(), &with_repair(&[])).unwrap_err();
    assert_eq!(error.code(), "unsuitable-surface");
    assert_eq!(
        error.to_string(),
        "1 face uses a vertex twice; the first is face 2 with vertex 1 (both counted from 0) at (1.00, 0.00, 0.00) mm; \
         to have this repaired, send the parameters {\"input\": {\"repair\": [\"weld\"]}}"
    );
    let prepared = prepare(ply.as_bytes(), &defaults()).unwrap();
    assert_eq!(prepared.mesh.n_faces(), 4);
    let detail = "0 of 4 vertices joined to another; 1 face that uses a vertex twice and 0 repeated \
                  faces dropped";
    assert_eq!(prepared.report.repairs[0].detail, detail);
}

#[test]
fn limits_are_kept() {
    let bytes = write_nifti_gz(&volume(ball));
    let limited = |limits| prepare_surface(&bytes, None, &defaults(), &limits).unwrap_err().code();
    let open = IntakeLimits::default();
    assert_eq!(limited(IntakeLimits { max_bytes: 100, ..open }), "too-large");
    assert_eq!(limited(IntakeLimits { max_inflated_bytes: 1000, ..open }), "too-large");
    assert_eq!(limited(IntakeLimits { max_vertices: 10, ..open }), "too-large");
    assert_eq!(limited(IntakeLimits { max_vertices: 300, ..open }), "too-large");
    assert_eq!(prepare(b"nothing", &defaults()).unwrap_err(), IntakeError::UnknownFormat);
    let cut = prepare(&bytes[..bytes.len() / 2], &defaults()).unwrap_err();
    assert!(matches!(cut, IntakeError::Unreadable(FormatError::Gzip { .. })), "{cut:?}");
}

#[test]
fn inspection_tells_what_preparation_would_do() {
    let bytes = write_nifti(&volume(|p| ring(p) * 4));
    let limits = IntakeLimits::default();
    let seen = inspect(&bytes, None, &defaults(), &limits).unwrap();
    let volume = seen.volume.unwrap();
    assert_eq!((seen.format, seen.kind, seen.suitable), (InputFormat::Nifti, InputKind::LabelVolume, true));
    assert_eq!((volume.dims, volume.spacing_mm, volume.labels[0].label), ([20, 16, 12], [1.0; 3], 4));
    assert_eq!((seen.topology.unwrap().genus, seen.repaired_topology.unwrap().genus), (Some(1), Some(0)));
    let kept = inspect(&bytes, None, &with_repair(&[]), &limits).unwrap();
    assert_eq!((kept.suitable, kept.repaired_topology.unwrap().genus), (true, Some(1)));
    let face =
        SurfaceMesh::new(ball_mesh().vertices().to_vec(), FaceArity::Triangle, ball_mesh().indices()[..3].to_vec());
    let closed = InputParameters { allow_boundary: false, ..defaults() };
    let refused = inspect(&write_ply(&face.unwrap()), None, &closed, &limits).unwrap();
    assert_eq!((refused.suitable, refused.refusal.unwrap().code.as_str()), (false, "unsuitable-surface"));
    let none = InputParameters { labels: Some(vec![LabelChoice::Number(1)]), ..defaults() };
    let empty = inspect(&bytes, None, &none, &limits).unwrap();
    assert_eq!((empty.topology, empty.refusal.unwrap().code.as_str()), (None, "empty-structure"));
}

#[test]
fn phantom_volumes_become_closed_surfaces_of_genus_0() {
    for surface in [SurfaceKind::Smooth, SurfaceKind::Voxel] {
        let parameters = InputParameters { surface, ..defaults() };
        for (name, genus) in [("subject-1.nii.gz", 0), ("subject-2.nii.gz", 0), ("ring.nii.gz", 1)] {
            let prepared = prepare(&fixture(name), &parameters).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(analyze(&prepared.mesh).fault, None, "{name}");
            if surface == SurfaceKind::Smooth {
                // The boundary of the voxels themselves is rarely a manifold before its repair.
                assert_eq!(prepared.report.topology.genus, Some(genus), "{name}");
            }
            assert!(prepared.mesh.signed_volume() > 0.0, "{name}");
        }
    }
}

#[test]
fn an_unwelded_surface_is_welded() {
    check_unwelded(&fixture("unwelded-1.vtk"));
}

/// Faces with vertices of their own, and several pieces: what programs that extract surfaces often write.
fn check_unwelded(bytes: &[u8]) {
    let closed = InputParameters { allow_boundary: false, ..with_repair(&[]) };
    let error = prepare(bytes, &closed).unwrap_err().to_string();
    assert!(error.contains("{\"repair\": [\"weld\""), "{error}");
    let prepared = prepare(bytes, &InputParameters { allow_boundary: false, ..defaults() }).unwrap();
    assert_eq!(prepared.numbering.n_vertices(), prepared.mesh.n_vertices());
    // The surface that goes with the answer has the file's numbering.
    let uploaded = prepared.uploaded();
    for (p, &k) in prepared.mesh.vertices().iter().zip(prepared.numbering.originals()) {
        assert_eq!(&uploaded.vertices()[k as usize], p);
    }
    assert_eq!(uploaded.n_faces(), prepared.mesh.n_faces());
}

mod real_data {
    use super::*;
    use crate::fixtures::{real, real_files};

    #[test]
    #[ignore = "needs real data (hippocampus)"]
    fn every_hippocampus_becomes_a_closed_surface_of_genus_0() {
        for surface in [SurfaceKind::Smooth, SurfaceKind::Voxel] {
            let parameters = InputParameters { surface, ..defaults() };
            let mut changed = Vec::new();
            let mut vertices = Vec::new();
            let mut faults = 0;
            for path in real_files("hippocampus") {
                let bytes = std::fs::read(&path).unwrap();
                let prepared = prepare(&bytes, &parameters).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
                assert_eq!(analyze(&prepared.mesh).fault, None, "{}", path.display());
                faults += usize::from(prepared.report.topology.genus != Some(0));
                vertices.push(prepared.mesh.n_vertices());
                let numbers = |detail: &str| -> usize {
                    detail.rsplit(';').next().unwrap().split(' ').filter_map(|w| w.parse::<usize>().ok()).sum()
                };
                let fills = prepared.report.repairs.iter().filter(|r| r.repair == Repair::Fill);
                changed.push(fills.map(|r| numbers(&r.detail)).sum::<usize>());
            }
            changed.sort_unstable();
            vertices.sort_unstable();
            let n = changed.len();
            println!(
                "{surface:?}: {n} files, {faults} faulty before repair, {} filled; voxels changed median {} max {}; \
                 vertices {} to {}, median {}",
                changed.iter().filter(|&&c| c > 0).count(),
                changed[n / 2],
                changed[n - 1],
                vertices[0],
                vertices[n - 1],
                vertices[n / 2]
            );
        }
    }

    #[test]
    #[ignore = "needs real data (structures)"]
    fn unwelded_structures_are_welded() {
        check_unwelded(&std::fs::read(real("structures/Model_17_left_hippocampus.vtk")).unwrap());
    }
}

/// Once, a spacing of 1e-30 mm made the smoothing filter as wide as numbers go, and reading never ended.
#[test]
fn voxels_of_no_anatomical_size_are_refused_at_once() {
    for spacing in [1e-30, 1e-5, 2e5, 1e30] {
        let mut affine = nalgebra::Matrix4::identity();
        affine[(1, 1)] = spacing;
        let refused = LabelVolume::new([1, 1, 1], vec![1], affine).unwrap_err();
        assert!(refused.to_string().contains("smaller than 0.0001 mm or larger than 100000 mm"), "{refused}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn damaged_files_neither_panic_nor_hang(
        which in 0..3usize, flips in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..5), head: bool,
    ) {
        let small = SurfaceMesh::new(
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from).to_vec(),
            FaceArity::Triangle,
            vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
        )
        .unwrap();
        let mut bytes = [write_nifti(&volume(ring)), write_ply(&small), write_stl(&small)][which].clone();
        for (at, value) in flips {
            let at = at.index(if head { bytes.len().min(348) } else { bytes.len() });
            bytes[at] = value;
        }
        let all = with_repair(&[Repair::Weld, Repair::Orient, Repair::LargestComponent, Repair::Fill]);
        if let Ok(prepared) = prepare(&bytes, &all) {
            prop_assert_eq!(analyze_with(&prepared.mesh, Demand::Any).fault, None);
        }
    }
}
