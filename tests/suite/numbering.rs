//! Every vertex index in every export counts the vertices of the upload, however the upload numbers them.
//!
//! An upload is mangled: unused vertices, split vertices, a stray piece, another order of vertices and faces, inverted
//! faces. Repairs undo this, so the answer, mapped back through the mangling, must equal the answer for the clean
//! upload. A label volume is compared with the mangled surface that its own job returned.

use crate::cli::{homolog, read_json};
use base64::Engine as _;
use homolog::jobs::engine::Product;
use homolog::jobs::{ArtifactKind, ComputeInputs, Engine, PartFormat, ResultPart};
use homolog::worker::match_engine::MatchEngine;
use homolog::worker::presentation::NO_TARGET;
use homolog_contract::result::{Correspondences, ResultDocument};
use homolog_formats::{FileContent, ReadLimits, read, write_nifti_gz, write_ply};
use homolog_laboratory::phantom::{PhantomPair, random_permutation};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use nalgebra::{Matrix4, Point3};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::io::Read;
use std::sync::LazyLock;

/// How an upload is mangled.
#[derive(Debug, Clone)]
struct Mangling {
    /// Vertices that no face uses, some of them far away, some where a vertex of the surface is.
    n_unused: usize,
    /// Split vertices: two copies, each used by some of the faces.
    n_split: usize,
    /// A small tetrahedron beside the surface.
    stray_piece: bool,
    inside_out: bool,
    /// Seed of a new order of vertices and faces; `None` keeps the order and appends additions.
    order: Option<u64>,
}

fn mangling() -> impl Strategy<Value = Mangling> {
    let order = prop_oneof![1 => Just(None), 4 => any::<u64>().prop_map(Some)];
    (0..150usize, 0..60usize, any::<bool>(), any::<bool>(), order).prop_map(
        |(n_unused, n_split, stray_piece, inside_out, order)| Mangling {
            n_unused,
            n_split,
            stray_piece,
            inside_out,
            order,
        },
    )
}

/// An upload, and the mapping of its vertices to the clean surface.
#[derive(Clone)]
struct Upload {
    mesh: SurfaceMesh,
    /// For every vertex the vertex of the clean surface; `None` if no answer may name it.
    clean: Vec<Option<u32>>,
}

impl Upload {
    fn clean(mesh: &SurfaceMesh) -> Self {
        Upload { mesh: mesh.clone(), clean: (0..mesh.n_vertices() as u32).map(Some).collect() }
    }

