//! Identities of jobs, batches and studies, and the names of the methods that only jobs of a study have.

/// Identity of a job: a UUIDv7, so that ids sort by creation time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JobId(uuid::Uuid);

impl JobId {
    /// A new id.
    pub fn new() -> Self {
        JobId(uuid::Uuid::now_v7())
    }

    /// The id written in `text`, in the usual hyphenated form.
    pub fn parse(text: &str) -> Option<Self> {
        if text.len() != 36 {
            return None;
        }
        uuid::Uuid::try_parse(text).ok().map(JobId)
    }

    /// The id itself.
    pub(crate) fn uuid(self) -> uuid::Uuid {
        self.0
    }
}

impl Default for JobId {
    fn default() -> Self {
        JobId::new()
    }
}

impl std::fmt::Display for JobId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.as_hyphenated().fmt(f)
    }
}

/// Identity of a batch: a UUIDv7.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BatchId(uuid::Uuid);

impl BatchId {
    /// A new id.
    pub fn random() -> Self {
        BatchId(uuid::Uuid::now_v7())
    }

    /// The id written in `text`, in the usual hyphenated form.
    pub fn parse(text: &str) -> Option<Self> {
        if text.len() != 36 {
            return None;
        }
        uuid::Uuid::try_parse(text).ok().map(BatchId)
    }
}

impl std::fmt::Display for BatchId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.as_hyphenated().fmt(f)
    }
}

/// Identity of a study: a UUIDv7.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StudyId(uuid::Uuid);

impl StudyId {
    /// A new id.
    pub fn random() -> Self {
        StudyId(uuid::Uuid::now_v7())
    }

    /// The id written in `text`, in the usual hyphenated form.
    pub fn parse(text: &str) -> Option<Self> {
        if text.len() != 36 {
            return None;
        }
        uuid::Uuid::try_parse(text).ok().map(StudyId)
    }
}

impl std::fmt::Display for StudyId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self.0.as_hyphenated(), f)
    }
}

/// The method of the hidden jobs that plan and model.
pub(crate) const STEP_METHOD: &str = "study";

/// The method of the jobs that score a new subject against a study.
pub(crate) const SCORE_METHOD: &str = "study_score";
