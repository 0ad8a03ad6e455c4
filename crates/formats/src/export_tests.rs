//! Files that other programs read: exact bytes, or read back by readers of our own.

use super::arrow::write_arrow;
use super::gifti::write_gifti;
use super::npy::write_npy;
use super::ply::write_ply_with;
use super::transform::{write_itk_transform, write_lta, write_matrix_text};
use super::vtk::write_vtk_with;
use super::*;
use base64::Engine;
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Isometry3, Matrix4, Point3, Vector3};
use proptest::prelude::*;
use std::io::Read;

fn quads() -> SurfaceMesh {
    let vertices =
        (0..8).map(|k| Point3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2) + 0.1)).collect();
    let faces = vec![0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5];
    SurfaceMesh::new(vertices, FaceArity::Quad, faces).unwrap()
}

fn arrays() -> Vec<VertexArray> {
    vec![
        VertexArray { name: "target", values: VertexValues::Int(vec![7, 6, -1, 4, 3, 2, 1, 0]) },
        VertexArray { name: "confidence", values: VertexValues::Real((0..8).map(|k| f64::from(k) / 7.0).collect()) },
        VertexArray { name: "inlier", values: VertexValues::Byte(vec![1, 0, 0, 1, 1, 1, 0, 1]) },
    ]
}

fn mesh_of(bytes: &[u8]) -> SurfaceMesh {
    match read(bytes, None, &ReadLimits::default()).unwrap().content {
        FileContent::Mesh(file) => file.mesh,
        FileContent::Labels(_) => panic!("a mesh is expected"),
    }
}

#[test]
fn arrays_beside_a_mesh_leave_the_mesh_as_it_is() {
    for bytes in [write_ply_with(&quads(), &arrays()), write_vtk_with(&quads(), &arrays())] {
        assert_eq!(mesh_of(&bytes), quads());
    }
    assert_eq!(write_ply_with(&quads(), &[]), write_ply(&quads()));
    assert_eq!(write_vtk_with(&quads(), &[]), write_vtk(&quads()));
}

#[test]
fn ply_properties_stand_behind_each_position() {
    let bytes = write_ply_with(&quads(), &arrays());
    let end = b"end_header\n";
    let begin = bytes.windows(end.len()).position(|w| w == end).unwrap() + end.len();
    let header = std::str::from_utf8(&bytes[..begin]).unwrap();
    let properties =
        "property double z\nproperty int target\nproperty double confidence\nproperty uchar inlier\nelement";
    assert!(header.contains(properties), "{header}");
    let third = &bytes[begin + 2 * 37..begin + 3 * 37];
    assert_eq!(third[24..28], (-1i32).to_le_bytes());
    assert_eq!(third[28..36], (2.0f64 / 7.0).to_le_bytes());
    assert_eq!(third[36], 0);
}

#[test]
fn vtk_point_data_are_a_field_of_arrays() {
    let bytes = write_vtk_with(&quads(), &arrays());
    let head = b"\nPOINT_DATA 8\nFIELD FieldData 3\ntarget 1 8 int\n";
    let begin = bytes.windows(head.len()).position(|w| w == head).unwrap() + head.len();
    let mut expected: Vec<u8> = [7i32, 6, -1, 4, 3, 2, 1, 0].iter().flat_map(|v| v.to_be_bytes()).collect();
    expected.extend(b"\nconfidence 1 8 double\n");
    expected.extend((0..8).flat_map(|k| (f64::from(k) / 7.0).to_be_bytes()));
    expected.extend(b"\ninlier 1 8 unsigned_char\n\x01\0\0\x01\x01\x01\0\x01\n");
    assert_eq!(bytes[begin..], expected);
}

