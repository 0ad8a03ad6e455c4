//! The parts that operations have in common, and the resources that they are about.

use super::problem_table::ProblemKind;

/// A part of an operation that others have too.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// A query that is checked.
    Query,
    /// A page of a list of these.
    Pages(&'static str),
    /// `?wait=` and a weak ETag.
    Watch,
    /// A long poll, whose number is limited.
    Polls,
    /// A stream of events, which can be read with a ticket.
    Follow,
    /// Content that is read with a ticket or a key, and recorded in the audit log.
    Download,
    /// A strong ETag.
    Etag,
    /// A part of a result, which is there after the end and until it is deleted.
    OfResult,
    /// A choice of formats, each with an ETag.
    Formats,
    /// A surface, in the formats of surfaces.
    Surface,
    /// UIDs for DICOM objects.
    Uids,
    /// A small JSON body.
    Json,
    /// A body with files, which may take long to arrive.
    Files,
    /// A form, or JSON that refers to files.
    Form,
    /// An `Idempotency-Key`.
    Idempotent,
    /// 202 with the place of the resource.
    Accepted,
    /// A job, which a full queue does not take.
    Queue,
    /// A body that may be too slow.
    Slow,
    /// A body for which there may be no slot.
    Busy,
    /// A body for which there may be no space.
    Full,
    /// A problem of its own: its status, and when it is answered.
    Says(u16, &'static str),
}

/// The resource that an operation is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Resource {
    Job,
    Batch,
    Study,
    Mesh,
    Webhook,
    Key,
    Method,
    ProblemType,
}

impl Resource {
    /// What it is called, and what names it in a path: the name of the parameter and its description.
    pub(super) fn words(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Resource::Job => ("job", "id", "The job"),
            Resource::Batch => ("batch", "id", "The batch"),
            Resource::Study => ("study", "id", "The study"),
            Resource::Mesh => ("mesh", "id", "`blake3:` and 64 hexadecimal digits"),
            Resource::Webhook => ("webhook", "id", "The webhook"),
            Resource::Key => ("key", "id", "The public part of the key"),
            Resource::Method => ("method", "name", "The method"),
            Resource::ProblemType => ("problem type", "slug", "The last part of a problem's `type`"),
        }
    }

    /// The problem if there is none.
    pub(super) fn not_found(self) -> ProblemKind {
        match self {
            Resource::Job => ProblemKind::JobNotFound,
            Resource::Batch => ProblemKind::BatchNotFound,
            Resource::Study => ProblemKind::StudyNotFound,
            Resource::Mesh => ProblemKind::MeshNotFound,
            Resource::Webhook => ProblemKind::WebhookNotFound,
            Resource::Key => ProblemKind::KeyNotFound,
            Resource::Method => ProblemKind::MethodNotFound,
            Resource::ProblemType => ProblemKind::ProblemNotFound,
        }
    }
}
