//! Writing and reading back, small files of every dialect by hand, and damaged files of every format.

use super::*;
use homolog_mesh::volume::{VoxelMask, voxel_surface};
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Matrix4, Point3};
use proptest::prelude::*;
use std::io::Write;

fn limits() -> ReadLimits {
    ReadLimits::default()
}

fn tetrahedron() -> SurfaceMesh {
    let v = [[0.0, 0.0, 0.0], [1.5, 0.0, 0.0], [0.0, 2.25, 0.0], [0.0, 0.0, -3.0]].map(Point3::from).to_vec();
    SurfaceMesh::new(v, FaceArity::Triangle, vec![0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2]).unwrap()
}

fn box_of_quads() -> SurfaceMesh {
    let labels = vec![0, 7, 7, 0];
    let volume = LabelVolume::new([4, 1, 1], labels, Matrix4::identity()).unwrap();
    let mask: VoxelMask = volume.mask(None).unwrap();
    voxel_surface(&mask).unwrap()
}

fn volume() -> LabelVolume {
    let affine = Matrix4::new(
        -0.5, 0.0, 0.0, 12.0, //
        0.0, 0.0, 2.0, -7.5, //
        0.0, 1.0, 0.0, 3.0, //
        0.0, 0.0, 0.0, 1.0,
    );
    LabelVolume::new([3, 2, 2], vec![0, 1, 2, 0, 0, 5, 0, 255, 0, 0, 0, 9], affine).unwrap()
}

fn mesh_of(bytes: &[u8]) -> Result<SurfaceMesh, FormatError> {
    match read(bytes, None, &limits())?.content {
        FileContent::Mesh(file) => Ok(file.mesh),
        FileContent::Labels(_) => panic!("a mesh is expected"),
    }
}

