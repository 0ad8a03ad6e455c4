//! Tunnels of rings, of several rings, and of plates with holes are closed; nothing else changes.

use super::*;
use crate::repair;
use crate::shapes::{ellipsoid, torus};
use proptest::prelude::*;

/// A flat plate of unit cubes in which the cells of `holes` are missing, its boundary as triangles.
fn plate(columns: i32, rows: i32, holes: &[(i32, i32)]) -> SurfaceMesh {
    let solid = |x: i32, y: i32, z: i32| {
        (0..columns).contains(&x) && (0..rows).contains(&y) && z == 0 && !holes.contains(&(x, y))
    };
    let mut number: HashMap<[i32; 3], u32> = HashMap::new();
    let (mut vertices, mut faces) = (Vec::new(), Vec::new());
    for (x, y) in (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y))).filter(|&(x, y)| solid(x, y, 0)) {
        for axis in 0..3 {
            for side in [0, 1] {
                let mut beside = [x, y, 0];
                beside[axis] += 2 * side - 1;
                if solid(beside[0], beside[1], beside[2]) {
                    continue;
                }
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut quad = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| {
                    let mut corner = [x, y, 0];
                    corner[axis] += side;
                    corner[u] += a;
                    corner[v] += b;
                    *number.entry(corner).or_insert_with(|| {
                        vertices.push(Point3::new(f64::from(corner[0]), f64::from(corner[1]), f64::from(corner[2])));
                        vertices.len() as u32 - 1
                    })
                });
                if side == 0 {
                    quad.reverse();
                }
                faces.extend([quad[0], quad[1], quad[2], quad[0], quad[2], quad[3]]);
            }
        }
    }
    SurfaceMesh::new(vertices, FaceArity::Triangle, faces).unwrap()
}

/// Closes all tunnels and checks that the outcome is a closed surface of genus 0 around nearly the same space.
fn closed(mesh: &SurfaceMesh) -> ClosedTunnels {
    let before = topology_report(mesh);
    let closed = close_tunnels(mesh).unwrap().unwrap();
    let after = topology_report(&closed.mesh);
    assert_eq!((after.genus, after.n_components), (Some(0), before.n_components), "{after:?}");
    assert_eq!((closed.n_tunnels, closed.n_closed), (before.genus.unwrap(), before.genus.unwrap()));
    let n = mesh.n_vertices();
    assert_eq!(closed.mesh.n_vertices(), n + closed.n_copied + closed.n_added);
    let moved = mesh.vertices().iter().zip(closed.mesh.vertices()).map(|(a, b)| (a - b).norm());
    assert!(moved.fold(0.0, f64::max) <= closed.largest_mm);
    // The original faces keep their corners, or have copies of these.
    let place = |v: u32| closed.mesh.vertices()[v as usize];
    for (before, after) in mesh.triangles().into_iter().zip(closed.mesh.triangles()) {
        for (v, w) in before.into_iter().zip(after) {
            assert!((mesh.vertices()[v as usize] - place(w)).norm() <= closed.largest_mm + 1e-12);
        }
    }
    assert!(after.volume_mm3.unwrap() > 0.0);
    closed
}

#[test]
fn a_thin_ring_is_severed_and_a_narrow_hole_gets_a_membrane() {
    let thin = torus(10.0, 2.0, 60, 16, FaceArity::Quad);
    let severed = closed(&thin);
    assert!((severed.longest_loop_mm / (std::f64::consts::TAU * 2.0) - 1.0).abs() < 0.05, "around the tube");
    assert_eq!(severed.n_copied, 16);
    assert!(severed.mesh.signed_volume() < thin.signed_volume());

    let fat = torus(5.0, 4.0, 60, 40, FaceArity::Triangle);
    let covered = closed(&fat);
    assert!((covered.longest_loop_mm / std::f64::consts::TAU - 1.0).abs() < 0.05, "through the hole");
    assert!(covered.mesh.signed_volume() > fat.signed_volume());
    // Welding does not join the caps again.
    let welded = crate::repair::weld(&covered.mesh).unwrap();
    assert_eq!(topology_report(&welded.mesh).genus, Some(0));
    assert_eq!(welded.mesh.n_vertices(), covered.mesh.n_vertices());
}

