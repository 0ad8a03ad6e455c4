//! One surface and one label volume in every format and variant that is read, written here byte by byte.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use homolog_formats::{InputFormat, ply, vtk, vtp, write_zip};
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Matrix4, Point3};
use std::io::Write;

/// A file: a name for messages, its format, its bytes.
pub(crate) type Sample = (&'static str, InputFormat, Vec<u8>);

/// A double pyramid over a hexagon; its coordinates are exact in single precision.
pub(crate) fn surface() -> SurfaceMesh {
    let ring = [[2.0, 0.0], [1.0, 1.75], [-1.0, 1.75], [-2.0, 0.0], [-1.0, -1.75], [1.0, -1.75]];
    let mut vertices: Vec<Point3<f64>> = ring.iter().map(|&[x, y]| Point3::new(x + 10.5, y - 3.25, 0.125)).collect();
    vertices.extend([Point3::new(10.5, -3.25, 3.0), Point3::new(10.5, -3.25, -2.5)]);
    let faces = (0..6u32).flat_map(|k| [k, (k + 1) % 6, 6, (k + 1) % 6, k, 7]).collect();
    SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap()
}

fn coordinates() -> Vec<f32> {
    surface().vertices().iter().flat_map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect()
}

fn corners() -> Vec<i32> {
    surface().indices().iter().map(|&v| v as i32).collect()
}

fn little<const N: usize, T: Copy>(values: &[T], bytes: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|&v| bytes(v)).collect()
}

pub(crate) fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn lines<T: ToString>(values: &[T], width: usize, head: &str, tail: &str) -> String {
    let line = |row: &[T]| format!("{head}{}{tail}\n", row.iter().map(T::to_string).collect::<Vec<_>>().join(" "));
    values.chunks(width).map(line).collect()
}

/// A pointset and a list of triangles.
pub(crate) fn gifti(encoding: &str, column_major: bool, big: bool, index_type: &str, matrix: &str) -> Vec<u8> {
    let transposed =
        |n: usize| (0..n).map(|k| if column_major { k % (n / 3) * 3 + k / (n / 3) } else { k }).collect::<Vec<_>>();
    let (points, triangles) = (coordinates(), corners());
    let points: Vec<f32> = transposed(points.len()).into_iter().map(|k| points[k]).collect();
    let triangles: Vec<i32> = transposed(triangles.len()).into_iter().map(|k| triangles[k]).collect();
    let data = |text: String, bytes: Vec<u8>| match encoding {
        "ASCII" => text,
        "Base64Binary" => STANDARD.encode(bytes),
        _ => STANDARD.encode(zlib(&bytes)),
    };
    let order = if big { "BigEndian" } else { "LittleEndian" };
    let indexing = if column_major { "ColumnMajorOrder" } else { "RowMajorOrder" };
    let array = |intent: &str, kind: &str, rows: usize, space: &str, data: String| {
        format!(
            "<DataArray Intent=\"NIFTI_INTENT_{intent}\" DataType=\"NIFTI_TYPE_{kind}\" Dimensionality=\"2\" Dim0=\"{rows}\" \
             Dim1=\"3\" Encoding=\"{encoding}\" Endian=\"{order}\" ArrayIndexingOrder=\"{indexing}\" ExternalFileName=\"\">\n\
             <MetaData/>\n{space}<Data>{data}</Data>\n</DataArray>\n"
        )
    };
    let space = format!(
        "<CoordinateSystemTransformMatrix><DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>\
         <TransformedSpace>NIFTI_XFORM_TALAIRACH</TransformedSpace><MatrixData>{matrix}</MatrixData>\
         </CoordinateSystemTransformMatrix>\n"
    );
    let bytes = little(&points, |v| if big { v.to_be_bytes() } else { v.to_le_bytes() });
    let points = array("POINTSET", "FLOAT32", points.len() / 3, &space, data(lines(&points, 3, "", ""), bytes));
    let bytes = little(&triangles, |v| if big { v.to_be_bytes() } else { v.to_le_bytes() });
    let faces = array("TRIANGLE", index_type, triangles.len() / 3, "", data(lines(&triangles, 3, "", ""), bytes));
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM \"gifti.dtd\">\n\
         <GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n<MetaData/>\n{faces}{points}</GIFTI>\n"
    )
    .into_bytes()
}