/// The bytes of every data array of a GIFTI file, with its opening tag.
fn data_arrays(text: &str) -> Vec<(String, Vec<u8>)> {
    let arrays = text.split("<DataArray ").skip(1);
    let decoded = arrays.map(|array| {
        let data = array.split_once("<Data>").unwrap().1.split_once("</Data>").unwrap().0;
        let packed = base64::engine::general_purpose::STANDARD.decode(data).unwrap();
        let mut bytes = Vec::new();
        flate2::read::ZlibDecoder::new(packed.as_slice()).read_to_end(&mut bytes).unwrap();
        (array.split_once("<Data>").unwrap().0.to_owned(), bytes)
    });
    decoded.collect()
}

#[test]
fn gifti_has_the_surface_and_then_the_arrays() {
    let text = String::from_utf8(write_gifti(&quads(), &arrays())).unwrap();
    assert!(text.contains("NumberOfDataArrays=\"5\""));
    let found = data_arrays(&text);
    let points: Vec<u8> =
        quads().vertices().iter().flat_map(|p| p.iter()).flat_map(|&c| (c as f32).to_le_bytes()).collect();
    let triangles: Vec<u8> = quads().triangles().iter().flatten().flat_map(|v| v.to_le_bytes()).collect();
    let target: Vec<u8> = [7i32, 6, -1, 4, 3, 2, 1, 0].iter().flat_map(|v| v.to_le_bytes()).collect();
    let confidence: Vec<u8> = (0..8).flat_map(|k| ((f64::from(k) / 7.0) as f32).to_le_bytes()).collect();
    let expected = [
        ("POINTSET", "FLOAT32", "Dim0=\"8\" Dim1=\"3\"", points),
        ("TRIANGLE", "INT32", "Dim0=\"12\" Dim1=\"3\"", triangles),
        ("NONE", "INT32", "Dimensionality=\"1\" Dim0=\"8\"", target),
        ("NONE", "FLOAT32", "Dim0=\"8\"", confidence),
        ("NONE", "UINT8", "Dim0=\"8\"", vec![1, 0, 0, 1, 1, 1, 0, 1]),
    ];
    assert_eq!(found.len(), expected.len());
    for ((tag, bytes), (intent, kind, dimensions, values)) in found.iter().zip(&expected) {
        assert!(tag.contains(&format!("Intent=\"NIFTI_INTENT_{intent}\" DataType=\"NIFTI_TYPE_{kind}\"")), "{tag}");
        assert!(tag.contains(dimensions), "{tag}");
        assert_eq!(bytes, values);
    }
    assert!(found[3].0.contains("<![CDATA[confidence]]>"));
    assert_eq!(data_arrays(std::str::from_utf8(&write_gifti(&quads(), &[])).unwrap()).len(), 2);
}

#[test]
fn npy_is_a_structured_array() {
    let pairs = PairColumns {
        source: &[0, 300],
        target: &[5, 4],
        confidence: &[0.5, 1.0],
        inlier: &[true, false],
        spread_mm: &[0.25, 2.0],
        outlier: &[0, 3],
        triangle: &[[5, 6, 7], [1, 4, 2]],
        barycentric: &[[1.0, 0.0, 0.0], [0.25, 0.5, 0.25]],
    };
    let bytes = write_npy(&pairs);
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!((&bytes[..8], (10 + length) % 64, bytes[9 + length]), (b"\x93NUMPY\x01\0".as_slice(), 0, b'\n'));
    let header = std::str::from_utf8(&bytes[10..10 + length]).unwrap().trim_end();
    let fields = "[('source', '<u4'), ('target', '<u4'), ('confidence', '<f8'), ('inlier', '|b1'), \
                  ('spread_mm', '<f8'), ('outlier', '|u1'), ('triangle', '<u4', (3,)), ('barycentric', '<f8', (3,))]";
    assert_eq!(header, format!("{{'descr': {fields}, 'fortran_order': False, 'shape': (2,), }}"));
    let mut rows = vec![0, 0, 0, 0, 5, 0, 0, 0];
    rows.extend(0.5f64.to_le_bytes());
    rows.push(1);
    rows.extend(0.25f64.to_le_bytes());
    rows.push(0);
    rows.extend([5u32, 6, 7].iter().flat_map(|v| v.to_le_bytes()));
    rows.extend([1.0f64, 0.0, 0.0].iter().flat_map(|v| v.to_le_bytes()));
    rows.extend([44, 1, 0, 0, 4, 0, 0, 0]);
    rows.extend(1.0f64.to_le_bytes());
    rows.push(0);
    rows.extend(2.0f64.to_le_bytes());
    rows.push(3);
    rows.extend([1u32, 4, 2].iter().flat_map(|v| v.to_le_bytes()));
    rows.extend([0.25f64, 0.5, 0.25].iter().flat_map(|v| v.to_le_bytes()));
    assert_eq!(bytes[10 + length..], rows);
}

