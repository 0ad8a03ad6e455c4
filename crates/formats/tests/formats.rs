//! The same surface and the same label volume in every format, and files that are refused by name.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod samples;

use homolog_formats::{FileContent, FormatError, InputFormat, ReadFile, ReadLimits, read};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Point3};
use samples::{IDENTITY, affine, dicom_seg, gifti, gzip, labels, layered_nrrd, surface, surfaces, volumes};

fn read_file(bytes: &[u8], name: Option<&str>) -> Result<ReadFile, FormatError> {
    read(bytes, name, &ReadLimits::default())
}

fn mesh(name: &str, bytes: &[u8]) -> (ReadFile, SurfaceMesh) {
    let file = read_file(bytes, None).unwrap_or_else(|e| panic!("{name}: {e}"));
    match file.content.clone() {
        FileContent::Mesh(mesh) => (file, mesh.mesh),
        FileContent::Labels(_) => panic!("{name} is a mesh"),
    }
}

fn volume(name: &str, bytes: &[u8]) -> (ReadFile, LabelVolume) {
    let file = read_file(bytes, None).unwrap_or_else(|e| panic!("{name}: {e}"));
    match file.content.clone() {
        FileContent::Labels(volume) => (file, volume),
        FileContent::Mesh(_) => panic!("{name} is a label volume"),
    }
}

#[test]
fn one_surface_gives_the_same_mesh_in_every_format() {
    for (name, format, bytes) in surfaces() {
        let (file, found) = mesh(name, &bytes);
        assert_eq!(file.format, format, "{name}");
        assert_eq!(found, surface(), "{name}");
        if !name.ends_with("gzip") {
            assert_eq!(mesh(name, &gzip(&bytes)).1, surface(), "{name} in gzip");
        }
    }
}

/// Label and position in RAS, in thousandths of a millimetre, of every voxel, in order of position: some formats may only
/// store the slices in the opposite order.
fn places(labels: &[u32], affine: &Matrix4<f64>) -> Vec<([i64; 3], u32)> {
    let [nx, ny, _] = samples::DIMS;
    let place = |at: usize| {
        let voxel = nalgebra::Vector4::new((at % nx) as f64, (at / nx % ny) as f64, (at / (nx * ny)) as f64, 1.0);
        let p = affine * voxel;
        [p.x, p.y, p.z].map(|c| (c * 1000.0).round() as i64)
    };
    let mut places: Vec<_> = labels.iter().enumerate().map(|(at, &label)| (place(at), label)).collect();
    places.sort_unstable();
    places
}

#[test]
fn one_label_volume_is_the_same_in_every_format() {
    for (name, format, bytes) in volumes() {
        let (file, found) = volume(name, &bytes);
        assert_eq!((file.format, found.dims()), (format, samples::DIMS), "{name}");
        assert_eq!(places(found.labels(), found.affine()), places(&labels(), &affine()), "{name}");
        let is_lps = [InputFormat::Nrrd, InputFormat::MetaImage, InputFormat::DicomSeg].contains(&format);
        assert_eq!(file.notes.iter().any(|note| note.contains("LPS")), is_lps, "{name}: {:?}", file.notes);
    }
}

#[test]
fn the_coordinate_transform_of_gifti_is_applied_and_reported() {
    let matrix = "0 -2 0 5 2 0 0 0 0 0 2 -1 0 0 0 1";
    let (file, found) = mesh("GIFTI", &gifti("GZipBase64Binary", false, false, "INT32", matrix));
    for (found, stored) in found.vertices().iter().zip(surface().vertices()) {
        assert_eq!(*found, Point3::new(5.0 - 2.0 * stored.y, 2.0 * stored.x, 2.0 * stored.z - 1.0));
    }
    assert!(file.notes.iter().any(|note| note.contains("unknown to Talairach")), "{:?}", file.notes);
    assert_eq!(mesh("GIFTI", &gifti("ASCII", false, false, "INT32", IDENTITY)).0.notes, Vec::<String>::new());
    for singular in ["1 0 0 0 0 1 0 0 0 0 0 0 0 0 0 1", "1 2 3", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1"] {
        let found = read_file(&gifti("ASCII", false, false, "INT32", singular), None);
        assert!(matches!(found, Err(FormatError::Header { .. })), "{singular}: {found:?}");
    }
}