pub(crate) const IDENTITY: &str = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";

/// `storage`: `ascii`, `inline`, `raw` or `base64` (both appended).
pub(crate) fn vtp_file(storage: &str, compressed: bool, wide: bool) -> Vec<u8> {
    let length = |n: usize| if wide { (n as u64).to_le_bytes().to_vec() } else { (n as u32).to_le_bytes().to_vec() };
    let block = |bytes: &[u8], as_text: bool| -> Vec<u8> {
        let parts = if compressed {
            // Two blocks, the second shorter.
            let size = (bytes.len() * 2).div_ceil(3);
            let blocks: Vec<Vec<u8>> = bytes.chunks(size).map(zlib).collect();
            let last = bytes.len() % size;
            let mut head = [length(blocks.len()), length(size), length(last)].concat();
            head.extend(blocks.iter().flat_map(|b| length(b.len())));
            vec![head, blocks.concat()]
        } else {
            vec![[length(bytes.len()), bytes.to_vec()].concat()]
        };
        if as_text { parts.iter().map(|p| STANDARD.encode(p)).collect::<String>().into_bytes() } else { parts.concat() }
    };
    let ends: Vec<i64> = (1..=12).map(|k| 3 * k).collect();
    let corners: Vec<i64> = corners().into_iter().map(i64::from).collect();
    let arrays = [
        ("Points", "Float32", little(&coordinates(), f32::to_le_bytes), lines(&coordinates(), 3, "", "")),
        ("connectivity", "Int64", little(&corners, i64::to_le_bytes), lines(&corners, 3, "", "")),
        ("offsets", "Int64", little(&ends, i64::to_le_bytes), lines(&ends, 3, "", "")),
    ];
    let mut appended = Vec::new();
    let texts = arrays.map(|(name, kind, bytes, text)| {
        let head = format!("<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"3\" ");
        match storage {
            "ascii" => format!("{head}format=\"ascii\">\n{text}</DataArray>\n"),
            "inline" => {
                let text = String::from_utf8(block(&bytes, true)).unwrap();
                format!("{head}format=\"binary\">\n  {text}\n</DataArray>\n")
            }
            _ => {
                let at = appended.len();
                appended.extend(block(&bytes, storage == "base64"));
                format!("{head}format=\"appended\" offset=\"{at}\"/>\n")
            }
        }
    });
    let compressor = if compressed { " compressor=\"vtkZLibDataCompressor\"" } else { "" };
    let header = if wide { " header_type=\"UInt64\"" } else { "" };
    let mut file = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"{header}{compressor}>\n\
         <PolyData>\n<Piece NumberOfPoints=\"8\" NumberOfPolys=\"12\">\n<Points>\n{}</Points>\n<Polys>\n{}{}</Polys>\n</Piece>\n\
         </PolyData>\n",
        texts[0], texts[1], texts[2]
    )
    .into_bytes();
    if ["raw", "base64"].contains(&storage) {
        file.extend(format!("<AppendedData encoding=\"{storage}\">\n_").into_bytes());
        file.extend(appended);
        file.extend(b"\n</AppendedData>\n");
    }
    file.extend(b"</VTKFile>\n");
    file
}

fn legacy_vtk(version: &str, polygons: &str) -> Vec<u8> {
    let points = lines(&coordinates(), 3, "", "");
    format!("# vtk DataFile Version {version}\nsurface\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n{points}{polygons}")
        .into_bytes()
}

fn freesurfer() -> Vec<u8> {
    let mut file = b"\xff\xff\xfecreated by somebody\n\n\x00\x00\x00\x08\x00\x00\x00\x0c".to_vec();
    file.extend(little(&coordinates(), f32::to_be_bytes));
    file.extend(little(&corners(), i32::to_be_bytes));
    // The geometry of the volume follows.
    file.extend(b"\x00\x00\x00\x02\x00\x00\x00\x00");
    file
}

