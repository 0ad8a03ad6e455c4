//! Topology of small surfaces whose answer is known by hand.

use super::*;
use crate::FaceArity;
use nalgebra::Point3;

fn points(list: &[[f64; 3]]) -> Vec<Point3<f64>> {
    list.iter().map(|&p| Point3::from(p)).collect()
}

fn tetrahedron(shift: f64) -> (Vec<Point3<f64>>, Vec<u32>) {
    let v = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let v = v.map(|p| [p[0] + shift, p[1], p[2]]);
    (points(&v), vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3])
}

fn mesh(v: Vec<Point3<f64>>, f: Vec<u32>) -> SurfaceMesh {
    SurfaceMesh::new(v, FaceArity::Triangle, f).unwrap()
}

/// A closed torus of `m × n` quads.
fn torus(m: u32, n: u32) -> SurfaceMesh {
    let mut v = Vec::new();
    let mut f = Vec::new();
    for i in 0..m {
        for j in 0..n {
            let (a, b) = (f64::from(i) / f64::from(m), f64::from(j) / f64::from(n));
            let ((sa, ca), (sb, cb)) = ((a * 2.0 * std::f64::consts::PI).sin_cos(), {
                let t = b * 2.0 * std::f64::consts::PI;
                (t.sin(), t.cos())
            });
            v.push(Point3::new((3.0 + cb) * ca, (3.0 + cb) * sa, sb));
            let at = |i: u32, j: u32| (i % m) * n + j % n;
            f.extend([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    SurfaceMesh::new(v, FaceArity::Quad, f).unwrap()
}

#[test]
fn a_tetrahedron_is_a_sphere() {
    let (v, f) = tetrahedron(0.0);
    let a = analyze(&mesh(v, f));
    assert_eq!(a.fault, None);
    assert_eq!((a.report.n_vertices, a.report.n_edges, a.report.n_faces), (4, 6, 4));
    assert_eq!((a.report.genus, a.report.euler_characteristic, a.report.n_components), (Some(0), 2, 1));
    assert!((a.report.volume_mm3.unwrap() - 1.0 / 6.0).abs() < 1e-15);
}

#[test]
fn a_torus_of_quads_has_genus_one() {
    let a = analyze(&torus(12, 7));
    assert_eq!(a.report.genus, Some(1));
    let Some(SurfaceFault::Genus { genus: 1, tunnel: Some(tunnel) }) = a.fault else { panic!("{:?}", a.fault) };
    let said = SurfaceFault::Genus { genus: 2, tunnel: Some(tunnel) }.to_string();
    assert!(
        said.contains("2 tunnels (genus 2); the narrowest is near (") && said.contains(" mm, where a loop of "),
        "{said}"
    );
}

#[test]
fn a_missing_face_is_reported_with_its_edge() {
    let (v, f) = tetrahedron(0.0);
    let a = analyze(&mesh(v, f[..9].to_vec()));
    assert_eq!(a.report.n_boundary_edges, 3);
    assert_eq!((a.report.genus, a.report.volume_mm3), (None, None));
    let text = a.fault.unwrap().to_string();
    assert!(text.contains("vertices 1 and 2 near (0.50, 0.50, 0.00) mm"), "{text}");
}

#[test]
fn with_a_boundary_allowed_a_surface_needs_only_one_oriented_piece() {
    let (v, f) = tetrahedron(0.0);
    let open = f[..9].to_vec();
    let judged = |indices: Vec<u32>| analyze_with(&mesh(v.clone(), indices), Demand::Any).fault;
    assert_eq!(judged(open.clone()), None);
    let turned = open.chunks_exact(3).flat_map(|t| [t[0], t[2], t[1]]).collect();
    assert!(matches!(judged(turned), Some(SurfaceFault::InsideOut { .. })));
    let mut twisted = open;
    twisted.swap(0, 1);
    assert!(matches!(judged(twisted), Some(SurfaceFault::Misoriented { .. })));
}

#[test]
fn two_tetrahedra_at_a_vertex_an_edge_or_apart() {
    let (v, f) = tetrahedron(0.0);
    let (w, g) = tetrahedron(5.0);
    let both: Vec<_> = v.iter().chain(&w).copied().collect();
    let joined = |map: [u32; 4]| {
        let faces = f.iter().copied().chain(g.iter().map(|&k| map[k as usize])).collect();
        analyze(&mesh(both.clone(), faces))
    };
    let apart = joined([4, 5, 6, 7]);
    assert_eq!((apart.report.n_components, apart.report.genus), (2, Some(0)));
    assert!(matches!(apart.fault, Some(SurfaceFault::Pieces { n_components: 2, largest: 4, .. })));
    let at_vertex = joined([3, 5, 6, 7]);
    assert_eq!((at_vertex.report.n_nonmanifold_vertices, at_vertex.report.genus), (1, None));
    assert!(matches!(at_vertex.fault, Some(SurfaceFault::NonManifoldVertex { vertex: 3, n_fans: 2, .. })));
    let at_edge = joined([3, 1, 6, 7]);
    assert_eq!(at_edge.report.n_nonmanifold_edges, 1);
    assert!(matches!(at_edge.fault, Some(SurfaceFault::NonManifoldEdge { edge: [1, 3], n_faces: 4, .. })));
}

#[test]
fn orientation_faults_are_distinguished() {
    let (v, mut f) = tetrahedron(0.0);
    f.chunks_exact_mut(3).for_each(|t| t.swap(0, 1));
    let inside_out = analyze(&mesh(v.clone(), f.clone()));
    assert_eq!(inside_out.report.genus, Some(0));
    assert!(matches!(inside_out.fault, Some(SurfaceFault::InsideOut { .. })));
    f.swap(0, 1);
    let twisted = analyze(&mesh(v, f));
    assert!(!twisted.report.oriented && twisted.report.genus.is_none());
    assert!(matches!(twisted.fault, Some(SurfaceFault::Misoriented { n_edges: 3, .. })));
}

#[test]
fn unused_vertices_do_not_count() {
    let (mut v, f) = tetrahedron(0.0);
    v.push(Point3::new(9.0, 9.0, 9.0));
    let a = analyze(&mesh(v, f));
    assert_eq!((a.report.n_vertices, a.report.genus, a.fault), (4, Some(0), None));
}

#[test]
fn faces_on_a_line_have_no_area() {
    let v = [0.0, 1.0, 2.0].map(|x| Point3::new(x, 0.0, 0.0)).to_vec();
    let fault = analyze_with(&mesh(v, vec![0, 1, 2]), Demand::Any).fault;
    assert_eq!(fault, Some(SurfaceFault::NoArea { area_mm2: 0.0 }));
}
