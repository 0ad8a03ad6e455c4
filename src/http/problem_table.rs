//! All problem types, one row each. `api/problems.md` is generated from this table.

use axum::http::StatusCode;

/// A row of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ProblemEntry {
    /// Stable name; the problem's `type` is `/problems/<slug>`.
    pub(crate) slug: &'static str,
    /// HTTP status.
    pub(crate) status: StatusCode,
    /// The same for every occurrence.
    pub(crate) title: &'static str,
    /// Advice for the client.
    pub(crate) advice: &'static str,
}

macro_rules! problems {
    ($($kind:ident = $slug:literal, $status:ident, $title:literal, $advice:literal;)*) => {
        /// Kinds of problems.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub(crate) enum ProblemKind {
            $(#[doc = $title] $kind,)*
        }

        impl ProblemKind {
            /// All kinds, in the order of the table.
            pub(crate) const ALL: &[ProblemKind] = &[$(ProblemKind::$kind,)*];

            /// The kind's row.
            pub(crate) fn entry(self) -> ProblemEntry {
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
    StudyNotFound = "study-not-found", NOT_FOUND, "No such study",
        "The id is wrong, or the study was deleted or belongs to someone else.";
    SubjectNotFound = "subject-not-found", NOT_FOUND, "The study has no such subject",
        "GET /v1/studies/{id} lists the ids of its subjects.";
    JobNotFound = "job-not-found", NOT_FOUND, "No such job",
        "Check the id. Deleted jobs cannot be restored.";
    MeshNotFound = "mesh-not-found", NOT_FOUND, "No such mesh",
        "Upload the mesh with POST /v1/meshes; its id is the hash of its content.";
    BatchNotFound = "batch-not-found", NOT_FOUND, "No such batch",
        "Check the id.";
    WebhookNotFound = "webhook-not-found", NOT_FOUND, "No such webhook",
        "Check the id.";
    KeyNotFound = "key-not-found", NOT_FOUND, "No such API key",
        "Check the id; GET /v1/keys lists the keys of the tenant.";
    Unauthenticated = "unauthenticated", UNAUTHORIZED, "A valid API key is required",
        "Send the header Authorization: Bearer KEY with a key that is neither expired nor revoked.";
    ScopeMissing = "scope-missing", FORBIDDEN, "The API key does not allow this",
        "Use a key with the role named in detail; an admin of the tenant can create one with POST /v1/keys.";
    MethodNotFound = "method-not-found", NOT_FOUND, "No such matching method",
        "GET /v1/methods lists the methods.";
    ProblemNotFound = "problem-not-found", NOT_FOUND, "No such problem type",
        "See api/problems.md.";
    MethodNotAllowed = "method-not-allowed", METHOD_NOT_ALLOWED, "The resource does not support this HTTP method",
        "The Allow header lists the supported methods.";
    InvalidRequest = "invalid-request", UNPROCESSABLE_ENTITY, "The request has invalid fields",
        "Each entry of errors points to a field and says what is allowed.";
    InvalidParameters = "invalid-parameters", UNPROCESSABLE_ENTITY, "The parameters are invalid",
        "Each entry of errors points to a parameter and says what is allowed; GET /v1/methods has the JSON Schema.";
    InvalidQuery = "invalid-query", BAD_REQUEST, "The query string is invalid",
        "Each entry of errors names a query parameter and says what is allowed.";
    MalformedMultipart = "malformed-multipart", BAD_REQUEST, "The multipart body is malformed",
        "Send multipart/form-data (RFC 7578) with the fields source and target, each a file, and optionally parameters, tags, external_ref, priority, deadline_at, max_run_s, use_cache.";
    MalformedJson = "malformed-json", BAD_REQUEST, "The JSON body is malformed",
        "detail names the line and the column.";
    HostNotAllowed = "host-not-allowed", FORBIDDEN, "The host of the request is not allowed",
        "Use localhost or a loopback address, or send an API key to a service that requires one; the operator can allow other names with --allowed-host.";
    BadRequest = "bad-request", BAD_REQUEST, "The request is malformed",
        "Check path, headers and body against /openapi.json.";
    TargetTooLong = "target-too-long", URI_TOO_LONG, "The path and query are too long",
        "Send fewer query parameters; limit_bytes is the limit.";
    HeadersTooLarge = "headers-too-large", REQUEST_HEADER_FIELDS_TOO_LARGE, "The headers are too large",
        "Send fewer or shorter headers; limit_bytes is the limit of all together.";
    NotAcceptable = "not-acceptable", NOT_ACCEPTABLE, "The resource is not available in a format that Accept allows",
        "available lists the formats; request one of them with Accept or ?format=.";
    UnsupportedMediaType = "unsupported-media-type", UNSUPPORTED_MEDIA_TYPE, "The media type of the body is not supported",
        "Send a submission as multipart/form-data with a boundary, or as application/json.";
    UnknownFormat = "unknown-format", UNSUPPORTED_MEDIA_TYPE, "The file format of an input is unknown",
        "Send a surface as GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF or MZ3, or labels as NIfTI, MGZ, NRRD, MetaImage \
         or DICOM SEG.";
    UnreadableFile = "unreadable-file", UNPROCESSABLE_ENTITY, "An input cannot be read",
        "detail says where the file is invalid; export it again.";
    EmptyStructure = "empty-structure", UNPROCESSABLE_ENTITY, "An input contains no structure to match",
        "Check that the file is not empty and that the volume contains the labels in input.labels.";
    NotLabels = "not-labels", UNPROCESSABLE_ENTITY, "An input looks like an image, not like labels",
        "Send a segmentation, or choose labels with input.labels; input.image_is_labels takes the values as labels.";
    UnsuitableSurface = "unsuitable-surface", UNPROCESSABLE_ENTITY, "An input is no surface that can be matched",
        "The topology report says why. Repair the surface, or allow repairs with input.repair.";
    InvalidInput = "invalid-input", UNPROCESSABLE_ENTITY, "An input cannot be matched",
        "detail says why.";
    TooLarge = "too-large", PAYLOAD_TOO_LARGE, "An input is larger than this service allows",
        "Reduce the file size or the number of vertices, or ask the operator for a higher limit.";
    BodyTooLarge = "body-too-large", PAYLOAD_TOO_LARGE, "The body is larger than this service allows",
        "Send smaller files, or ask the operator for a higher limit.";
    QueueFull = "queue-full", TOO_MANY_REQUESTS, "The queue is full",
        "Submit again after the time in Retry-After.";
    StorageShareFull = "storage-share-full", INSUFFICIENT_STORAGE, "The tenant has stored as many bytes as it may",
        "Delete jobs and uploads that are no longer needed, wait until their retention time is over, or ask the operator for a higher limit.";
    TooManyRequests = "too-many-requests", TOO_MANY_REQUESTS, "The tenant sends too many requests",
        "Send the request again after the time in Retry-After; follow many jobs with GET /v1/changes?wait=20.";
    Busy = "busy", SERVICE_UNAVAILABLE, "The service is receiving or sending too much at the moment",
        "Send the request again after the time in Retry-After.";
    TooManyStreams = "too-many-streams", TOO_MANY_REQUESTS, "Too many event streams and long polls are open",
        "Close some, or follow many jobs with one stream of changes: GET /v1/changes?wait=20.";
    RangeNotSatisfiable = "range-not-satisfiable", RANGE_NOT_SATISFIABLE, "The range is not within the content",
        "Content-Range states the size; request a range within it.";
    UploadTimeout = "upload-timeout", REQUEST_TIMEOUT, "The body took too long to arrive",
        "Submit again over a faster connection, or send smaller files.";
    Timeout = "timeout", SERVICE_UNAVAILABLE, "The request took too long",
        "Retry after the time in Retry-After.";
    MeshInUse = "mesh-in-use", CONFLICT, "Jobs refer to the mesh",
        "Delete those jobs first, or wait until their retention time is over.";
    Expired = "expired", GONE, "The result was deleted at the end of its retention time",
        "Submit the inputs again.";
    DeadlinePassed = "deadline-passed", UNPROCESSABLE_ENTITY, "The deadline of the job passed before it started",
        "Submit again with a later deadline or a higher priority.";
    IdempotencyKeyReused = "idempotency-key-reused", UNPROCESSABLE_ENTITY, "The Idempotency-Key was used for another request",
        "Use a new key for each new request.";
    IdempotencyKeyInProgress = "idempotency-key-in-progress", CONFLICT, "A request with the same Idempotency-Key is in progress",
        "Send it again after the time in Retry-After, to get the answer of the first.";
    TooManyWebhooks = "too-many-webhooks", CONFLICT, "The tenant has the maximum number of webhooks",
        "Delete a webhook that is no longer needed.";
    TooManyKeys = "too-many-keys", CONFLICT, "The tenant has the maximum number of valid API keys",
        "Revoke a key that is no longer needed.";
    UnsuitableBatch = "unsuitable-batch", UNPROCESSABLE_ENTITY, "Some jobs of the batch cannot be created",
        "Each entry of errors points to a pair and says why. No job was created.";
    StudyNotReady = "study-not-ready", CONFLICT, "The study is not finished",
        "Wait until it is finished; study_state is its state, and the study's error says why it failed.";
    StudyActive = "study-active", CONFLICT, "The study, or a match of it, is not finished",
        "Cancel the study first, or wait until it is finished; matches that run are cancelled within a second.";
    StudyFinished = "study-finished", CONFLICT, "The study is already finished",
        "A finished study cannot be cancelled.";
    ResultNotReady = "result-not-ready", CONFLICT, "The job is not finished",
        "Wait until the job is finished, for example with GET /v1/jobs/{id}?wait=20; state is the current state.";
    NoResult = "no-result", CONFLICT, "The job finished without a result",
        "state says how the job ended; its error says why.";
    JobActive = "job-active", CONFLICT, "The job is not finished",
        "Cancel the job first, or wait until it is finished.";
    JobFinished = "job-finished", CONFLICT, "The job is already finished",
        "A finished job cannot be cancelled.";
    NoRegistration = "no-registration", UNPROCESSABLE_ENTITY, "No rigid transform fits the two surfaces",
        "Check that both surfaces show the same structure, or increase registration.tolerance_mm.";
    MatchFailed = "match-failed", UNPROCESSABLE_ENTITY, "The match cannot be computed",
        "detail says why.";
    RunTimeExceeded = "run-time-exceeded", UNPROCESSABLE_ENTITY, "The job exceeded its run time",
        "Submit smaller surfaces or fewer iterations, increase max_run_s, or ask the operator for a higher limit.";
    OutOfMemory = "out-of-memory", UNPROCESSABLE_ENTITY, "The computation ran out of the memory that was planned for it",
        "Submit smaller surfaces, and tell the operator. The job is not run again; no other was affected.";
    ComputationCrashed = "computation-crashed", UNPROCESSABLE_ENTITY, "The process that computed the job crashed twice",
        "Tell the operator. The job is not run again; no other was affected.";
    CrashLimitReached = "crash-limit-reached", UNPROCESSABLE_ENTITY, "The workers of the job crashed too often",
        "Tell the operator. The job is not run again.";
    InputMissing = "input-missing", UNPROCESSABLE_ENTITY, "An input of the job is not in the blob store",
        "Tell the operator: the processes of the service may not share one blob store, or a blob was lost. Submit the files again.";
    StudyFailed = "study-failed", UNPROCESSABLE_ENTITY, "The study cannot be computed",
        "detail says why. Add subjects, or drop one with a decision, and the study goes on.";
    StorageFull = "storage-full", INSUFFICIENT_STORAGE, "The service is out of storage space",
        "Tell the operator. The request was not accepted.";
    Unavailable = "unavailable", SERVICE_UNAVAILABLE, "A dependency of the service does not respond",
        "Retry after the time in Retry-After; /readyz names the dependency.";
    InternalError = "internal-error", INTERNAL_SERVER_ERROR, "Internal error",
        "Tell the operator the request_id; the cause is in the log of the service.";
}

impl ProblemKind {
    /// The kind of this name.
    pub(crate) fn from_slug(slug: &str) -> Option<ProblemKind> {
        ProblemKind::ALL.iter().copied().find(|kind| kind.entry().slug == slug)
    }

    /// The kind for an error if only the status is known.
    pub(crate) fn from_status(status: StatusCode) -> ProblemKind {
        match status {
            StatusCode::NOT_FOUND => ProblemKind::RouteNotFound,
            StatusCode::METHOD_NOT_ALLOWED => ProblemKind::MethodNotAllowed,
            StatusCode::NOT_ACCEPTABLE => ProblemKind::NotAcceptable,
            StatusCode::RANGE_NOT_SATISFIABLE => ProblemKind::RangeNotSatisfiable,
            StatusCode::PAYLOAD_TOO_LARGE => ProblemKind::BodyTooLarge,
            StatusCode::UNSUPPORTED_MEDIA_TYPE => ProblemKind::UnsupportedMediaType,
            StatusCode::REQUEST_TIMEOUT => ProblemKind::UploadTimeout,
            StatusCode::SERVICE_UNAVAILABLE => ProblemKind::Unavailable,
            other if other.is_server_error() => ProblemKind::InternalError,
            _ => ProblemKind::BadRequest,
        }
    }
}

/// The table in Markdown: `api/problems.md`.
pub fn problems_markdown() -> String {
    let mut page = String::from(
        "# Problems\n\n\
         Every error is answered as `application/problem+json` (RFC 9457). `type` is stable; `detail` and further members\n\
         are specific to the occurrence. The `error` of a job that finished without a result is the same kind of object.\n\n\
         | type | status | meaning | advice |\n|---|---|---|---|\n",
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
    fn slugs_are_unique_and_parse_back() {
        for &kind in ProblemKind::ALL {
            let slug = kind.entry().slug;
            assert_eq!(ProblemKind::from_slug(slug), Some(kind));
            assert!(slug.bytes().all(|b| b.is_ascii_lowercase() || b == b'-'), "{slug}");
        }
    }
}