fn mz3() -> Vec<u8> {
    let mut file = b"MZ\x03\x00\x0c\x00\x00\x00\x08\x00\x00\x00\x04\x00\x00\x00skip".to_vec();
    file.extend(little(&corners(), i32::to_le_bytes));
    file.extend(little(&coordinates(), f32::to_le_bytes));
    file
}

/// [`surface`] in every format with shared vertices.
pub(crate) fn surfaces() -> Vec<Sample> {
    use InputFormat::{Freesurfer, Gifti, Mz3, Obj, Off, Ply, Vtk, Vtp};
    let (points, faces) = (coordinates(), corners());
    let from_one: Vec<i32> = faces.iter().map(|v| v + 1).collect();
    let ends: Vec<i32> = (0..=12).map(|k| 3 * k).collect();
    let ply_head = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\ncomment by hand\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
             property uchar red\nelement face 12\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    let binary_ply = |format: &str, big: bool| {
        let mut file = ply_head(format).into_bytes();
        for p in points.chunks(3) {
            file.extend(little(p, |v| if big { v.to_be_bytes() } else { v.to_le_bytes() }));
            file.push(9);
        }
        for f in faces.chunks(3) {
            file.push(3);
            file.extend(little(f, |v| if big { v.to_be_bytes() } else { v.to_le_bytes() }));
        }
        file
    };
    let ascii_ply = ply_head("ascii") + &lines(&points, 3, "", " 9") + &lines(&faces, 3, "3 ", "");
    let new_cells = format!(
        "POLYGONS 13 36\nOFFSETS vtktypeint64\n{}CONNECTIVITY vtktypeint64\n{}",
        lines(&ends, 9, "", ""),
        lines(&faces, 9, "", "")
    );
    let old_cells = format!("POLYGONS 12 48\n{}", lines(&faces, 3, "3 ", ""));
    let strips = format!("TRIANGLE_STRIPS 12 48\n{}", lines(&faces, 3, "3 ", ""));
    let obj = format!(
        "# by hand\nmtllib none.mtl\n{}vn 0 0 1\n{}",
        lines(&points, 3, "v ", ""),
        faces.chunks(3).map(|f| format!("f {0}//1 {1}//1 {2}//1\n", f[0] + 1, f[1] - 8, f[2] + 1)).collect::<String>()
    );
    let plain_obj = format!("{}{}", lines(&points, 3, "v ", ""), lines(&from_one, 3, "f ", ""));
    let off = format!(
        "OFF # by hand\n# counts\n8 12 0\n{}{}",
        lines(&points, 3, "", ""),
        lines(&faces, 3, "3\t", " 255 0 0")
    );
    let asc =
        format!("#!ascii version of lh.pial\n8 12\n{}{}", lines(&points, 3, "", " 0"), lines(&faces, 3, "", " 0"));
    vec![
        ("FreeSurfer, binary", Freesurfer, freesurfer()),
        ("FreeSurfer, ASCII", Freesurfer, asc.into_bytes()),
        ("GIFTI, ASCII", Gifti, gifti("ASCII", false, false, "INT32", IDENTITY)),
        ("GIFTI, ASCII by columns", Gifti, gifti("ASCII", true, false, "INT32", IDENTITY)),
        ("GIFTI, base64", Gifti, gifti("Base64Binary", false, false, "UINT32", IDENTITY)),
        ("GIFTI, base64 by columns, big-endian", Gifti, gifti("Base64Binary", true, true, "INT32", IDENTITY)),
        ("GIFTI, zlib", Gifti, gifti("GZipBase64Binary", false, false, "INT32", IDENTITY)),
        ("GIFTI, zlib, big-endian", Gifti, gifti("GZipBase64Binary", false, true, "UINT32", "")),
        ("PLY, ASCII", Ply, ascii_ply.into_bytes()),
        ("PLY, little-endian", Ply, binary_ply("binary_little_endian", false)),
        ("PLY, big-endian", Ply, binary_ply("binary_big_endian", true)),
        ("PLY, as written", Ply, ply::write_ply(&surface())),
        ("VTK 2.0, ASCII", Vtk, legacy_vtk("2.0", &old_cells)),
        ("VTK 3.0, strips", Vtk, legacy_vtk("3.0", &strips)),
        ("VTK 5.1, ASCII", Vtk, legacy_vtk("5.1", &new_cells)),
        ("VTK, as written", Vtk, vtk::write_vtk(&surface())),
        ("VTP, ASCII", Vtp, vtp_file("ascii", false, false)),
        ("VTP, inline", Vtp, vtp_file("inline", false, false)),
        ("VTP, inline, wide", Vtp, vtp_file("inline", false, true)),
        ("VTP, inline, zlib", Vtp, vtp_file("inline", true, false)),
        ("VTP, appended raw", Vtp, vtp_file("raw", false, false)),
        ("VTP, appended raw, zlib, wide", Vtp, vtp_file("raw", true, true)),
        ("VTP, appended base64", Vtp, vtp_file("base64", false, true)),
        ("VTP, appended base64, zlib", Vtp, vtp_file("base64", true, false)),
        ("VTP, as written", Vtp, vtp::write_vtp(&surface())),
        ("OBJ", Obj, obj.into_bytes()),
        ("OBJ, only v and f", Obj, plain_obj.into_bytes()),
        ("OFF", Off, off.into_bytes()),
        ("MZ3", Mz3, mz3()),
        ("MZ3, gzip", Mz3, gzip(&mz3())),
    ]
}

