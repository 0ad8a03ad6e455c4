//! Compares two statements of one file about the position of its voxels: side, scale, direction and place.

use nalgebra::{Matrix4, Vector3};

/// Relative difference of lengths above which two affines disagree: more than the rounding of single precision and
/// header digits.
const SCALE_RTOL: f64 = 0.01;
/// Difference of places, in voxels, and of directions, in the sine of the angle, above which two affines disagree.
const PLACE_TOLERANCE: f64 = 0.1;

/// Disagreement between two affines of a file.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Disagreement {
    /// A sentence on the disagreement.
    pub(super) note: String,
    /// Whether their handedness differs: one affine's left is the other's right.
    pub(super) sides: bool,
}

/// Compares the chosen affine with the other one, for a volume of this size; `None` if they agree.
pub(super) fn compare(
    taken: &Matrix4<f64>,
    other: &Matrix4<f64>,
    dims: [usize; 3],
    [name, other_name]: [&str; 2],
) -> Option<Disagreement> {
    let [a, b] = [taken, other].map(|m| m.fixed_view::<3, 3>(0, 0).into_owned());
    let (lengths, others) = (sizes(taken), sizes(other));
    if lengths.iter().chain(others.iter()).any(|&length| !length.is_finite() || length <= 0.0) {
        return None;
    }
    let mut found = Vec::new();
    let sides = a.determinant() * b.determinant() < 0.0;
    if sides {
        found.push("in side: what is left by one is right by the other".to_owned());
    }
    found.extend(scales(lengths, others));
    // The largest angle between the directions, without side and scale.
    let angle = (0..3)
        .map(|k| (a.column(k).dot(&b.column(k)) / (lengths[k] * others[k])).abs().clamp(0.0, 1.0).acos())
        .fold(0.0, f64::max);
    if angle.sin() > PLACE_TOLERANCE {
        found.push(format!("in direction, by up to {:.1} degrees", angle.to_degrees()));
    }
    let turned = (0..3).filter(|&k| a.column(k).dot(&b.column(k)) < 0.0).count();
    if !sides && turned > 0 {
        found.push("in the sense of two axes".to_owned());
    }
    let middle = Vector3::from_fn(|k, _| (dims[k] as f64 - 1.0) / 2.0).push(1.0);
    let shift = (taken * middle - other * middle).norm();
    if shift > PLACE_TOLERANCE * lengths.min() {
        found.push(format!("in place, by {shift:.2} mm in the middle of the volume"));
    }
    disagreement(found, sides, name, other_name)
}

/// Compares the chosen affine with the voxel sizes stated by the file.
pub(super) fn compare_sizes(
    taken: &Matrix4<f64>,
    stated: Vector3<f64>,
    [name, other_name]: [&str; 2],
) -> Option<Disagreement> {
    // Sizes of 0 count as not stated.
    let is_stated = stated.iter().all(|&size| size.is_finite() && size > 0.0);
    let found = if is_stated { scales(sizes(taken), stated) } else { None };
    disagreement(found.into_iter().collect(), false, name, other_name)
}

fn disagreement(found: Vec<String>, sides: bool, name: &str, other_name: &str) -> Option<Disagreement> {
    let note = format!(
        "the file states two orientations that disagree; the {name} was taken, and the {other_name} differs {}",
        found.join("; ")
    );
    (!found.is_empty()).then_some(Disagreement { note, sides })
}

/// The lengths of the sides of a voxel.
fn sizes(affine: &Matrix4<f64>) -> Vector3<f64> {
    Vector3::from_fn(|k, _| affine.fixed_view::<3, 1>(0, k).norm())
}

fn scales(taken: Vector3<f64>, other: Vector3<f64>) -> Option<String> {
    let differs = (0..3).any(|k| (taken[k] / other[k] - 1.0).abs() > SCALE_RTOL);
    let show = |v: Vector3<f64>| format!("{:.4} × {:.4} × {:.4} mm", v.x, v.y, v.z);
    differs.then(|| format!("in scale: voxels of {} and of {}", show(taken), show(other)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Rotation3, Vector4};
    use proptest::prelude::*;

    fn affine(angles: [f64; 3], sizes: [f64; 3], place: [f64; 3]) -> Matrix4<f64> {
        let turned = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]).to_homogeneous();
        let mut affine = turned * Matrix4::from_diagonal(&Vector4::new(sizes[0], sizes[1], sizes[2], 1.0));
        affine.set_column(3, &Vector4::new(place[0], place[1], place[2], 1.0));
        affine
    }

    proptest! {
        #[test]
        fn any_affine_agrees_with_its_rounded_copy_and_with_nothing_else(
            angles in prop::array::uniform3(-3.0..3.0f64),
            sizes in prop::array::uniform3(0.2..5.0f64),
            place in prop::array::uniform3(-200.0..200.0f64),
            axis in 0..3usize,
            factor in 1.02..30.0f64,
            shift in 0.2..50.0f64,
        ) {
            let dims = [40, 50, 60];
            let names = ["sform", "qform"];
            let taken = affine(angles, sizes, place);
            prop_assert_eq!(compare(&taken, &taken.map(|v| f64::from(v as f32)), dims, names), None);
            // Mirrored about the middle of the volume, as if an axis were stored in reverse.
            let mut mirrored = taken;
            let column = -taken.column(axis).into_owned();
            mirrored.set_column(axis, &column);
            mirrored.set_column(3, &(taken.column(3) - column * (dims[axis] as f64 - 1.0)));
            let found = compare(&taken, &mirrored, dims, names).unwrap();
            prop_assert!(found.sides && found.note.contains("left"));
            let mut scaled = taken;
            scaled.set_column(axis, &(taken.column(axis) * factor));
            let found = compare(&taken, &scaled, dims, names).unwrap();
            prop_assert!(!found.sides && found.note.contains("scale"), "{}", found.note);
            prop_assert!(compare_sizes(&taken, super::sizes(&scaled), names).unwrap().note.contains("scale"));
            prop_assert_eq!(compare_sizes(&taken, super::sizes(&taken), names), None);
            let mut shifted = taken;
            shifted[(axis, 3)] += shift * sizes.iter().copied().fold(0.0, f64::max);
            let found = compare(&taken, &shifted, dims, names).unwrap();
            prop_assert!(!found.sides && found.note.contains("place"), "{}", found.note);
        }
    }
}
