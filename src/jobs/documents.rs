//! The forms of what passes through jobs as JSON without being looked into: named here, in one place, so that the
//! API can describe them and read them again without knowing how a match is computed.

pub use homolog_contract::input::{BodySide, InputReport};
pub use homolog_contract::parameters::{LabelChoice, MatchParameters, PartialParameters, parameter_schemas};
pub use homolog_contract::result::{
    Correspondences, ResultDocument, SurfaceDistanceDocument, TransformDocument, UnreliableReason,
};
pub use homolog_contract::verdict::Verdict;
pub use homolog_mesh::topology::TopologyReport;
