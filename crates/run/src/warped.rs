//! One surface deformed onto the other: its vertices at their corresponding points, with measures of the deformation at
//! each vertex.

use homolog_contract::result::{Correspondences, OutlierReason, WarpDirection, WarpSpace};
use homolog_formats::transform::write_lta;
use homolog_formats::{FileContent, ReadLimits, VertexArray, VertexValues};
use homolog_mesh::{MeshError, SurfaceMesh, repair};
use nalgebra::{Matrix4, Point3, Vector3};

/// The transform as an LTA file of FreeSurfer, with the geometry of the inputs that are label volumes.
pub fn lta(target_from_source: &[[f64; 4]; 4], files: [&[u8]; 2]) -> String {
    let read = files.map(|bytes| homolog_formats::read(bytes, None, &ReadLimits::default()).ok());
    let volume = |side: usize| match read[side].as_ref().map(|file| &file.content) {
        Some(FileContent::Labels(volume)) => Some(volume),
        _ => None,
    };
    write_lta(target_from_source, [volume(0), volume(1)])
}

/// The name of the segment that holds a bent surface.
pub fn segment_label(direction: WarpDirection) -> &'static str {
    match direction {
        WarpDirection::Forward => "source deformed onto target",
        WarpDirection::Inverse => "target deformed onto source",
    }
}

/// A surface deformed onto the other.
#[derive(Debug, Clone, PartialEq)]
pub struct WarpedSurface {
    /// The faces and the numbering of the bent surface. If the transform mirrors, each face is reversed, so that all
    /// still look outwards. A vertex without a correspondence, which no face uses, is only moved rigidly.
    pub mesh: SurfaceMesh,
    /// One value for each vertex; see [`warp`].
    pub arrays: Vec<VertexArray>,
}

impl WarpedSurface {
    /// The bent surface without its deformation: only moved rigidly, in the same space.
    ///
    /// # Errors
    /// [`WarpError::Mesh`] if a coordinate overflows.
    pub fn without_deformation(&self) -> Result<SurfaceMesh, WarpError> {
        let mut vertices = self.mesh.vertices().to_vec();
        for (k, name) in ["displacement_x_mm", "displacement_y_mm", "displacement_z_mm"].into_iter().enumerate() {
            let array = self.arrays.iter().find(|array| array.name == name);
            if let Some(VertexArray { values: VertexValues::Real(values), .. }) = array {
                vertices.iter_mut().zip(values).for_each(|(vertex, value)| vertex[k] -= value);
            }
        }
        Ok(self.mesh.with_vertices(vertices)?)
    }
}

/// Reasons why a surface cannot be bent.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum WarpError {
    /// The match computed no map from the target to the source.
    #[error("the match has no inverse correspondences; match again with both_directions set to true")]
    NoInverse,
    /// The correspondences do not belong to these surfaces.
    #[error("the correspondences refer to vertices that the surfaces do not have")]
    OtherSurfaces,
    /// The transform has no inverse.
    #[error("the transform has no inverse")]
    Singular,
    /// A coordinate is not finite.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// Bends the source onto the target, or the target onto the source: each vertex moves to its corresponding point, which