    fn mangled(mesh: &SurfaceMesh, mangling: &Mangling) -> Self {
        let n = mesh.n_vertices();
        let mut vertices = mesh.vertices().to_vec();
        let mut faces: Vec<Vec<u32>> = mesh.faces().map(<[u32]>::to_vec).collect();
        // `of[v]`: the clean vertex of which `v` is a copy.
        let mut of: Vec<Option<u32>> = (0..n as u32).map(Some).collect();
        for k in 0..mangling.n_split {
            let v = (k * 7919) % n;
            let copy = vertices.len() as u32;
            let mut turn = false;
            for corner in faces.iter_mut().flatten().filter(|corner| **corner == v as u32) {
                turn = !turn;
                if turn {
                    *corner = copy;
                }
            }
            assert!(faces.iter().flatten().any(|&corner| corner == copy));
            vertices.push(mesh.vertices()[v]);
            of.push(Some(v as u32));
        }
        for k in 0..mangling.n_unused {
            let p = mesh.vertices()[(k * 31) % n];
            vertices.push(if k % 2 == 0 { p } else { Point3::new(900.0 + k as f64, p.y, -70.0) });
            of.push(None);
        }
        if mangling.stray_piece {
            let (first, corner) = (vertices.len() as u32, Point3::new(200.0, 0.0, 0.0));
            for offset in [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                vertices.push(corner + nalgebra::Vector3::from(offset));
                of.push(None);
            }
            match mesh.arity().n_corners() {
                3 => faces.extend([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(|f| f.map(|v| first + v).to_vec())),
                // Two pairs of opposite quads: closed surfaces without volume.
                _ => faces.extend([[0, 1, 2, 3], [3, 2, 1, 0]].map(|f| f.map(|v| first + v).to_vec())),
            }
        }
        if mangling.inside_out {
            faces.iter_mut().for_each(|face| face[1..].reverse());
        }
        let n = vertices.len();
        let new_index = mangling.order.map_or_else(|| (0..n as u32).collect(), |seed| random_permutation(n, seed));
        let mut placed = vertices.clone();
        let mut placed_of = of.clone();
        for (old, &new) in new_index.iter().enumerate() {
            (placed[new as usize], placed_of[new as usize]) = (vertices[old], of[old]);
        }
        faces.iter_mut().flatten().for_each(|v| *v = new_index[*v as usize]);
        if let Some(seed) = mangling.order {
            let order = random_permutation(faces.len(), seed ^ 1);
            faces = order.iter().map(|&k| std::mem::take(&mut faces[k as usize])).collect();
            faces.iter_mut().enumerate().for_each(|(k, face)| face.rotate_left(k % 3));
        }
        let mesh = SurfaceMesh::new(placed, mesh.arity(), faces.concat()).unwrap();
        // The first copy of a split vertex that a face uses represents all copies.
        let mut seen = BTreeSet::new();
        let clean = placed_of.into_iter().map(|v| v.filter(|&v| seen.insert(v))).collect();
        Upload { mesh, clean }
    }

    fn read(&self, vertex: u32) -> u32 {
        self.clean[vertex as usize].unwrap_or_else(|| panic!("vertex {vertex} has no answer, but is named in one"))
    }
}

/// `columns` in the numbering and the row order of the clean surfaces.
fn read_back(columns: &Correspondences, source: &Upload, target: &Upload) -> Correspondences {
    let mut rows: Vec<usize> = (0..columns.source.len()).collect();
    assert!(columns.source.is_sorted(), "rows are in the order of the upload");
    rows.sort_by_key(|&row| source.read(columns.source[row]));
    fn ordered<T: Copy>(column: &[T], rows: &[usize]) -> Vec<T> {
        rows.iter().map(|&row| column[row]).collect()
    }
    Correspondences {
        source: ordered(&columns.source, &rows).into_iter().map(|v| source.read(v)).collect(),
        target: ordered(&columns.target, &rows).into_iter().map(|v| target.read(v)).collect(),
        confidence: ordered(&columns.confidence, &rows),
        inlier: ordered(&columns.inlier, &rows),
        spread_mm: ordered(&columns.spread_mm, &rows),
        outlier: ordered(&columns.outlier, &rows),
        triangle: ordered(&columns.triangle, &rows).into_iter().map(|t| t.map(|v| target.read(v))).collect(),
        barycentric: ordered(&columns.barycentric, &rows),
        inverse: columns.inverse.as_ref().map(|inverse| Box::new(read_back(inverse, target, source))),
    }
}

/// Asserts that the points of the rows lie on the surface whose faces `triangle` numbers, from the uploaded coordinates
/// alone.
fn assert_points_on_upload(columns: &Correspondences, target: &Upload, faces: &BTreeSet<Vec<u32>>, edge_mm: f64) {
    let at = |v: u32| target.mesh.vertices()[v as usize].coords;
    for row in 0..columns.source.len() {
        let (triangle, weights) = (columns.triangle[row], columns.barycentric[row]);
        let mut corners = triangle.map(|v| target.read(v)).to_vec();
        corners.sort_unstable();
        assert!(faces.contains(&corners), "row {row}: {triangle:?} is no triangle of the surface");
        let point = (0..3).map(|k| at(triangle[k]) * weights[k]).sum::<nalgebra::Vector3<f64>>();
        let far = (point - at(columns.target[row])).norm();
        assert!(far <= 2.0 * edge_mm, "row {row}: {far} mm from the vertex nearest to the image");
    }
}

/// Triangles of a surface, corners ascending.
fn triangles(mesh: &SurfaceMesh) -> BTreeSet<Vec<u32>> {
    let sorted = |triangle: &[u32; 3]| {
        let mut triangle = triangle.to_vec();
        triangle.sort_unstable();
        triangle
    };
    // The diagonal along which a quad is split depends on its first corner; both are valid.
    let quads = mesh.faces().filter(|f| f.len() == 4);
    let other = quads.flat_map(|f| [[f[1], f[2], f[3]], [f[1], f[3], f[0]]]);
    mesh.triangles().iter().map(sorted).chain(other.map(|t| sorted(&t))).collect()
}

/// The stored results of a job.
struct Stored {
    document: ResultDocument,
    columns: Correspondences,
    products: Vec<Product>,
}

impl Stored {
    fn bytes(&self, kind: ArtifactKind) -> &[u8] {
        &self.products.iter().find(|p| p.kind == kind).unwrap().bytes
    }