#[test]
fn files_of_slicer_that_declare_lps_are_converted() {
    let by_slicer = |name: &str| {
        let (_, _, bytes) = surfaces().into_iter().find(|(found, ..)| *found == name).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        text.replacen("\nsurface\n", "\n3D Slicer output. SPACE=LPS\n", 1).replacen("by hand", "SPACE=LPS", 1)
    };
    for name in ["VTK 2.0, ASCII", "PLY, ASCII", "OBJ"] {
        let (file, found) = mesh(name, by_slicer(name).as_bytes());
        for (found, stored) in found.vertices().iter().zip(surface().vertices()) {
            assert_eq!(*found, Point3::new(-stored.x, -stored.y, stored.z), "{name}");
        }
        assert!(file.notes.iter().any(|note| note.contains("LPS")), "{name}");
    }
}

#[test]
fn segments_that_overlap_keep_their_voxels_and_names() {
    let (file, found) = volume(".seg.nrrd", &layered_nrrd());
    let counts: Vec<_> = found.label_counts().into_iter().collect();
    assert_eq!(counts, [(1, 4), (2, 2)], "one voxel belongs to both");
    assert_eq!(file.label_names.values().collect::<Vec<_>>(), ["Left Hippocampus", "tumor"]);
    assert_eq!([1, 2].map(|label| found.mask(Some(&[label])).unwrap().n_voxels()), [4, 2]);
    assert_eq!(found.mask(None).unwrap().n_voxels(), 5);
    // Older files state neither layers nor values.
    let text = String::from_utf8_lossy(&layered_nrrd()).into_owned();
    let kept = text.lines().filter(|line| !line.contains("_Layer") && !line.contains("_LabelValue"));
    let header: Vec<&str> = kept.take_while(|line| !line.is_empty()).collect();
    let voxels = layered_nrrd().split_off(text.find("\n\n").unwrap() + 2);
    let older = [header.join("\n").into_bytes(), b"\n\n".to_vec(), voxels].concat();
    assert_eq!(volume("older .seg.nrrd", &older).1.label_counts().into_iter().collect::<Vec<_>>(), counts);
    let overlapping = dicom_seg("BINARY", &[(17, 0), (17, 1), (53, 0)], |segment, at| match segment {
        17 => u16::from(labels()[at] == 17),
        _ => u16::from(at == 4 || at == 0),
    });
    let (file, found) = volume("DICOM SEG", &overlapping);
    assert_eq!(found.label_counts().into_iter().collect::<Vec<_>>(), [(17, 4), (53, 2)]);
    assert_eq!(file.label_names[&53], "Right Hippocampus");
}

#[test]
fn a_gap_between_the_frames_of_a_segmentation_is_refused_with_its_place() {
    let gap = dicom_seg("BINARY", &[(17, 0), (17, 1), (17, 4)], |_, _| 1);
    let error = read_file(&gap, None).unwrap_err().to_string();
    assert!(error.contains("2 missing slices of 2 mm between the frames at"), "{error}");
}