/// lies on the other surface. `space` is the space of the result. If it is the other surface's own, the points lie on
/// the other surface; otherwise they lie on that surface moved rigidly.
///
/// The arrays: `image_x_mm`, `image_y_mm`, `image_z_mm` (position of the vertex after bending) and, with the rigid
/// transform removed from every displacement: `displacement_x_mm`, `displacement_y_mm`, `displacement_z_mm` (from the
/// rigidly moved vertex to its corresponding point, in `space`), `displacement_normal_mm` (its component along the
/// outward normal), `residual_mm` (its length), `area_ratio` (area around the vertex after bending over the area
/// before), `confidence`, `spread_mm`, and `outlier` (0 none, 1 residual, 2 neighborhood, 3 both, 4 no counterpart).
///
/// # Errors
/// [`WarpError`].
///
/// # Cost
/// Linear in the size of both surfaces.
pub fn warp(
    [source, target]: [&SurfaceMesh; 2],
    correspondences: &Correspondences,
    target_from_source: &[[f64; 4]; 4],
    direction: WarpDirection,
    space: WarpSpace,
) -> Result<WarpedSurface, WarpError> {
    let forward = Matrix4::from_fn(|r, c| target_from_source[r][c]);
    let backward = forward.try_inverse().ok_or(WarpError::Singular)?;
    let (moving, fixed, pairs, fixed_from_moving, moving_from_fixed) = match direction {
        WarpDirection::Forward => (source, target, correspondences, forward, backward),
        WarpDirection::Inverse => {
            let inverse = correspondences.inverse.as_deref().ok_or(WarpError::NoInverse)?;
            (target, source, inverse, backward, forward)
        }
    };
    // Transform from the space of the fixed surface, which contains the corresponding points, to the requested space.
    let is_own = (direction == WarpDirection::Forward) == (space == WarpSpace::Target);
    let to_space = if is_own { Matrix4::identity() } else { moving_from_fixed };
    let rigid: Vec<Point3<f64>> = moving.vertices().iter().map(|p| fixed_from_moving.transform_point(p)).collect();
    let mut bent = rigid.clone();
    let n = moving.n_vertices();
    let (mut confidence, mut spread_mm) = (vec![0.0; n], vec![0.0; n]);
    let mut outlier = vec![OutlierReason::NoCounterpart.code(); n];
    for (row, &vertex) in pairs.source.iter().enumerate() {
        let image = image(fixed, pairs, row).ok_or(WarpError::OtherSurfaces)?;
        let vertex = vertex as usize;
        *bent.get_mut(vertex).ok_or(WarpError::OtherSurfaces)? = image;
        confidence[vertex] = pairs.confidence.get(row).copied().unwrap_or(0.0);
        spread_mm[vertex] = pairs.spread_mm.get(row).copied().unwrap_or(0.0);
        outlier[vertex] = pairs.outlier.get(row).map_or(0, |reason| reason.code());
    }
    let displacements: Vec<Vector3<f64>> =
        bent.iter().zip(&rigid).map(|(image, rigid)| to_space.transform_vector(&(image - rigid))).collect();
    let rotated = to_space * fixed_from_moving;
    // Outward normals stay outward under a mirroring transform.
    let normals = moving.vertex_normals().into_iter().map(|normal| rotated.transform_vector(&normal));
    let along: Vec<f64> = displacements.iter().zip(normals).map(|(d, normal)| d.dot(&normal)).collect();
    let mesh = moving.with_vertices(bent.iter().map(|p| to_space.transform_point(p)).collect())?;
    // Mirrored faces look inwards.
    let mesh = if rotated.determinant() < 0.0 { repair::reversed(&mesh) } else { mesh };
    let area_ratio = ratios(&vertex_areas(&mesh), &vertex_areas(moving));
    let real = |name, values| VertexArray { name, values: VertexValues::Real(values) };
    let component = |k: usize| displacements.iter().map(|d| d[k]).collect();
    let image = |k: usize| mesh.vertices().iter().map(|p| p[k]).collect();
    let arrays = vec![
        real("image_x_mm", image(0)),
        real("image_y_mm", image(1)),
        real("image_z_mm", image(2)),
        real("displacement_x_mm", component(0)),
        real("displacement_y_mm", component(1)),
        real("displacement_z_mm", component(2)),
        real("displacement_normal_mm", along),
        real("residual_mm", displacements.iter().map(Vector3::norm).collect()),
        real("area_ratio", area_ratio),
        real("confidence", confidence),
        real("spread_mm", spread_mm),
        VertexArray { name: "outlier", values: VertexValues::Byte(outlier) },
    ];
    Ok(WarpedSurface { mesh, arrays })
}

/// The corresponding point of a row, on `fixed`.
fn image(fixed: &SurfaceMesh, pairs: &Correspondences, row: usize) -> Option<Point3<f64>> {
    let (triangle, weights) = (pairs.triangle.get(row)?, pairs.barycentric.get(row)?);
    let mut point = Vector3::zeros();
    for (&vertex, &weight) in triangle.iter().zip(weights) {
        point += fixed.vertices().get(vertex as usize)?.coords * weight;
    }
    Some(point.into())
}

/// A share of the area of its faces for every vertex, mm².
fn vertex_areas(mesh: &SurfaceMesh) -> Vec<f64> {
    let mut areas = vec![0.0; mesh.n_vertices()];
    for (face, area) in mesh.faces().zip(mesh.face_vector_areas()) {
        for &v in face {
            areas[v as usize] += area.norm() / face.len() as f64;
        }
    }
    areas
}

