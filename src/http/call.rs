//! A request to an operation, whose sender has the scope that the row of the operation asks for.

use super::auth::{Rights, tenant_with};
use super::fields::Fields;
use super::operations::Operation;
use super::problem::Problem;
use super::problem_table::ProblemKind;
use super::query::QueryString;
use super::shares::{Origin, SharePermit};
use super::state::{AS_IT_ARRIVES, HttpState, IN_MEMORY};
use super::submission::{SentFiles, media_type, read_json, read_with_files};
use super::upload::LimitedBody;
use crate::jobs::mesh::hash_of_id;
use crate::jobs::{BatchId, JobId, JobService, SecretKey, StudyId, Tenant};
use axum::extract::{FromRequestParts, MatchedPath, Path, Request};
use axum::http::request::Parts;
use axum::http::{HeaderMap, Method};
use axum::response::{IntoResponse, Response};
use serde::de::DeserializeOwned;
use std::time::Duration;
use utoipa::PartialSchema;

/// Entries of a page by default.
const DEFAULT_PAGE: u32 = 50;
/// Most entries of a page.
const MAX_PAGE: u32 = 500;
/// Largest body of a request with a small document, bytes.
const MAX_SMALL_BODY: usize = 64 << 10;

/// All that handlers read of a request, except its body. Taking one authorizes the sender.
pub(crate) struct AuthorizedRequest {
    pub(super) state: HttpState,
    pub(super) tenant: Tenant,
    pub(super) rights: Rights,
    pub(super) origin: Origin,
    pub(super) method: Method,
    pub(super) headers: HeaderMap,
    pub(super) query: QueryString,
    /// The parts of the path that its template names in braces.
    path: Vec<String>,
}

impl FromRequestParts<HttpState> for AuthorizedRequest {
    type Rejection = Response;

    async fn from_request_parts(parts: &mut Parts, state: &HttpState) -> Result<Self, Response> {
        let route = parts.extensions.get::<MatchedPath>();
        let operation = route.and_then(|route| Operation::of(&parts.method, route.as_str()));
        // No row, no rights.
        let scope = operation.and_then(|operation| operation.scope);
        let scope = scope.ok_or_else(|| Problem::new(ProblemKind::InternalError).into_response())?;
        let tenant = tenant_with(parts, state, scope).await.map_err(Problem::into_response)?;
        let rights = Rights::of(parts, state);
        let Path(path) = Path::from_request_parts(parts, state).await.map_err(IntoResponse::into_response)?;
        let query = QueryString::from_request_parts(parts, state).await.map_err(Problem::into_response)?;
        Ok(AuthorizedRequest {
            state: state.clone(),
            tenant,
            rights,
            origin: Origin::of(&parts.extensions),
            method: parts.method.clone(),
            headers: parts.headers.clone(),
            query,
            path,
        })
    }
}

/// An id in a path.
pub(crate) trait ResourceId: Sized {
    /// The problem if there is no such resource; a text that cannot be an id names none.
    const NOT_FOUND: ProblemKind;

    /// The id with this text.
    fn parse(text: &str) -> Option<Self>;
}

/// The hash of an upload.
pub(crate) struct MeshHash(pub(super) String);
/// The id of a webhook.
pub(crate) struct WebhookId(pub(super) String);
/// The public part of a key.
pub(crate) struct KeyId(pub(super) String);

macro_rules! ids {
    ($($id:ty, $kind:ident, $parse:expr;)*) => {
        $(impl ResourceId for $id {
            const NOT_FOUND: ProblemKind = ProblemKind::$kind;

            fn parse(text: &str) -> Option<Self> {
                $parse(text)
            }
        })*
    };
}

ids! {
    JobId, JobNotFound, JobId::parse;
    BatchId, BatchNotFound, BatchId::parse;
    StudyId, StudyNotFound, StudyId::parse;
    MeshHash, MeshNotFound, |id| hash_of_id(id).map(|hash| MeshHash(hash.to_owned()));
    WebhookId, WebhookNotFound, |id: &str| (id.len() == 36 && uuid::Uuid::try_parse(id).is_ok()).then(|| WebhookId(id.to_owned()));
    KeyId, KeyNotFound, |id: &str| SecretKey::is_id(id).then(|| KeyId(id.to_owned()));
}

/// Size and start of a page of a list, and the members that its entries keep.
pub(super) struct PageOf<C, E> {
    pub(super) size: u32,
    pub(super) after: Option<C>,
    pub(super) fields: Fields<E>,
}

impl AuthorizedRequest {
    pub(super) fn service(&self) -> &JobService {
        &self.state.service
    }

