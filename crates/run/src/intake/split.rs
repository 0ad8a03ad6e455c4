//! Splits a surface where it is not a manifold: parts that share an edge with further faces, or only one vertex, get
//! separate vertices. Nothing moves.

use homolog_mesh::{MeshError, SurfaceMesh};

/// A split surface.
pub(super) struct Split {
    /// The surface: the original vertices, then the copies.
    pub(super) mesh: SurfaceMesh,
    /// For each copy, the copied vertex.
    pub(super) copies: Vec<u32>,
    /// Number of edges that had more than two faces.
    pub(super) n_edges: usize,
}

/// `mesh` with a separate vertex for each fan of faces. Two faces belong to one fan of a vertex if they share an edge
/// at it that has no further face. `None` if every vertex already has a single fan.
///
/// # Errors
/// None for a valid mesh.
///
/// # Cost
/// `O(faces log faces)`.
pub(super) fn split(mesh: &SurfaceMesh) -> Result<Option<Split>, MeshError> {
    let n_corners = mesh.arity().n_corners();
    // Edge, and the positions among the corners of its two ends in one face.
    let mut uses: Vec<([u32; 2], [u32; 2])> = Vec::with_capacity(mesh.indices().len());
    for (f, face) in mesh.faces().enumerate() {
        for k in 0..n_corners {
            let next = (k + 1) % n_corners;
            let (here, there) = ((f * n_corners + k) as u32, (f * n_corners + next) as u32);
            let ascending = face[k] < face[next];
            let edge = if ascending { [face[k], face[next]] } else { [face[next], face[k]] };
            uses.push((edge, if ascending { [here, there] } else { [there, here] }));
        }
    }
    uses.sort_unstable();
    let mut fan: Vec<u32> = (0..mesh.indices().len() as u32).collect();
    let mut n_edges = 0;
    for group in uses.chunk_by(|a, b| a.0 == b.0) {
        match group {
            [(_, one), (_, other)] => {
                for (&a, &b) in one.iter().zip(other) {
                    let (a, b) = (root(&mut fan, a), root(&mut fan, b));
                    fan[a.max(b) as usize] = a.min(b);
                }
            }
            [_] => {}
            _ => n_edges += 1,
        }
    }
    let n_vertices = mesh.n_vertices() as u32;
    // The first fan of a vertex keeps the vertex.
    let mut first_fan = vec![u32::MAX; mesh.n_vertices()];
    let mut copy_of_fan = vec![u32::MAX; mesh.indices().len()];
    let mut copies = Vec::new();
    let mut indices = mesh.indices().to_vec();
    for (corner, vertex) in indices.iter_mut().enumerate() {
        let fan = root(&mut fan, corner as u32);
        let first = &mut first_fan[*vertex as usize];
        if *first == u32::MAX {
            *first = fan;
        }
        if *first != fan {
            let copy = &mut copy_of_fan[fan as usize];
            if *copy == u32::MAX {
                *copy = n_vertices + copies.len() as u32;
                copies.push(*vertex);
            }
            *vertex = *copy;
        }
    }
    if copies.is_empty() {
        return Ok(None);
    }
    let copied = copies.iter().map(|&v| mesh.vertices()[v as usize]);
    let vertices = mesh.vertices().iter().copied().chain(copied).collect();
    Ok(Some(Split { mesh: SurfaceMesh::new(vertices, mesh.arity(), indices)?, copies, n_edges }))
}

/// The lowest member of a set, with path halving.
fn root(sets: &mut [u32], mut k: u32) -> u32 {
    while sets[k as usize] != k {
        sets[k as usize] = sets[sets[k as usize] as usize];
        k = sets[k as usize];
    }
    k
}