#[test]
fn surfaces_without_tunnels_are_left_as_they_are() {
    let ball = ellipsoid(Vector3::new(3.0, 2.0, 1.0), 3);
    assert_eq!(close_tunnels(&ball).unwrap(), None);
    // A tube has two boundaries and no tunnel.
    let tube: Vec<u32> = ball
        .triangles()
        .into_iter()
        .filter(|t| t.iter().all(|&v| ball.vertices()[v as usize].x.abs() < 2.0))
        .flatten()
        .collect();
    let tube =
        repair::drop_unused(&SurfaceMesh::new(ball.vertices().to_vec(), FaceArity::Triangle, tube).unwrap()).mesh;
    assert_eq!((count_tunnels(&tube), topology_report(&tube).euler_characteristic), (Some(0), 0));
    assert_eq!(close_tunnels(&tube).unwrap(), None);
    assert_eq!(narrowest_tunnel(&tube), None);
}

/// `mesh` without the triangles whose corners all lie within `radius` of one of `places`.
fn opened(mesh: &SurfaceMesh, places: &[Point3<f64>], radius: f64) -> SurfaceMesh {
    let near = |v: &u32| places.iter().any(|p| (p - mesh.vertices()[*v as usize]).norm() < radius);
    let kept = mesh.triangles().into_iter().filter(|t| !t.iter().all(near)).flatten().collect();
    repair::drop_unused(&SurfaceMesh::new(mesh.vertices().to_vec(), FaceArity::Triangle, kept).unwrap()).mesh
}

/// Lengths of the boundaries, as numbers of edges, ascending.
fn boundaries(mesh: &SurfaceMesh) -> Vec<usize> {
    let mut next: HashMap<u32, u32> = HashMap::new();
    let directed = |t: [u32; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    let all: std::collections::HashSet<[u32; 2]> = mesh.triangles().into_iter().flat_map(directed).collect();
    for [a, b] in all.iter().filter(|[a, b]| !all.contains(&[*b, *a])) {
        assert_eq!(next.insert(*a, *b), None, "a simple boundary");
    }
    let mut lengths = Vec::new();
    while let Some(&start) = next.keys().next() {
        let (mut at, mut n) = (start, 0);
        while let Some(to) = next.remove(&at) {
            (at, n) = (to, n + 1);
        }
        lengths.push(n);
    }
    lengths.sort_unstable();
    lengths
}

#[test]
fn the_tunnels_of_open_surfaces_are_closed_and_their_boundaries_stay() {
    // The hole of the first window lies on the tube where loops around it are shortest.
    for (thick, windows) in [(2.0, 1), (4.0, 1), (2.0, 3), (4.0, 2)] {
        let ring = torus(6.0, thick, 60, 30, FaceArity::Triangle);
        let at = |k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / windows as f64;
            Point3::new((6.0 - thick) * angle.cos(), (6.0 - thick) * angle.sin(), 0.0)
        };
        let open = opened(&ring, &(0..windows).map(at).collect::<Vec<_>>(), 1.2);
        let rims = boundaries(&open);
        assert_eq!(rims.len(), windows);
        assert_eq!((count_tunnels(&open), topology_report(&open).genus), (Some(1), None));
        let closed = close_tunnels(&open).unwrap().unwrap();
        assert_eq!((closed.n_tunnels, closed.n_closed, count_tunnels(&closed.mesh)), (1, 1, Some(0)));
        let report = topology_report(&closed.mesh);
        assert_eq!((report.n_nonmanifold_vertices, report.oriented, report.n_components), (0, true, 1));
        assert_eq!(boundaries(&closed.mesh), rims);
        assert_eq!(closed.mesh.n_vertices(), open.n_vertices() + closed.n_copied + closed.n_added);
        assert!(closed.mesh.vertices().iter().all(|p| p.coords.iter().all(|x| x.is_finite())));
        assert_eq!(narrowest_tunnel(&open).unwrap().length_mm, closed.longest_loop_mm);
    }
}