/// Quotients; 1 where the area before is zero.
fn ratios(after: &[f64], before: &[f64]) -> Vec<f64> {
    after.iter().zip(before).map(|(&after, &before)| if before > 0.0 { after / before } else { 1.0 }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::FaceArity;

    /// A tetrahedron; the same rotated by a quarter about z, moved by (10, 0, 0) and scaled by two about a vertex; and
    /// their correspondence, whose target vertices are in the opposite order.
    fn grown() -> ([SurfaceMesh; 2], Correspondences, [[f64; 4]; 4]) {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Point3::from);
        let faces = vec![0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
        let source = SurfaceMesh::new(corners.to_vec(), FaceArity::Triangle, faces.clone()).unwrap();
        let moved = corners.map(|p| Point3::new(10.0 - 2.0 * p.y, 2.0 * p.x, 2.0 * p.z));
        let faces = faces.iter().map(|v| 3 - v).collect();
        let target = SurfaceMesh::new(moved.into_iter().rev().collect(), FaceArity::Triangle, faces).unwrap();
        let one_way = Correspondences {
            source: vec![0, 1, 2, 3],
            target: vec![3, 2, 1, 0],
            confidence: vec![0.5; 4],
            spread_mm: vec![0.25; 4],
            inlier: vec![true; 4],
            outlier: vec![OutlierReason::None; 4],
            triangle: vec![[3, 1, 0], [2, 1, 0], [1, 2, 3], [0, 1, 2]],
            barycentric: vec![[1.0, 0.0, 0.0]; 4],
            inverse: None,
        };
        let both = Correspondences { inverse: Some(Box::new(one_way.clone())), ..one_way };
        let transform = [[0.0, -1.0, 0.0, 10.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
        ([source, target], both, transform)
    }

    fn real<'a>(warped: &'a WarpedSurface, name: &str) -> &'a [f64] {
        match &warped.arrays.iter().find(|array| array.name == name).unwrap().values {
            VertexValues::Real(values) => values,
            _ => panic!("{name} holds real numbers"),
        }
    }

    #[test]
    fn the_source_lies_on_the_target_and_keeps_its_faces() {
        let ([source, target], pairs, transform) = grown();
        let warped = |space| warp([&source, &target], &pairs, &transform, WarpDirection::Forward, space).unwrap();
        let there = warped(WarpSpace::Target);
        assert_eq!(there.mesh.indices(), source.indices());
        let expected: Vec<_> = target.vertices().iter().rev().copied().collect();
        assert_eq!(there.mesh.vertices(), expected);
        // Without the rigid part, the vertex on the x axis moves by one more along x, which the transform rotates to y.
        assert_eq!(
            [0, 1, 2].map(|k| real(&there, ["displacement_x_mm", "displacement_y_mm", "displacement_z_mm"][k])[1]),
            [0.0, 1.0, 0.0]
        );
        assert_eq!(real(&there, "residual_mm"), [0.0, 1.0, 1.0, 1.0]);
        let rigid = there.without_deformation().unwrap();
        assert!((rigid.vertices()[1] - Point3::new(10.0, 1.0, 0.0)).norm() < 1e-12);
        assert!(real(&there, "area_ratio").iter().all(|ratio| (ratio - 4.0).abs() < 1e-12));
        let here = warped(WarpSpace::Source);
        assert!((here.mesh.vertices()[1] - Point3::new(2.0, 0.0, 0.0)).norm() < 1e-12);
        assert!((real(&here, "displacement_x_mm")[1] - 1.0).abs() < 1e-12);
        for (a, b) in real(&here, "displacement_normal_mm").iter().zip(real(&there, "displacement_normal_mm")) {
            assert!((a - b).abs() < 1e-12 && *a >= 0.0, "{a} {b}");
        }
    }

    #[test]
    fn the_inverse_lies_on_the_source() {
        let ([source, target], pairs, transform) = grown();
        let inverse = |pairs| warp([&source, &target], pairs, &transform, WarpDirection::Inverse, WarpSpace::Source);
        let warped = inverse(&pairs).unwrap();
        assert_eq!(warped.mesh.indices(), target.indices());
        let expected: Vec<_> = source.vertices().iter().rev().copied().collect();
        assert_eq!(warped.mesh.vertices(), expected);
        assert_eq!(inverse(&Correspondences { inverse: None, ..pairs.clone() }), Err(WarpError::NoInverse));
    }

    #[test]
    fn correspondences_of_other_surfaces_are_refused() {
        let ([source, target], mut pairs, transform) = grown();
        pairs.triangle[2] = [0, 1, 4];
        let warped = warp([&source, &target], &pairs, &transform, WarpDirection::Forward, WarpSpace::Target);
        assert_eq!(warped, Err(WarpError::OtherSurfaces));
    }
}
