//! The forms of what passes through jobs as JSON without being looked into: named here, in one place, so that the
//! API can describe them and read them again without knowing how a match is computed.

pub use crate::intake::InputReport;
pub use crate::matching::parameters::MatchParameters;
pub use crate::matching::result::{Correspondences, ResultDocument, TransformDocument};
pub use crate::mesh::topology::TopologyReport;
