//! Detects surfaces that seem to be in different units of length.

use homolog_contract::input::InputWarning;
use homolog_contract::result::UnreliableReason;
use homolog_mesh::SurfaceMesh;

/// Ratios of units in which surfaces are exported, with their names, the larger first.
const RATIOS: [(f64, &str); 5] = [
    (10.0, "millimeters and centimeters"),
    (25.4, "millimeters and inches"),
    (100.0, "centimeters and meters"),
    (1000.0, "millimeters and meters, or micrometers and millimeters"),
    (1e6, "micrometers and meters"),
];
/// Largest ratio of sizes that occurs within one unit, as between one structure in two subjects, or a half and a whole:
/// a factor of two in area.
const NEAR: f64 = 1.4;

/// A warning if the ratio of the sizes of two surfaces (square roots of their areas) is near the ratio of two units.
pub(crate) fn scale_warning(source: &SurfaceMesh, target: &SurfaceMesh) -> Option<InputWarning> {
    let ratio = (target.area() / source.area()).sqrt();
    let factor = ratio.max(1.0 / ratio);
    let (unit, names) = RATIOS.into_iter().find(|(unit, _)| (unit / NEAR..=unit * NEAR).contains(&factor))?;
    let larger = if ratio > 1.0 { "target" } else { "source" };
    Some(InputWarning {
        reason: Some(UnreliableReason::UnitsDiffer),
        detail: format!(
            "the {larger} is {factor:.4} times as large as the other surface, near {unit}: one of them may be in {names}"
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn only_ratios_of_units_are_warned_of(size in 0.8..1.25f64, unit in 0..7usize, swapped: bool) {
            let factor = [1.0, 3.0, 10.0, 25.4, 100.0, 1000.0, 1e6][unit];
            let one = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2);
            let other = ellipsoid(Vector3::new(9.0, 5.0, 3.0) * factor * size, 2);
            let [source, target] = if swapped { [&other, &one] } else { [&one, &other] };
            let found = scale_warning(source, target);
            prop_assert_eq!(found.is_some(), factor >= 10.0, "{:?}", found);
            if let Some(InputWarning { reason, detail }) = found {
                prop_assert_eq!(reason, Some(UnreliableReason::UnitsDiffer));
                prop_assert!(detail.contains(&format!("near {factor}")), "{}", detail);
            }
        }
    }
}
