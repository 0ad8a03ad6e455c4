//! The same surface and the same label volume in every format, and files that are refused by name.

use crate::samples::{
    IDENTITY, affine, archive_of, dicom_seg, gifti, gzip, instances, labels, layered_nrrd, surface, surfaces, volumes,
};
use homolog_formats::{
    FileContent, FormatError, InputFormat, InputSpace, LabelChoice, ReadFile, ReadLimits, ReadOptions, read, read_with,
    write_zip,
};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Point3};

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

/// Label and position in RAS, in thousandths of a millimeter, of every voxel, in order of position: some formats may only
/// store the slices in the opposite order.
fn places(labels: &[u32], affine: &Matrix4<f64>) -> Vec<([i64; 3], u32)> {
    let [nx, ny, _] = crate::samples::DIMS;
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
        assert_eq!((file.format, found.dims()), (format, crate::samples::DIMS), "{name}");
        assert_eq!(places(found.labels(), found.affine()), places(&labels(), &affine()), "{name}");
        let is_lps = [InputFormat::Nrrd, InputFormat::MetaImage, InputFormat::DicomSeg].contains(&format);
        assert_eq!(file.notes.iter().any(|note| note.contains("LPS")), is_lps, "{name}: {:?}", file.notes);
    }
}

#[test]
fn a_rigid_transform_of_gifti_is_applied_and_reported() {
    let matrix = "0 -1 0 5 1 0 0 0 0 0 1 -1 0 0 0 1";
    let (file, found) = mesh("GIFTI", &gifti("GZipBase64Binary", false, false, "INT32", matrix));
    for (found, stored) in found.vertices().iter().zip(surface().vertices()) {
        assert_eq!(*found, Point3::new(5.0 - stored.y, stored.x, stored.z - 1.0));
    }
    assert!(file.notes.iter().any(|note| note.contains("unknown to Talairach")), "{:?}", file.notes);
    assert_eq!(mesh("GIFTI", &gifti("ASCII", false, false, "INT32", IDENTITY)).0.notes, Vec::<String>::new());
    for singular in ["1 0 0 0 0 1 0 0 0 0 0 0 0 0 0 1", "1 2 3", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1"] {
        let bytes = gifti("ASCII", false, false, "INT32", singular);
        let (file, found) = mesh("GIFTI", &bytes);
        assert_eq!((found, file.notes.len()), (surface(), 1), "{singular}");
        let options = ReadOptions { apply_transform: Some(true), ..ReadOptions::default() };
        let found = read_with(&bytes, None, &ReadLimits::default(), &options);
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
fn instances_in_an_archive_are_one_volume_in_which_no_two_segments_share_a_number() {
    let counts = |bytes: &[u8]| {
        let (file, found) = volume("archive", bytes);
        (found.label_counts().into_iter().collect::<Vec<_>>(), file)
    };
    let whole = [17, 53].map(|label| labels().iter().filter(|&&l| l == label).count() as u64);
    let (found, file) = counts(&archive_of(instances(true, "1.2.3")));
    assert_eq!(found, [(17, whole[0]), (53, whole[1])], "parts of a concatenation share the numbers");
    assert!(
        file.notes.iter().any(|n| n.contains("has 2 segmentations") && n.contains("2 other files")),
        "{:?}",
        file.notes
    );
    // Both instances name segments 17 and 53; the second one has voxels of its 53 alone.
    let (found, file) = counts(&archive_of(instances(false, "")));
    assert_eq!(found, [(17, whole[0]), (55, whole[1])]);
    assert_eq!([17, 55].map(|label| file.label_names[&label].as_str()), ["Left Hippocampus", "Right Hippocampus"]);
    assert!(file.notes.iter().any(|n| n.starts_with("2 segments of instances")), "{:?}", file.notes);
    // One file of any format is taken out of its archive, with its name.
    let ply = write_zip(&[("a/b.ply".to_owned(), homolog_formats::write_ply(&surface()))]).unwrap();
    assert_eq!(mesh("archive", &ply).1, surface());
    let mut elsewhere = instances(true, "1.2.3");
    let rows = [0x28, 0, 0x10, 0, b'U', b'S', 2, 0];
    let at = elsewhere[1].windows(8).position(|w| w == rows).unwrap() + 8;
    elsewhere[1][at] = 3;
    let error = read_file(&archive_of(elsewhere), None).unwrap_err().to_string();
    assert!(error.contains("of different sizes of frames"), "{error}");
}

#[test]
fn the_share_from_which_a_fractional_voxel_counts_is_chosen() {
    // Of 200: half at most in slice 0, three quarters in slice 1.
    let bytes = dicom_seg("FRACTIONAL", &[(17, 0), (17, 1)], |_, at| if at < 12 { 100 } else { 150 });
    let voxels = |fraction: f64| {
        let options = ReadOptions { fraction, ..ReadOptions::default() };
        let file = read_with(&bytes, None, &ReadLimits::default(), &options).unwrap();
        assert!(file.notes.iter().any(|note| note.contains(&format!("at least {fraction} of the largest"))));
        let FileContent::Labels(found) = file.content else { panic!("a label volume") };
        found.label_counts().get(&17).copied().unwrap_or(0)
    };
    assert_eq!([0.01, 0.5, 0.51, 0.75, 0.76, 1.0].map(voxels), [24, 24, 12, 12, 0, 0]);
}

#[test]
fn what_inflates_beyond_all_measure_is_refused() {
    let bytes = gzip(&vec![b'\n'; 8 << 20]);
    let read = |max_inflation| {
        let limits = ReadLimits { max_inflation, ..ReadLimits::default() };
        homolog_formats::read(&bytes, Some("a.off"), &limits).unwrap_err()
    };
    assert!(matches!(read(4), FormatError::TooLarge { what: "bytes", limit: 4_194_304, .. }));
    assert!(!matches!(read(8), FormatError::TooLarge { .. }));
}

#[test]
fn a_segment_that_all_frames_share_is_found_in_the_shared_groups() {
    let own = dicom_seg("BINARY", &[(17, 0), (17, 1)], |_, at| u16::from(labels()[at] == 17));
    let item = [0x62, 0, 0x0b, 0, b'U', b'S', 2, 0, 17, 0];
    // The sequence of the segment, 12 + 8 + 10 bytes, moves from both frames to the groups that they share.
    let mut moved = own.clone();
    let mut sequence = Vec::new();
    while let Some(at) = moved.windows(10).position(|w| w == item) {
        sequence = moved.drain(at - 20..at + 10).collect();
    }
    let shared = [0x00, 0x52, 0x29, 0x92, b'S', b'Q', 0, 0];
    let at = moved.windows(8).position(|w| w == shared).unwrap();
    for length in [at + 8, at + 16] {
        let value = u32::from_le_bytes(moved[length..length + 4].try_into().unwrap()) + 30;
        moved[length..length + 4].copy_from_slice(&value.to_le_bytes());
    }
    let groups = moved.windows(8).position(|w| w == [0x00, 0x52, 0x30, 0x92, b'S', b'Q', 0, 0]).unwrap();
    let value = u32::from_le_bytes(moved[groups + 8..groups + 12].try_into().unwrap()) - 60;
    moved[groups + 8..groups + 12].copy_from_slice(&value.to_le_bytes());
    moved.splice(at + 20..at + 20, sequence);
    assert_eq!(volume("shared", &moved).1, volume("own", &own).1);
}

#[test]
fn the_space_that_a_file_declares_is_reported() {
    use InputSpace::{FreesurferRas, Lps, ScannerRas, Unknown};
    let expected = |format, name: &str| match format {
        InputFormat::Nifti | InputFormat::Mgh => ScannerRas,
        InputFormat::Nrrd | InputFormat::MetaImage | InputFormat::DicomSeg => Lps,
        InputFormat::Freesurfer => FreesurferRas,
        _ => {
            if name.contains("LPS") {
                Lps
            } else {
                Unknown
            }
        }
    };
    for (name, format, bytes) in surfaces().into_iter().chain(volumes()) {
        assert_eq!(read_file(&bytes, Some(name)).unwrap().space, expected(format, name), "{name}");
    }
    let of = |bytes: &[u8]| read_file(bytes, None).unwrap().space;
    let mut silent = crate::samples::nifti_2(false);
    // Without codes, positions are through the voxel sizes.
    silent[344..352].fill(0);
    for at in [112, 120, 128] {
        silent[at..at + 8].copy_from_slice(&1.0f64.to_le_bytes());
    }
    assert_eq!(of(&silent), Unknown);
    let scanner = String::from_utf8(gifti("ASCII", false, false, "INT32", IDENTITY)).unwrap();
    let scanner = scanner.replace("NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_SCANNER_ANAT");
    assert_eq!(of(scanner.as_bytes()), ScannerRas);
}

#[test]
fn frames_off_the_stack_are_refused_unless_they_are_of_segments_that_are_not_chosen() {
    let mut stray = dicom_seg("BINARY", &[(17, 0), (17, 1), (53, 4)], |_, _| 1);
    let at = stray.windows(6).position(|w| w == b"\\-0.5\\").unwrap();
    stray[at..at + 6].copy_from_slice(b"\\-1.3\\");
    let error = read_file(&stray, None).unwrap_err().to_string();
    assert!(error.contains("4.40 slices of 2 mm from the first"), "{error}");
    for choice in [LabelChoice::Number(17), LabelChoice::Name("left hippocampus".to_owned())] {
        let options = ReadOptions { labels: Some(vec![choice]), ..ReadOptions::default() };
        let file = read_with(&stray, None, &ReadLimits::default(), &options).unwrap();
        let FileContent::Labels(volume) = file.content else { panic!("labels are expected") };
        assert_eq!(volume.dims()[2], 2);
        assert!(file.notes.iter().any(|note| note.contains("left out: 1 frame")), "{:?}", file.notes);
    }
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
        let mut bytes = crate::samples::nifti_2(false);
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
        ("a.zip", write_zip(&["a", "b"].map(|name| (name.to_owned(), b"text".to_vec()))).unwrap(), "several files"),
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
    let mut bytes = crate::samples::nifti_2(false);
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
