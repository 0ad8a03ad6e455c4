//! Files as other programs write them: every oddity that a format's grammar allows reads as the plain file does, and whatever
//! contradicts itself is refused with what it states and what it holds.

use crate::fixtures::fixture;
use crate::samples::{gifti, surface, surfaces, volumes};
use homolog_contract::result::UnreliableReason;
use homolog_formats::{FileContent, FormatError, ReadFile, ReadLimits, ReadOptions, read, read_with};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::topology::topology_report;
use homolog_mesh::volume::LabelVolume;
use nalgebra::Point3;
use proptest::prelude::*;

fn file(bytes: &[u8], name: Option<&str>) -> Result<ReadFile, FormatError> {
    read(bytes, name, &ReadLimits::default())
}

fn mesh_of(read: ReadFile) -> SurfaceMesh {
    match read.content {
        FileContent::Mesh(file) => file.mesh,
        FileContent::Labels(_) => panic!("a mesh is expected"),
    }
}

fn mesh(bytes: &[u8]) -> SurfaceMesh {
    mesh_of(file(bytes, None).unwrap())
}

fn volume_of(read: &ReadFile) -> &LabelVolume {
    match &read.content {
        FileContent::Labels(volume) => volume,
        FileContent::Mesh(_) => panic!("a label volume is expected"),
    }
}

fn sample(name: &str) -> Vec<u8> {
    surfaces().into_iter().find(|(found, ..)| *found == name).unwrap_or_else(|| panic!("no sample {name}")).2
}

fn text(name: &str) -> String {
    match name {
        "STL, ASCII" => ascii_stl(),
        _ => String::from_utf8(sample(name)).unwrap(),
    }
}

fn ascii_stl() -> String {
    let facet = |face: &[u32]| {
        let corner = |v: &u32| {
            let p = surface().vertices()[*v as usize];
            format!("vertex {} {} {}\n", p.x, p.y, p.z)
        };
        let corners: String = face.iter().map(corner).collect();
        format!("facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n")
    };
    let facets: String = surface().faces().map(facet).collect();
    format!("solid by hand\n{facets}endsolid by hand\n")
}

/// The corners of all triangles, in an order that does not depend on the numbering of vertices.
fn triangles(mesh: &SurfaceMesh) -> Vec<[[u64; 3]; 3]> {
    let place = |v: u32| mesh.vertices()[v as usize].coords.map(f64::to_bits).into();
    let mut triangles: Vec<[[u64; 3]; 3]> = mesh.triangles().iter().map(|t| t.map(place)).collect();
    for corners in &mut triangles {
        let first = (0..3).min_by_key(|&k| corners[k]).unwrap();
        corners.rotate_left(first);
    }
    triangles.sort_unstable();
    triangles
}

/// The counts that a refusal names.
fn mismatch(bytes: &[u8]) -> (u64, u64) {
    match file(bytes, None) {
        Err(FormatError::CountMismatch { stated, found, .. } | FormatError::Overlong { stated, found, .. }) => {
            (stated, found)
        }
        other => panic!("a mismatch of counts is expected, not {other:?}"),
    }
}

