//! Damaged files of every format: no reader panics, takes longer than a second (and a second for 30 MB), or allocates much more than it received.

use crate::counting::HELD;
use homolog_formats::{FormatError, ReadLimits, nifti, read, stl};
use homolog_mesh::volume::LabelVolume;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;
use std::time::Instant;

/// Bytes that a reader may hold for each byte of the file (inflated, if it is compressed), and in any case.
const BYTES_PER_BYTE: usize = 64;
const BYTES_ALWAYS: usize = 16 << 20;
/// Seconds that any file may take, and how many bytes of a large one may take a second more on a busy machine.
const MAX_SECONDS: f64 = 1.0;
const BYTES_PER_SECOND: f64 = 3e7;

/// Reads a file under the bounds; `inflated` is its size without gzip.
fn check(name: &str, bytes: &[u8], inflated: usize) {
    HELD.with(|held| held.set([0, 0]));
    let started = Instant::now();
    // The content is dropped within the measurement.
    let _ = read(bytes, Some(name), &ReadLimits::default());
    let seconds = started.elapsed().as_secs_f64();
    let most = HELD.with(Cell::get)[1];
    let limit = (BYTES_PER_BYTE * inflated.max(bytes.len()) + BYTES_ALWAYS) as isize;
    assert!(most <= limit, "{name}: {most} bytes were held for a file of {} bytes", bytes.len());
    let most = MAX_SECONDS + inflated.max(bytes.len()) as f64 / BYTES_PER_SECOND;
    assert!(seconds < most, "{name}: {seconds} s for a file of {} bytes", bytes.len());
}

fn all_samples() -> Vec<(String, Vec<u8>)> {
    let mut samples: Vec<_> = crate::samples::surfaces().into_iter().chain(crate::samples::volumes()).collect();
    let volume = LabelVolume::new(crate::samples::DIMS, crate::samples::labels(), crate::samples::affine()).unwrap();
    samples.push(("NIfTI-1", homolog_formats::InputFormat::Nifti, nifti::write_nifti(&volume)));
    samples.push(("STL", homolog_formats::InputFormat::Stl, stl::write_stl(&crate::samples::surface())));
    samples.push((".seg.nrrd", homolog_formats::InputFormat::Nrrd, crate::samples::layered_nrrd()));
    samples.into_iter().map(|(name, _, bytes)| (name.to_owned(), bytes)).collect()
}

/// Values that break counts: none, one, all bits, the largest of a sign, digits.
const PIECES: [&[u8]; 8] =
    [&[0; 4], &[0xff; 4], &[0x7f, 0xff, 0xff, 0xff], &[0xff, 0xff, 0xff, 0x7f], b"999999999", b"-1 ", b"<", b"\n\n"];

#[derive(Debug, Clone)]
enum Damage {
    Byte(prop::sample::Index, u8),
    Piece(prop::sample::Index, usize),
    Cut(prop::sample::Index),
    Repeat(prop::sample::Index, prop::sample::Index),
}

fn damage() -> impl Strategy<Value = Damage> {
    let index = any::<prop::sample::Index>;
    prop_oneof![
        4 => (index(), any::<u8>()).prop_map(|(at, byte)| Damage::Byte(at, byte)),
        4 => (index(), 0..PIECES.len()).prop_map(|(at, piece)| Damage::Piece(at, piece)),
        1 => index().prop_map(Damage::Cut),
        1 => (index(), index()).prop_map(|(from, to)| Damage::Repeat(from, to)),
    ]
}

fn damaged(mut bytes: Vec<u8>, damage: &[Damage]) -> Vec<u8> {
    for damage in damage {
        if bytes.is_empty() {
            break;
        }
        match damage {
            Damage::Byte(at, byte) => {
                let at = at.index(bytes.len());
                bytes[at] = *byte;
            }
            Damage::Piece(at, piece) => {
                let at = at.index(bytes.len());
                for (k, byte) in PIECES[*piece].iter().enumerate().take(bytes.len() - at) {
                    bytes[at + k] = *byte;
                }
            }
            Damage::Cut(at) => bytes.truncate(at.index(bytes.len())),
            Damage::Repeat(from, to) => {
                let (a, b) = (from.index(bytes.len()), to.index(bytes.len()));
                let part = bytes[a.min(b)..a.max(b)].to_vec();
                bytes.extend(part);
            }
        }
    }
    bytes
}

