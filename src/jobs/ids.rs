//! Identities of jobs, batches and studies, and the names of the methods that only jobs of a study have.

/// An identity: a UUIDv7.
macro_rules! identity {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(uuid::Uuid);

        impl $name {
            /// A new id.
            pub fn new() -> Self {
                $name(uuid::Uuid::now_v7())
            }

            /// The id written in `text`, in the usual hyphenated form.
            pub fn parse(text: &str) -> Option<Self> {
                if text.len() != 36 {
                    return None;
                }
                uuid::Uuid::try_parse(text).ok().map($name)
            }
        }

        impl Default for $name {
            fn default() -> Self {
                $name::new()
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.0.as_hyphenated().fmt(f)
            }
        }
    };
}

identity! {
    /// Identity of a job: a UUIDv7, so that ids sort by creation time.
    JobId
}

identity! {
    /// Identity of a batch: a UUIDv7.
    BatchId
}

identity! {
    /// Identity of a study: a UUIDv7.
    StudyId
}

impl JobId {
    /// The id itself.
    pub(crate) fn uuid(self) -> uuid::Uuid {
        self.0
    }
}

/// The method of the hidden jobs that plan and model.
pub(crate) const STEP_METHOD: &str = "study";

/// The method of the jobs that score a new subject against a study.
pub(crate) const SCORE_METHOD: &str = "study_score";
