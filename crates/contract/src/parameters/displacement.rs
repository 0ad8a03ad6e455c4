//! Parameters of the smooth displacement field.

/// The smooth displacement field after the rigid rounds.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct DisplacementParameters {
    /// Whether there is one.
    pub mode: DisplacementMode,
    /// What is known of the structure beside its surface.
    #[cfg_attr(feature = "serde", serde(default = "unknown"))]
    pub anatomy: Anatomy,
}

/// Jobs that were stored before this was a parameter knew nothing.
fn unknown() -> Anatomy {
    Anatomy::Any
}

/// What is known of a structure, so that what a surface alone leaves open is answered from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Anatomy {
    /// Nothing.
    Any,
    /// Where hippocampi part into anterior and posterior, learned from labelled ones. Pairs of two subjects slide along the
    /// long axis by at most 3 mm, so that these borders meet; surfaces that look otherwise are left alone.
    Hippocampus,
}

/// Whether the source bends before its vertices are answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum DisplacementMode {
    /// It stays rigid: the labeling is the minimiser's.
    None,
    /// A smooth field moves it, from the pose found and from those on the principal axes, whichever fits best after the
    /// bending; each vertex is answered with the nearest target vertex then.
    Smooth,
}