#[test]
fn files_of_other_programs_give_the_surface_that_they_hold() {
    let reference = topology_report(&mesh(&fixture("field/reference.ply")));
    assert_eq!((reference.n_vertices, reference.n_faces), (246, 488));
    for name in [
        "talairach.surf.gii",
        "count_half.stl",
        "count_zero.stl",
        "lh.one_newline",
        "dot.ply",
        "b64bin.surf.gii",
        "bom.stl.gz",
    ] {
        let read = file(&fixture(&format!("field/{name}")), Some(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
        let found = topology_report(&mesh_of(read));
        assert_eq!((found.n_vertices, found.n_faces), (246, 488), "{name}");
        // One vertex of `dot.ply` was moved to get its number.
        let tolerance = if name == "dot.ply" { 0.02 } else { 1e-4 };
        let [area, volume] =
            [found.area_mm2 / reference.area_mm2, found.volume_mm3.unwrap() / reference.volume_mm3.unwrap()];
        assert!((area - 1.0).abs() < tolerance && (volume - 1.0).abs() < tolerance, "{name}: {area} {volume}");
    }
}

#[test]
fn label_volumes_of_other_programs_give_the_voxels_that_they_hold() {
    for (name, n_voxels, spacing) in [
        ("micrometers.nrrd.gz", 3752, 1.0),
        ("byte_skip.nrrd.gz", 3752, 1.0),
        ("empty_field.nrrd.gz", 3752, 1.0),
        ("sparse.dcm", 3403, 1.0),
    ] {
        let read = file(&fixture(&format!("field/{name}")), Some(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
        let volume = volume_of(&read);
        assert_eq!(volume.label_counts().values().copied().collect::<Vec<_>>(), [n_voxels], "{name}");
        assert!(volume.spacing_mm().iter().all(|s| (s - spacing).abs() < 1e-9), "{name}: {:?}", volume.spacing_mm());
    }
    let sparse = file(&fixture("field/sparse.dcm"), None).unwrap();
    assert_eq!(volume_of(&sparse).dims()[2], 14);
    assert!(sparse.notes.iter().any(|note| note.contains("2 of the 14 slices")), "{:?}", sparse.notes);
    let note = file(&fixture("field/micrometers.nrrd.gz"), None).unwrap().notes.join("; ");
    assert!(note.contains("0.001 mm"), "{note}");
    let plain = file(&fixture("field/no_preamble.dcm"), Some("a.dcm")).unwrap();
    assert_eq!(plain.format, homolog_formats::InputFormat::DicomSeg);
    assert!(volume_of(&plain).mask(None).is_some());
}

#[test]
fn two_orientations_of_different_handedness_are_a_warning() {
    let read = file(&fixture("field/two_sides.nii.gz"), None).unwrap();
    assert_eq!(read.warnings.iter().map(|w| w.reason).collect::<Vec<_>>(), [Some(UnreliableReason::UncertainSide)]);
    assert!(read.warnings[0].detail.contains("sform was taken"), "{}", read.warnings[0].detail);
    assert!(volume_of(&read).affine()[(0, 0)] > 0.0, "the sform has RAS axes");
}

#[test]
fn what_is_refused_is_refused_for_what_it_is() {
    let cases: [(&[u8], &str, &str); 12] = [
        (&fixture("field/header_only.nhdr"), "a.nhdr", "whose voxels are in another file"),
        (b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n", "a.nrrd", "without voxels"),
        (
            b"ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = a.raw\n",
            "a.mhd",
            "in another file",
        ),
        (b"NDims = 3\nObjectType = Image\nDimSize = 2 2 2\n", "a.mhd", "without its voxels"),
        (b"ObjectType = Scene\nNDims = 3\nNObjects = 1\n", "a.scn", "without its voxels"),
        (b"#!ascii label  , from subject  vox2ras=TkReg\n1\n0 1 2 3 0\n", "lh.cortex.label", "FreeSurfer label"),
        (b"<!DOCTYPE html>\n<html><body>404</body></html>", "a.nii.gz", "HTML page"),
        (b"version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12\n", "a.stl", "Git LFS"),
        (b"\x89PNG\r\n\x1a\n0000000000", "a.png", "PNG picture"),
        (b"mrtrix image\ndim: 2,2,2\n", "a.mif", "MRtrix"),
        (b"\xff\xfes\0o\0l\0i\0d\0", "a.stl", "UTF-16"),
        (b"BZh91AY&SY0000", "a.nii.bz2", "bzip2"),
    ];
    for (bytes, name, expected) in cases {
        let error = file(bytes, Some(name)).unwrap_err();
        assert!(matches!(error, FormatError::Unsupported { .. }), "{name}: {error:?}");
        assert!(error.to_string().contains(expected), "{name}: {error}");
    }
    let model = homolog_formats::write_zip(&[
        ("[Content_Types].xml".to_owned(), b"<Types/>".as_slice()),
        ("3D/3dmodel.model".to_owned(), b"<model unit=\"millimeter\"/>"),
    ]);
    let error = file(&model.unwrap(), Some("a.3mf")).unwrap_err().to_string();
    assert!(error.starts_with("3MF is not supported"), "{error}");
    // A name alone is no reason to read a file as what it is not.
    for name in ["a.stl", "a.nii", "a.ply", "a.vtk", "a.gii", "a.mgz", "a.dcm", "a.obj", "lh.pial"] {
        let error = file(
            b"some text that is no model at all, but long enough to have a count of facets somewhere in it, if read so",
            Some(name),
        );
        assert!(matches!(error, Err(FormatError::NotAsNamed { .. })), "{name}: {error:?}");
    }
}

/// All counts up to 19 vertices and 29 faces instead of 8 and 12.
#[test]
fn a_changed_count_of_a_mesh_is_never_half_a_mesh() {
    let text_with = |text: &str, counts: [(&str, String); 2]| {
        counts.iter().fold(text.to_owned(), |text, (from, to)| text.replacen(from, to, 1)).into_bytes()
    };
    let ply =
        ["PLY, ASCII", "PLY, little-endian", "PLY, big-endian", "PLY, as written"].map(|name| (name, sample(name)));
    let (off, vtk, freesurfer) = (text("OFF"), text("VTK 2.0, ASCII"), sample("FreeSurfer, binary"));
    let ply_with = |bytes: &[u8], vertices: u64, faces: u64| {
        let head = String::from_utf8_lossy(bytes).find("end_header").unwrap();
        let header = std::str::from_utf8(&bytes[..head]).unwrap();
        let mut changed = text_with(
            header,
            [
                ("element vertex 8", format!("element vertex {vertices}")),
                ("element face 12", format!("element face {faces}")),
            ],
        );
        changed.extend(&bytes[head..]);
        changed
    };
    let freesurfer_with = |vertices: u64, faces: u64| {
        let mut bytes = freesurfer.clone();
        let at = bytes.windows(8).position(|w| w == [0, 0, 0, 8, 0, 0, 0, 12]).unwrap();
        bytes[at..at + 4].copy_from_slice(&(vertices as u32).to_be_bytes());
        bytes[at + 4..at + 8].copy_from_slice(&(faces as u32).to_be_bytes());
        bytes
    };
    let expected = triangles(&surface());
    for (vertices, faces) in (0..20u64).flat_map(|v| (0..30u64).map(move |f| (v, f))) {
        let of_off = [("8 12 0", format!("{vertices} {faces} 0")), ("# counts", String::new())];
        let of_vtk =
            [("POINTS 8", format!("POINTS {vertices}")), ("POLYGONS 12 48", format!("POLYGONS {faces} {}", 4 * faces))];
        let mut files: Vec<_> = ply.iter().map(|(name, bytes)| (*name, ply_with(bytes, vertices, faces))).collect();
        files.extend([
            ("OFF", text_with(&off, of_off)),
            ("FreeSurfer, binary", freesurfer_with(vertices, faces)),
            ("VTK 2.0, ASCII", text_with(&vtk, of_vtk)),
        ]);
        // As many rows in all contradict nothing where a row of a face could be that of a vertex: as many words in text,
        // as many bytes in the other files, except where coordinates are in double precision.
        if vertices + faces == 20 && vertices != 8 {
            files.retain(|(name, _)| ["PLY, as written", "VTK 2.0, ASCII"].contains(name));
        }
        for (name, bytes) in files {
            match file(&bytes, None) {
                Ok(read) => {
                    assert_eq!(triangles(&mesh_of(read)), expected, "{name} with {vertices} vertices, {faces} faces")
                }
                Err(error) => assert!((vertices, faces) != (8, 12), "{name}: {error}"),
            }
        }
    }
}

proptest! {
    #[test]
    fn binary_stl_is_read_whole_or_refused_with_both_counts(stated in 0..40u32, cut in 0..=600usize, more in 0..120usize, byte: u8) {
        let whole = homolog_formats::write_stl(&surface());
        prop_assert_eq!(whole.len(), 84 + 50 * 12);
        let mut bytes = whole[..whole.len() - cut].to_vec();
        bytes.extend(std::iter::repeat_n(byte, more));
        bytes[80..84].copy_from_slice(&stated.to_le_bytes());
        match file(&bytes, Some("a.stl")) {
            Ok(read) => {
                let silent = read.notes.is_empty();
                let n = mesh_of(read).n_faces();
                // Zeros are no facets; what else is dropped or differs from the count is said.
                let n_whole = (12 - cut.div_ceil(50)).min(12);
                // Bytes that complete a facet contradict nothing where count and length agree.
                let agrees = n == stated as usize && bytes.len() == 84 + 50 * n;
                prop_assert!(n <= n_whole.max(1) || more >= 50 || agrees, "{n} faces");
                prop_assert!(stated as usize == n || !silent || n < stated as usize, "{n} of {stated} in silence");
                prop_assert!(n >= n_whole || stated as usize == n, "{n} of {n_whole} faces");
                prop_assert!(n as u32 >= stated || !silent, "{n} of {stated}: a part of what is stated is missing");
                let beyond = bytes.len() - 84 - 50 * n;
                prop_assert!(beyond == 0 || byte == 0 || !silent, "{beyond} bytes dropped in silence");
            }
            Err(FormatError::CountMismatch { stated: said, found, .. }) => {
                prop_assert_eq!((said, found), (u64::from(stated), (bytes.len() - 84) as u64 / 50));
                prop_assert_ne!(said, found);
            }
            Err(other) => prop_assert!(bytes.len() < 134 || byte != 0 || cut > 0 || more > 0, "{other}"),
        }
    }

    #[test]
    fn numbers_may_have_any_form_of_c(which in 0..5usize, form in 0..7usize) {
        let write = |c: f64| match form {
            0 if c == 0.125 => ".125".to_owned(),
            1 if c.fract() == 0.0 => format!("{c}."),
            2 if c >= 0.0 => format!("+{c}"),
            3 => format!("{c:e}"),
            4 => format!("{c:E}"),
            5 => format!("{c:.9}"),
            6 => format!("{}{:.6}", if c < 0.0 { "-0" } else { "0" }, c.abs()),
            _ => c.to_string(),
        };
        let name = ["PLY, ASCII", "OBJ", "OFF", "VTK 2.0, ASCII", "STL, ASCII"][which];
        let rewritten: String = text(name)
            .lines()
            .map(|line| {
                // Lines of coordinates only: indices are whole numbers.
                let is_place = line.contains('.') && !line.starts_with('#');
                let word = |w: &str| match w.parse::<f64>() {
                    Ok(c) if is_place && w != "9" => write(c),
                    _ => w.to_owned(),
                };
                line.split(' ').map(word).collect::<Vec<_>>().join(" ") + "\n"
            })
            .collect();
        let header = ["format", "# vtk", "solid"];
        let restored = text(name).lines().zip(rewritten.lines()).map(|(old, new)| {
            if header.iter().any(|word| old.starts_with(word)) { old } else { new }
        }).collect::<Vec<_>>().join("\n") + "\n";
        prop_assert_eq!(triangles(&mesh(restored.as_bytes())), triangles(&surface()), "{}", name);
    }

    #[test]
    fn blanks_and_a_mark_before_the_first_word_and_any_line_ends_mean_nothing(which in 0..8usize, before in "[ \t\n]{0,6}", mark: bool, ends in 0..3usize) {
        let name = ["PLY, ASCII", "OBJ", "OFF", "VTK 2.0, ASCII", "STL, ASCII", "FreeSurfer, ASCII", "VTP, ASCII", "GIFTI, ASCII"][which];
        // Old Macintosh line ends are those of OBJ, OFF, STL and PLY alone.
        let end = ["\n", "\r\n", if [0, 1, 2, 4].contains(&which) { "\r" } else { "\n" }][ends];
        let body = text(name).replace('\n', end);
        let bytes = format!("{}{before}{body}", if mark { "\u{feff}" } else { "" });
        prop_assert_eq!(triangles(&mesh(bytes.as_bytes())), triangles(&surface()), "{}", name);
    }

    #[test]
    fn fields_of_headers_may_have_any_order(order in Just((0..20usize).collect::<Vec<_>>()).prop_shuffle(), which in 0..2usize) {
        let found = volumes().into_iter().filter(|(name, ..)| name.starts_with(["NRRD", "MetaImage"][which]));
        for (name, _, bytes) in found {
            let marker: &[u8] = if which == 0 { b"\n\n" } else { b"ElementDataFile" };
            let Some(at) = bytes.windows(marker.len()).position(|w| w == marker) else { continue };
            let head = String::from_utf8(bytes[..at].to_vec()).unwrap();
            let mut lines: Vec<&str> = head.trim_end().lines().collect();
            let first = if which == 0 { vec![lines.remove(0)] } else { Vec::new() };
            let mut sorted: Vec<(usize, &str)> = order.iter().copied().cycle().zip(lines).collect();
            sorted.sort_by_key(|(place, _)| *place);
            let lines: Vec<&str> = first.into_iter().chain(sorted.into_iter().map(|(_, line)| line)).collect();
            let mut shuffled = lines.join("\n").into_bytes();
            if which == 1 { shuffled.push(b'\n'); }
            shuffled.extend(&bytes[at..]);
            let [a, b] = [&bytes, &shuffled].map(|bytes| file(bytes, None).unwrap_or_else(|e| panic!("{name}: {e}")));
            prop_assert_eq!(a.content, b.content, "{}", name);
        }
    }

    #[test]
    fn frames_that_are_left_out_are_empty(
        first in prop::collection::btree_set(0..9usize, 0..6), second in prop::collection::btree_set(0..9usize, 1..6),
        kind in 0..3usize, chosen: bool, seed: u64,
    ) {
        // Two neighboring frames, which tell the step of the stack.
        let first: std::collections::BTreeSet<usize> = first.into_iter().chain([3, 4]).collect();
        let kind = ["BINARY", "FRACTIONAL", "LABELMAP"][kind];
        let plane = crate::samples::DIMS[0] * crate::samples::DIMS[1];
        let bit = |segment: u16, at: usize| (seed ^ (u64::from(segment) << 40)).wrapping_mul(2 * at as u64 + 0x9e37_79b9_7f4a_7c15) >> 63 == 1;
        let has = |segment: u16, at: usize| [(17, &first), (53, &second)].iter().any(|(s, slices)| *s == segment && slices.contains(&(at / plane)) && bit(segment, at));
        let frames: Vec<(u16, usize)> = if kind == "LABELMAP" {
            first.union(&second).map(|&slice| (0, slice)).collect()
        } else {
            first.iter().map(|&slice| (17, slice)).chain(second.iter().map(|&slice| (53, slice))).collect()
        };
        let bytes = crate::samples::dicom_seg(kind, &frames, |segment, at| match kind {
            "BINARY" => has(segment, at).into(),
            "FRACTIONAL" => u16::from(has(segment, at)) * 200,
            // A voxel of both belongs to the second.
            _ => if has(53, at) { 53 } else if has(17, at) { 17 } else { 0 },
        });
        let labels = chosen.then(|| vec![homolog_formats::LabelChoice::Number(17)]);
        let options = ReadOptions { labels, ..ReadOptions::default() };
        let read = read_with(&bytes, None, &ReadLimits::default(), &options).unwrap();
        let volume = volume_of(&read);
        let all: Vec<usize> = first.union(&second).copied().collect();
        let (begin, end) = (all[0], all[all.len() - 1]);
        prop_assert_eq!(volume.dims()[2], end - begin + 1);
        for label in [17, 53] {
            let expected = (begin * plane..(end + 1) * plane)
                .filter(|&at| has(label, at) && !(kind == "LABELMAP" && label == 17 && has(53, at))).count();
            let found = volume.mask(Some(&[u32::from(label)])).map_or(0, |mask| mask.n_voxels());
            prop_assert_eq!(found, expected, "{} {}", kind, label);
        }
        let judged: Vec<usize> = if chosen && kind != "LABELMAP" { first.iter().copied().collect() } else { all };
        let n_missing = judged[judged.len() - 1] - judged[0] + 1 - judged.len();
        let is_said = read.notes.iter().any(|note| note.starts_with(&format!("{n_missing} of the ")));
        prop_assert_eq!(is_said, n_missing > 0, "{:?}", read.notes);
    }

    #[test]
    fn matrices_of_gifti_are_applied_if_they_are_rigid_or_if_that_is_asked(
        angles in prop::array::uniform3(-3.0..3.0f64), shift in prop::array::uniform3(-50.0..50.0f64),
        scale in 0.5..2.0f64, is_rigid: bool, mirrored: bool, asked in prop::option::of(any::<bool>()),
    ) {
        let turned = nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]).to_homogeneous();
        let factor = if is_rigid { 1.0 } else if (0.99..1.01).contains(&scale) { 1.1 } else { scale };
        let side = if mirrored { -1.0 } else { 1.0 };
        let mut matrix = turned * nalgebra::Matrix4::from_diagonal(&nalgebra::Vector4::new(factor * side, 1.0, 1.0, 1.0));
        matrix.set_column(3, &nalgebra::Vector4::new(shift[0], shift[1], shift[2], 1.0));
        let numbers: Vec<String> = matrix.transpose().iter().map(|v| format!("{v:.6}")).collect();
        let bytes = gifti("ASCII", false, false, "INT32", &numbers.join(" "));
        let options = ReadOptions { apply_transform: asked, ..ReadOptions::default() };
        let read = read_with(&bytes, None, &ReadLimits::default(), &options).unwrap();
        let is_applied = asked.unwrap_or(is_rigid && !mirrored);
        prop_assert!(read.notes.len() == 1 && read.notes[0].contains("not applied") != is_applied, "{:?}", read.notes);
        for (found, stored) in mesh_of(read).vertices().iter().zip(surface().vertices()) {
            let expected = if is_applied { matrix.transform_point(stored) } else { *stored };
            prop_assert!((found - expected).norm() < 1e-3, "{found} {expected}");
        }
    }
}

#[test]
fn vertices_without_coordinates_that_no_face_uses_are_ignored() {
    for bad in ["nan nan nan", "-nan 1 2", "1.#QNAN 0 0", "inf 0 0", "NaN NaN NaN", "-1.#IND 0 0"] {
        let ply = text("PLY, ASCII").replacen("element vertex 8", "element vertex 9", 1);
        let first_face = ply.find("\n3 ").unwrap();
        let ply = format!("{}\n{bad} 9{}", &ply[..first_face], &ply[first_face..]);
        let obj = format!("{}v {bad}\n", text("OBJ"));
        for bytes in [ply, obj] {
            let read = file(bytes.as_bytes(), None).unwrap_or_else(|e| panic!("{bad}: {e}"));
            assert!(read.notes.iter().any(|note| note.contains("no finite coordinates")), "{:?}", read.notes);
            let mesh = mesh_of(read);
            assert_eq!((mesh.n_vertices(), mesh.n_faces()), (9, 12), "{bad}");
            assert_eq!(mesh.vertices()[..8], *surface().vertices());
        }
        let used = text("OBJ").replacen("v 12.5 -3.25 0.125", &format!("v {bad}"), 1);
        assert!(file(used.as_bytes(), None).is_err(), "{bad} in a used vertex");
    }
}

#[test]
fn comments_follow_anything_in_obj() {
    let commented: String = text("OBJ").lines().map(|line| format!("{line} # said of {line}\n")).collect();
    assert_eq!(mesh(commented.as_bytes()), surface());
    let cut = text("OBJ").trim_end().rsplit_once(' ').unwrap().0.to_owned();
    assert!(matches!(file(cut.as_bytes(), None), Err(FormatError::Syntax { .. })), "a face of two corners at the end");
}

#[test]
fn strips_of_ply_are_triangles() {
    let header = |format: &str, n: usize| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
             element tristrips {n}\nproperty list int int vertex_indices\nend_header\n"
        )
    };
    let places = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    // A strip of two triangles, its end, and one triangle; then a list of its own.
    let ascii = header("ascii", 2) + places + "8 0 2 1 3 -1 0 1 3\n3 0 3 2\n";
    let found = mesh(ascii.as_bytes());
    assert_eq!(found.indices(), [0, 2, 1, 1, 2, 3, 0, 1, 3, 0, 3, 2]);
    let mut binary = header("binary_big_endian", 2).into_bytes();
    binary.extend([0f32, 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1.].iter().flat_map(|c| c.to_be_bytes()));
    binary.extend([8i32, 0, 2, 1, 3, -1, 0, 1, 3, 3, 0, 3, 2].iter().flat_map(|c| c.to_be_bytes()));
    assert_eq!(mesh(&binary), found);
}

#[test]
fn any_line_ends_may_follow_the_stamp_of_freesurfer() {
    let bytes = sample("FreeSurfer, binary");
    let at = bytes.windows(8).position(|w| w == [0, 0, 0, 8, 0, 0, 0, 12]).unwrap();
    for stamp in ["x\n", "x\n\n", "x\n\n\n", "x\r\n\r\n", "\n\n", "x\ny\n", "x\ny\n\n", "x\n\nz\n", "\n"] {
        let file = [b"\xff\xff\xfe".as_slice(), stamp.as_bytes(), &bytes[at..]].concat();
        assert_eq!(mesh(&file), surface(), "{stamp:?}");
    }
}

#[test]
fn units_are_applied_wherever_a_format_states_one() {
    let scaled = |bytes: &[u8], factor: f64| {
        let read = file(bytes, None).unwrap();
        assert!(read.notes.iter().any(|note| note.contains("unit of length")), "{:?}", read.notes);
        for (found, stored) in mesh_of(read).vertices().iter().zip(surface().vertices()) {
            let expected = Point3::from(stored.coords * factor);
            assert!((found - expected).norm() <= 1e-9 * factor, "{found} {expected}");
        }
    };
    for (name, unit, factor) in
        [("cm", "cm", 10.0), ("m", "meters", 1000.0), ("inch", "in", 25.4), ("um", "microns", 0.001)]
    {
        scaled(format!("# 1 unit = 1 {name}\n{}", text("OBJ")).as_bytes(), factor);
        scaled(text("PLY, ASCII").replacen("by hand", &format!("units: {unit}"), 1).as_bytes(), factor);
        scaled(text("OFF").replacen("# counts", &format!("# File units = {unit}"), 1).as_bytes(), factor);
        let vtk = text("VTK 2.0, ASCII");
        scaled(
            vtk.replacen("POLYDATA\n", &format!("POLYDATA\nFIELD FieldData 1\nUnits 1 1 string\n{unit}\n"), 1)
                .as_bytes(),
            factor,
        );
        let letters: Vec<String> = name.bytes().chain([0]).map(|b| b.to_string()).collect();
        let field = format!(
            "<PolyData>\n<FieldData><Array type=\"String\" Name=\"LengthUnit\" NumberOfTuples=\"1\" format=\"ascii\">{}</Array>\
             </FieldData>",
            letters.join(" ")
        );
        scaled(text("VTP, ASCII").replacen("<PolyData>", &field, 1).as_bytes(), factor);
        let key = format!(
            "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{name}</InformationKey></DataArray>"
        );
        scaled(text("VTP, ASCII").replacen("</DataArray>", &key, 1).as_bytes(), factor);
        let mut stl = homolog_formats::write_stl(&surface());
        stl[..80].fill(b' ');
        let title = format!("part UNITS={unit}");
        stl[..title.len()].copy_from_slice(title.as_bytes());
        let found = topology_report(&mesh(&stl)).area_mm2 / topology_report(&surface()).area_mm2;
        assert!((found / factor.powi(2) - 1.0).abs() < 1e-5, "{found}");
    }
}

#[test]
fn volumes_with_other_units_skips_and_axes_of_size_one_are_the_same_volume() {
    let header = |lines: &str| {
        format!("NRRD0005\ntype: uint8\nencoding: raw\nspace: right-anterior-superior\n{lines}\n\n").into_bytes()
    };
    let plain = "dimension: 3\nsizes: 3 2 2\nspace directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (4,5,6)";
    let voxels: Vec<u8> = (0..12).map(|k| u8::from(k % 5 == 0) * 7).collect();
    let of = |lines: &str, data: &[u8]| file(&[header(lines), data.to_vec()].concat(), None);
    let expected = of(plain, &voxels).unwrap().content;
    let cases: Vec<(String, Vec<u8>)> = vec![
        (format!("{plain}\nbyte skip: -1"), [b"junk".as_slice(), &voxels].concat()),
        (format!("{plain}\nbyte skip: 4"), [b"junk".as_slice(), &voxels].concat()),
        (format!("{plain}\nbyteskip: -3"), [b"junk".as_slice(), &voxels, b"ab"].concat()),
        (format!("{plain}\nline skip: 2"), [b"one\ntwo\n".as_slice(), &voxels].concat()),
        (format!("{plain}\nline skip: 1\nbyte skip: 2"), [b"one\nab".as_slice(), &voxels].concat()),
        (format!("{plain}\nline skip: 1\nbyte skip: -1"), [b"one\nab".as_slice(), &voxels].concat()),
        (format!("{plain}\ncontent:\nkinds:"), voxels.clone()),
        (format!("{plain}\nkey:=value: of : a pair"), voxels.clone()),
        ("dimension: 4\nsizes: 1 3 2 2\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\nspace origin: (4,5,6)".to_owned(), voxels.clone()),
        ("dimension: 4\nsizes: 3 2 1 2\nspace directions: (1,0,0) (0,2,0) none (0,0,3)\nspace origin: (4,5,6)".to_owned(), voxels.clone()),
        ("dimension: 5\nsizes: 3 2 2 1 1\nspace directions: (1,0,0) (0,2,0) (0,0,3) none (nan,nan,nan)\nspace origin: (4,5,6)".to_owned(), voxels.clone()),
        ("dimension: 3\nsizes: 3 2 2\nspace units: \"um\" \"cm\" \"mm\"\nspace directions: (1000,0,0) (0,0.2,0) (0,0,3)\nspace origin: (4000,0.5,6)".to_owned(), voxels.clone()),
    ];
    for (lines, data) in cases {
        assert_eq!(of(&lines, &data).unwrap_or_else(|e| panic!("{lines}: {e}")).content, expected, "{lines}");
    }
    let hex: String = voxels.iter().map(|v| format!("{v:02X}")).collect();
    let lines = format!("{plain}\nencoding: hex");
    assert_eq!(of(&lines, hex.as_bytes()).unwrap().content, expected);
    let packed = crate::samples::gzip(&[b"ab".as_slice(), &voxels].concat());
    for skip in ["byte skip: 2", "byte skip: -1"] {
        let lines = format!("{plain}\nencoding: gzip\n{skip}");
        assert_eq!(of(&lines, &packed).unwrap().content, expected, "{skip}");
    }
    // More voxels than the sizes hold are no padding.
    let more = [voxels.as_slice(), &voxels].concat();
    assert!(matches!(of(plain, &more), Err(FormatError::Overlong { stated: 12, found: 24, .. })));
    assert_eq!(of(plain, &[voxels.as_slice(), &[0; 30]].concat()).unwrap().content, expected);
    assert!(matches!(of(&format!("{plain}\nline skip: 9"), &voxels), Err(FormatError::Header { .. })));
}

#[test]
fn metaimage_with_units_and_further_axes_is_the_same_volume() {
    let of = |lines: &str| {
        let voxels: Vec<u8> = (0..12).map(|k| u8::from(k % 5 == 0) * 7).collect();
        let head = format!("{lines}\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n");
        file(&[head.as_bytes(), &voxels].concat(), None).unwrap_or_else(|e| panic!("{lines}: {e}")).content
    };
    let plain = of("ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\nElementSpacing = 1 2 3\nOffset = 4 5 6");
    for lines in [
        "ElementSpacing = 1 2 3\nOffset = 4 5 6\nDimSize = 3 2 2\nNDims = 3",
        "BinaryData = True\nNDims = 3\nDistanceUnits = cm\nDimSize = 3 2 2\nElementSpacing = .1 .2 .3\nOffset = 0.4 0.5 0.6",
        "NDims = 3\nDistanceUnits = um\nDimSize = 3 2 2\nElementSpacing = 1e3 2e3 3e3\nOffset = 4e3 5e3 6e3",
        "ObjectType = Image\nNDims = 4\nDimSize = 3 2 2 1\nElementSpacing = 1 2 3 1\nOffset = 4 5 6 0",
        "ObjectType = Image\nNDims = 4\nDimSize = 1 3 2 2\nElementSpacing = 1 1 2 3\nOffset = 0 4 5 6",
    ] {
        assert_eq!(of(lines), plain, "{lines}");
    }
}

#[test]
fn counts_and_lengths_that_disagree_are_named() {
    assert_eq!(mismatch(&fixture_with_count("OFF", "8 12", "8 6")), (6, 12));
    assert_eq!(mismatch(&fixture_with_count("PLY, ASCII", "element face 12", "element face 6")), (6, 12));
    let polygons = text("VTK 2.0, ASCII").replacen("POLYGONS 12 48", "POLYGONS 6 48", 1);
    assert_eq!(mismatch(polygons.as_bytes()), (24, 48));
    assert!(matches!(
        file(text("VTK 2.0, ASCII").replacen("POINTS 8", "POINTS 7", 1).as_bytes(), None),
        Err(FormatError::Syntax { .. })
    ));
    let piece = text("VTP, ASCII").replacen("NumberOfPolys=\"12\"", "NumberOfPolys=\"6\"", 1);
    assert_eq!(mismatch(piece.as_bytes()), (6, 12));
    let points = text("VTP, ASCII").replacen("NumberOfPoints=\"8\"", "NumberOfPoints=\"4\"", 1);
    assert_eq!(mismatch(points.as_bytes()), (4, 8));
    let array = String::from_utf8(gifti("GZipBase64Binary", false, false, "INT32", crate::samples::IDENTITY)).unwrap();
    assert_eq!(mismatch(array.replacen("Dim0=\"12\"", "Dim0=\"6\"", 1).as_bytes()), (18, 36));
    let array = String::from_utf8(gifti("ASCII", false, false, "INT32", crate::samples::IDENTITY)).unwrap();
    assert_eq!(mismatch(array.replacen("Dim0=\"12\"", "Dim0=\"6\"", 1).as_bytes()), (18, 36));
    assert_eq!(mismatch(array.replacen("NumberOfDataArrays=\"2\"", "NumberOfDataArrays=\"3\"", 1).as_bytes()), (3, 2));
    // A truncated file of XML is not read up to where it ends.
    let cut = &array.as_bytes()[..array.len() - 4];
    assert!(file(cut, None).is_err());
    // Half of the slices in the header of a volume.
    let affine = crate::samples::affine();
    let whole = LabelVolume::new(crate::samples::DIMS, crate::samples::labels(), affine).unwrap();
    let bytes = homolog_formats::write_nifti(&whole);
    let mut half = bytes.clone();
    half[46..48].copy_from_slice(&1i16.to_le_bytes());
    for bytes in [half.clone(), crate::samples::gzip(&half)] {
        assert!(matches!(file(&bytes, None), Err(FormatError::Overlong { stated: 12, found: 24, .. })));
    }
    for padding in [vec![0; 512], b"end".to_vec()] {
        let padded = [bytes.clone(), padding].concat();
        assert_eq!(file(&padded, None).unwrap().content, file(&bytes, None).unwrap().content);
        assert_eq!(file(&crate::samples::gzip(&padded), None).unwrap().content, file(&bytes, None).unwrap().content);
    }
    let (_, _, mgh) = volumes().into_iter().find(|(name, ..)| *name == "MGH").unwrap();
    let mut half = mgh.clone();
    half[12..16].copy_from_slice(&1i32.to_be_bytes());
    assert!(matches!(file(&half, None), Err(FormatError::Overlong { .. })));
    // Scan parameters and tags of FreeSurfer.
    let tags = [[0; 20].as_slice(), &[0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 5], b"mri_a"].concat();
    let tagged = [mgh.clone(), tags].concat();
    assert_eq!(file(&tagged, None).unwrap().content, file(&mgh, None).unwrap().content);
}

fn fixture_with_count(name: &str, from: &str, to: &str) -> Vec<u8> {
    let changed = text(name).replacen(from, to, 1);
    assert_ne!(changed, text(name), "{name} has {from}");
    changed.into_bytes()
}