    fn surface(&self, kind: ArtifactKind) -> SurfaceMesh {
        mesh_of(self.bytes(kind))
    }
}

fn mesh_of(bytes: &[u8]) -> SurfaceMesh {
    match read(bytes, None, &ReadLimits::default()).unwrap().content {
        FileContent::Mesh(file) => file.mesh,
        FileContent::Labels(_) => panic!("a mesh is expected"),
    }
}

const FORWARD: ResultPart = ResultPart::Correspondences { direction: homolog::jobs::WarpDirection::Forward };

fn engine() -> MatchEngine {
    MatchEngine::new(IntakeLimits::default(), 0)
}

fn matched(source: Vec<u8>, target: Vec<u8>, request: &Value) -> Stored {
    let computation = engine().resolve(request).unwrap().computation;
    let inputs = ComputeInputs { source, source_hint: None, target, target_hint: None, purpose: Default::default() };
    let products = computation.compute(&inputs, &Silent).unwrap().products;
    let of = |kind| products.iter().find(|p: &&Product| p.kind == kind).unwrap().bytes.clone();
    let document = serde_json::from_slice(&of(ArtifactKind::Result)).unwrap();
    let columns = serde_json::from_slice(&of(ArtifactKind::Correspondences)).unwrap();
    Stored { document, columns, products }
}

/// Source, target and triangle of every row.
type Indices = Vec<(u32, u32, [u32; 3])>;

fn indices(columns: &Correspondences) -> Indices {
    let row = |k: usize| (columns.source[k], columns.target[k], columns.triangle[k]);
    (0..columns.source.len()).map(row).collect()
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(*bytes[at..].first_chunk().unwrap())
}

fn of_csv(bytes: &[u8]) -> Indices {
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |k: usize| fields[k].parse().unwrap();
        (number(0), number(1), [number(6), number(7), number(8)])
    };
    std::str::from_utf8(bytes).unwrap().lines().skip(1).map(row).collect()
}

fn of_npy(bytes: &[u8]) -> Indices {
    let begin = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    let row = |r: &[u8]| (u32_at(r, 0), u32_at(r, 4), [26, 30, 34].map(|at| u32_at(r, at)));
    bytes[begin..].chunks_exact(62).map(row).collect()
}

/// Columns of one record batch of `n` rows, whose buffers stand one after another, each aligned to eight bytes.
fn of_arrow(bytes: &[u8], n: usize) -> Indices {
    let sizes = [4 * n, 4 * n, 8 * n, n.div_ceil(8), 8 * n, n, 4 * n, 4 * n, 4 * n, 8 * n, 8 * n, 8 * n];
    let padded = sizes.map(|size| size.next_multiple_of(8));
    // After the body: the end of the stream, the footer, its length and the magic bytes.
    let footer = u32_at(bytes, bytes.len() - 10) as usize;
    let begin = bytes.len() - 10 - footer - 8 - padded.iter().sum::<usize>();
    let column = |k: usize, row: usize| u32_at(bytes, begin + padded[..k].iter().sum::<usize>() + 4 * row);
    (0..n).map(|row| (column(0, row), column(1, row), [6, 7, 8].map(|k| column(k, row)))).collect()
}

fn after<'a>(bytes: &'a [u8], mark: &str) -> &'a [u8] {
    let at = bytes.windows(mark.len()).position(|w| w == mark.as_bytes()).unwrap();
    &bytes[at + mark.len()..]
}

const PLY_VERTEX_BYTES: usize = 24 + 4 + 8 + 1 + 8 + 1 + 3 * 4 + 3 * 8;

/// The array `target` of a surface file of `n` vertices.
fn target_array(format: PartFormat, bytes: &[u8], n: usize) -> Vec<i32> {
    let int = |b: &[u8]| i32::from_le_bytes(*b.first_chunk().unwrap());
    match format {
        // Position, target, confidence, inlier, spread, outlier, corners of the triangle, weights.
        PartFormat::Ply => {
            after(bytes, "end_header\n").chunks_exact(PLY_VERTEX_BYTES).take(n).map(|v| int(&v[24..])).collect()
        }
        PartFormat::Vtk => {
            let values = after(bytes, &format!("\ntarget 1 {n} int\n"));
            values.chunks_exact(4).take(n).map(|v| i32::from_be_bytes(*v.first_chunk().unwrap())).collect()
        }
        _ => {
            let text = std::str::from_utf8(after(bytes, "<![CDATA[target]]>")).unwrap();
            let data = text.split_once("<Data>").unwrap().1.split_once("</Data>").unwrap().0;
            let packed = base64::engine::general_purpose::STANDARD.decode(data).unwrap();
            let mut values = Vec::new();
            flate2::read::ZlibDecoder::new(packed.as_slice()).read_to_end(&mut values).unwrap();
            assert_eq!(values.len(), 4 * n);
            values.chunks_exact(4).map(int).collect()
        }
    }
}

