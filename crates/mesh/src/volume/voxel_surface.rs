//! The boundary faces of a voxel set, as quads.

use super::VoxelMask;
use crate::{FaceArity, MeshError, SurfaceMesh};

/// The faces between `mask` and its complement, in world mm, facing outwards. The four corners of a face lie half a
/// voxel from the center of its voxel. Faces share a vertex wherever they share a lattice corner, so voxels that touch
/// along an edge or at a corner only make a non-manifold edge or vertex (none after [`super::fill`] with
/// [`super::Contacts::Resolve`]).
///
/// # Errors
/// [`MeshError::Empty`] for an empty mask.
///
/// # Cost
/// `O(voxels)`.
pub fn voxel_surface(mask: &VoxelMask) -> Result<SurfaceMesh, MeshError> {
    let [nx, ny, nz] = mask.dims();
    let strides = mask.strides();
    let corner_strides = [1, nx + 1, (nx + 1) * (ny + 1)];
    let mut number = vec![u32::MAX; (nx + 1) * (ny + 1) * (nz + 1)];
    let mut vertices = Vec::new();
    let mut indices = Vec::new();
    let mirrors = mask.mirrors();
    for (at, _) in mask.voxels().iter().enumerate().filter(|&(_, &v)| v) {
        let place = mask.place(at);
        for side in 0..6 {
            let (axis, high) = (side / 2, side % 2 == 1);
            let next = if high { at + strides[axis] } else { at - strides[axis] };
            if mask.voxels()[next] {
                continue;
            }
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut base = place;
            base[axis] += usize::from(high);
            // Counter-clockwise seen from the high side.
            let mut ring = [(0, 0), (1, 0), (1, 1), (0, 1)];
            if high == mirrors {
                ring.reverse();
            }
            for (du, dv) in ring {
                let mut corner = base;
                corner[u] += du;
                corner[v] += dv;
                let slot = (0..3).map(|k| corner[k] * corner_strides[k]).sum::<usize>();
                if number[slot] == u32::MAX {
                    number[slot] = vertices.len() as u32;
                    vertices.push(mask.world(corner.map(|c| c as f64 - 0.5)));
                }
                indices.push(number[slot]);
            }
        }
    }
    SurfaceMesh::new(vertices, FaceArity::Quad, indices)
}
