//! Labels chosen by name and for each side, refusals that name everything at once, and a table of every file of the field's
//! own tools.

use homolog_contract::parameters::{InputParameters, Method, Repair, preset, resolve};
use homolog_formats::{InputFormat, write_nifti, write_ply};
use homolog_laboratory::phantom::PhantomPair;
use homolog_mesh::volume::LabelVolume;
use homolog_mesh::{FaceArity, SurfaceMesh, shapes};
use homolog_primitives::observe::Silent;
use homolog_run::intake::{IntakeError, IntakeLimits, PreparedSurface, inspect, prepare_surface};
use homolog_run::{InputFile, RunOutput, run_match};
use nalgebra::Matrix4;
use serde_json::json;

fn defaults() -> InputParameters {
    preset(Method::Balanced).input
}

fn prepare(bytes: &[u8], parameters: &InputParameters) -> Result<PreparedSurface, IntakeError> {
    prepare_surface(bytes, None, parameters, &IntakeLimits::default())
}

/// Two balls of radius 4 and 3 mm side by side, labels 3 and 7, in a volume of 30 x 12 x 12 voxels of 1 mm.
fn two_balls() -> LabelVolume {
    let ball = |x: f64, y: f64, z: f64, middle: f64, radius: f64| {
        (x - middle).powi(2) + (y - 5.5).powi(2) + (z - 5.5).powi(2) < radius * radius
    };
    let label = |k: usize| {
        let [x, y, z] = [k % 30, k / 30 % 12, k / 360].map(|c| c as f64);
        if ball(x, y, z, 6.5, 4.0) { 3 } else { 7 * u32::from(ball(x, y, z, 20.5, 3.0)) }
    };
    LabelVolume::new([30, 12, 12], (0..30 * 144).map(label).collect(), Matrix4::identity()).unwrap()
}

/// The same as a segmentation of 3D Slicer with names.
fn named_balls() -> Vec<u8> {
    let mut file = b"NRRD0004\ntype: uchar\ndimension: 3\nspace: RAS\nsizes: 30 12 12\n\
        space directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n\
        Segment0_ID:=one\nSegment0_Name:=Left Hippocampus\nSegment0_LabelValue:=3\n\
        Segment1_ID:=two\nSegment1_Name:=tumor\nSegment1_LabelValue:=7\n\n"
        .to_vec();
    file.extend(two_balls().labels().iter().map(|&label| label as u8));
    file
}

#[test]
fn labels_are_chosen_for_both_inputs_or_for_each_by_number_or_name() {
    let by = |input: serde_json::Value| resolve(&json!({ "input": input })).unwrap().input;
    let volume_of =
        |bytes: &[u8], parameters: &InputParameters| prepare(bytes, parameters).unwrap().mesh.signed_volume();
    let numbers = write_nifti(&two_balls());
    let [large, small] = [3, 7].map(|label| volume_of(&numbers, &by(json!({ "labels": [label] }))));
    assert!(large > 1.5 * small, "{large} {small}");
    let sides = by(json!({"labels": 3, "target": {"labels": [7]}}));
    assert_eq!(volume_of(&numbers, &sides.of_source()), large, "a single label stands without brackets");
    assert_eq!(volume_of(&numbers, &sides.of_target()), small);
    let names = by(json!({"source": {"labels": ["left hippocampus"]}, "target": {"labels": "Tumor"}}));
    assert_eq!(volume_of(&named_balls(), &names.of_source()), large);
    assert_eq!(volume_of(&named_balls(), &names.of_target()), small);
    for (bytes, expected) in [(named_balls(), "labels of a file with their names"), (numbers, "no names of labels")] {
        let error = prepare(&bytes, &by(json!({"labels": [3, "amygdala"]}))).unwrap_err();
        assert_eq!(error.code(), "empty-structure");
        assert!(error.to_string().contains("\"amygdala\"") && error.to_string().contains(expected), "{error}");
    }
    let seen = inspect(&named_balls(), None, &defaults(), &IntakeLimits::default()).unwrap();
    let labels = seen.volume.unwrap().labels;
    assert_eq!(labels[1].name.as_deref(), Some("tumor"));
    for wrong in [json!({"labels": []}), json!({"source": {"labels": [0]}}), json!({"target": {"labels": []}})] {
        assert!(resolve(&json!({ "input": wrong })).is_err(), "{wrong}");
    }
}

