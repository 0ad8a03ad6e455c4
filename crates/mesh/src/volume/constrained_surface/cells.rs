//! The volume that a surface encloses in each cube of the lattice, compared with the volume of the voxels there.

use super::super::cubes::{Cell, Contour, FACES, edge_between};
use nalgebra::Vector3;

/// For each cell of `contour` the volume of its eighths of voxels minus the volume that the surface encloses in it, in
/// voxels.
///
/// The sum over all cells is the number of voxels minus the enclosed volume: a cube without a crossing lies entirely
/// inside or outside.
///
/// # Cost
/// `O(cells)`.
pub(super) fn deficits(contour: &Contour) -> Vec<f64> {
    contour.cells.iter().map(|cell| f64::from(cell.pattern.count_ones()) / 8.0 - enclosed(contour, cell)).collect()
}

/// The enclosed volume of a cell by the divergence theorem about its lowest corner: three faces of the cube contain
/// that corner, the others lie at distance 1.
fn enclosed(contour: &Contour, cell: &Cell) -> f64 {
    let corner = Vector3::from(cell.place.map(|c| c as f64));
    let caps: f64 = [1, 3, 5].iter().map(|&face| cap_area(contour, cell, FACES[face])).sum();
    let triangles: f64 = contour.triangles[cell.triangles.clone()]
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|v| contour.voxels[v as usize] - corner);
            a.dot(&b.cross(&c))
        })
        .sum();
    caps / 3.0 + triangles / 6.0
}

/// Area of the inner part of a face of a cell. Inner corners at opposite ends are kept apart.
fn cap_area(contour: &Contour, cell: &Cell, face: [usize; 4]) -> f64 {
    let inside = face.map(|corner| cell.pattern >> corner & 1 == 1);
    // Distance of the crossing from the first corner of each side.
    let along = |k: usize| {
        let (from, to) = (face[k], face[(k + 1) % 4]);
        let axis = (from ^ to).trailing_zeros() as usize;
        let vertex = contour.voxels[cell.edges[edge_between(from, to)] as usize];
        let share = vertex[axis] - cell.place[axis] as f64;
        if from >> axis & 1 == 0 { share } else { 1.0 - share }
    };
    match inside {
        [false, false, false, false] => return 0.0,
        [true, true, true, true] => return 1.0,
        [true, false, true, false] => return 0.5 * (along(0) * (1.0 - along(3)) + along(2) * (1.0 - along(1))),
        [false, true, false, true] => return 0.5 * (along(1) * (1.0 - along(0)) + along(3) * (1.0 - along(2))),
        _ => {}
    }
    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let (mut outline, mut n) = ([[0.0; 2]; 6], 0);
    let mut push = |point: [f64; 2]| {
        outline[n] = point;
        n += 1;
    };
    for k in 0..4 {
        let next = (k + 1) % 4;
        if inside[k] {
            push(SQUARE[k]);
        }
        if inside[k] != inside[next] {
            let share = along(k);
            push([0, 1].map(|a| SQUARE[k][a] + share * (SQUARE[next][a] - SQUARE[k][a])));
        }
    }
    (0..n).map(|k| outline[k][0] * outline[(k + 1) % n][1] - outline[(k + 1) % n][0] * outline[k][1]).sum::<f64>() / 2.0
}