/// Voxels of [`volumes`], first index fastest, and the affine to RAS.
pub(crate) const DIMS: [usize; 3] = [3, 4, 2];

pub(crate) fn labels() -> Vec<u32> {
    vec![0, 0, 0, 0, 17, 17, 0, 17, 53, 0, 0, 0, 0, 0, 0, 0, 17, 0, 0, 53, 53, 0, 0, 0]
}

/// Rotated by a quarter about x, with anisotropic voxels of 0.5, 1.25 and 2 mm.
pub(crate) fn affine() -> Matrix4<f64> {
    Matrix4::new(
        -0.5, 0.0, 0.0, 12.0, //
        0.0, 0.0, 2.0, -7.5, //
        0.0, -1.25, 0.0, 3.0, //
        0.0, 0.0, 0.0, 1.0,
    )
}

/// The affine in LPS, column by column.
fn lps() -> [[f64; 3]; 4] {
    [0, 1, 2, 3].map(|k| [-affine()[(0, k)], -affine()[(1, k)], affine()[(2, k)]])
}

fn spaced(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}

pub(crate) fn nifti_2(big: bool) -> Vec<u8> {
    let mut file = vec![0u8; 544];
    let mut put = |at: usize, bytes: &[u8]| {
        let mut bytes = bytes.to_vec();
        if big && bytes.len() <= 8 && at != 4 {
            bytes.reverse();
        }
        file[at..at + bytes.len()].copy_from_slice(&bytes);
    };
    put(0, &540i32.to_le_bytes());
    put(4, b"n+2\0\r\n\x1a\n");
    put(12, &4i16.to_le_bytes());
    for (k, d) in [3i64, 3, 4, 2, 1, 1, 1, 1].iter().enumerate() {
        put(16 + 8 * k, &d.to_le_bytes());
    }
    put(168, &544i64.to_le_bytes());
    put(176, &1f64.to_le_bytes());
    put(348, &1i32.to_le_bytes());
    for r in 0..3 {
        for c in 0..4 {
            put(400 + 32 * r + 8 * c, &affine()[(r, c)].to_le_bytes());
        }
    }
    put(500, &2i32.to_le_bytes());
    file.extend(labels().iter().flat_map(|&l| if big { (l as i16).to_be_bytes() } else { (l as i16).to_le_bytes() }));
    file
}

fn mgh() -> Vec<u8> {
    let mut file: Vec<u8> = little(&[1i32, 3, 4, 2, 1, 1, 0], i32::to_be_bytes);
    file.extend(1i16.to_be_bytes());
    let a = affine();
    let spacing = [0.5, 1.25, 2.0];
    let directions = (0..9).map(|k| a[(k % 3, k / 3)] / spacing[k / 3]);
    let center = a * nalgebra::Vector4::new(1.5, 2.0, 1.0, 1.0);
    let numbers: Vec<f32> =
        spacing.iter().copied().chain(directions).chain(center.iter().take(3).copied()).map(|v| v as f32).collect();
    file.extend(little(&numbers, f32::to_be_bytes));
    file.resize(284, 0);
    file.extend(labels().iter().flat_map(|&l| (l as i32).to_be_bytes()));
    file
}

