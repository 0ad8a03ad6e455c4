//! The state of a study.

use serde::{Deserialize, Serialize};

/// The state of a study. Of the final ones, each is left when subjects are added or a decision changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, utoipa::ToSchema)]
#[serde(rename_all = "snake_case")]
pub enum StudyState {
    /// Its first matches are being planned.
    Queued,
    /// Its template is being made, or matched to its subjects.
    Matching,
    /// Its model, statistics and report are being computed.
    #[serde(rename = "modelling")]
    Modeling,
    /// It has a result.
    Finished,
    /// It ended without a result; `error` says why.
    Failed,
    /// Cancelled on request.
    Cancelled,
}

impl StudyState {
    /// All states.
    pub const ALL: [StudyState; 6] = [
        StudyState::Queued,
        StudyState::Matching,
        StudyState::Modeling,
        StudyState::Finished,
        StudyState::Failed,
        StudyState::Cancelled,
    ];

    /// The name used in JSON and in the database.
    pub fn name(self) -> &'static str {
        match self {
            StudyState::Queued => "queued",
            StudyState::Matching => "matching",
            StudyState::Modeling => "modelling",
            StudyState::Finished => "finished",
            StudyState::Failed => "failed",
            StudyState::Cancelled => "cancelled",
        }
    }

    /// The state of this name.
    pub fn from_name(name: &str) -> Option<StudyState> {
        StudyState::ALL.into_iter().find(|state| state.name() == name)
    }

    /// Whether nothing of the study is to be done.
    pub fn is_final(self) -> bool {
        matches!(self, StudyState::Finished | StudyState::Failed | StudyState::Cancelled)
    }
}