fn labels_of(bytes: &[u8]) -> Result<LabelVolume, FormatError> {
    match read(bytes, None, &limits())?.content {
        FileContent::Labels(volume) => Ok(volume),
        FileContent::Mesh(_) => panic!("a volume is expected"),
    }
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

#[test]
fn what_is_written_is_read_back() {
    for mesh in [tetrahedron(), box_of_quads()] {
        assert_eq!(mesh_of(&write_ply(&mesh)).unwrap(), mesh);
        assert_eq!(mesh_of(&write_vtk(&mesh)).unwrap(), mesh);
        assert_eq!(mesh_of(&gzip(&write_vtk(&mesh))).unwrap(), mesh);
    }
    // STL names vertices in the order in which facets meet them.
    let stl = mesh_of(&write_stl(&tetrahedron())).unwrap();
    assert_eq!((stl.n_vertices(), stl.n_faces(), stl.signed_volume()), (4, 4, tetrahedron().signed_volume()));
    assert_eq!(labels_of(&write_nifti(&volume())).unwrap(), volume());
    assert_eq!(labels_of(&write_nifti_gz(&volume())).unwrap(), volume());
}

#[test]
fn nifti_bytes_agree_with_an_independent_reader() {
    use ::nifti::{InMemNiftiObject, NiftiObject};
    let bytes = write_nifti(&volume());
    let object = InMemNiftiObject::from_reader(bytes.as_slice()).unwrap();
    let header = object.header();
    assert_eq!((&header.dim[..4], header.datatype, header.vox_offset), ([3u16, 3, 2, 2].as_slice(), 2, 352.0));
    assert_eq!(header.srow_x, [-0.5, 0.0, 0.0, 12.0]);
}

/// A header for `dims` with the given type code, to be changed by the test.
fn nifti_with(code: i16, voxels: &[u8], change: impl Fn(&mut [u8])) -> Vec<u8> {
    let mut bytes = write_nifti(&volume())[..352].to_vec();
    bytes[70..72].copy_from_slice(&code.to_le_bytes());
    change(&mut bytes);
    bytes.extend(voxels);
    bytes
}

#[test]
fn every_element_type_and_scaling_reads_the_same_labels() {
    let values = volume().labels().to_vec();
    let encoded = |f: &dyn Fn(u32) -> Vec<u8>| values.iter().flat_map(|&v| f(v)).collect::<Vec<u8>>();
    let cases: Vec<(i16, Vec<u8>)> = vec![
        (4, encoded(&|v| (v as i16).to_le_bytes().to_vec())),
        (8, encoded(&|v| (v as i32).to_le_bytes().to_vec())),
        (16, encoded(&|v| (v as f32).to_le_bytes().to_vec())),
        (64, encoded(&|v| f64::from(v).to_le_bytes().to_vec())),
        (512, encoded(&|v| (v as u16).to_le_bytes().to_vec())),
        (768, encoded(&|v| v.to_le_bytes().to_vec())),
        (1024, encoded(&|v| i64::from(v).to_le_bytes().to_vec())),
        (1280, encoded(&|v| u64::from(v).to_le_bytes().to_vec())),
    ];
    for (code, voxels) in cases {
        assert_eq!(labels_of(&nifti_with(code, &voxels, |_| ())).unwrap(), volume(), "{code}");
    }
    let scaled = nifti_with(64, &encoded(&|v| ((f64::from(v) - 1.0) / 0.25).to_le_bytes().to_vec()), |h| {
        h[112..116].copy_from_slice(&0.25f32.to_le_bytes());
        h[116..120].copy_from_slice(&1f32.to_le_bytes());
    });
    assert_eq!(labels_of(&scaled).unwrap(), volume());
    let image = nifti_with(64, &encoded(&|v| (f64::from(v) * 0.3).to_le_bytes().to_vec()), |_| ());
    assert!(matches!(labels_of(&image), Err(FormatError::NotALabel { voxel: [1, 0, 0], .. })));
    assert!(matches!(labels_of(&nifti_with(128, &[0; 99], |_| ())), Err(FormatError::Header { .. })));
}

#[test]
fn a_big_endian_file_reads_the_same() {
    let mut bytes = write_nifti(&volume());
    let mut swap = |at: usize, n: usize| bytes[at..at + n].reverse();
    swap(0, 4);
    (0..8).for_each(|k| swap(40 + 2 * k, 2));
    [70, 72, 252, 254].iter().for_each(|&at| swap(at, 2));
    (0..12).for_each(|k| swap(76 + 4 * k, 4));
    (0..18).for_each(|k| swap(256 + 4 * k, 4));
    assert_eq!(labels_of(&bytes).unwrap(), volume());
}

#[test]
fn the_affine_is_sform_then_qform_then_voxel_sizes() {
    let voxels: Vec<u8> = volume().labels().iter().map(|&v| v as u8).collect();
    let affine = |change: &dyn Fn(&mut [u8])| *labels_of(&nifti_with(2, &voxels, change)).unwrap().affine();
    let f = |h: &mut [u8], at: usize, v: f32| h[at..at + 4].copy_from_slice(&v.to_le_bytes());
    // A half turn about z, mirrored z, as qform; spacing 0.5, 1, 2 as written.
    let qform = affine(&|h| {
        h[252..256].copy_from_slice(&[1, 0, 0, 0]);
        f(h, 76, -1.0);
        f(h, 264, 1.0);
        f(h, 268, 10.0);
    });
    let expected = Matrix4::new(
        -0.5, 0.0, 0.0, 10.0, //
        0.0, -1.0, 0.0, 0.0, //
        0.0, 0.0, -2.0, 0.0, //
        0.0, 0.0, 0.0, 1.0,
    );
    assert!((qform - expected).norm() < 1e-12, "{qform}");
    let plain = affine(&|h| h[252..256].copy_from_slice(&[0; 4]));
    assert_eq!(plain, Matrix4::from_diagonal(&nalgebra::Vector4::new(0.5, 1.0, 2.0, 1.0)));
    let meters = affine(&|h| h[123] = 1);
    assert_eq!(meters[(0, 3)], 12_000.0);
    assert_eq!(affine(&|h| h[123] = 3)[(0, 0)], -0.0005);
    for bad in [0.0, f32::NAN] {
        let bytes = nifti_with(2, &voxels, |h| (0..3).for_each(|k| f(h, 280 + 4 * k, bad)));
        assert!(matches!(labels_of(&bytes), Err(FormatError::Volume(_))));
    }
}

#[test]
fn counts_larger_than_the_file_allocate_nothing() {
    let huge = nifti_with(2, &[], |h| h[42..48].copy_from_slice(&[0xff, 0x7f, 0xff, 0x7f, 1, 0]));
    assert!(matches!(labels_of(&huge), Err(FormatError::TooLarge { .. })));
    let large = nifti_with(2, &[], |h| h[42..48].copy_from_slice(&[0, 1, 0, 1, 0, 1]));
    assert!(matches!(labels_of(&large), Err(FormatError::Truncated { .. })));
    assert!(matches!(labels_of(&gzip(&large)), Err(FormatError::Truncated { .. })));
    let faces = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
                 property float z\nelement face 4000000000\nproperty list uint int vertex_indices\nend_header\n";
    assert!(matches!(mesh_of(faces.as_bytes()), Err(FormatError::TooLarge { .. })));
    let empty = "ply\nformat ascii 1.0\nelement nothing 4000000000\nelement vertex 1\nproperty float x\n\
                 property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    assert!(mesh_of(empty.as_bytes()).is_err());
    let mut stl = vec![0; 84];
    stl[80..].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(matches!(read(&stl, Some("a.stl"), &limits()), Err(FormatError::CountMismatch { found: 0, .. })));
    for section in
        ["POINTS 100000000000 float", "POLYGONS 4000000000 16000000000", "TRIANGLE_STRIPS 1 18446744073709551615"]
    {
        for encoding in ["ASCII", "BINARY"] {
            let vtk = format!("# vtk DataFile Version 3.0\n\n{encoding}\nDATASET POLYDATA\n{section}\n");
            assert!(mesh_of(vtk.as_bytes()).is_err());
        }
    }
    let bomb = gzip(&vec![b'#'; 1 << 20]);
    let small = ReadLimits { max_inflated_bytes: 1 << 16, ..limits() };
    assert!(matches!(read(&bomb, Some("a.vtk"), &small), Err(FormatError::TooLarge { .. })));
}

#[test]
fn dialects_of_ply() {
    let ascii = "ply\r\nformat ascii 1.0\r\ncomment hello\r\nelement vertex 5\r\nproperty double x\r\nproperty double y\r\n\
        property uchar red\r\nproperty double z\r\nelement edge 1\r\nproperty int a\r\nelement face 2\r\n\
        property uchar flag\r\nproperty list uchar uint vertex_index\r\nend_header\r\n\
        0 0 9 0\r\n1 0 9 0\r\n1 1 9 0\r\n0 1 9 0\r\n0 0 9 1\r\n7\r\n1 4 0 1 2 3\r\n1 3 0 4 1\r\n";
    let mesh = mesh_of(ascii.as_bytes()).unwrap();
    assert_eq!((mesh.arity(), mesh.indices()), (FaceArity::Triangle, [0, 1, 2, 0, 2, 3, 0, 4, 1].as_slice()));
    let negative = ascii.replace("uchar uint", "uchar int").replace("3 0 4 1", "3 0 -4 1");
    assert_eq!(mesh_of(negative.as_bytes()), Err(FormatError::NegativeIndex { face: 1, vertex: -4 }));
    let outside = ascii.replace("3 0 4 1", "3 0 5 1");
    assert!(matches!(mesh_of(outside.as_bytes()), Err(FormatError::Mesh(_))));
}

#[test]
fn dialects_of_stl() {
    let ascii = "solid vertex 1 2 3 of somebody\n facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1e0 0 0\n\
        vertex 0 1 0\n endloop\n endfacet\nendsolid\nsolid b\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 1 0 0\nVERTEX 1 1 0\n\
        VERTEX 0 1 0\nENDLOOP\nENDFACET\nENDSOLID b\n";
    let mesh = mesh_of(ascii.as_bytes()).unwrap();
    assert_eq!(mesh.indices(), [0, 1, 2, 1, 3, 2]);
    let cut = mesh_of(&ascii.as_bytes()[..100]).unwrap_err();
    assert!(matches!(cut, FormatError::Syntax { .. }), "{cut}");
    let mut binary = write_stl(&tetrahedron());
    binary[..6].copy_from_slice(b"solid ");
    assert_eq!(mesh_of(&binary).unwrap().n_vertices(), 4);
    let independent = stl_io::read_stl(&mut std::io::Cursor::new(write_stl(&box_of_quads()))).unwrap();
    assert_eq!((independent.vertices.len(), independent.faces.len()), (12, 20));
}

#[test]
fn dialects_of_vtk() {
    let old = "# vtk DataFile Version 2.0\nPOINTS of a patient\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nTimeValue 1 1 double\n\
        0.5\nPOINTS 5 float\n0 0 0 1 0 0\n1 1 0 0 1 0 0 0 1\nMETADATA\nINFORMATION 0\n\nLINES 1 3\n2 0 1\n\
        POLYGONS 1 5\n4 0 1 2 3\nPOINT_DATA 5\nSCALARS x float\nLOOKUP_TABLE default\n1 1 1 1 1\n";
    assert_eq!(mesh_of(old.as_bytes()).unwrap().arity(), FaceArity::Quad);
    let strips = old.replace("POLYGONS 1 5\n4 0 1 2 3", "TRIANGLE_STRIPS 1 7\n6 0 1 3 3 2 4");
    assert_eq!(mesh_of(strips.as_bytes()).unwrap().indices(), [0, 1, 3, 2, 3, 4]);
    let new = old.replace(
        "POLYGONS 1 5\n4 0 1 2 3",
        "POLYGONS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY vtktypeint64\n0 1 2 3 0 4 1",
    );
    assert_eq!(mesh_of(new.as_bytes()).unwrap().indices(), [0, 1, 2, 0, 2, 3, 0, 4, 1]);
    let mut binary = b"# vtk DataFile Version 5.1\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n".to_vec();
    binary.extend([0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|c| c.to_be_bytes()));
    binary.extend(b"\nMETADATA\nINFORMATION 1\nNAME L2 LOCATION vtk\nDATA 1 0\n\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n");
    binary.extend([0i64, 3].iter().flat_map(|c| c.to_be_bytes()));
    binary.extend(b"\nCONNECTIVITY vtktypeint64\n");
    binary.extend([0i64, 1, 2].iter().flat_map(|c| c.to_be_bytes()));
    assert_eq!(mesh_of(&binary).unwrap().indices(), [0, 1, 2]);
    let fields =
        "FIELD FieldData 2\nSource 1 1 string\nsome%20body\nMETADATA\nINFORMATION 0\n\nTimeValue 1 1 double\n0.5\n";
    let with_text = old.replace("FIELD FieldData 1\nTimeValue 1 1 double\n        0.5\n", fields);
    let with_text = with_text.replace("FIELD FieldData 1\nTimeValue 1 1 double\n0.5\n", fields);
    assert!(with_text.contains("string"));
    assert_eq!(mesh_of(with_text.as_bytes()).unwrap(), mesh_of(old.as_bytes()).unwrap());
    let grid = "# vtk DataFile Version 2.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n";
    assert!(matches!(mesh_of(grid.as_bytes()), Err(FormatError::Unsupported { .. })));
}

#[test]
fn errors_repeat_no_text_of_the_file() {
    let name = "Doe^Jane";
    let vtk = format!("# vtk DataFile Version 2.0\n{name}\nASCII\nDATASET POLYDATA\nPOINTS {name} float\n");
    let ply = format!(
        "ply\nformat ascii 1.0\ncomment {name}\nelement vertex 1\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n{name}\n"
    );
    let ply_header = format!("ply\nformat ascii 1.0\nelement {name}\nend_header\n");
    let stl = format!("solid {name}\nfacet {name}\nouter loop\n vertex {name} 0 0\n");
    for text in [vtk, ply, ply_header, stl] {
        let error = read(text.as_bytes(), Some(name), &limits()).unwrap_err();
        assert!(!format!("{error} {error:?}").contains("Doe"), "{error}");
    }
}

#[test]
fn the_file_name_decides_only_where_the_content_does_not() {
    assert_eq!(read(b"hello", None, &limits()), Err(FormatError::UnknownFormat));
    assert_eq!(read(b"hello", Some("x.txt"), &limits()), Err(FormatError::UnknownFormat));
    assert_eq!(read(b"hello", Some("x.NII.gz"), &limits()), Err(FormatError::NotAsNamed { promised: "NIfTI" }));
    let misnamed = read(&write_ply(&tetrahedron()), Some("x.stl"), &limits()).unwrap();
    assert_eq!(misnamed.format, InputFormat::Ply);
    assert_eq!(misnamed.notes.len(), 1, "{:?}", misnamed.notes);
}

fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let ascii_ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let ascii_stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    let new_vtk = "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 2 3\n\
        OFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\n";
    vec![
        ("a.nii", write_nifti(&volume())),
        ("a.nii.gz", write_nifti_gz(&volume())),
        ("a.ply", write_ply(&tetrahedron())),
        ("a.ply", ascii_ply.into()),
        ("a.stl", write_stl(&tetrahedron())),
        ("a.stl", ascii_stl.into()),
        ("a.vtk", write_vtk(&box_of_quads())),
        ("a.vtk", new_vtk.into()),
        ("a.vtk.gz", gzip(&write_vtk(&tetrahedron()))),
    ]
}