/// Runs `n_cases` damaged copies of each file, from a seed that is stated.
fn fuzz(files: &[(String, Vec<u8>)], n_cases: u32, seed: u8) {
    for (name, whole) in files {
        // Headers of compressed files are reached only below the compression.
        let is_gzip = whole.starts_with(&[0x1f, 0x8b]);
        let plain = if is_gzip {
            let mut plain = Vec::new();
            std::io::Read::read_to_end(&mut flate2::read::MultiGzDecoder::new(whole.as_slice()), &mut plain).unwrap();
            plain
        } else {
            whole.clone()
        };
        check(name, whole, plain.len());
        let config = Config { cases: n_cases, failure_persistence: None, ..Config::default() };
        let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]));
        let outcome = runner.run(&proptest::collection::vec(damage(), 1..5), |damage| {
            let bytes = damaged(plain.clone(), &damage);
            check(name, &bytes, bytes.len());
            if is_gzip {
                // A damaged stream may inflate to more than the whole one did.
                check(name, &damaged(whole.clone(), &damage), 1100 * whole.len());
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

#[test]
fn damaged_files_of_every_format_cost_little_and_panic_nowhere() {
    fuzz(&all_samples(), 400, 1);
}

#[test]
fn every_prefix_of_every_file_costs_little_and_panics_nowhere() {
    for (name, bytes) in all_samples() {
        for length in 0..bytes.len() {
            check(&name, &bytes[..length], length);
        }
    }
}

/// Every format has a sample; `make fuzz` names a folder for them, as seeds.
#[test]
fn every_format_is_a_seed_of_fuzzing() {
    let folder = std::env::var_os("HOMOLOG_FUZZ_SEEDS").map(std::path::PathBuf::from);
    let mut seen = std::collections::HashSet::new();
    for (k, (name, bytes)) in all_samples().into_iter().enumerate() {
        seen.insert(read(&bytes, Some(&name), &ReadLimits::default()).unwrap().format);
        if let Some(folder) = &folder {
            std::fs::write(folder.join(format!("sample-{k}")), bytes).unwrap();
        }
    }
    assert_eq!(seen.len(), homolog_formats::InputFormat::ALL.len());
}

/// A small compressed file may inflate to a surface of any number of faces; what is held stays below what is accepted.
#[test]
fn a_surface_of_many_more_faces_than_vertices_are_accepted_is_refused_before_it_takes_memory() {
    const N: usize = 90_000;
    let limits = ReadLimits { max_vertices: 10_000, ..ReadLimits::default() };
    let stl = [vec![0; 80], (N as u32).to_le_bytes().to_vec(), vec![0; 50 * N]].concat();
    let ascii_stl =
        format!("solid x\n{}", "facet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet\n".repeat(N));
    let vertices = "0 0 0\n1 0 0\n0 1 0\n";
    let obj = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{}", "f 1 2 3\n".repeat(N));
    let off = format!("OFF\n3 {N} 0\n{vertices}{}", "3 0 1 2\n".repeat(N));
    let head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let faces = format!("element face {N}\nproperty list uchar int vertex_indices\nend_header\n");
    let ply = format!("{head}{faces}{vertices}{}", "3 0 1 2\n".repeat(N));
    let vtk = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n";
    let vtk = format!("{vtk}{vertices}POLYGONS {N} {}\n{}", 4 * N, "3 0 1 2\n".repeat(N));
    let words = "0 ".repeat(12 * N);
    let vtp = format!(
        "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"{N}\"><Points><DataArray \
         type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray \
         type=\"Int32\" Name=\"connectivity\" format=\"ascii\">{words}</DataArray></Polys></Piece></PolyData></VTKFile>"
    );
    let whole = |text: String| text.into_bytes();
    for (name, bytes) in [
        ("a.stl", stl),
        ("ascii.stl", whole(ascii_stl)),
        ("a.obj", whole(obj)),
        ("a.off", whole(off)),
        ("a.ply", whole(ply)),
        ("a.vtk", whole(vtk)),
        ("a.vtp", whole(vtp)),
    ] {
        HELD.with(|held| held.set([0, 0]));
        let refused = read(&bytes, Some(name), &limits).unwrap_err();
        let most = HELD.with(Cell::get)[1];
        assert!(matches!(refused, FormatError::TooLarge { .. }), "{name}: {refused}");
        assert!(most < 32 << 20, "{name}: {most} bytes were held");
    }
    // A surface larger than any that is accepted is not even read.
    let long = format!("{}v 0 0 0\n", "# x\n".repeat(2_000_000));
    let refused = read(long.as_bytes(), Some("a.obj"), &limits).unwrap_err();
    assert!(matches!(refused, FormatError::TooLarge { what: "bytes of a surface", .. }), "{refused}");
}

/// What coverage-guided fuzzing (`make fuzz`) has found.
#[test]
fn files_that_once_were_trouble_are_none() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/crashes");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        let bytes = std::fs::read(&path).unwrap();
        check(&path.file_name().unwrap().to_string_lossy(), &bytes, bytes.len());
    }
}

/// Files of other programs, which are not part of the repository.
mod real_data {
    use super::*;

    #[test]
    #[ignore = "needs real data (formats)"]
    fn damaged_files_of_other_programs_cost_little_and_panic_nowhere() {
        let folders: Vec<_> = crate::fixtures::real_files("formats").into_iter().collect();
        let files = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
        let mut paths: Vec<_> = files.map(|file| file.unwrap().path()).collect();
        paths.sort();
        for path in paths {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let bytes = std::fs::read(&path).unwrap();
            // Copies of the largest files take most of the time.
            let n_cases = if bytes.len() > 200_000 { 12 } else { 60 };
            fuzz(&[(name, bytes)], n_cases, 2);
        }
    }
}
