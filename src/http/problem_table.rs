//! Every problem the service answers: one row each. `api/problems.md` is made from this table.

use axum::http::StatusCode;

/// A row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ProblemEntry {
    /// Stable name; the problem's `type` is `/problems/<slug>`.
    pub slug: &'static str,
    /// HTTP status.
    pub status: StatusCode,
    /// The same for every occurrence.
    pub title: &'static str,
    /// What the client can do.
    pub advice: &'static str,
}

macro_rules! problems {
    ($($kind:ident = $slug:literal, $status:ident, $title:literal, $advice:literal;)*) => {
        /// Kinds of problems.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum ProblemKind {
            $(#[doc = $title] $kind,)*
        }

        impl ProblemKind {
            /// All kinds, in the order of the table.
            pub const ALL: &[ProblemKind] = &[$(ProblemKind::$kind,)*];

            /// The kind's row.
            pub fn entry(self) -> ProblemEntry {
                match self {
                    $(ProblemKind::$kind => ProblemEntry {
                        slug: $slug,
                        status: StatusCode::$status,
                        title: $title,
                        advice: $advice,
                    },)*
                }
            }
        }
    };
}

problems! {
    RouteNotFound = "route-not-found", NOT_FOUND, "No such resource",
        "Check the path against /openapi.json.";
    JobNotFound = "job-not-found", NOT_FOUND, "No such job",
        "Check the id; a deleted job is gone for good.";
    MeshNotFound = "mesh-not-found", NOT_FOUND, "No such mesh",
        "Upload it with POST /v1/meshes; its id is the hash of its content.";
    BatchNotFound = "batch-not-found", NOT_FOUND, "No such batch",
        "Check the id.";
    WebhookNotFound = "webhook-not-found", NOT_FOUND, "No such webhook",
        "Check the id.";
    Unauthenticated = "unauthenticated", UNAUTHORIZED, "A valid API key is needed",
        "Send Authorization: Bearer and a key that is neither expired nor revoked.";
    ScopeMissing = "scope-missing", FORBIDDEN, "The API key does not allow this",
        "Ask the operator for a key with the scope that the detail names.";
    MethodNotFound = "method-not-found", NOT_FOUND, "No such matching method",
        "GET /v1/methods lists those there are.";
    ProblemNotFound = "problem-not-found", NOT_FOUND, "No such problem type",
        "See api/problems.md.";
    MethodNotAllowed = "method-not-allowed", METHOD_NOT_ALLOWED, "The resource does not take this HTTP method",
        "The Allow header names those it takes.";
    InvalidRequest = "invalid-request", UNPROCESSABLE_ENTITY, "The submission has faults",
        "Each entry of errors points at a field of the form and says what is allowed.";
    InvalidParameters = "invalid-parameters", UNPROCESSABLE_ENTITY, "The parameters have faults",
        "Each entry of errors points into the parameters and says what is allowed; GET /v1/methods has their JSON Schema.";
    InvalidQuery = "invalid-query", BAD_REQUEST, "The query string has faults",
        "Each entry of errors names a parameter of the query and says what is allowed.";
    MalformedMultipart = "malformed-multipart", BAD_REQUEST, "The multipart body cannot be read",
        "Send multipart/form-data (RFC 7578) with the fields source and target, each a file, and optionally parameters, labels, external_ref, priority, deadline_at, max_run_s, use_cache.";
    MalformedJson = "malformed-json", BAD_REQUEST, "The JSON body cannot be read",
        "The detail names the line and the column.";
    HostNotAllowed = "host-not-allowed", FORBIDDEN, "The request names a host that is not this service",
        "Ask for localhost or a loopback address; the operator allows other names with --allowed-host.";
    BadRequest = "bad-request", BAD_REQUEST, "The request cannot be understood",
        "Check path, headers and body against /openapi.json.";
    NotAcceptable = "not-acceptable", NOT_ACCEPTABLE, "The resource cannot be had in a format that Accept allows",
        "available lists the formats; ask for one by Accept or by ?format=.";
    UnsupportedMediaType = "unsupported-media-type", UNSUPPORTED_MEDIA_TYPE, "The body's media type is not taken here",
        "Send a submission as multipart/form-data with a boundary, or as application/json.";
    UnknownFormat = "unknown-format", UNSUPPORTED_MEDIA_TYPE, "An input's file format is not known",
        "Send NIfTI-1 (.nii, .nii.gz), PLY, STL or legacy VTK.";
    UnreadableFile = "unreadable-file", UNPROCESSABLE_ENTITY, "An input cannot be read",
        "The detail says where the file is wrong; write it anew.";
    EmptyStructure = "empty-structure", UNPROCESSABLE_ENTITY, "An input has nothing to match",
        "Check that input.labels names labels that the volume has.";
    UnsuitableSurface = "unsuitable-surface", UNPROCESSABLE_ENTITY, "An input is no closed surface of genus 0",
        "The topology report says why; repair it, or allow repairs in input.repair.";
    InvalidInput = "invalid-input", UNPROCESSABLE_ENTITY, "An input cannot be matched",
        "The detail says why.";
    TooLarge = "too-large", PAYLOAD_TOO_LARGE, "An input is larger than this service allows",
        "Send fewer bytes or vertices, or ask the operator for a higher limit.";
    BodyTooLarge = "body-too-large", PAYLOAD_TOO_LARGE, "The body is larger than this service allows",
        "Send smaller files, or ask the operator for a higher limit.";
    QueueFull = "queue-full", TOO_MANY_REQUESTS, "As many jobs wait as this service allows",
        "Submit again after the time in Retry-After.";
    Busy = "busy", SERVICE_UNAVAILABLE, "As many submissions are being read as this service allows",
        "Submit again after the time in Retry-After.";
    UploadTimeout = "upload-timeout", REQUEST_TIMEOUT, "The body took too long to arrive",
        "Submit again over a faster connection, or send smaller files.";
    Timeout = "timeout", SERVICE_UNAVAILABLE, "The answer took too long",
        "Ask again after the time in Retry-After.";
    MeshInUse = "mesh-in-use", CONFLICT, "Jobs refer to the mesh",
        "Delete those jobs first, or wait until their retention is over.";
    Expired = "expired", GONE, "The result was removed when its time was over",
        "Submit the inputs again.";
    DeadlinePassed = "deadline-passed", UNPROCESSABLE_ENTITY, "The job's deadline passed before a worker was free",
        "Submit again with a later deadline or a higher priority.";
    IdempotencyKeyReused = "idempotency-key-reused", UNPROCESSABLE_ENTITY, "Another request was made with this Idempotency-Key",
        "Take a new key for a new request.";
    IdempotencyKeyInProgress = "idempotency-key-in-progress", CONFLICT, "The same request is being worked on",
        "Send it again after the time in Retry-After; it will be answered alike.";
    TooManyWebhooks = "too-many-webhooks", CONFLICT, "As many webhooks as a tenant may have",
        "Delete one that is not needed any more.";
    UnsuitableBatch = "unsuitable-batch", UNPROCESSABLE_ENTITY, "Some jobs of the batch cannot be made",
        "Each entry of errors points at a pair and says why; nothing was made.";
    ResultNotReady = "result-not-ready", CONFLICT, "The job is not finished",
        "Follow the job until its state is final; state says what it is now.";
    NoResult = "no-result", CONFLICT, "The job ended without a result",
        "state says how it ended, and error why; submit a new job.";
    JobActive = "job-active", CONFLICT, "The job is not finished",
        "Cancel it first, or wait for its end.";
    JobFinished = "job-finished", CONFLICT, "The job is finished already",
        "A finished state never changes.";
    NoRegistration = "no-registration", UNPROCESSABLE_ENTITY, "No rigid transform fits the two surfaces",
        "Check that both show the same structure, or raise registration.tolerance_mm.";
    MatchFailed = "match-failed", UNPROCESSABLE_ENTITY, "The match cannot be computed",
        "The detail says why.";
    RunTimeExceeded = "run-time-exceeded", UNPROCESSABLE_ENTITY, "The job ran longer than this service allows",
        "Submit smaller surfaces or fewer iterations, or ask the operator for a higher limit.";
    CrashLimitReached = "crash-limit-reached", UNPROCESSABLE_ENTITY, "The job's workers crashed too often",
        "Tell the operator; the job is not tried again.";
    StorageFull = "storage-full", INSUFFICIENT_STORAGE, "The service has no room to store this",
        "Tell the operator; nothing was accepted.";
    Unavailable = "unavailable", SERVICE_UNAVAILABLE, "A part of the service does not answer",
        "Ask again after the time in Retry-After; /readyz names the part.";
    InternalError = "internal-error", INTERNAL_SERVER_ERROR, "The service failed",
        "Tell the operator the request_id; the cause is in the service's log.";
}