#[test]
fn truncated_files_neither_panic_nor_hang() {
    for (name, bytes) in samples() {
        assert!(read(&bytes, Some(name), &limits()).is_ok(), "{name}");
        for length in 0..bytes.len() {
            let _ = read(&bytes[..length], Some(name), &limits());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn flipped_bytes_neither_panic_nor_hang(
        which in 0..9usize, flips in proptest::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let (name, mut bytes) = samples().swap_remove(which);
        for (at, value) in flips {
            let at = at.index(bytes.len());
            bytes[at] = value;
        }
        // A test that hangs is ended by the runner; `make fuzz` looks for slow inputs.
        let _ = read(&bytes, Some(name), &ReadLimits { max_inflated_bytes: 1 << 24, max_vertices: 100_000, ..limits() });
    }

    #[test]
    fn random_bytes_do_not_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400), name in 0..4usize) {
        let name = ["a.nii", "a.ply", "a.stl", "a.vtk"][name];
        let _ = read(&bytes, Some(name), &limits());
    }
}

proptest! {
    #[test]
    fn any_mesh_survives_ply_and_vtk(
        v in proptest::collection::vec(proptest::array::uniform3(-1e6..1e6f64), 4..20),
        f in proptest::collection::vec(proptest::sample::subsequence(vec![0u32, 1, 2, 3], 3), 1..9), quads: bool,
    ) {
        let vertices: Vec<_> = v.into_iter().map(Point3::from).collect();
        let mesh = if quads {
            SurfaceMesh::new(vertices, FaceArity::Quad, [0, 1, 2, 3].repeat(f.len())).unwrap()
        } else {
            SurfaceMesh::new(vertices, FaceArity::Triangle, f.concat()).unwrap()
        };
        prop_assert_eq!(&mesh_of(&write_ply(&mesh)).unwrap(), &mesh);
        prop_assert_eq!(&mesh_of(&write_vtk(&mesh)).unwrap(), &mesh);
    }

    #[test]
    fn any_labels_survive_nifti(labels in proptest::collection::vec(0..70_000u32, 24), narrow: bool) {
        let labels = labels.into_iter().map(|l| if narrow { l % 256 } else { l }).collect();
        let volume = LabelVolume::new([2, 3, 4], labels, *volume().affine()).unwrap();
        prop_assert_eq!(&labels_of(&write_nifti_gz(&volume)).unwrap(), &volume);
    }
}