#[test]
fn the_narrowest_tunnel_is_where_it_is() {
    let far = Vector3::new(100.0, -20.0, 3.0);
    let ring = torus(5.0, 4.0, 60, 40, FaceArity::Triangle);
    let ring = ring.with_vertices(ring.vertices().iter().map(|p| p + far).collect()).unwrap();
    let Tunnel { place_mm, length_mm } = narrowest_tunnel(&ring).unwrap();
    assert!((Vector3::from(place_mm) - far).norm() < 0.1, "{place_mm:?}");
    assert!((length_mm / std::f64::consts::TAU - 1.0).abs() < 0.05);
}

#[test]
fn pieces_with_tunnels_are_closed_each() {
    let ring = torus(10.0, 2.0, 30, 12, FaceArity::Triangle);
    let n = ring.n_vertices() as u32;
    let far = ring.vertices().iter().map(|p| p + Vector3::new(50.0, 0.0, 0.0));
    let vertices = ring.vertices().iter().copied().chain(far).collect();
    let indices = ring.indices().iter().copied().chain(ring.indices().iter().map(|v| v + n)).collect();
    let two = SurfaceMesh::new(vertices, FaceArity::Triangle, indices).unwrap();
    assert_eq!(closed(&two).n_closed, 2);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]
    #[test]
    fn a_plate_with_any_holes_gets_none(
        columns in 3i32..12, rows in 3i32..12, holes in prop::collection::vec((1i32..11, 1i32..11), 1..10),
    ) {
        // Holes lie inside and touch each other nowhere, so each is a tunnel of its own.
        let mut kept: Vec<(i32, i32)> = Vec::new();
        for (x, y) in holes {
            let inside = x < columns - 1 && y < rows - 1;
            if inside && kept.iter().all(|(a, b)| (a - x).abs() > 1 || (b - y).abs() > 1) {
                kept.push((x, y));
            }
        }
        let mesh = plate(columns, rows, &kept);
        prop_assert_eq!(topology_report(&mesh).genus, Some(kept.len() as u32));
        if kept.is_empty() {
            prop_assert_eq!(close_tunnels(&mesh).unwrap(), None);
        } else {
            closed(&mesh);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]
    #[test]
    fn an_open_ring_gets_no_tunnel_wherever_it_is_open(
        tube in 1.0f64..5.0, places in prop::collection::vec((0.0f64..6.3, 0.0f64..6.3), 1..4), radius in 0.9f64..2.0,
    ) {
        let ring = torus(6.0, tube, 40, 24, FaceArity::Triangle);
        let at = |(around, across): &(f64, f64)| {
            let out = 6.0 + tube * across.cos();
            Point3::new(out * around.cos(), out * around.sin(), tube * across.sin())
        };
        let open = opened(&ring, &places.iter().map(at).collect::<Vec<_>>(), radius);
        // Openings that meet may leave several pieces or vertices at which parts only touch.
        let before = topology_report(&open);
        prop_assume!(before.n_nonmanifold_vertices == 0 && before.n_components == 1 && before.n_boundary_edges > 0);
        match count_tunnels(&open) {
            Some(0) => prop_assert_eq!(close_tunnels(&open).unwrap(), None),
            n => {
                prop_assert_eq!(n, Some(1));
                let closed = close_tunnels(&open).unwrap().unwrap().mesh;
                let after = topology_report(&closed);
                prop_assert_eq!((count_tunnels(&closed), after.n_nonmanifold_vertices, after.oriented), (Some(0), 0, true));
                prop_assert_eq!(boundaries(&closed), boundaries(&open));
            }
        }
    }
}