/// Follows a FlatBuffer: numbers, links and vectors of tables, each from its place.
struct Buffer<'a>(&'a [u8]);

impl Buffer<'_> {
    fn u16(&self, at: usize) -> usize {
        u16::from_le_bytes(*self.0[at..].first_chunk().unwrap()).into()
    }
    fn i32(&self, at: usize) -> i32 {
        i32::from_le_bytes(*self.0[at..].first_chunk().unwrap())
    }
    fn i64(&self, at: usize) -> usize {
        assert_eq!(at % 8, 0, "not aligned");
        usize::try_from(i64::from_le_bytes(*self.0[at..].first_chunk().unwrap())).unwrap()
    }
    fn follow(&self, at: usize) -> usize {
        assert_eq!(at % 4, 0, "not aligned");
        at + self.i32(at) as usize
    }
    fn field(&self, table: usize, index: usize) -> Option<usize> {
        let vtable = (table as i64 - i64::from(self.i32(table))) as usize;
        let offset = if 4 + 2 * index < self.u16(vtable) { self.u16(vtable + 4 + 2 * index) } else { 0 };
        (offset > 0).then_some(table + offset)
    }
    fn vector(&self, table: usize, index: usize) -> (usize, usize) {
        let place = self.follow(self.field(table, index).unwrap());
        (self.i32(place) as usize, place + 4)
    }
}

type Columns = (Vec<u32>, Vec<u32>, Vec<f64>, Vec<bool>, Vec<f64>, Vec<u8>, Vec<[u32; 3]>, Vec<[f64; 3]>);