#[test]
fn formats_that_are_known_and_not_read_are_named_with_what_to_do() {
    let rtstruct = {
        let mut bytes = dicom_seg("BINARY", &[(17, 0)], |_, _| 1);
        let class = b"1.2.840.10008.5.1.4.1.1.66.4";
        let at = bytes.windows(class.len()).position(|w| w == class).unwrap();
        // The value has an even length, so the replacement must have the same.
        let other = b"1.2.840.10008.5.1.4.1.1.481.3";
        bytes[at - 2..at].copy_from_slice(&30u16.to_le_bytes());
        let tail = bytes.split_off(at + class.len());
        bytes.truncate(at);
        bytes.extend(other);
        bytes.push(0);
        bytes.extend(tail);
        bytes
    };
    let cifti = {
        let mut bytes = samples::nifti_2(false);
        bytes[504..508].copy_from_slice(&3006i32.to_le_bytes());
        bytes
    };
    let mut analyze = vec![0; 400];
    analyze[..4].copy_from_slice(&348i32.to_le_bytes());
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("a.obj", b"P 0.3 0.3 0.4 10 1 1558\n -18 -16.85 2.5\n".to_vec(), "MNI .obj"),
        ("a.hdr", analyze, "ANALYZE"),
        ("a.mnc", b"\x89HDF\r\n\x1a\n\0\0\0".to_vec(), "MINC 2"),
        ("a.mnc", b"CDF\x01\0\0\0\0".to_vec(), "MINC 1"),
        ("a.dcm", rtstruct, "RT structure set"),
        ("a.dscalar.nii", cifti, "CIFTI"),
        ("a.fbx", b"Kaydara FBX Binary  \0\x1a\0".to_vec(), "FBX"),
        ("a.gltf", b"{ \"asset\": {\"version\": \"2.0\"} }".to_vec(), "glTF"),
        ("a.glb", b"glTF\x02\0\0\0".to_vec(), "glTF"),
        ("a.zip", b"PK\x03\x04....".to_vec(), "zip"),
        ("lh.patch", b"\xff\xff\xff\xff\0\0\0\x05".to_vec(), "patch"),
        ("a.mesh", b"binarDCBA\0\0".to_vec(), "BrainVISA"),
        ("a.nhdr", b"NRRD0004\ntype: uchar\nsizes: 1 1 1\ndata file: x.raw\n\n".to_vec(), ".nhdr"),
        ("a.mhd", b"ObjectType = Image\nNDims = 3\nElementDataFile = x.raw\n".to_vec(), "MetaImage header"),
        (
            "a.vtu",
            b"<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\"></VTKFile>".to_vec(),
            "other than PolyData",
        ),
        ("a.func.gii", b"<?xml version=\"1.0\"?><GIFTI Version=\"1.0\"></GIFTI>".to_vec(), "without a pointset"),
    ];
    for (name, bytes, expected) in cases {
        let error = read_file(&bytes, Some(name)).unwrap_err();
        assert!(matches!(error, FormatError::Unsupported { .. }), "{name}: {error:?}");
        let text = error.to_string();
        assert!(text.contains(expected) && text.contains("; "), "{name}: {text}");
    }
}

#[test]
fn a_name_that_promises_another_format_is_reported() {
    for (name, format, bytes) in surfaces() {
        let promised = if format == InputFormat::Stl { "x.ply" } else { "x.stl" };
        let file = read_file(&bytes, Some(promised)).unwrap();
        assert!(file.notes.iter().any(|note| note.contains("name promises")), "{name}: {:?}", file.notes);
    }
}

#[test]
fn both_kinds_of_quads_of_freesurfer_are_split_alike() {
    let corners: [[u8; 3]; 4] = [[0, 0, 0], [100, 0, 0], [100, 100, 0], [0, 100, 0]];
    let mut old = b"\xff\xff\xff\0\0\x04\0\0\x01".to_vec();
    let mut new = b"\xff\xff\xfd\0\0\x04\0\0\x01".to_vec();
    for c in corners.as_flattened() {
        old.extend(i16::from(*c).to_be_bytes());
        new.extend((f32::from(*c) / 100.0).to_be_bytes());
    }
    for file in [&mut old, &mut new] {
        file.extend([0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3]);
        let (read, mesh) = mesh("quads", file);
        assert_eq!((read.format, mesh.indices()), (InputFormat::Freesurfer, [0, 1, 3, 2, 3, 1].as_slice()));
        assert_eq!(mesh.vertices()[2], Point3::new(1.0, 1.0, 0.0));
    }
}

#[test]
fn a_nifti_2_affine_may_be_that_of_the_qform() {
    let mut bytes = samples::nifti_2(false);
    bytes[344..352].copy_from_slice(&[1, 0, 0, 0, 0, 0, 0, 0]);
    for (k, size) in [1.0f64, 0.5, 1.25, 2.0].iter().enumerate() {
        bytes[104 + 8 * k..112 + 8 * k].copy_from_slice(&size.to_le_bytes());
    }
    let (_, found) = volume("NIfTI-2", &bytes);
    assert_eq!(*found.affine(), Matrix4::from_diagonal(&nalgebra::Vector4::new(0.5, 1.25, 2.0, 1.0)));
}

