//! Memory of a study, computed from the allocations of each part.
//!
//! This is the only place that lists the arrays: planners of a study query it before a match is made, and a test checks
//! that it exceeds the count of an allocator (`tests/memory.rs`). `n` subjects, `v` vertices and `f` faces of the
//! template, `t` threads.

use crate::joint::{JointSettings, SURFACES_BYTES};
use crate::model::{COMPLETE, many};
use crate::plan::{RIVALS_PER_SUBJECT, rivals_at_a_time};
use crate::rivals::GroupSettings;
use crate::settings::{Analysis, Measure};
use homolog_contract::study::StudySize;

/// Vertices per block of `model::gram`.
const BLOCK: u64 = 512;
/// Largest number of kept modes.
const MODES: u64 = 60;
/// Shapes that [`crate::align::align`] holds in memory at a time.
const ALIGNED: u64 = 32;
/// Tasks of [`crate::statistics::permutation::test`] whose counts are in memory at a time.
const TASKS: u64 = 32;
/// Written surfaces (modes, mean and template); number of modes and subjects with a picture.
const WRITTEN_SURFACES: u64 = 12;
const SHOWN_MODES: u64 = 6;
const PICTURES: u64 = 12;
/// Total vertices of all pictures.
const PICTURE_VERTICES: u64 = 120_000;
/// Copies of the page while it is written: its parts, its data as JSON, escaped, the page, and the file.
const PAGE_COPIES: u64 = 6;
/// Memory of a subject besides its points, bytes: names, facts, findings, rows of tables.
const SUBJECT: u64 = 16 << 10;
/// Memory of a map besides its values, bytes: the heads of its arrays in two files.
const MAP: u64 = 24 << 10;
/// Memory of a cell of the subject table with all its copies, bytes: as text in maps and in columns, and as value.
const CELL: u64 = 512;
/// Scratch of compressors and of decompositions on each thread, bytes.
const SCRATCH: u64 = 2 << 20;
/// Memory of a label volume per byte of its file: labels compress well and take four bytes each.
const VOLUME: u64 = 64;

/// Number of tested measures.
pub fn measures(size: &StudySize) -> u64 {
    size.measures.unwrap_or(Measure::ALL.len() as u64)
}

/// Number of permutations of each test.
pub fn permutations(size: &StudySize) -> u64 {
    size.permutations.unwrap_or_else(|| Analysis::default().permutations as u64)
}

/// Upper bound of the memory allocated by a step of the study on `threads` threads, bytes, excluding the process's own.
pub fn step_bytes(size: &StudySize, threads: usize) -> u64 {
    let StudySize { subjects: n, vertices: v, faces: f, .. } = *size;
    let t = (threads as u64).max(1);
    let times = |parts: &[u64]| parts.iter().copied().fold(1, u64::saturating_mul);
    let sum = |parts: &[u64]| parts.iter().copied().fold(0, u64::saturating_add);
    let maps = times(&[size.contrasts, measures(size)]);
    let modes = MODES.min(n.saturating_sub(1));
    // Positions of 24 bytes and faces of three corners of 4.
    let surface = 24 * v + 12 * f;
    // As VTK, in double precision with corners of 8 bytes, and as GIFTI, compressed and in base64.
    let written = (24 * v + 32 * f) + (16 * v + 17 * f);
    // Per array value: 8 bytes, and 4 in base64.
    let array = 14 * v;

    // The records, as read and in the folder; those of the ring are four matches each, joint maps have their own. A visit of
    // a person with a template has up to three matches and a map besides, and a joint one.
    let joint_maps = if size.joint { n } else { 0 };
    let of_visits = if size.own_templates { times(&[4, n]) } else { 0 };
    // Any subject may be ambiguous, and has then the map that the group decided on.
    let of_rivals = if size.rivals { times(&[1 + RIVALS_PER_SUBJECT as u64, n]) } else { 0 };
    let records = times(&[2, sum(&[n, joint_maps, of_visits, of_rivals, times(&[4, size.ring])]), 12 * v + 1024]);
    let table = sum(&[times(&[n, SUBJECT]), times(&[size.cells, CELL])]);
    // The template as read, as matched, as written, and in the findings; the mean; weights, areas, normals, the graph.
    let surfaces = times(&[12, surface]) + 300 * v;
    // Per thread: a record and its points, the surface deformed onto a subject, and its index of closest points.
    let of_threads = times(&[t, SCRATCH + 120 * v + 3 * surface + 160 * f + times(&[6, volume_bytes(size)])]);
    // The surfaces that templates of persons are made from, and such templates of a part of a step, with their files.
    let persons = if size.own_templates { times(&[n, 2, surface + 40 * v]) } else { 0 };
    let (rivals, turned) = if size.rivals { (rival_bytes(size), turned_bytes(size)) } else { (0, 0) };
    let held = sum(&[records, table, surfaces, persons]);

    let aligned = times(&[ALIGNED.min(n), 60 * v]);
    // A block twice; the matrix of inner products, its parts and components, and on each thread those without some
    // subjects.
    let complete = n.min(COMPLETE as u64);
    let gram = sum(&[times(&[2, BLOCK, 24, n]), times(&[32, n, complete]), times(&[40, t, complete, complete])]);
    let gram = if n > complete { gram.max(many_bytes(size, t)) } else { gram };
    let of_modes = times(&[modes, 24 * v]);
    let model = sum(&[aligned, gram, of_modes]);
    let joint = if size.joint { joint_bytes(size, t) } else { 0 };

    // Values by subject and by vertex, then these and the residuals; results of a contrast; counts, and scratch of each
    // thread.
    let values = times(&[16, n, v]);
    let test = sum(&[240 * v, times(&[TASKS, 4 * v]), times(&[t, 80 * v]), times(&[48, permutations(size)])]);
    let kept = times(&[maps, 96 * v]);
    let p = size.columns;
    let design = sum(&[times(&[n, p, 64]), times(&[t, p, p, 48])]);
    let scores = times(&[8, n, complete]);
    let statistics = sum(&[values, test, kept, of_modes, design, scores]);

    let pictures = times(&[18, SHOWN_MODES * v + times(&[PICTURES, v]).min(PICTURE_VERTICES.max(v))]);
    let page = times(&[PAGE_COPIES, sum(&[times(&[maps, 3 * v]), pictures, 17 * f, times(&[n.min(200), 1024])])]);
    let files = sum(&[
        times(&[n, written + 3 * array + if size.has_volumes { 2 * size.file_bytes } else { 0 }]),
        times(&[WRITTEN_SURFACES, written + array]),
        times(&[maps, written + 12 * array + MAP]),
        times(&[n, SUBJECT]),
    ]);
    let writing = sum(&[files, page, kept, of_modes, times(&[t, SCRATCH + 2 * written + 12 * array])]);
    // The archive has every file, and the records.
    let archive = sum(&[times(&[2, files]), page / PAGE_COPIES, records]);
    // Subjects are read before anything is written.
    let computing = of_threads + model.max(statistics).max(joint).max(rivals).max(turned);
    sum(&[held, computing.max(writing).max(archive)])
}

