//! What reading may hold: 64 times what was received and 16 MiB, whatever the format and however it is compressed; beyond that
//! only four times the voxels that a header declares, that are there and that the limits allow.

use crate::counting::HELD;
use flate2::Compression;
use flate2::write::{DeflateEncoder, GzEncoder, ZlibEncoder};
use homolog_formats::{FormatError, ReadLimits, nifti, read, stl};
use homolog_mesh::volume::LabelVolume;
use nalgebra::Matrix4;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;
use std::fmt::Write as _;
use std::io::Write as _;

const MIB: usize = 1 << 20;

/// Reads a file and holds what that took against the law; `voxels` are the bytes of its volume, 4 for each voxel at least.
fn held(name: &str, bytes: &[u8], voxels: usize) -> Result<(), FormatError> {
    HELD.with(|held| held.set([0, 0]));
    // The content is dropped within the measurement.
    let outcome = read(bytes, Some(name), &ReadLimits::default()).map(|_| ());
    let most = HELD.with(Cell::get)[1];
    let law = 64 * bytes.len() + 16 * MIB + 4 * voxels;
    assert!(most <= law as isize, "{name}: {most} bytes were held for {} bytes, not {law}: {outcome:?}", bytes.len());
    outcome
}

fn deflate(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// An archive with `n` entries of the same name that all name the same deflated bytes.
fn zip(name: &str, bytes: &[u8], n: u16) -> Vec<u8> {
    let packed = deflate(bytes);
    let mut crc = flate2::Crc::new();
    crc.update(bytes);
    let mut common = vec![20, 0, 0, 0, 8, 0, 0, 0, 0, 0];
    for number in [crc.sum(), packed.len() as u32, bytes.len() as u32] {
        common.extend(number.to_le_bytes());
    }
    common.extend((name.len() as u16).to_le_bytes());
    common.extend([0, 0]);
    let local = [b"PK\x03\x04", common.as_slice(), name.as_bytes(), &packed].concat();
    let entries = [b"PK\x01\x02\x14\0", common.as_slice(), &[0; 14], name.as_bytes()].concat().repeat(n.into());
    let mut end = b"PK\x05\x06\0\0\0\0".to_vec();
    end.extend([n.to_le_bytes(), n.to_le_bytes()].concat());
    end.extend((entries.len() as u32).to_le_bytes());
    end.extend((local.len() as u32).to_le_bytes());
    [local, entries, end, vec![0, 0]].concat()
}

fn element(tag: u32, kind: &[u8; 2], value: &[u8]) -> Vec<u8> {
    let mut bytes = [((tag >> 16) as u16).to_le_bytes(), (tag as u16).to_le_bytes()].concat();
    bytes.extend(kind);
    if [b"SQ", b"OB", b"OW", b"UT", b"UN"].contains(&kind) {
        bytes.extend([0, 0]);
        bytes.extend((value.len() as u32).to_le_bytes());
    } else {
        bytes.extend((value.len() as u16).to_le_bytes());
    }
    bytes.extend(value);
    bytes
}

/// A DICOM file of the transfer syntax in which the data set is deflated.
fn deflated_dicom(data_set: &[u8]) -> Vec<u8> {
    let mut file = vec![0; 128];
    file.extend(b"DICM");
    file.extend(element(0x0002_0010, b"UI", b"1.2.840.10008.1.2.1.99"));
    file.extend(deflate(data_set));
    file
}

/// A segmentation of frames of this size, of which only one voxel of each is in the segment; its data set alone.
fn segmentation(rows: u16, n_frames: usize, kind: &str, owner: &[u8], pixels: &[u8]) -> Vec<u8> {
    let item = |bytes: Vec<u8>| {
        [&[0xfe, 0xff, 0x00, 0xe0], (bytes.len() as u32).to_le_bytes().as_slice(), bytes.as_slice()].concat()
    };
    let sequence =
        |tag: u32, items: Vec<Vec<u8>>| element(tag, b"SQ", &items.into_iter().flat_map(item).collect::<Vec<u8>>());
    let frames = (0..n_frames).map(|k| {
        let place = format!("0\\0\\{k}");
        let position = sequence(0x0020_9113, vec![element(0x0020_0032, b"DS", place.as_bytes())]);
        let number = sequence(0x0062_000a, vec![element(0x0062_000b, b"US", &1u16.to_le_bytes())]);
        [position, if kind == "LABELMAP" { Vec::new() } else { number }].concat()
    });
    let shared = [
        sequence(0x0020_9116, vec![element(0x0020_0037, b"DS", b"1\\0\\0\\0\\1\\0")]),
        sequence(0x0028_9110, vec![element(0x0028_0030, b"DS", b"1\\1")]),
    ];
    let class: &[u8] =
        if kind == "LABELMAP" { b"1.2.840.10008.5.1.4.1.1.66.7" } else { b"1.2.840.10008.5.1.4.1.1.66.4" };
    let bits: u16 = if kind == "LABELMAP" { 16 } else { 1 };
    [
        element(0x0008_0016, b"UI", class),
        element(0x0008_0018, b"UT", owner),
        element(0x0028_0008, b"IS", n_frames.to_string().as_bytes()),
        element(0x0028_0010, b"US", &rows.to_le_bytes()),
        element(0x0028_0011, b"US", &rows.to_le_bytes()),
        element(0x0028_0100, b"US", &bits.to_le_bytes()),
        element(0x0062_0001, b"CS", kind.as_bytes()),
        sequence(0x5200_9229, vec![shared.concat()]),
        sequence(0x5200_9230, frames.collect()),
        element(0x7fe0_0010, b"OB", pixels),
    ]
    .concat()
}

fn plain_dicom(data_set: &[u8]) -> Vec<u8> {
    let mut file = vec![0; 128];
    file.extend(b"DICM");
    file.extend(element(0x0002_0010, b"UI", b"1.2.840.10008.1.2.1"));
    file.extend(data_set);
    file
}

/// The file of 510 kB that took 3 GiB: 500 MiB of zeros, which are millions of empty elements.
#[test]
fn a_deflated_dicom_of_zeros_is_refused_before_it_takes_memory() {
    let file = deflated_dicom(&vec![0; 500 * MIB]);
    assert!(file.len() > 480_000, "{}", file.len());
    let refused = held("a.dcm", &file, 0).unwrap_err();
    assert!(matches!(refused, FormatError::TooLarge { .. }), "{refused}");
}

#[test]
fn no_format_has_a_bomb() {
    const N: usize = 8 * MIB;
    let repeated = |head: &str, part: &str, tail: &str| {
        [head.as_bytes(), part.repeat(N / part.len()).as_bytes(), tail.as_bytes()].concat()
    };
    let item = [0xfe, 0xff, 0x00, 0xe0, 0, 0, 0, 0];
    let open = [0x40, 0, 8, 0, b'S', b'Q', 0, 0, 0xff, 0xff, 0xff, 0xff];
    let pixels = [0xe0, 0x7f, 0x10, 0, b'O', b'B', 0, 0, 0xff, 0xff, 0xff, 0xff];
    let fragments = [&pixels[..], &item.repeat(N / 8)].concat();
    let one_each = [&[0xfe, 0xff, 0x00, 0xe0, 8, 0, 0, 0][..], &[1, 0, 1, 0, b'L', b'O', 0, 0]].concat();
    let off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let list = "element face 1\nproperty list int uchar vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
    let bytes_ply = {
        let head = ply.replace("ascii", "binary_little_endian") + &list[..list.len() - 18];
        let corners = (N as u32).to_le_bytes();
        [head.as_bytes(), &[0; 36], &corners, &[0, 1, 2].repeat(N / 3 + 1)].concat()
    };
    let vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
    let vtp = "<VTKFile type=\"PolyData\"><PolyData>";
    let ascii_vtp = "<Piece NumberOfPoints=\"1\"><Points><DataArray type=\"Float32\" format=\"ascii\">";
    let gii = "<GIFTI><DataArray Intent=\"NIFTI_INTENT_POINTSET\" DataType=\"NIFTI_TYPE_FLOAT32\" Dimensionality=\"2\" \
               Dim0=\"199999\" Dim1=\"3\" Encoding=\"ASCII\"><Data>";
    let stl = [vec![0; 80], 190_000u32.to_le_bytes().to_vec(), [0, 0, 1, 2, 3, 4, 5, 6, 7, 8].repeat(950_000)].concat();
    let nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n";
    let mut keys = nrrd.to_owned();
    (0..90_000).for_each(|k| writeln!(keys, "{k:x}:=").unwrap());
    let mut fields = nrrd.to_owned();
    (0..90_000).for_each(|k| writeln!(fields, "{k:x}: ").unwrap());
    let mha = "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n";
    let triangles = {
        let counts = [3i32.to_be_bytes(), 1_500_000i32.to_be_bytes()].concat();
        [&[0xff, 0xff, 0xfe], b"x\n\n".as_slice(), &counts, &[0; 36], &vec![0; N]].concat()
    };
    let files: Vec<(&str, Vec<u8>)> = vec![
        ("zeros", vec![0; 4 * N]),
        ("blanks.off", vec![b'\n'; 4 * N]),
        ("items.dcm", [&open[..], &item.repeat(N / 8)].concat()),
        ("elements.dcm", [&open[..], &one_each.repeat(N / 16)].concat()),
        ("fragments.dcm", fragments),
        ("faces.obj", repeated(obj, "f\n", "")),
        ("corners.obj", repeated(&format!("{obj}f"), " 1", "\n")),
        ("vertices.obj", repeated("", "v 0 0 0\n", "f 1 2 3\n")),
        ("corners.off", repeated(&format!("{off}9999999"), " 1", "\n")),
        ("comments.off", repeated("OFF\n", "#\n", "")),
        ("corners.ply", repeated(&format!("{ply}{list}9999999"), " 1", "\n")),
        ("bytes.ply", bytes_ply),
        ("header.ply", repeated("ply\n", "comment x\n", "")),
        ("cells.vtk", repeated(&format!("{vtk}POLYGONS 1 9999999\n9999998"), " 1", "\n")),
        ("fields.vtk", repeated(&format!("{vtk}FIELD x 99999999\n"), "a 0 0 int\n", "")),
        ("pieces.vtp", repeated(vtp, "<Piece/>", "</PolyData></VTKFile>")),
        ("open.vtp", repeated(vtp, "<a>", "")),
        ("attributes.vtp", repeated(&format!("{vtp}<a"), " a=\"\"", "/>")),
        (
            "ascii.vtp",
            repeated(&format!("{vtp}{ascii_vtp}"), "0 ", "</DataArray></Points></Piece></PolyData></VTKFile>"),
        ),
        ("open.gii", repeated("<GIFTI>", "<a>", "")),
        ("ascii.gii", repeated(gii, "0 ", "</Data></DataArray></GIFTI>")),
        ("texts.gii", repeated(gii, "<![CDATA[0]]>", "</Data></DataArray></GIFTI>")),
        ("facets.stl", stl),
        (
            "text.stl",
            repeated("solid x\n", "facet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n", ""),
        ),
        ("surface.pial", triangles),
        ("ascii.pial", repeated("#!ascii x\n199999 1\n", "0 0 0 0\n", "")),
        ("pairs.nrrd", keys.clone().into_bytes()),
        ("fields.nrrd", fields.into_bytes()),
        ("long.nrrd", repeated(&format!("{nrrd}space directions:"), " none", "\n\n12345678")),
        ("kinds.nrrd", repeated(&format!("{nrrd}kinds:"), " a", "\n\n12345678")),
        ("sizes.nrrd", repeated("NRRD0004\ntype: uchar\nencoding: raw\nsizes:", " 1", "\n\n1")),
        ("after.nrrd", repeated(&format!("{nrrd}\n12345678"), "0", "")),
        (
            "sizes.mha",
            repeated(
                "ObjectType = Image\nNDims = 3\nElementType = MET_UCHAR\nDimSize =",
                " 1",
                "\nElementDataFile = LOCAL\n1",
            ),
        ),
        ("after.mha", repeated(&format!("{mha}ElementDataFile = LOCAL\n12345678"), "0", "")),
        (
            "a.mz3",
            [b"MZ\x03\0".as_slice(), &1_500_000u32.to_le_bytes(), &3u32.to_le_bytes(), &[0; 4], &vec![0; N]].concat(),
        ),
    ];
    for (name, bytes) in files {
        // As it is only as far as that takes no time.
        let _ = held(name, &bytes[..bytes.len().min(4 * MIB)], 0);
        let _ = held(&format!("{name}.gz"), &gzip(&bytes), 0);
        let _ = held(&format!("{name}.zip"), &zip(name, &bytes, 1), 0);
        let _ = held(&format!("{name}.gz.zip"), &zip(name, &gzip(&bytes), 1), 0);
        let _ = held(&format!("{name} 200 times"), &zip(name, &bytes[..MIB / 4], 200), 0);
        if name.ends_with(".dcm") {
            let _ = held(&format!("{name} deflated"), &deflated_dicom(&bytes), 0);
        }
    }
    // Streams within a file.
    let zeros = zlib(&vec![0; N]);
    let text = base64::Engine::encode(&base64::engine::general_purpose::STANDARD, &zeros);
    let gii = gii.replace("ASCII", "GZipBase64Binary").replace("FLOAT32", "FLOAT64");
    let _ = held("zlib.gii", format!("{gii}{text}</Data></DataArray></GIFTI>").as_bytes(), 0);
    let _ = held("gzip.nrrd", &[nrrd.replace("raw", "gzip").as_bytes(), b"\n", &gzip(&vec![0; N])].concat(), 32);
    let _ = held("zlib.nrrd", &[nrrd.replace("raw", "gzip").as_bytes(), b"\n", &zeros].concat(), 32);
    let head = format!("{mha}CompressedData = True\nElementDataFile = LOCAL\n");
    let _ = held("zlib.mha", &[head.as_bytes(), &zeros].concat(), 32);
    // Sizes without voxels.
    for (name, text) in [
        ("none.nrrd", nrrd.replace("2 2 2", "600 600 600") + "\n"),
        ("none.mha", mha.replace("2 2 2", "600 600 600") + "ElementDataFile = LOCAL\n"),
        ("none.vtk", vtk.replace("POINTS 3", "POINTS 199999")),
        ("none.ply", ply.replace("vertex 3", "vertex 199999") + list),
    ] {
        assert!(held(name, text.as_bytes(), 0).is_err(), "{name}");
    }
    // Labels that are each remembered with the identifier of their instance.
    let pixels: Vec<u8> = (0..=u16::MAX).flat_map(u16::to_le_bytes).collect();
    let label_map = plain_dicom(&segmentation(256, 1, "LABELMAP", &vec![b'1'; MIB / 2], &pixels));
    held("owner.dcm", &label_map, 4 * 256 * 256).unwrap();
}

/// A file of any format in which a part is repeated until it is large, as it is and compressed.
#[test]
fn repeated_parts_of_files_of_every_format_cost_little() {
    let mut samples: Vec<_> = crate::samples::surfaces().into_iter().chain(crate::samples::volumes()).collect();
    samples.push(("STL", homolog_formats::InputFormat::Stl, stl::write_stl(&crate::samples::surface())));
    for (name, _, bytes) in samples {
        let is_gzip = bytes.starts_with(&[0x1f, 0x8b]);
        let mut plain = Vec::new();
        match is_gzip {
            true => drop(std::io::copy(&mut flate2::read::GzDecoder::new(bytes.as_slice()), &mut plain).unwrap()),
            false => plain.clone_from(&bytes),
        }
        let config = Config { cases: 8, failure_persistence: None, ..Config::default() };
        let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[5; 32]));
        let index = any::<prop::sample::Index>;
        let outcome = runner.run(&(index(), index(), 0..3usize), |(from, to, kind)| {
            let (a, b) = (from.index(plain.len()), to.index(plain.len()));
            let (a, b) = (a.min(b), a.max(b) + 1);
            // A word or a line is what a reader may keep for each.
            let b = if kind == 0 { b } else { b.min(a + 8 * kind) };
            let n = 2 * MIB / (b - a);
            let file = [&plain[..a], &plain[a..b].repeat(n), &plain[b..]].concat();
            // What a header declares of voxels stays small: only its numbers could grow.
            let _ = held(name, &file, 0);
            let _ = held(&format!("{name} in gzip"), &gzip(&file), 0);
            let _ = held(&format!("{name} in zip"), &zip(name, &file, 1), 0);
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// Label volumes that are mostly background, which compress a thousand times, are read in every compressed form.
#[test]
fn volumes_of_background_are_read_however_well_they_compress() {
    const N: usize = 224;
    let voxels = N * N * N;
    let mut labels = vec![0u8; voxels];
    (0..40).for_each(|k| labels[voxels / 2 + k] = 7);
    let volume = LabelVolume::new([N; 3], labels.iter().map(|&l| l.into()).collect(), Matrix4::identity()).unwrap();
    let nifti = nifti::write_nifti(&volume);
    let sizes = format!("{N} {N} {N}");
    let nrrd = |encoding: &str, stored: &[u8]| {
        let head = format!("NRRD0004\ntype: uchar\ndimension: 3\nsizes: {sizes}\nencoding: {encoding}\n\n");
        [head.as_bytes(), stored].concat()
    };
    let mha = |compressed: &str, stored: &[u8]| {
        let head = format!(
            "ObjectType = Image\nNDims = 3\nDimSize = {sizes}\nElementType = MET_UCHAR\nCompressedData = {compressed}\nElementDataFile = LOCAL\n"
        );
        [head.as_bytes(), stored].concat()
    };
    let mgh = {
        let mut head =
            [1, N as i32, N as i32, N as i32, 1, 0].iter().flat_map(|v| v.to_be_bytes()).collect::<Vec<u8>>();
        head.resize(284, 0);
        [head, labels.clone()].concat()
    };
    let bits: Vec<u8> =
        labels.chunks(8).map(|b| b.iter().rev().fold(0, |sum, &v| sum << 1 | u8::from(v > 0))).collect();
    let seg = segmentation(N as u16, N, "BINARY", b"1.2", &bits);
    let files: Vec<(&str, Vec<u8>)> = vec![
        ("a.nii.gz", gzip(&nifti)),
        ("nii.zip", zip("a.nii", &nifti, 1)),
        ("nii.gz.zip", zip("a.nii.gz", &gzip(&nifti), 1)),
        ("gzip.nrrd", nrrd("gzip", &gzip(&labels))),
        ("zlib.nrrd", nrrd("gzip", &zlib(&labels))),
        ("raw.nrrd.gz", gzip(&nrrd("raw", &labels))),
        ("a.mha", mha("True", &zlib(&labels))),
        ("a.mha.gz", gzip(&mha("False", &labels))),
        ("a.mgz", gzip(&mgh)),
        ("deflated.dcm", deflated_dicom(&seg)),
        ("dcm.gz", gzip(&plain_dicom(&seg))),
        ("dcm.zip", zip("a.dcm", &plain_dicom(&seg), 1)),
        ("two.dcm.zip", zip("a.dcm", &plain_dicom(&seg), 2)),
    ];
    for (name, bytes) in files {
        assert!(bytes.len() < voxels / 40, "{name}: {} bytes", bytes.len());
        held(name, &bytes, 4 * voxels).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// The surface of the voxels of a ball, as programs write it, which compresses as well as surfaces do.
#[test]
fn surfaces_of_voxels_are_read_however_well_they_compress() {
    const N: i64 = 48;
    let inside = |p: [i64; 3]| p.iter().map(|c| (2 * c - N).pow(2)).sum::<i64>() < (N - 4).pow(2);
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for at in 0..N * N * N {
        let p = [at % N, at / N % N, at / N / N];
        for (axis, way) in (0..3).flat_map(|axis| [(axis, 1), (axis, -1)]) {
            let mut beside = p;
            beside[axis] += way;
            if inside(p) && !inside(beside) {
                let (mut u, mut v) = ((axis + 1) % 3, (axis + 2) % 3);
                if way < 0 {
                    (u, v) = (v, u);
                }
                let corner = |a: i64, b: i64| {
                    let mut q = p;
                    q[axis] += i64::from(way > 0);
                    q[u] += a;
                    q[v] += b;
                    q.map(|c| c as f64 * 0.7)
                };
                corners.extend([(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)].map(|(a, b)| corner(a, b)));
            }
        }
    }
    let mut ascii = "solid x\n".to_owned();
    let mut binary = [vec![0; 80], (corners.len() as u32 / 3).to_le_bytes().to_vec()].concat();
    let (mut points, mut faces) = (String::new(), String::new());
    for (k, facet) in corners.chunks(3).enumerate() {
        ascii.push_str("facet normal 0.000000e+00 0.000000e+00 0.000000e+00\n  outer loop\n");
        binary.extend([0; 12]);
        for [x, y, z] in facet {
            writeln!(ascii, "    vertex {x:.6e} {y:.6e} {z:.6e}").unwrap();
            writeln!(points, "v {x:.6} {y:.6} {z:.6}").unwrap();
            binary.extend([x, y, z].iter().flat_map(|&&c| (c as f32).to_le_bytes()));
        }
        ascii.push_str("  endloop\nendfacet\n");
        binary.extend([0, 0]);
        writeln!(faces, "f {} {} {}", 3 * k + 1, 3 * k + 2, 3 * k + 3).unwrap();
    }
    ascii.push_str("endsolid x\n");
    for (name, plain) in
        [("ascii.stl", ascii.into_bytes()), ("binary.stl", binary), ("a.obj", (points + &faces).into_bytes())]
    {
        held(name, &plain, 0).unwrap_or_else(|error| panic!("{name}: {error}"));
        for (name, packed) in [("gz", gzip(&plain)), ("zip", zip(name, &plain, 1))] {
            let ratio = plain.len() / packed.len();
            held(name, &packed, 0).unwrap_or_else(|error| panic!("{name}, {ratio} times: {error}"));
        }
    }
}