#[test]
fn a_limit_counts_only_the_chosen_labels() {
    let bytes = write_nifti(&two_balls());
    let limits = IntakeLimits { max_vertices: 200, ..IntakeLimits::default() };
    let with = |labels: serde_json::Value| {
        let parameters = resolve(&json!({"input": {"labels": labels, "surface": "voxel"}})).unwrap().input;
        prepare_surface(&bytes, None, &parameters, &limits)
    };
    let all = with(json!(null)).unwrap_err().to_string();
    assert!(all.contains("of all its labels together (choose a structure: input.labels, a number or a name)"), "{all}");
    assert!(with(json!(7)).is_ok());
    let boxed = |max_voxels| {
        let parameters = resolve(&json!({"input": {"labels": 7}})).unwrap().input;
        prepare_surface(&bytes, None, &parameters, &IntakeLimits { max_voxels, ..IntakeLimits::default() })
    };
    // The ball of radius 3 mm has 6 voxels across, and one beside it on each side.
    assert!(boxed(512).is_ok());
    assert!(boxed(511).unwrap_err().to_string().contains("512 voxels in the box around the structure"));
    let ring = write_ply(&shapes::torus(8.0, 3.0, 24, 12, FaceArity::Triangle));
    let faces =
        |max_faces| prepare_surface(&ring, None, &defaults(), &IntakeLimits { max_faces, ..IntakeLimits::default() });
    assert!(faces(576).is_ok());
    assert!(faces(575).unwrap_err().to_string().contains("576 faces, but at most 575"));
}

#[test]
fn a_repair_may_stand_without_brackets() {
    let one = resolve(&json!({"input": {"repair": "weld"}})).unwrap();
    assert_eq!(one, resolve(&json!({"input": {"repair": ["weld"]}})).unwrap());
    assert!(resolve(&json!({"input": {"repair": "wld"}})).is_err());
}

