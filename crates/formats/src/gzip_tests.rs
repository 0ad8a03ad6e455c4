//! Damaged, truncated and unusual gzip streams, for every format that may come compressed.

use super::gzip::{inflate, inflate_prefix, unverified_prefix};
use super::*;
use flate2::read::MultiGzDecoder;
use flate2::{Compression, GzBuilder};
use homolog_mesh::{FaceArity, SurfaceMesh};
use nalgebra::{Matrix4, Point3};
use proptest::prelude::*;
use std::io::{Read, Write};

const TRAILER_BYTES: usize = 8;

/// A budget that no test exhausts.
fn ample() -> Budget {
    Budget::new(1 << 30)
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzBuilder::new().write(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn plain_files() -> [(&'static str, Vec<u8>); 4] {
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from).to_vec();
    let mesh = SurfaceMesh::new(vertices, FaceArity::Triangle, vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]).unwrap();
    let volume = LabelVolume::new([7, 5, 3], (0..105).collect(), Matrix4::identity()).unwrap();
    [
        ("a.nii", write_nifti(&volume)),
        ("a.ply", write_ply(&mesh)),
        ("a.stl", write_stl(&mesh)),
        ("a.vtk", write_vtk(&mesh)),
    ]
}

fn read_as(name: &str, bytes: &[u8]) -> Result<(InputFormat, FileContent), FormatError> {
    read(bytes, Some(name), &ReadLimits::default()).map(|file| (file.format, file.content))
}

fn fault_of(name: &str, bytes: &[u8]) -> GzipFault {
    match read_as(name, bytes) {
        Err(FormatError::Gzip { fault, .. }) => fault,
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn a_wrong_checksum_or_length_is_refused_in_every_format() {
    for (name, plain) in plain_files() {
        let whole = gzip(&plain);
        assert_eq!(read_as(name, &whole), read_as(name, &plain), "{name}");
        for back in 1..=TRAILER_BYTES {
            let mut damaged = whole.clone();
            let at = damaged.len() - back;
            damaged[at] ^= 0x10;
            let expected = if back > 4 { GzipFault::Checksum } else { GzipFault::Length };
            assert_eq!(fault_of(name, &damaged), expected, "{name}, {back} bytes before the end");
        }
    }
}

#[test]
fn a_stream_cut_anywhere_is_refused_in_every_format() {
    for (name, plain) in plain_files() {
        let whole = gzip(&plain);
        for length in 2..whole.len() {
            let expected = match length {
                0..10 => GzipFault::EndsInHeader,
                _ if length < whole.len() - TRAILER_BYTES => GzipFault::EndsInData,
                _ => GzipFault::EndsBeforeTrailer,
            };
            assert_eq!(fault_of(name, &whole[..length]), expected, "{name}, {length} of {} bytes", whole.len());
        }
    }
}

#[test]
fn voxels_are_refused_when_only_what_follows_them_is_damaged() {
    let [(name, mut plain), ..] = plain_files();
    plain.extend([0; 100_000]);
    let mut damaged = gzip(&plain);
    assert!(read_as(name, &damaged).is_ok(), "padding after the voxels is allowed");
    let at = damaged.len() - TRAILER_BYTES;
    damaged[at] ^= 1;
    assert_eq!(fault_of(name, &damaged), GzipFault::Checksum);
    let limits = ReadLimits { max_inflated_bytes: 50_000, ..ReadLimits::default() };
    assert!(matches!(read(&gzip(&plain), Some(name), &limits), Err(FormatError::TooLarge { .. })));
}

#[test]
fn several_members_are_one_file() {
    for (name, plain) in plain_files() {
        // As bgzip writes: blocks of their own, each with an extra field, and an empty block at the end.
        let mut blocks = Vec::new();
        for piece in plain.chunks(100).chain([[].as_slice()]) {
            let mut encoder = GzBuilder::new().extra(*b"BC\x02\x00\x1b\x00").write(Vec::new(), Compression::fast());
            encoder.write_all(piece).unwrap();
            blocks.push(encoder.finish().unwrap());
        }
        assert!(blocks.len() > 2);
        assert_eq!(read_as(name, &blocks.concat()), read_as(name, &plain), "{name}");
        let checksum = blocks[1].len() - TRAILER_BYTES;
        blocks[1][checksum] ^= 1;
        assert_eq!(fault_of(name, &blocks.concat()), GzipFault::Checksum);
    }
}

#[test]
fn zeros_after_the_last_member_are_padding_and_anything_else_is_refused() {
    for (name, plain) in plain_files() {
        let mut padded = gzip(&plain);
        padded.extend([0; 512]);
        assert_eq!(read_as(name, &padded), read_as(name, &plain), "{name}");
        padded.push(b'x');
        assert_eq!(fault_of(name, &padded), GzipFault::TrailingData);
    }
}

#[test]
fn headers_with_every_optional_field_are_read_and_checked() {
    let [(name, plain), ..] = plain_files();
    let mut header = vec![0x1f, 0x8b, 8, 0x1e, 0, 0, 0, 0, 0, 255, 3, 0, 1, 2, 3];
    header.extend(b"name.nii\0a comment\0");
    let mut crc = flate2::Crc::new();
    crc.update(&header);
    header.extend((crc.sum() as u16).to_le_bytes());
    let body = &gzip(&plain)[10..];
    let with = |header: &[u8]| [header, body].concat();
    assert_eq!(read_as(name, &with(&header)), read_as(name, &plain));
    for length in 2..header.len() {
        assert_eq!(fault_of(name, &header[..length]), GzipFault::EndsInHeader, "{length}");
    }
    // Byte 4 belongs to the time, which nothing but the header's checksum protects; 2 is the method, 3 the flags.
    for (at, value) in [(4, 1), (2, 7), (3, 0x3e)] {
        let mut damaged = header.clone();
        damaged[at] = value;
        assert_eq!(fault_of(name, &with(&damaged)), GzipFault::Header, "byte {at}");
    }
}

#[test]
fn the_message_says_what_is_wrong_and_what_to_do() {
    let [(name, plain), ..] = plain_files();
    let mut damaged = gzip(&plain);
    let cut = read_as(name, &damaged[..damaged.len() - 1]).unwrap_err().to_string();
    assert!(cut.starts_with("the gzip stream ends before its trailer (after 457 inflated bytes); compress"), "{cut}");
    let at = damaged.len() - TRAILER_BYTES;
    damaged[at] ^= 1;
    let text = read_as(name, &damaged).unwrap_err().to_string();
    assert!(text.starts_with("the gzip stream is damaged: its checksum does not match (after"), "{text}");
}

#[test]
fn nothing_beyond_the_limit_is_inflated() {
    let bomb = gzip(&vec![0; 1 << 24]);
    let limit = 1 << 10;
    for found in [inflate(&bomb, limit, &ample()), inflate_prefix(&bomb, 100, limit, &ample()).map(|(plain, _)| plain)]
    {
        let Err(FormatError::TooLarge { found, .. }) = found else { panic!("a bomb is refused") };
        assert!(found <= 1 << 17, "{found} bytes were inflated");
    }
    let exactly = gzip(&vec![0; limit]);
    assert_eq!(inflate(&exactly, limit, &ample()).unwrap().len(), limit);
    assert_eq!(inflate_prefix(&exactly, 100, limit, &ample()).unwrap().0.len(), 100);
}

proptest! {
    /// The decoder of flate2 as the oracle: the same bytes, or a refusal by both.
    #[test]
    fn another_decoder_reads_the_same(
        pieces in proptest::collection::vec(proptest::collection::vec(0..9u8, 0..3000), 1..4),
        level in 0..10u32,
        flip in proptest::option::of((any::<prop::sample::Index>(), 1..=255u8)),
    ) {
        let member = |piece: &Vec<u8>| {
            let mut encoder = GzBuilder::new().filename("a").write(Vec::new(), Compression::new(level));
            encoder.write_all(piece).unwrap();
            encoder.finish().unwrap()
        };
        let mut stream: Vec<u8> = pieces.iter().flat_map(member).collect();
        if let Some((at, value)) = flip {
            // The two magic bytes are kept; otherwise it is not a gzip stream.
            let at = 2 + at.index(stream.len() - 2);
            stream[at] ^= value;
        }
        let mut expected = Vec::new();
        let oracle = MultiGzDecoder::new(stream.as_slice()).read_to_end(&mut expected);
        let ours = inflate(&stream, 1 << 20, &ample());
        match oracle {
            Ok(_) if ours.is_ok() => prop_assert_eq!(&ours.unwrap()[..], &expected[..]),
            // Flags that RFC 1952 reserves are only refused here.
            Ok(_) => prop_assert!(flip.is_some()),
            Err(_) => prop_assert!(ours.is_err()),
        }
        let head = unverified_prefix(&stream, 100);
        if flip.is_none() {
            prop_assert_eq!(&head.unwrap()[..], &expected[..expected.len().min(100)]);
        }
    }
}