/// Asserts that every export equals the stored columns, in the numbering of the upload.
fn assert_exports(stored: &Stored, n_source: usize) {
    let columns = stored.bytes(ArtifactKind::Correspondences);
    let surface = stored.bytes(ArtifactKind::SourceSurface);
    let present = |format, blobs: &[&[u8]]| engine().present(FORWARD, format, blobs).unwrap();
    let expected = indices(&stored.columns);
    assert_eq!(of_csv(&present(PartFormat::Csv, &[columns])), expected);
    assert_eq!(of_npy(&present(PartFormat::Npy, &[columns])), expected);
    assert_eq!(of_arrow(&present(PartFormat::Arrow, &[columns]), expected.len()), expected);
    let mut targets = vec![NO_TARGET; n_source];
    let mut triangles = vec![[NO_TARGET; 3]; n_source];
    for (source, target, triangle) in expected {
        targets[source as usize] = target as i32;
        triangles[source as usize] = triangle.map(|corner| corner as i32);
    }
    let ply = present(PartFormat::Ply, &[columns, surface]);
    let vertices = after(&ply, "end_header\n").chunks_exact(PLY_VERTEX_BYTES).take(n_source);
    let corners = vertices.map(|v| [46, 50, 54].map(|at| u32_at(v, at) as i32));
    assert_eq!(corners.collect::<Vec<_>>(), triangles);
    for format in [PartFormat::Ply, PartFormat::Vtk, PartFormat::Gifti] {
        let made = present(format, &[columns, surface]);
        assert_eq!(target_array(format, &made, n_source), targets, "{}", format.name());
    }
}

/// A clean pair: the uploads, the surfaces that number its vertices, and the answer.
struct Clean {
    files: [Vec<u8>; 2],
    request: Value,
    surfaces: [SurfaceMesh; 2],
    answer: Stored,
}

impl Clean {
    fn new(files: [Vec<u8>; 2], mut request: Value) -> Self {
        request["both_directions"] = json!(true);
        request["input"]["repair"] = json!(["weld", "largest_component", "fill"]);
        let [source, target] = files.clone();
        let answer = matched(source, target, &request);
        let surfaces = [ArtifactKind::SourceSurface, ArtifactKind::TargetSurface].map(|kind| answer.surface(kind));
        Clean { files, request, surfaces, answer }
    }

    fn assert_answers_alike(&self, manglings: [Option<&Mangling>; 2]) {
        let upload = |k: usize| match manglings[k] {
            None => Upload::clean(&self.surfaces[k]),
            Some(mangling) => Upload::mangled(&self.surfaces[k], mangling),
        };
        let uploads = [upload(0), upload(1)];
        let file = |k: usize| manglings[k].map_or_else(|| self.files[k].clone(), |_| write_ply(&uploads[k].mesh));
        let found = matched(file(0), file(1), &self.request);
        let [source, target] = &uploads;

        assert_eq!(read_back(&found.columns, source, target), self.answer.columns);
        // Except for times and descriptions of the files, the documents are equal.
        let mut document = found.document.clone();
        document.timings_ms.clone_from(&self.answer.document.timings_ms);
        document.provenance = self.answer.document.provenance.clone();
        // A mangled file has small pieces, and a warning says that they were dropped.
        assert!(document.warnings.iter().all(|warning| warning.reason.is_none()), "{:?}", document.warnings);
        document.warnings.clone_from(&self.answer.document.warnings);
        assert_eq!(document, self.answer.document);

        let edge_mm = self.surfaces.each_ref().map(SurfaceMesh::mean_edge_length);
        let faces = self.surfaces.each_ref().map(triangles);
        assert_points_on_upload(&found.columns, target, &faces[1], edge_mm[1]);
        let inverse = found.columns.inverse.as_ref().unwrap();
        assert_points_on_upload(inverse, source, &faces[0], edge_mm[0]);

        let served = [ArtifactKind::SourceSurface, ArtifactKind::TargetSurface].map(|kind| found.surface(kind));
        assert_eq!(served[0].vertices(), source.mesh.vertices());
        assert_eq!(served[1].vertices(), target.mesh.vertices());
        let matrix = Matrix4::from_fn(|r, c| found.document.transform.matrix[r][c]);
        let aligned = found.surface(ArtifactKind::Aligned);
        for (p, moved) in source.mesh.vertices().iter().zip(aligned.vertices()) {
            assert!((matrix.transform_point(p) - moved).norm() < 1e-9);
        }
        assert_exports(&found, source.mesh.n_vertices());
    }
}