/// Reads what [`write_arrow`] writes, beginning at the end as readers of the file format do.
fn read_arrow(file: &[u8]) -> Columns {
    assert!(file.starts_with(b"ARROW1\0\0") && file.ends_with(b"ARROW1"));
    let length = u32::from_le_bytes(*file[file.len() - 10..].first_chunk().unwrap()) as usize;
    let begin = file.len() - 10 - length;
    assert_eq!(file[begin - 8..begin], [0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0], "the stream has an end");
    let footer = Buffer(&file[begin..begin + length]);
    let root = footer.follow(0);
    let schema = footer.follow(footer.field(root, 1).unwrap());
    let (n_fields, fields) = footer.vector(schema, 1);
    let names: Vec<_> = (0..n_fields)
        .map(|k| {
            let (length, place) = footer.vector(footer.follow(fields + 4 * k), 0);
            std::str::from_utf8(&footer.0[place..place + length]).unwrap().to_owned()
        })
        .collect();
    assert_eq!(names[..6], ["source", "target", "confidence", "inlier", "spread_mm", "outlier"]);
    assert_eq!(names[6..9], ["triangle_0", "triangle_1", "triangle_2"]);
    assert_eq!(names[9..], ["barycentric_0", "barycentric_1", "barycentric_2"]);
    let (n_batches, block) = footer.vector(root, 3);
    assert_eq!(n_batches, 1);
    let (offset, metadata) = (footer.i64(block), footer.i32(block + 8) as usize);
    assert_eq!((offset % 8, metadata % 8, file[offset..offset + 4].to_vec()), (0, 0, vec![0xff; 4]));
    let message = Buffer(&file[offset + 8..offset + metadata]);
    let body = &file[offset + metadata..offset + metadata + footer.i64(block + 16)];
    let root = message.follow(0);
    assert_eq!(
        (message.0[message.field(root, 1).unwrap()], message.i64(message.field(root, 3).unwrap())),
        (3, body.len())
    );
    let batch = message.follow(message.field(root, 2).unwrap());
    let n = message.i64(message.field(batch, 0).unwrap());
    let (n_nodes, nodes) = message.vector(batch, 1);
    assert_eq!((n_nodes, message.i64(nodes), message.i64(nodes + 8)), (12, n, 0));
    let (n_buffers, buffers) = message.vector(batch, 2);
    assert_eq!(n_buffers, 24);
    let values = |column: usize| {
        let at = buffers + 16 * (2 * column + 1);
        assert_eq!(message.i64(at) % 8, 0);
        &body[message.i64(at)..message.i64(at) + message.i64(at + 8)]
    };
    let u32s = |column| values(column).as_chunks::<4>().0.iter().map(|&b| u32::from_le_bytes(b)).collect::<Vec<_>>();
    let reals =
        |column| -> Vec<_> { values(column).as_chunks::<8>().0.iter().map(|&b| f64::from_le_bytes(b)).collect() };
    let bits = (0..n).map(|k| values(3)[k / 8] >> (k % 8) & 1 == 1).collect();
    assert_eq!([u32s(0).len(), u32s(1).len(), reals(2).len(), reals(4).len(), values(5).len()], [n; 5]);
    let triangles = (0..n).map(|k| [6, 7, 8].map(|column| u32s(column)[k])).collect();
    let weights = (0..n).map(|k| [9, 10, 11].map(|column| reals(column)[k])).collect();
    (u32s(0), u32s(1), reals(2), bits, reals(4), values(5).to_vec(), triangles, weights)
}

proptest! {
    #[test]
    fn any_pairs_survive_arrow(rows in proptest::collection::vec((any::<u32>(), any::<u32>(), 0.0..1.0f64, any::<bool>(), 0.0..9.0f64, 0..4u8, any::<[u32; 3]>(), [0.0..1.0f64, 0.0..1.0f64, 0.0..1.0f64]), 0..70)) {
        let columns: Columns = (
            rows.iter().map(|r| r.0).collect(),
            rows.iter().map(|r| r.1).collect(),
            rows.iter().map(|r| r.2).collect(),
            rows.iter().map(|r| r.3).collect(),
            rows.iter().map(|r| r.4).collect(),
            rows.iter().map(|r| r.5).collect(),
            rows.iter().map(|r| r.6).collect(),
            rows.iter().map(|r| r.7).collect(),
        );
        let pairs = PairColumns {
            source: &columns.0,
            target: &columns.1,
            confidence: &columns.2,
            inlier: &columns.3,
            spread_mm: &columns.4,
            outlier: &columns.5,
            triangle: &columns.6,
            barycentric: &columns.7,
        };
        prop_assert_eq!(read_arrow(&write_arrow(&pairs)), columns);
    }
}

/// A turn about an oblique axis with a shift, and the numbers as the writers take them.
fn motion() -> (Isometry3<f64>, [[f64; 4]; 4]) {
    let motion = Isometry3::new(Vector3::new(12.5, -3.25, 40.0), Vector3::new(0.3, -0.7, 0.2));
    let matrix = motion.to_homogeneous();
    (motion, std::array::from_fn(|r| std::array::from_fn(|c| matrix[(r, c)])))
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().map(|word| word.parse().unwrap()).collect()
}