impl ProblemKind {
    /// The kind of this name.
    pub fn from_slug(slug: &str) -> Option<ProblemKind> {
        ProblemKind::ALL.iter().copied().find(|kind| kind.entry().slug == slug)
    }

    /// The kind that says no more than a status.
    pub fn from_status(status: StatusCode) -> ProblemKind {
        match status {
            StatusCode::NOT_FOUND => ProblemKind::RouteNotFound,
            StatusCode::METHOD_NOT_ALLOWED => ProblemKind::MethodNotAllowed,
            StatusCode::NOT_ACCEPTABLE => ProblemKind::NotAcceptable,
            StatusCode::PAYLOAD_TOO_LARGE => ProblemKind::BodyTooLarge,
            StatusCode::UNSUPPORTED_MEDIA_TYPE => ProblemKind::UnsupportedMediaType,
            StatusCode::REQUEST_TIMEOUT => ProblemKind::UploadTimeout,
            StatusCode::SERVICE_UNAVAILABLE => ProblemKind::Unavailable,
            other if other.is_server_error() => ProblemKind::InternalError,
            _ => ProblemKind::BadRequest,
        }
    }
}

/// The table as a page for people: `api/problems.md`.
pub fn problems_markdown() -> String {
    let mut page = String::from(
        "# Problems\n\n\
         Every error is `application/problem+json` (RFC 9457). `type` is stable; `detail` and extra members say more.\n\
         A job that ended without a result has the same object as its `error`.\n\n\
         | type | status | what it means | what to do |\n|---|---|---|---|\n",
    );
    for kind in ProblemKind::ALL {
        let ProblemEntry { slug, status, title, advice } = kind.entry();
        page.push_str(&format!("| `/problems/{slug}` | {} | {title} | {advice} |\n", status.as_u16()));
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slugs_are_unique_and_lead_back() {
        for &kind in ProblemKind::ALL {
            let slug = kind.entry().slug;
            assert_eq!(ProblemKind::from_slug(slug), Some(kind));
            assert!(slug.bytes().all(|b| b.is_ascii_lowercase() || b == b'-'), "{slug}");
        }
    }
}
