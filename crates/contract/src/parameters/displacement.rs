//! Parameters of the smooth displacement field.

/// The smooth displacement field that is fitted after the rigid transform.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct DisplacementParameters {
    /// Whether and how the source is deformed before corresponding points are determined.
    pub mode: DisplacementMode,
    /// Starts for surfaces that are bent, folded or articulated against each other.
    pub bending: Bending,
    /// Which rigid poses fits begin from.
    pub starts: FieldStarts,
    /// Basis of confidences and spreads.
    pub uncertainty: Uncertainty,
}

/// Which rigid poses the fit of a displacement field begins from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum FieldStarts {
    /// Those that RANSAC finds among the pairs that belief propagation assigns; a search of all orientations where these leave a doubt.
    #[cfg_attr(feature = "serde", serde(rename = "inference", alias = "labels"))]
    Inference,
    /// Those of a search of all orientations, for comparison.
    Search,
    /// That of `registration.initial` alone, which is then not `search`: the answer keeps this pose, and no other is compared with it.
    Initial,
}

/// Basis of the confidences and spreads of a displacement field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Uncertainty {
    /// The posterior of the field under what the two surfaces determine.
    Posterior,
    /// The distance that is left along the normals alone, for comparison: it does not know how far an image may have slid.
    Residual,
}

/// How a surface that no rigid motion brings close to the other is matched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Bending {
    /// Not at all: all starts are rigid.
    None,
    /// Tubular surfaces, longer than six of their radii, straightened along their center lines. Tried where rigid starts disagree, and
    /// where surfaces of one shape are bent against each other; kept where they then fit better.
    Straightened,
    /// The same, and any surface by the correspondence that keeps distances along the surfaces best: the assignment of lowest energy
    /// of a Markov random field without a pose, by belief propagation from bending-invariant forms and from extremities. Tried only where rigid starts disagree, and
    /// between closed surfaces with four limbs or more; kept where they then fit better.
    NearIsometry,
}

/// Whether the source is deformed before corresponding points are determined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum DisplacementMode {
    /// No deformation: correspondences are the target vertices of the minimizer, or the nearest vertices where there is none or it
    /// worked on a coarse level. A match fails if no rigid transform is supported by three of them.
    None,
    /// A smooth field deforms the source, starting from the rigid transform, from the landmarks and from a search of all
    /// orientations, whichever fits best after the deformation. Each vertex then corresponds to the closest point of the
    /// target.
    Smooth,
    /// Coherent point drift (Myronenko, Song 2010), non-rigid, from the rigid transform.
    Cpd,
    /// Bayesian coherent point drift (Hirose 2021), from the rigid transform.
    Bcpd,
    /// Optimal-step non-rigid ICP with locally affine maps (Amberg et al. 2007), from the rigid transform.
    NonrigidIcp,
    /// SPHARM-PDM: points of equal parameter on the sphere correspond (Brechbühler 1995, Styner 2006). Both surfaces have to be
    /// closed and of genus 0.
    SpharmPdm,
    /// Functional maps between eigenfunctions of the Laplace-Beltrami operators, refined by ZoomOut (Melzi et al. 2019), from the
    /// nearest points after the rigid transform or from heat and wave kernel signatures.
    FunctionalMap,
    /// Points of equal medial coordinates correspond: position along the center line of a tubular structure, and in the cross
    /// section there. The rigid transform says which ends correspond.
    Medial,
    /// The flow of a stationary velocity field, without folds and invertible, with the varifold distance, from the rigid
    /// transform.
    Diffeomorphic,
}