/// Meshes matched in three ways (with a displacement field from a coarse level; with vertices as labels; by
/// registration alone), and label volumes with smooth surfaces and with voxel surfaces, whose faces are quads.
static PAIRS: LazyLock<Vec<Clean>> = LazyLock::new(|| {
    let pair = PhantomPair::against_template(0).unwrap();
    let meshes = pair.meshes(2.0).unwrap().map(|mesh| write_ply(&mesh));
    let volumes = [pair.source_volume(2.0).unwrap(), pair.target_volume(2.0).unwrap()];
    let volumes = volumes.map(|volume| write_nifti_gz(&volume.into_label_volume().unwrap()));
    vec![
        Clean::new(meshes.clone(), json!({"inference": {"coarse_vertices": 150}})),
        Clean::new(meshes.clone(), json!({"method": "thesis", "inference": {"max_iterations": 10}})),
        Clean::new(meshes, json!({"method": "rigid"})),
        Clean::new(volumes.clone(), json!({})),
        Clean::new(volumes, json!({"input": {"surface": "voxel"}})),
    ]
});

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn mangled_uploads_are_answered_in_their_own_numbering(
        which in 0..5usize, source in proptest::option::of(mangling()), target in mangling(),
    ) {
        PAIRS[which].assert_answers_alike([source.as_ref(), Some(&target)]);
    }
}

/// Regression: `target` counted unused vertices, but `triangle` and `inverse` did not.
#[test]
fn unused_vertices_before_the_target_are_counted_by_every_column() {
    let clean = &PAIRS[0];
    let target = &clean.surfaces[1];
    let mut vertices = vec![Point3::new(900.0, 0.0, 0.0); 100];
    vertices.extend(target.vertices());
    let indices = target.indices().iter().map(|&v| v + 100).collect();
    let mesh = SurfaceMesh::new(vertices, target.arity(), indices).unwrap();
    let found = matched(clean.files[0].clone(), write_ply(&mesh), &clean.request);
    let by_100 = |columns: &[u32]| columns.iter().map(|v| v + 100).collect::<Vec<_>>();
    let before = &clean.answer.columns;
    assert_eq!(found.columns.source, before.source);
    assert_eq!(found.columns.target, by_100(&before.target));
    assert_eq!(found.columns.triangle.as_flattened(), by_100(before.triangle.as_flattened()));
    let (inverse, before) = (found.columns.inverse.unwrap(), before.inverse.as_ref().unwrap());
    assert_eq!(inverse.source, by_100(&before.source));
    assert_eq!((&inverse.target, &inverse.triangle), (&before.target, &before.triangle));
}

#[test]
fn files_of_the_command_line_count_the_vertices_of_the_upload() {
    let clean = &PAIRS[0];
    let mangling = Mangling { n_unused: 30, n_split: 20, stray_piece: true, inside_out: false, order: Some(5) };
    let uploads = clean.surfaces.each_ref().map(|mesh| Upload::mangled(mesh, &mangling));
    let folder = tempfile::tempdir().unwrap();
    let paths = ["a.ply", "b.ply"].map(|name| folder.path().join(name));
    for (path, upload) in paths.iter().zip(&uploads) {
        std::fs::write(path, write_ply(&upload.mesh)).unwrap();
    }
    std::fs::write(folder.path().join("p.json"), clean.request.to_string()).unwrap();
    let out = folder.path().join("out");
    let mut command = homolog();
    command.arg("match").args(&paths).arg("--params").arg(folder.path().join("p.json")).arg("--out").arg(&out);
    let done = command.output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let file = |name: &str| std::fs::read(out.join(name)).unwrap();
    let columns: Correspondences =
        serde_json::from_value(read_json(&out.join("result.json"))["correspondences"].take()).unwrap();
    assert_eq!(read_back(&columns, &uploads[0], &uploads[1]), clean.answer.columns);
    assert_eq!(of_csv(&file("correspondences.csv")), indices(&columns));
    assert_eq!(mesh_of(&file("source.ply")).vertices(), uploads[0].mesh.vertices());
    assert_eq!(mesh_of(&file("target.ply")).vertices(), uploads[1].mesh.vertices());
    assert_eq!(mesh_of(&file("aligned.ply")).n_vertices(), uploads[0].mesh.n_vertices());
}