#[test]
fn an_itk_transform_takes_target_points_to_source_points_in_lps() {
    let (target_from_source, matrix) = motion();
    let text = write_itk_transform(&matrix).unwrap();
    let line = |name: &str| text.lines().find_map(|l| l.strip_prefix(name)).unwrap();
    assert_eq!(line("Transform: "), "AffineTransform_double_3_3");
    assert_eq!(numbers(line("FixedParameters: ")), [0.0; 3]);
    let p = numbers(line("Parameters: "));
    let apply = |q: [f64; 3]| -> [f64; 3] {
        std::array::from_fn(|r| p[3 * r] * q[0] + p[3 * r + 1] * q[1] + p[3 * r + 2] * q[2] + p[9 + r])
    };
    let lps = |p: Point3<f64>| [-p.x, -p.y, p.z];
    for source in [Point3::new(1.0, 2.0, 3.0), Point3::new(-70.0, 15.5, 0.25), Point3::origin()] {
        let target = target_from_source * source;
        let found = apply(lps(target));
        assert!(found.iter().zip(lps(source)).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }
    assert!(write_itk_transform(&[[0.0; 4]; 4]).is_none());
}

#[test]
fn a_translation_has_the_documented_direction_in_each_file() {
    let mut shift: [[f64; 4]; 4] = std::array::from_fn(|r| std::array::from_fn(|c| f64::from(u8::from(r == c))));
    (shift[0][3], shift[1][3], shift[2][3]) = (1.0, 2.0, 3.0);
    // To the source from the target: −1, −2, −3 in RAS, so 1, 2, −3 in LPS.
    let itk = write_itk_transform(&shift).unwrap();
    assert!(itk.contains("Parameters: 1.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 1.0 1.0 2.0 -3.0\n"), "{itk}");
    assert_eq!(write_matrix_text(&shift), "1.0 0.0 0.0 1.0\n0.0 1.0 0.0 2.0\n0.0 0.0 1.0 3.0\n0.0 0.0 0.0 1.0\n");
}

#[test]
fn text_and_lta_hold_the_matrix_as_it_is() {
    let (_, matrix) = motion();
    let rows = |text: &str| text.lines().map(numbers).collect::<Vec<_>>();
    assert_eq!(rows(&write_matrix_text(&matrix)), matrix.map(|row| row.to_vec()), "to the bit");
    let lta = write_lta(&matrix, [None; 2]);
    let mut lines = lta.lines();
    assert!(lines.next().unwrap().split_whitespace().eq(["type", "=", "1", "#", "LINEAR_RAS_TO_RAS"]));
    let found: Vec<_> = lines.skip(4).take(4).map(numbers).collect();
    let error = Matrix4::from_fn(|r, c| found[r][c] - matrix[r][c]).norm();
    assert!(error < 1e-12, "{lta}");
    assert_eq!(lta.matches("valid = 0").count(), 2);
    assert!(lta.contains("\nsrc volume info\n") && lta.contains("\ndst volume info\n"));
    // Voxels of 2 x 1 x 3 mm, the first axis to the left and the second upwards.
    let affine = Matrix4::new(-2.0, 0.0, 0.0, 10.0, 0.0, 0.0, 3.0, -4.0, 0.0, 1.0, 0.0, 6.0, 0.0, 0.0, 0.0, 1.0);
    let volume = homolog_mesh::volume::LabelVolume::new([4, 6, 2], vec![1; 48], affine).unwrap();
    let lta = write_lta(&matrix, [None, Some(&volume)]);
    let geometry = lta.split("dst volume info\n").nth(1).unwrap();
    let values = |name: &str| {
        let line = geometry.lines().find(|line| line.starts_with(name)).unwrap();
        numbers(line.split_once('=').unwrap().1)
    };
    assert!(geometry.starts_with("valid = 1 ") && geometry.contains("volume = 4 6 2\n"), "{geometry}");
    assert_eq!(values("voxelsize"), [2.0, 1.0, 3.0]);
    assert_eq!([values("xras"), values("yras"), values("zras")], [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]);
    assert_eq!(values("cras"), [10.0 - 4.0, -4.0 + 3.0, 6.0 + 3.0], "the middle of the volume");
}