/// Memory of the model of a large group on `t` threads, bytes.
fn many_bytes(size: &StudySize, t: u64) -> u64 {
    let StudySize { subjects: n, vertices: v, .. } = *size;
    let times = |parts: &[u64]| parts.iter().copied().fold(1, u64::saturating_mul);
    let r = many::COMPONENTS as u64;
    // Shapes read and as columns; directions, their image, and their factors; scores as matrices and rows, and left out.
    let columns = times(&[2, many::AT_A_TIME as u64, 24, v]);
    let directions = times(&[6, 24, v, r]);
    let scores = times(&[8, n, r, 5 + t]);
    let inner = times(&[8, r, r, 6 + 6 * t]);
    [columns, directions, scores, inner].into_iter().fold(0, u64::saturating_add)
}

/// Memory of what decides on poses besides the records, bytes.
fn rival_bytes(size: &StudySize) -> u64 {
    let StudySize { subjects: n, vertices: v, .. } = *size;
    let times = |parts: &[u64]| parts.iter().copied().fold(1, u64::saturating_mul);
    let (settings, candidates) = (GroupSettings::default(), 1 + RIVALS_PER_SUBJECT as u64);
    // The shapes of all candidates, the maps of reliable subjects, and the potentials and messages of a part.
    let shapes = times(&[n, candidates, 8 * settings.patches as u64 + 64]);
    let observed = times(&[n.min(settings.most_observed as u64), 40 * v]);
    let together = n.min(settings.together as u64);
    let potentials = times(&[together, together, candidates * (candidates + 4), 8]);
    [shapes, observed, potentials].into_iter().fold(0, u64::saturating_add)
}

/// Memory of the surfaces of a step to rival poses, bytes: each as it was turned and as a file, as large as the template or as the
/// file of a subject.
fn turned_bytes(size: &StudySize) -> u64 {
    let StudySize { subjects: n, vertices: v, faces: f, .. } = *size;
    let tasks = (rivals_at_a_time(n as usize) as u64).min(n.saturating_mul(RIVALS_PER_SUBJECT as u64));
    let of_file = if size.has_volumes { 0 } else { size.file_bytes };
    tasks.saturating_mul((48 * v + 26 * f + 1024).max(of_file.saturating_mul(3)))
}

/// Memory of joint maps on `t` threads besides the records, bytes.
fn joint_bytes(size: &StudySize, t: u64) -> u64 {
    let StudySize { subjects, vertices: v, faces: f, .. } = *size;
    let times = |parts: &[u64]| parts.iter().copied().fold(1, u64::saturating_mul);
    let n = subjects.min(JointSettings::default().most_in_model as u64);
    // A subject's surface with its index and normals, as large as the template or as its file at most.
    let surface = 72 * v + 140 * f + size.file_bytes;
    let held = times(&[subjects, surface]).min(SURFACES_BYTES as u64);
    // Maps before and after a round, shapes and their matrix, residuals and normals, steps; inner products.
    let shapes = times(&[n, 240 * v]);
    let gram = times(&[8, n, n, 2 + 8 * t]);
    let modes = times(&[1 + t, n / 4 + 2, 48 * v + 8 * n]);
    let scratch = times(&[t, 2 * surface + 200 * v]);
    [held, shapes, gram, modes, scratch].into_iter().fold(0, u64::saturating_add)
}

/// The labels of the largest volume.
fn volume_bytes(size: &StudySize) -> u64 {
    if size.has_volumes { size.file_bytes.saturating_mul(VOLUME).min(1 << 30) } else { size.file_bytes }
}