fn nrrd(encoding: &str) -> Vec<u8> {
    let [x, y, z, origin] = lps().map(|v| format!("({},{},{})", v[0], v[1], v[2]));
    let mut file = format!(
        "NRRD0004\n# by hand\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\nsizes: 3 4 2\n\
         space directions: {x} {y} {z}\nkinds: domain domain domain\nendian: little\nencoding: {encoding}\n\
         space origin: {origin}\n\n"
    )
    .into_bytes();
    let bytes: Vec<u8> = labels().iter().map(|&l| l as u8).collect();
    file.extend(match encoding {
        "raw" => bytes,
        "gzip" => gzip(&bytes),
        _ => lines(&bytes, 3, "", "").into_bytes(),
    });
    file
}

/// Two segments of 3D Slicer in two layers, which share a voxel; both have the value 1 in their layer.
pub(crate) fn layered_nrrd() -> Vec<u8> {
    let [x, y, z, origin] = lps().map(|v| format!("({},{},{})", v[0], v[1], v[2]));
    let mut file = format!(
        "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\nsizes: 2 3 4 2\n\
         space directions: none {x} {y} {z}\nkinds: list domain domain domain\nencoding: raw\nspace origin: {origin}\n\
         Segment0_ID:=a\nSegment0_Name:=Left Hippocampus\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n\
         Segment1_ID:=b\nSegment1_Name:=tumor\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n\n"
    )
    .into_bytes();
    let second = |at: usize| u8::from(at == 8 || at == 4);
    file.extend(labels().iter().enumerate().flat_map(|(at, &l)| [u8::from(l == 17), second(at)]));
    file
}

fn metaimage(variant: &str) -> Vec<u8> {
    let [x, y, z, origin] = lps();
    let unit = |v: [f64; 3], s: f64| v.map(|c| c / s);
    let directions = [unit(x, 0.5), unit(y, 1.25), unit(z, 2.0)].concat();
    let bytes: Vec<u8> = little(&labels().iter().map(|&l| l as u16).collect::<Vec<_>>(), u16::to_be_bytes);
    let body = match variant {
        "zlib" => zlib(&bytes),
        "text" => lines(&labels(), 3, "", "").into_bytes(),
        _ => bytes,
    };
    let (binary, compressed) = (variant != "text", variant == "zlib");
    let mut file = format!(
        "ObjectType = Image\nNDims = 3\nBinaryData = {}\nBinaryDataByteOrderMSB = True\nCompressedData = {}\n\
         CompressedDataSize = {}\nTransformMatrix = {}\nOffset = {}\nElementSpacing = 0.5 1.25 2\nDimSize = 3 4 2\n\
         AnatomicalOrientation = LIP\nElementType = MET_USHORT\nElementDataFile = LOCAL\n",
        if binary { "True" } else { "False" },
        if compressed { "True" } else { "False" },
        body.len(),
        spaced(&directions),
        spaced(&origin),
    )
    .into_bytes();
    file.extend(body);
    file
}

/// Explicit little-endian DICOM, element by element.
#[derive(Default)]
struct Dicom(Vec<u8>);

impl Dicom {
    fn element(&mut self, group: u16, element: u16, kind: &[u8; 2], value: &[u8]) -> &mut Self {
        let mut value = value.to_vec();
        if value.len() % 2 == 1 {
            value.push(if kind == b"UI" { 0 } else { b' ' });
        }
        self.0.extend(group.to_le_bytes());
        self.0.extend(element.to_le_bytes());
        self.0.extend(kind);
        if [b"OB", b"OW", b"SQ"].contains(&kind) {
            self.0.extend([0, 0]);
            self.0.extend((value.len() as u32).to_le_bytes());
        } else {
            self.0.extend((value.len() as u16).to_le_bytes());
        }
        self.0.extend(value);
        self
    }

