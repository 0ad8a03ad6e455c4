//! One orientation for all faces of a surface.

use super::elements::EdgeUses;
use super::{SurfaceMesh, repair};

/// Reverses faces of `mesh` until neighboring faces agree across every edge with two faces. Also returns the number of
/// reversed faces: in each part connected by such edges, the smaller of the two possible numbers. `None` where no
/// choice agrees everywhere, as on a Möbius strip.
///
/// Cost `O(faces log faces)`.
pub fn oriented(mesh: &SurfaceMesh) -> Option<(SurfaceMesh, usize)> {
    let n_corners = mesh.arity().n_corners() as u32;
    let edges = EdgeUses::new(mesh);
    // The neighbors of every face, and whether one of the two has to be reversed.
    let mut neighbors: Vec<Vec<(u32, bool)>> = vec![Vec::new(); mesh.n_faces()];
    for uses in edges.groups() {
        if let [a, b] = uses {
            let (f, g) = (a.corner_low / n_corners, b.corner_low / n_corners);
            let disagree = a.ascending == b.ascending;
            neighbors[f as usize].push((g, disagree));
            neighbors[g as usize].push((f, disagree));
        }
    }
    let mut reverse: Vec<Option<bool>> = vec![None; mesh.n_faces()];
    let mut part: Vec<u32> = Vec::new();
    let mut n_reversed = 0;
    for first in 0..mesh.n_faces() as u32 {
        if reverse[first as usize].is_some() {
            continue;
        }
        part.clear();
        part.push(first);
        reverse[first as usize] = Some(false);
        let mut next = 0;
        while let Some(&f) = part.get(next) {
            next += 1;
            let own = reverse[f as usize] == Some(true);
            for &(g, disagree) in &neighbors[f as usize] {
                match reverse[g as usize] {
                    None => {
                        reverse[g as usize] = Some(own != disagree);
                        part.push(g);
                    }
                    Some(other) if other != (own != disagree) => return None,
                    Some(_) => {}
                }
            }
        }
        let n = part.iter().filter(|&&f| reverse[f as usize] == Some(true)).count();
        let swap = 2 * n > part.len();
        if swap {
            part.iter().for_each(|&f| reverse[f as usize] = reverse[f as usize].map(|r| !r));
        }
        n_reversed += if swap { part.len() - n } else { n };
    }
    Some((repair::reversed_where(mesh, |f| reverse[f] == Some(true)), n_reversed))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::topology_report;
    use crate::{FaceArity, shapes};
    use nalgebra::Point3;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn reversed_faces_are_found(chosen in proptest::collection::btree_set(0usize..100, 0..40)) {
            let mesh = shapes::torus(5.0, 2.0, 10, 10, FaceArity::Quad);
            let mixed = repair::reversed_where(&mesh, |f| chosen.contains(&f));
            let (mended, n) = oriented(&mixed).unwrap();
            prop_assert_eq!(n, chosen.len());
            prop_assert_eq!(mended, mesh);
        }
    }

    #[test]
    fn a_moebius_strip_has_no_orientation() {
        let n = 12u32;
        let vertices: Vec<Point3<f64>> = (0..2 * n)
            .map(|k| {
                let around = std::f64::consts::TAU * f64::from(k / 2) / f64::from(n);
                let across = if k.is_multiple_of(2) { -1.0 } else { 1.0 };
                let (radius, height) = (5.0 + across * (around / 2.0).cos(), across * (around / 2.0).sin());
                Point3::new(radius * around.cos(), radius * around.sin(), height)
            })
            .collect();
        let quads = |i: u32| {
            let (a, b) = (2 * i, 2 * ((i + 1) % n));
            let (c, d) = if i + 1 == n { (b + 1, b) } else { (b, b + 1) };
            [a, c, d, a + 1]
        };
        let mesh = SurfaceMesh::new(vertices, FaceArity::Quad, (0..n).flat_map(quads).collect()).unwrap();
        assert_eq!(oriented(&mesh), None);
        assert!(!topology_report(&mesh).oriented);
    }
}