#[test]
fn a_refusal_names_every_fault_and_what_to_send() {
    let torus = shapes::torus(8.0, 3.0, 24, 12, FaceArity::Triangle);
    // One face is missing and another is reversed.
    let mut faces = torus.indices()[3..].to_vec();
    faces.swap(300, 301);
    let broken = SurfaceMesh::new(torus.vertices().to_vec(), FaceArity::Triangle, faces).unwrap();
    let with = |input: serde_json::Value| resolve(&json!({ "input": input })).unwrap().input;
    let strict = with(json!({"allow_boundary": false, "repair": []}));
    let text = prepare(&write_ply(&broken), &strict).unwrap_err().to_string();
    assert!(text.contains("3 edges have only one face"), "{text}");
    assert!(text.contains("; also, 3 edges lie between faces of opposite orientation"), "{text}");
    assert_eq!(text.matches(" mm").count(), 2, "each with its place: {text}");
    let one_hole = with(json!({"allow_boundary": false}));
    let error = prepare(&write_ply(&broken), &one_hole).unwrap_err();
    assert!(error.to_string().contains(r#"send the parameters {"input": {"allow_boundary": true}}"#), "{error}");
    assert!(error.for_command_line().contains("--set input.allow_boundary=true"), "{}", error.for_command_line());
    let twisted = with(json!({"repair": []}));
    let error = prepare(&write_ply(&broken), &twisted).unwrap_err();
    assert!(error.to_string().ends_with(r#"send the parameters {"input": {"repair": ["orient"]}}"#), "{error}");
    assert!(error.for_command_line().ends_with(r#"--set 'input.repair=["orient"]'"#), "{}", error.for_command_line());
}

#[test]
fn parts_that_touch_at_an_edge_or_a_vertex_are_split_without_moving() {
    // Two tetrahedra with a common edge, and a third that touches the second at one vertex; a vertex that no face uses.
    let places = [
        [9.0, 9.0, 9.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [-2.0, 0.0, 0.5],
        [-2.0, 1.0, 0.0],
        [-2.0, 0.0, -1.0],
    ];
    let tetrahedron = |[a, b, c, d]: [u32; 4]| [a, c, b, a, b, d, a, d, c, b, c, d];
    let faces = [[1, 3, 4, 2], [1, 5, 6, 2], [5, 7, 8, 9]].map(tetrahedron).concat();
    let touching = SurfaceMesh::new(places.map(Into::into).to_vec(), FaceArity::Triangle, faces).unwrap();
    let with = |repair: serde_json::Value| resolve(&json!({"input": {"repair": repair}})).unwrap().input;
    let bytes = write_ply(&touching);
    let kept = prepare(&bytes, &with(json!(["weld", "orient"]))).unwrap();
    assert_eq!(kept.report.repairs.len(), 0, "such surfaces are matched as they are");
    let split = prepare(&bytes, &with(json!(["weld", "orient", "split"]))).unwrap();
    assert_eq!(
        split.report.repairs[0].detail,
        "3 vertices copied, where parts touched at 1 edge with more than two faces or at a vertex only; no vertex moved"
    );
    let report = homolog_mesh::topology::topology_report(&split.mesh);
    assert_eq!((report.n_components, report.genus, report.n_vertices), (3, Some(0), 12));
    assert_eq!(split.numbering.originals(), [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
    assert_eq!(split.uploaded().n_vertices(), 13);
    assert_eq!(split.uploaded().vertices()[..10], *touching.vertices());
    let copied: Vec<_> = split.uploaded().vertices()[10..].to_vec();
    assert!(copied.iter().all(|p| [1, 2, 5].iter().any(|&v| touching.vertices()[v] == *p)), "{copied:?}");
    let largest = prepare(&bytes, &with(json!(["split", "largest_component"]))).unwrap();
    assert_eq!(largest.mesh.n_vertices(), 4);
}

#[test]
fn tunnels_and_cavities_of_a_mesh_are_closed_on_request_with_counts_and_displacements() {
    // A ring with a cavity in a ball beside it, behind a vertex that no face uses.
    let ring = shapes::torus(10.0, 3.0, 40, 20, FaceArity::Quad);
    let ball = shapes::torus(30.0, 1.0, 60, 8, FaceArity::Quad);
    let cavity = homolog_mesh::repair::reversed(&shapes::torus(30.0, 0.5, 60, 8, FaceArity::Quad));
    let (mut vertices, mut indices) = (vec![nalgebra::Point3::new(90.0, 0.0, 0.0)], Vec::new());
    for piece in [&ring, &ball, &cavity] {
        let first = vertices.len() as u32;
        vertices.extend_from_slice(piece.vertices());
        indices.extend(piece.indices().iter().map(|v| v + first));
    }
    let mesh = SurfaceMesh::new(vertices, FaceArity::Quad, indices).unwrap();
    let with = |repair: serde_json::Value| resolve(&json!({"input": {"repair": repair}})).unwrap().input;
    let kept = prepare(&write_ply(&mesh), &with(json!(["weld"]))).unwrap();
    assert_eq!(homolog_mesh::topology::topology_report(&kept.mesh).genus, Some(3));
    let filled = prepare(&write_ply(&mesh), &with(json!("fill"))).unwrap();
    let report = homolog_mesh::topology::topology_report(&filled.mesh);
    assert_eq!((report.genus, report.n_components), (Some(0), 2));
    let details: Vec<&str> = filled.report.repairs.iter().map(|note| note.detail.as_str()).collect();
    assert_eq!(details[0], "1 piece inside another dropped");
    assert!(details[1].starts_with("closed 2 of 2 tunnels, cut along loops of at most 18.7"), "{}", details[1]);
    assert!(details[1].contains("28 vertices copied and 4 added, none moved more than 0."), "{}", details[1]);
    let open = SurfaceMesh::new(ring.vertices().to_vec(), FaceArity::Quad, ring.indices()[4..].to_vec()).unwrap();
    let closed = prepare(&write_ply(&open), &with(json!("fill"))).unwrap();
    let detail = &closed.report.repairs[0].detail;
    assert!(detail.starts_with("closed 1 of 1 tunnel, cut along loops of at most 18.7"), "{detail}");
    assert_eq!(homolog_mesh::topology::topology_report(&closed.mesh).n_boundary_edges, 4);
    let mut twisted = ring.indices().to_vec();
    twisted[..4].reverse();
    let twisted = SurfaceMesh::new(ring.vertices().to_vec(), FaceArity::Quad, twisted).unwrap();
    let left = inspect(&write_ply(&twisted), None, &with(json!("fill")), &IntakeLimits::default());
    let left = left.unwrap();
    assert!(left.notes[0].starts_with("tunnels were not looked for: the surface has edges"), "{:?}", left.notes);
    // What was added is numbered after the file; what was dropped is still there.
    let n = mesh.n_vertices();
    assert_eq!(filled.uploaded().n_vertices(), n + 32);
    assert_eq!(filled.numbering.originals()[0], 1);
    assert_eq!(filled.numbering.originals().last(), Some(&(n as u32 + 31)));
    for (v, place) in filled.mesh.vertices().iter().enumerate() {
        assert_eq!(filled.uploaded().vertices()[filled.numbering.original(v as u32) as usize], *place);
    }
    assert_eq!(filled.uploaded().vertices()[0], mesh.vertices()[0]);
}

#[test]
fn a_surface_is_simplified_to_a_number_of_vertices_that_keep_their_numbers() {
    let ball = shapes::ellipsoid(nalgebra::Vector3::new(12.0, 9.0, 6.0), 4);
    let with = |input: serde_json::Value| resolve(&json!({ "input": input })).unwrap().input;
    let small = prepare(&write_ply(&ball), &with(json!({"max_vertices": 300}))).unwrap();
    assert_eq!(small.mesh.n_vertices(), 300);
    let detail = &small.report.repairs[0].detail;
    assert!(detail.starts_with("300 of 2562 vertices kept where they are; the others are at most 0."), "{detail}");
    assert_eq!(small.uploaded(), &ball, "an answer counts the whole surface");
    for (v, place) in small.mesh.vertices().iter().enumerate() {
        assert_eq!(ball.vertices()[small.numbering.original(v as u32) as usize], *place);
    }
    let whole = prepare(&write_ply(&ball), &with(json!({"max_vertices": 2562}))).unwrap();
    assert_eq!((whole.mesh, whole.report.repairs.len()), (ball, 0));
    // A volume has no vertices of its own: the answer counts those of the surface before. Quads become triangles.
    let bytes = write_nifti(&two_balls());
    let chosen = json!({"labels": 3, "surface": "voxel", "max_vertices": 100, "repair": ["triangulate", "simplify"]});
    let of_volume = prepare(&bytes, &with(chosen)).unwrap();
    let before = prepare(&bytes, &with(json!({"labels": 3, "surface": "voxel", "repair": ["triangulate"]}))).unwrap();
    assert_eq!((of_volume.uploaded(), of_volume.mesh.n_vertices()), (&before.mesh, 100));
    let made: Vec<_> = of_volume.report.repairs.iter().map(|note| note.repair).collect();
    assert_eq!(made, [Repair::Triangulate, Repair::Simplify]);
    for wrong in [json!({"max_vertices": 99}), json!({"repair": "simplify"}), json!({"fraction": 0.0})] {
        assert!(resolve(&json!({ "input": wrong })).is_err(), "{wrong}");
    }
}

#[test]
fn the_same_surface_in_seven_formats_gives_the_same_answer_to_the_bit() {
    let single = |mesh: &SurfaceMesh| {
        let places = mesh.vertices().iter().map(|p| p.map(|x| f64::from(x as f32))).collect();
        SurfaceMesh::new(places, FaceArity::Triangle, mesh.triangles().concat()).unwrap()
    };
    let [source, target] = PhantomPair::against_template(0).unwrap().meshes(2.0).unwrap().each_ref().map(single);
    let text = |head: &str, vertex: &str, face: &str, first: u32| {
        let vertices = source.vertices().iter().map(|p| format!("{vertex}{} {} {}\n", p.x, p.y, p.z));
        let faces = source.faces().map(|f| format!("{face}{} {} {}\n", f[0] + first, f[1] + first, f[2] + first));
        (head.to_owned() + &vertices.chain(faces).collect::<String>()).into_bytes()
    };
    let off = format!("OFF\n{} {} 0\n", source.n_vertices(), source.n_faces());
    let files = [
        ("PLY", write_ply(&source)),
        ("VTK", homolog_formats::write_vtk(&source)),
        ("VTP", homolog_formats::write_vtp(&source)),
        ("GIFTI", homolog_formats::gifti::write_gifti(&source, &[])),
        ("OBJ", text("", "v ", "f ", 1)),
        ("OFF", text(&off, "", "3 ", 0)),
        ("STL", homolog_formats::write_stl(&source)),
    ];
    let target = write_ply(&target);
    let answer = |bytes: &[u8]| {
        let [source, target] = [bytes, &target].map(|bytes| InputFile { bytes, name: None });
        let parameters = resolve(&json!({})).unwrap();
        run_match(source, target, &parameters, &IntakeLimits::default(), &Silent).unwrap()
    };
    let expected = answer(&files[0].1);
    let pairs = |output: &RunOutput| output.document.correspondences.clone().unwrap();
    for (name, bytes) in &files[1..] {
        let found = answer(bytes);
        let (found_document, document) = (&found.document, &expected.document);
        assert_eq!(found_document.transform, document.transform, "{name}");
        assert_eq!(found_document.energy, document.energy, "{name}");
        assert_eq!(found_document.surface_distance, document.surface_distance, "{name}");
        assert_eq!(found_document.reliability, document.reliability, "{name}");
        // STL has an order of vertices of its own.
        if *name != "STL" {
            assert_eq!(pairs(&found), pairs(&expected), "{name}");
            continue;
        }
        let by_place = |output: &RunOutput| {
            let columns = pairs(output);
            let rows = columns.source.iter().zip(&columns.target).zip(&columns.confidence);
            let place = |v: u32| output.source.vertices()[v as usize].map(f64::to_bits);
            let mut rows: Vec<_> = rows
                .map(|((&source, &target), confidence)| {
                    let p = place(source);
                    ([p.x, p.y, p.z], target, confidence.to_bits())
                })
                .collect();
            rows.sort_unstable();
            rows
        };
        assert_eq!(by_place(&found), by_place(&expected), "{name}");
    }
}

/// What should come of a file.
enum Expected {
    /// Format, vertices, faces and genus as read.
    Mesh(InputFormat, u32, u32, Option<u32>),
    /// Format, a label, and its number of voxels.
    Labels(InputFormat, u32, u64),
    /// A part of the reason.
    Refused(&'static str),
}

/// Files of other programs, which are not part of the repository.
mod real_data {
    use super::*;
    use crate::fixtures::{real, real_files};
    use Expected::{Labels, Mesh, Refused};
    use InputFormat::{DicomSeg, Freesurfer, Gifti, Mgh, Nifti, Nrrd, Obj, Off, Ply, Stl, Vtk, Vtp};

    const TABLE: [(&str, Expected); 45] = [
        ("dicom_seg/liver.dcm", Labels(DicomSeg, 1, 107_098)),
        ("dicom_seg/partial_overlaps.dcm", Labels(DicomSeg, 3, 10_743)),
        ("dicom_seg/seg_image_ct_binary.dcm", Labels(DicomSeg, 1, 638)),
        ("dicom_seg/seg_image_ct_binary_fractional.dcm", Labels(DicomSeg, 1, 638)),
        ("dicom_seg/seg_image_ct_binary_overlap.dcm", Labels(DicomSeg, 1, 64)),
        ("dicom_seg/seg_image_ct_binary_single_frame.dcm", Labels(DicomSeg, 1, 1832)),
        ("dicom_seg/seg_image_ct_true_fractional.dcm", Labels(DicomSeg, 1, 638)),
        ("dicom_seg/seg_image_sm_control_labelmap.dcm", Refused("microscope slide")),
        ("dicom_seg/sparse-labelmap-ppv5.dcm", Labels(DicomSeg, 1, 630)),
        // All its vertices coincide.
        ("freesurfer/lh.tinysurface", Refused("and 0 faces")),
        ("freesurfer/mricros_lh.pial", Mesh(Freesurfer, 40_962, 81_920, Some(0))),
        ("gifti/brainspace_fsa5_pial_rh.gii", Mesh(Gifti, 10_242, 20_480, Some(0))),
        // The faces of this cube disagree in orientation, in every format.
        ("gifti/cube.gii", Mesh(Gifti, 8, 12, None)),
        ("gifti/hippomaps_hipp_disk_1mm.surf.gii", Mesh(Gifti, 2004, 3870, None)),
        ("gifti/mricros_cortex_column_major.surf.gii", Mesh(Gifti, 20_484, 40_960, Some(0))),
        ("gifti/nilearn_fsaverage5_pial_left.gii.gz", Mesh(Gifti, 10_242, 20_480, Some(0))),
        ("gifti/tvb_cortex_nonidentity_transform.gii", Mesh(Gifti, 131_342, 262_680, Some(0))),
        ("gifti/workbench_S1200_L_midthickness_32k.surf.gii", Mesh(Gifti, 32_492, 64_980, Some(0))),
        ("mgz/aparc+aseg.mgz", Labels(Mgh, 17, 4068)),
        ("nifti/aal.nii.gz", Labels(Nifti, 37, 7469)),
        ("nifti/vol27int.nii.gz", Labels(Nifti, 12, 1)),
        ("nrrd/heart_seg.nrrd", Labels(Nrrd, 3, 41_449)),
        ("nrrd/liver_seg.nrrd", Labels(Nrrd, 1, 107_098)),
        ("nrrd/spine_seg.nrrd", Labels(Nrrd, 2, 12_439)),
        ("obj/cow.obj", Mesh(Obj, 2903, 5804, None)),
        ("obj/cube.obj", Mesh(Obj, 8, 12, None)),
        ("obj/mni_surface_mesh_not_wavefront.obj", Refused("MNI .obj")),
        ("obj/motor_4t95vol_5.obj", Mesh(Obj, 349, 694, Some(0))),
        ("off/cube.off", Mesh(Off, 8, 12, None)),
        ("off/icosahedron.off", Mesh(Off, 12, 20, Some(0))),
        ("off/square-mesh.off", Mesh(Off, 415, 768, None)),
        ("off/torus.off", Mesh(Off, 576, 1152, Some(1))),
        ("ply/cube.ply", Mesh(Ply, 8, 12, None)),
        ("ply/invMotor.ply", Mesh(Ply, 696, 1380, Some(0))),
        ("stl/42400-IDGH.stl", Mesh(Stl, 5500, 11_036, Some(10))),
        ("stl/cube.stl", Mesh(Stl, 8, 12, None)),
        ("stl/cube_bin.stl", Mesh(Stl, 8, 12, Some(0))),
        ("vtk/Bunny.vtp", Mesh(Vtp, 872, 1000, None)),
        ("vtk/SuperQuadric.vtp", Mesh(Vtp, 480, 512, None)),
        ("vtk/Torso.vtp", Mesh(Vtp, 12_015, 23_762, None)),
        ("vtk/cow.vtp", Mesh(Vtp, 2903, 5804, None)),
        ("vtk/cube.vtk", Mesh(Vtk, 8, 12, None)),
        ("vtk/cubeTria.vtk", Mesh(Vtk, 2402, 4800, Some(0))),
        // Lines alone.
        ("vtk/faults.vtk", Refused("0 faces")),
        ("vtk/fran_cut.vtk", Mesh(Vtk, 2205, 4224, None)),
    ];

    #[test]
    #[ignore = "needs real data (formats)"]
    fn every_file_is_read_as_documented_or_refused_for_its_reason() {
        let mut found = Vec::new();
        for folder in real_files("formats") {
            for file in std::fs::read_dir(&folder).unwrap() {
                let path = file.unwrap().path();
                let name = format!("{}/{}", folder.file_name().unwrap().display(), path.file_name().unwrap().display());
                found.push((name, path));
            }
        }
        found.sort();
        let known: Vec<&str> = TABLE.iter().map(|(name, _)| *name).collect();
        assert_eq!(found.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), known);
        for ((name, path), (_, expected)) in found.iter().zip(TABLE) {
            let bytes = std::fs::read(path).unwrap();
            // One label of a volume is looked at; meshes ignore it.
            let label = if let Labels(_, label, _) = expected { json!(label) } else { json!(null) };
            let parameters = resolve(&json!({"input": {"labels": label}})).unwrap().input;
            let seen =
                inspect(&bytes, path.file_name().and_then(|n| n.to_str()), &parameters, &IntakeLimits::default());
            match (seen, expected) {
                (Err(error), Refused(reason)) => {
                    assert!(error.to_string().contains(reason), "{name}: {error}");
                    println!("| {name} | refused | {error} |");
                }
                (Ok(seen), Refused(reason)) => {
                    let detail = seen.refusal.map(|refusal| refusal.detail).unwrap_or_default();
                    assert!(detail.contains(reason), "{name}: {detail}");
                    println!("| {name} | refused | {detail} |");
                }
                (Ok(seen), Mesh(format, n_vertices, n_faces, genus)) => {
                    let topology = seen.topology.unwrap();
                    let read = (seen.format, topology.n_vertices, topology.n_faces, topology.genus);
                    assert_eq!(read, (format, n_vertices, n_faces, genus), "{name}");
                    let fitness = seen.refusal.map_or("can be matched".to_owned(), |refusal| refusal.detail);
                    println!("| {name} | {n_vertices} vertices, {n_faces} faces, genus {genus:?} | {fitness} |");
                }
                (Ok(seen), Labels(format, label, n_voxels)) => {
                    let labels = seen.volume.unwrap().labels;
                    let count = labels.iter().find(|l| l.label == label).map(|l| l.n_voxels);
                    assert_eq!((seen.format, count), (format, Some(n_voxels)), "{name}");
                    let fitness = seen.refusal.map_or("can be matched".to_owned(), |refusal| refusal.detail);
                    println!("| {name} | label {label}: {n_voxels} voxels | {fitness} |");
                }
                (seen, _) => panic!("{name}: {seen:?}"),
            }
        }
    }

    #[test]
    #[ignore = "needs real data (formats, structures)"]
    fn tunnels_of_real_surfaces_are_closed() {
        let tunnels = [
            ("structures/Model_54_right_amygdala.vtk", 1),
            ("structures/Model_50_right_caudate_nucleus.vtk", 3),
            ("formats/stl/42400-IDGH.stl", 10),
        ];
        for (name, n_tunnels) in tunnels {
            let bytes = std::fs::read(real(name)).unwrap();
            let repair = json!(["weld", "largest_component", "orient", "fill"]);
            let parameters = resolve(&json!({"input": {"repair": repair, "allow_boundary": false}})).unwrap().input;
            let closed = prepare(&bytes, &parameters).unwrap();
            let report = homolog_mesh::topology::topology_report(&closed.mesh);
            assert_eq!((report.genus, report.n_components), (Some(0), 1), "{name}");
            let detail = &closed.report.repairs.last().unwrap().detail;
            assert!(detail.starts_with(&format!("closed {n_tunnels} of {n_tunnels} tunnel")), "{name}: {detail}");
            println!("{name}: {detail}");
        }
    }

    /// An array of a NumPy archive as the bytes of its values.
    fn npz_column(archive: &[u8], name: &str) -> Vec<u8> {
        use std::io::Read;
        let number = |at: usize, n: usize| (0..n).rev().fold(0usize, |sum, k| sum << 8 | usize::from(archive[at + k]));
        // The entry in the directory: its name begins 46 bytes after its mark.
        let mark =
            |at: &usize| archive[*at..].starts_with(b"PK\x01\x02") && archive[at + 46..].starts_with(name.as_bytes());
        let entry = (0..archive.len()).find(mark).unwrap();
        let (packed, local) = (number(entry + 20, 4), number(entry + 42, 4));
        let start = local + 30 + number(local + 26, 2) + number(local + 28, 2);
        let mut array = Vec::new();
        flate2::read::DeflateDecoder::new(&archive[start..start + packed]).read_to_end(&mut array).unwrap();
        let header = 10 + usize::from(array[8]) + (usize::from(array[9]) << 8);
        array.split_off(header)
    }

    #[test]
    #[ignore = "needs real data (landmarked)"]
    fn the_tunnel_of_a_vertebra_is_closed_by_cutting_its_arch() {
        let archive = std::fs::read(real_files("landmarked/vertebra").first().unwrap()).unwrap();
        let coordinates: Vec<f64> = npz_column(&archive, "V.npy")
            .chunks_exact(4)
            .map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])))
            .collect();
        let vertices = coordinates.chunks_exact(3).map(|p| nalgebra::Point3::new(p[0], p[1], p[2])).collect();
        let faces = npz_column(&archive, "F.npy");
        let faces = faces.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect();
        let vertebra = SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap();
        let with = |repair: serde_json::Value| resolve(&json!({"input": {"repair": repair}})).unwrap().input;
        let bytes = write_ply(&vertebra);
        let repairs = json!(["weld", "split", "largest_component", "orient"]);
        let before = prepare(&bytes, &with(repairs.clone())).unwrap();
        let genus = |prepared: &PreparedSurface| homolog_mesh::topology::topology_report(&prepared.mesh).genus;
        assert!(genus(&before).unwrap() > 0);
        let mut all = repairs;
        all.as_array_mut().unwrap().push(json!("fill"));
        let after = prepare(&bytes, &with(all)).unwrap();
        assert_eq!(genus(&after), Some(0));
        println!("{}", after.report.repairs.last().unwrap().detail);
        // Only a thin slice of the arch is gone.
        let lost = 1.0 - after.mesh.signed_volume() / before.mesh.signed_volume();
        assert!((0.0..0.01).contains(&lost), "{lost}");
    }

    #[test]
    #[ignore = "needs real data (formats)"]
    fn a_segmentation_and_its_nrrd_twin_give_the_same_surface() {
        let read = |name: &str| prepare(&std::fs::read(real(name)).unwrap(), &defaults()).unwrap().mesh;
        let [dicom, nrrd] = ["formats/dicom_seg/liver.dcm", "formats/nrrd/liver_seg.nrrd"].map(read);
        assert_eq!(dicom.indices(), nrrd.indices());
        for (a, b) in dicom.vertices().iter().zip(nrrd.vertices()) {
            assert!((a - b).norm() < 1e-4, "{a} {b}");
        }
    }

    #[test]
    #[ignore = "needs real data (formats)"]
    fn an_open_sheet_is_refused_with_its_boundary_where_that_is_not_allowed() {
        let bytes = std::fs::read(real("formats/gifti/hippomaps_hipp_disk_1mm.surf.gii")).unwrap();
        let closed = InputParameters { allow_boundary: false, ..defaults() };
        let error = prepare(&bytes, &closed).unwrap_err().to_string();
        assert!(error.contains("136 edges have only one face") && error.contains(" mm"), "{error}");
        assert!(prepare(&bytes, &defaults()).is_ok());
    }

    #[test]
    #[ignore = "needs real data (formats)"]
    fn left_structures_of_a_freesurfer_volume_lie_left_of_right_ones() {
        let bytes = std::fs::read(real("formats/mgz/aparc+aseg.mgz")).unwrap();
        let center = |label: u32| {
            let parameters = resolve(&json!({"input": {"labels": label}})).unwrap().input;
            prepare(&bytes, &parameters).unwrap().mesh.centroid()
        };
        for (left, right) in [(17, 53), (18, 54), (11, 50), (12, 51), (10, 49)] {
            let (left, right) = (center(left), center(right));
            assert!(left.x + 20.0 < right.x && (left.y - right.y).abs() < 8.0, "{left} {right}");
        }
    }
}