#[test]
fn every_writer_of_surfaces_is_read_back_with_arrays_beside_the_surface() {
    use homolog_formats::gifti::write_gifti;
    use homolog_formats::ply::write_ply_with;
    use homolog_formats::vtk::write_vtk_with;
    use homolog_formats::vtp::write_vtp_with;
    use homolog_formats::{VertexArray, VertexValues, write_stl};
    let n = surface().n_vertices();
    let arrays = [
        VertexArray { name: "residual_mm", values: VertexValues::Real((0..n).map(|k| k as f64 / 3.0).collect()) },
        VertexArray { name: "target", values: VertexValues::Int((0..n as i32).rev().collect()) },
        VertexArray { name: "outlier", values: VertexValues::Byte(vec![1; n]) },
    ];
    let quads = homolog_mesh::shapes::torus(8.0, 3.0, 24, 12, homolog_mesh::FaceArity::Quad);
    for (name, with, without) in [
        ("PLY", write_ply_with(&surface(), &arrays), write_ply_with(&quads, &[])),
        ("VTK", write_vtk_with(&surface(), &arrays), write_vtk_with(&quads, &[])),
        ("VTP", write_vtp_with(&surface(), &arrays), write_vtp_with(&quads, &[])),
    ] {
        assert_eq!(mesh(name, &with).1, surface(), "{name}");
        assert_eq!(mesh(name, &without).1, quads, "{name} keeps quads and double precision");
    }
    // The coordinates of this surface are exact in single precision.
    assert_eq!(mesh("GIFTI", &write_gifti(&surface(), &arrays)).1, surface());
    let (file, stl) = mesh("STL", &write_stl(&surface()));
    assert_eq!((file.format, stl.n_vertices(), stl.signed_volume()), (InputFormat::Stl, n, surface().signed_volume()));
}

#[test]
fn tables_of_vertices_hold_every_value() {
    use homolog_formats::arrow::write_arrow_table;
    use homolog_formats::vertex_table::{write_csv, write_npy_table};
    use homolog_formats::{VertexArray, VertexValues};
    let arrays = [
        VertexArray { name: "residual_mm", values: VertexValues::Real(vec![0.5, -1.25]) },
        VertexArray { name: "target", values: VertexValues::Int(vec![-1, 7]) },
        VertexArray { name: "outlier", values: VertexValues::Byte(vec![0, 4]) },
    ];
    let csv = String::from_utf8(write_csv(&arrays)).unwrap();
    assert_eq!(csv, "vertex,residual_mm,target,outlier\r\n0,0.5,-1,0\r\n1,-1.25,7,4\r\n");
    let npy = write_npy_table(&arrays);
    let head = String::from_utf8_lossy(&npy[10..npy.len() - 26]).into_owned();
    assert!(head.contains("[('residual_mm', '<f8'), ('target', '<i4'), ('outlier', '|u1')]"), "{head}");
    assert!(head.contains("'shape': (2,)") && (npy.len() - 26).is_multiple_of(64), "{head}");
    assert_eq!(npy[npy.len() - 13..], [(-1.25f64).to_le_bytes().as_slice(), &7i32.to_le_bytes(), &[4]].concat());
    let arrow = write_arrow_table(&arrays);
    let holds = |bytes: &[u8]| arrow.windows(bytes.len()).any(|w| w == bytes);
    assert!(arrow.starts_with(b"ARROW1\0\0") && arrow.ends_with(b"ARROW1"));
    assert!(holds(&[0.5f64.to_le_bytes(), (-1.25f64).to_le_bytes()].concat()), "a column of reals");
    assert!(holds(&[(-1i32).to_le_bytes(), 7i32.to_le_bytes()].concat()), "a column of integers");
    assert!(holds(b"residual_mm") && holds(b"outlier"));
}