    /// A part of the path, counted from 0.
    pub(super) fn segment(&self, k: usize) -> &str {
        self.path.get(k).map_or("", String::as_str)
    }

    /// The id in the path.
    ///
    /// # Errors
    /// 404 for a text that cannot be an id.
    pub(super) fn id<I: ResourceId>(&self) -> Result<I, Problem> {
        I::parse(self.segment(0)).ok_or_else(|| Problem::new(I::NOT_FOUND))
    }

    /// The id in the path of a request that can have no further query parameters.
    ///
    /// # Errors
    /// `invalid-query`, or 404.
    pub(super) fn last_id<I: ResourceId>(&mut self) -> Result<I, Problem> {
        self.query.finish()?;
        self.id()
    }

    /// Size and start of a page, from `page_size` and `page_token`.
    pub(super) fn page<C>(&mut self, read: impl FnOnce(&str) -> Option<C>) -> (u32, Option<C>) {
        let size = self.query.number("page_size", 1..=MAX_PAGE).unwrap_or(DEFAULT_PAGE);
        let token = self.query.text("page_token").filter(|token| !token.is_empty());
        let after = token.as_deref().and_then(read);
        if token.is_some() && after.is_none() {
            self.query.fault("page_token", "out_of_range", "must be a next_page_token of an earlier answer");
        }
        (size, after)
    }

    /// A page of a list whose query has no further parameters; `read` reads the token of a page.
    ///
    /// # Errors
    /// `invalid-query`.
    pub(super) fn last_page<C, E: PartialSchema>(
        &mut self,
        read: impl FnOnce(&str) -> Option<C>,
    ) -> Result<PageOf<C, E>, Problem> {
        let (size, after) = self.page(read);
        let fields = Fields::of(&mut self.query);
        self.query.finish()?;
        Ok(PageOf { size, after, fields })
    }

    /// The place of a stream or a long poll; none is needed without a wait.
    ///
    /// # Errors
    /// `too-many-streams`.
    pub(super) fn place(&self, wait: Duration) -> Result<[Option<SharePermit>; 2], Problem> {
        if wait.is_zero() { Ok([None, None]) } else { self.state.begin_stream(&self.tenant, self.origin) }
    }

    /// Memory for an answer of `n` bytes, held until the answer is sent.
    ///
    /// # Errors
    /// `busy` if there is none in time.
    pub(super) async fn memory(&self, n: usize) -> Result<SharePermit, Problem> {
        self.state.answer_memory(&self.tenant, self.origin, n).await
    }

    /// Begins to read a body that is kept in memory.
    ///
    /// # Errors
    /// `busy` if no slot becomes free in time.
    pub(super) async fn begin_reading(&self, tap: &LimitedBody) -> Result<(), Problem> {
        self.state.begin_reading(tap, &self.tenant, self.origin, IN_MEMORY).await
    }

    /// Begins to read a body that is stored as it arrives.
    ///
    /// # Errors
    /// `busy` if no slot becomes free in time.
    pub(super) async fn begin_storing(&self, tap: &LimitedBody) -> Result<(), Problem> {
        self.state.begin_reading(tap, &self.tenant, self.origin, AS_IT_ARRIVES).await
    }

    /// What `reading` reads, within the time for a submission.
    ///
    /// # Errors
    /// `upload-timeout`, and those of `reading`.
    pub(super) async fn in_time<T>(&self, reading: impl Future<Output = Result<T, Problem>>) -> Result<T, Problem> {
        let read = tokio::time::timeout(self.state.limits.upload_timeout, reading).await;
        read.map_err(|_| Problem::new(ProblemKind::UploadTimeout))?
    }

    /// The document of a submission, and the files to which it refers.
    ///
    /// # Errors
    /// A limit, or a fault of the body.
    pub(super) async fn document<T: DeserializeOwned>(
        &self,
        request: Request,
        tap: &LimitedBody,
    ) -> Result<(T, SentFiles), Problem> {
        self.begin_reading(tap).await?;
        self.in_time(read_with_files(request, tap, &self.state.limits)).await
    }

    /// The document in the JSON body of a request that is small and has no query.
    ///
    /// # Errors
    /// `invalid-query`, a limit, or a fault of the body.
    pub(super) async fn small_json<T: DeserializeOwned>(&mut self, request: Request) -> Result<T, Problem> {
        let (request, tap) = LimitedBody::on(request, MAX_SMALL_BODY);
        let read = async {
            self.query.finish()?;
            if media_type(&request) != "application/json" {
                return Err(Problem::new(ProblemKind::UnsupportedMediaType));
            }
            self.begin_reading(&tap).await?;
            read_json(request, &tap, &self.state.limits, MAX_SMALL_BODY).await
        };
        tap.settle(read).await
    }
}