    /// A sequence; items of undefined length if `open`.
    fn sequence(&mut self, group: u16, element: u16, items: &[Vec<u8>], open: bool) -> &mut Self {
        let mut value = Vec::new();
        for item in items {
            value.extend([0xfe, 0xff, 0x00, 0xe0]);
            value.extend(if open { u32::MAX } else { item.len() as u32 }.to_le_bytes());
            value.extend(item);
            if open {
                value.extend([0xfe, 0xff, 0x0d, 0xe0, 0, 0, 0, 0]);
            }
        }
        self.element(group, element, b"SQ", &value)
    }

    fn bytes(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.0)
    }
}

/// A segmentation with a frame for each (segment, slice), or for each slice of a label map.
pub(crate) fn dicom_seg(kind: &str, frames: &[(u16, usize)], pixel: impl Fn(u16, usize) -> u16) -> Vec<u8> {
    dicom_instance(kind, "", "", frames, pixel)
}

/// The same with the identifiers of the instance and of the concatenation to which it belongs.
pub(crate) fn dicom_instance(
    kind: &str,
    instance: &str,
    concatenation: &str,
    frames: &[(u16, usize)],
    pixel: impl Fn(u16, usize) -> u16,
) -> Vec<u8> {
    let [x, y, z, origin] = lps();
    let joined = |values: &[f64]| values.iter().map(f64::to_string).collect::<Vec<_>>().join("\\").into_bytes();
    let plane = DIMS[0] * DIMS[1];
    let groups: Vec<Vec<u8>> = frames
        .iter()
        .map(|&(segment, slice)| {
            let position: Vec<f64> = (0..3).map(|k| origin[k] + z[k] * slice as f64).collect();
            let position = Dicom::default().element(0x20, 0x32, b"DS", &joined(&position)).bytes();
            let number = Dicom::default().element(0x62, 0x0b, b"US", &segment.to_le_bytes()).bytes();
            let mut group = Dicom::default();
            group.sequence(0x20, 0x9113, &[position], true);
            if kind != "LABELMAP" {
                group.sequence(0x62, 0x0a, &[number], false);
            }
            group.bytes()
        })
        .collect();
    let unit = |v: [f64; 3], s: f64| v.map(|c| c / s);
    let orientation = joined(&[unit(x, 0.5), unit(y, 1.25)].concat());
    let orientation = Dicom::default().element(0x20, 0x37, b"DS", &orientation).bytes();
    let measures =
        Dicom::default().element(0x18, 0x50, b"DS", b"2").element(0x28, 0x30, b"DS", &joined(&[1.25, 0.5])).bytes();
    let shared = Dicom::default()
        .sequence(0x20, 0x9116, &[orientation], false)
        .sequence(0x28, 0x9110, &[measures], true)
        .bytes();
    let segment = |number: u16, name: &str| {
        Dicom::default().element(0x62, 4, b"US", &number.to_le_bytes()).element(0x62, 5, b"LO", name.as_bytes()).bytes()
    };
    let values: Vec<u16> = frames
        .iter()
        .flat_map(|&(s, slice)| (0..plane).map(move |k| (s, slice * plane + k)))
        .map(|(s, at)| pixel(s, at))
        .collect();
    let (bits, pixels): (u16, Vec<u8>) = match kind {
        "BINARY" => (1, values.chunks(8).map(|b| b.iter().rev().fold(0, |sum, &v| sum << 1 | v as u8)).collect()),
        "FRACTIONAL" => (8, values.iter().map(|&v| v as u8).collect()),
        _ => (16, little(&values, u16::to_le_bytes)),
    };
    let class: &[u8] =
        if kind == "LABELMAP" { b"1.2.840.10008.5.1.4.1.1.66.7" } else { b"1.2.840.10008.5.1.4.1.1.66.4" };
    let mut file = vec![0; 128];
    file.extend(b"DICM");
    file.extend(Dicom::default().element(2, 0x10, b"UI", b"1.2.840.10008.1.2.1").bytes());
    file.extend(
        Dicom::default()
            .element(8, 0x16, b"UI", class)
            .element(8, 0x18, b"UI", instance.as_bytes())
            .element(0x20, 0x9161, b"UI", concatenation.as_bytes())
            .element(0x28, 8, b"IS", frames.len().to_string().as_bytes())
            .element(0x28, 0x10, b"US", &(DIMS[1] as u16).to_le_bytes())
            .element(0x28, 0x11, b"US", &(DIMS[0] as u16).to_le_bytes())
            .element(0x28, 0x100, b"US", &bits.to_le_bytes())
            .element(0x62, 1, b"CS", kind.as_bytes())
            .sequence(0x62, 2, &[segment(17, "Left Hippocampus"), segment(53, "Right Hippocampus")], false)
            .element(0x62, 0x0e, b"US", &200u16.to_le_bytes())
            .sequence(0x5200, 0x9229, &[shared], false)
            .sequence(0x5200, 0x9230, &groups, true)
            .element(0x7fe0, 0x10, b"OB", &pixels)
            .bytes(),
    );
    file
}

