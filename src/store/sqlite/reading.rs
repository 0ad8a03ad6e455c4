//! Jobs, lists, traces and references, read without a lock.

use super::rows::{self, JobRow};
use super::{SqliteStore, domain_error, query_text};
use crate::jobs::job::{Cursor, Order};
use crate::jobs::{
    ArtifactKey, ArtifactKind, ArtifactRef, Job, JobError, JobFilter, JobId, JobPage, JobState, NumberedPoint,
    PageRequest, Tenant, TracePage,
};
use sqlx::SqliteConnection;

/// A job by its id, on any connection.
pub(super) async fn find_job(connection: &mut SqliteConnection, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
    let row: Option<JobRow> = sqlx::query_as(query_text!("get_job"))
        .bind(id.to_string())
        .bind(tenant.name())
        .fetch_optional(connection)
        .await
        .map_err(domain_error)?;
    row.ok_or(JobError::NotFound)?.into_job()
}

impl SqliteStore {
    pub(super) async fn get_job(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        let mut connection = self.readers.acquire().await.map_err(domain_error)?;
        let mut job = find_job(&mut connection, tenant, id).await?;
        if job.state == JobState::Queued {
            let position: i64 = sqlx::query_scalar(query_text!("queue_position"))
                .bind(job.priority)
                .bind(job.created_at.as_millisecond())
                .bind(id.to_string())
                .fetch_one(&mut *connection)
                .await
                .map_err(domain_error)?;
            job.queue_position = Some(position.unsigned_abs());
        }
        Ok(job)
    }

    pub(super) async fn list_jobs(
        &self,
        tenant: &Tenant,
        filter: &JobFilter,
        page: &PageRequest,
    ) -> Result<JobPage, JobError> {
        let text = match page.order {
            Order::NewestFirst => query_text!("list_jobs_newest"),
            Order::OldestFirst => query_text!("list_jobs_oldest"),
        };
        let states: Vec<_> = filter.states.iter().map(|s| s.name()).collect();
        let size = page.size as usize;
        let rows: Vec<JobRow> = sqlx::query_as(text)
            .bind(tenant.name())
            .bind(rows::to_json("states", &states)?)
            .bind(&filter.method)
            .bind(&filter.external_ref)
            .bind(page.after.map(|c| c.created_at_ms))
            .bind(page.after.map(|c| c.id.to_string()))
            .bind(i64::from(page.size) + 1) // one more than asked for tells whether there is a next page
            .fetch_all(&self.readers)
            .await
            .map_err(domain_error)?;
        let more = rows.len() > size;
        let jobs = rows.into_iter().take(size).map(JobRow::into_job).collect::<Result<Vec<_>, _>>()?;
        let next = jobs
            .last()
            .filter(|_| more)
            .map(|job| Cursor { created_at_ms: job.created_at.as_millisecond(), id: job.id });
        Ok(JobPage { jobs, next })
    }

    pub(super) async fn read_trace(
        &self,
        tenant: &Tenant,
        id: JobId,
        after_seq: u64,
        limit: u32,
    ) -> Result<TracePage, JobError> {
        let after = i64::try_from(after_seq).unwrap_or(i64::MAX);
        // One transaction, so that state and points are of the same moment: `complete` must not hide a last chunk.
        let mut reading = self.readers.begin().await.map_err(domain_error)?;
        let state: Option<String> = sqlx::query_scalar(query_text!("job_state"))
            .bind(id.to_string())
            .bind(tenant.name())
            .fetch_optional(&mut *reading)
            .await
            .map_err(domain_error)?;
        let state = rows::state(&state.ok_or(JobError::NotFound)?)?;
        let chunks: Vec<String> = sqlx::query_scalar(query_text!("trace_chunks_after"))
            .bind(id.to_string())
            .bind(after)
            .bind(i64::from(limit) + 2) // a chunk has at least a point; the first may reach back before `after`
            .fetch_all(&mut *reading)
            .await
            .map_err(domain_error)?;
        drop(reading);
        let mut points: Vec<NumberedPoint> = Vec::new();
        for chunk in &chunks {
            points.extend(rows::json::<Vec<NumberedPoint>>("a trace chunk", chunk)?);
        }
        points.retain(|p| p.seq > after_seq);
        let more = points.len() > limit as usize;
        points.truncate(limit as usize);
        let next_after_seq = points.last().map_or(after_seq, |p| p.seq);
        Ok(TracePage { points, next_after_seq, complete: state.is_final() && !more })
    }

    pub(super) async fn get_artifact(
        &self,
        tenant: &Tenant,
        id: JobId,
        kind: ArtifactKind,
    ) -> Result<(JobState, Option<ArtifactRef>), JobError> {
        let row: Option<(String, Option<String>, Option<i64>)> = sqlx::query_as(query_text!("get_artifact"))
            .bind(id.to_string())
            .bind(tenant.name())
            .bind(kind.name())
            .fetch_optional(&self.readers)
            .await
            .map_err(domain_error)?;
        let (state, hash, n_bytes) = row.ok_or(JobError::NotFound)?;
        let artifact = hash.zip(n_bytes).map(|(hash, n_bytes)| ArtifactRef {
            kind,
            key: ArtifactKey { tenant: tenant.clone(), hash },
            n_bytes: n_bytes.unsigned_abs(),
        });
        Ok((rows::state(&state)?, artifact))
    }
}