/// The volume of [`labels`] as two instances, a segment or a slice each.
pub(crate) fn instances(by_slice: bool, concatenation: &str) -> [Vec<u8>; 2] {
    let all = labels();
    let is = |segment: u16, at: usize| u16::from(all[at] == u32::from(segment));
    let frames =
        if by_slice { [[(17, 0), (53, 0)], [(17, 1), (53, 1)]] } else { [[(17, 0), (17, 1)], [(53, 0), (53, 1)]] };
    [("1.2.1", frames[0]), ("1.2.2", frames[1])]
        .map(|(uid, frames)| dicom_instance("BINARY", uid, concatenation, &frames, is))
}

/// These in an archive with an image and a text.
pub(crate) fn archive_of(instances: [Vec<u8>; 2]) -> Vec<u8> {
    let mut image = dicom_seg("BINARY", &[(17, 0)], |_, _| 1);
    let class = b"1.2.840.10008.5.1.4.1.1.66.4";
    let at = image.windows(class.len()).position(|w| w == class).unwrap();
    image[at..at + class.len()].copy_from_slice(b"1.2.840.10008.5.1.4.1.1.2\0\0\0");
    let [a, b] = instances;
    let files = [("study/2.dcm", b), ("study/image", image), ("study/1.dcm", a), ("README", b"a study".to_vec())];
    write_zip(&files.map(|(name, bytes)| (name.to_owned(), bytes))).unwrap()
}

/// The volume of [`labels`] in every format.
pub(crate) fn volumes() -> Vec<Sample> {
    use InputFormat::{DicomSeg, MetaImage, Mgh, Nifti, Nrrd};
    let all = labels();
    let is = |segment: u16, at: usize| u16::from(all[at] == u32::from(segment));
    let frames = [(17, 0), (17, 1), (53, 1), (53, 0)];
    vec![
        ("NIfTI-2", Nifti, nifti_2(false)),
        ("NIfTI-2, big-endian, gzip", Nifti, gzip(&nifti_2(true))),
        ("MGH", Mgh, mgh()),
        ("MGZ", Mgh, gzip(&mgh())),
        ("NRRD, raw", Nrrd, nrrd("raw")),
        ("NRRD, gzip", Nrrd, nrrd("gzip")),
        ("NRRD, ASCII", Nrrd, nrrd("ascii")),
        ("MetaImage", MetaImage, metaimage("raw")),
        ("MetaImage, zlib", MetaImage, metaimage("zlib")),
        ("MetaImage, ASCII", MetaImage, metaimage("text")),
        ("DICOM SEG, binary", DicomSeg, dicom_seg("BINARY", &frames, is)),
        (
            "DICOM SEG, fractional",
            DicomSeg,
            dicom_seg("FRACTIONAL", &frames, |s, at| if is(s, at) == 1 { 100 } else { 99 }),
        ),
        ("DICOM SEG, two instances in an archive", DicomSeg, archive_of(instances(true, "1.2.3"))),
        ("DICOM SEG, label map", DicomSeg, dicom_seg("LABELMAP", &[(0, 1), (0, 0)], |_, at| all[at] as u16)),
    ]
}
