//! Jobs, batches, traces and the feed of changes, as clients read them.

use super::argument::{Argument, bind};
use super::database::Session;
use super::dialect::{sql, with_options};
use super::{SqlStore, batches, changes, rows};
use crate::jobs::job::{Cursor, Order};
use crate::jobs::{
    ArtifactKey, ArtifactKind, ArtifactRef, Batch, BatchId, BatchPage, ChangePage, Job, JobError, JobFilter, JobId,
    JobPage, JobReader, JobState, Load, NumberedPoint, PageRequest, Tenant, TracePage,
};
use async_trait::async_trait;

/// A job by its id.
pub(super) async fn get_job(session: &mut Session, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
    let row = session.row(sql!("get_job"), bind![id, tenant]).await?;
    rows::job(&row.ok_or(JobError::NotFound)?)
}

/// The number of a tenant's queued jobs, counted up to `at_most`.
pub(super) async fn queue_length(session: &mut Session, tenant: &Tenant, at_most: u32) -> Result<u32, JobError> {
    let row = session.row(sql!("queue_length"), bind![tenant, at_most]).await?;
    row.map_or(Ok(0), |row| row.count(0))
}

#[async_trait]
impl JobReader for SqlStore {
    async fn get_job(&self, tenant: &Tenant, id: JobId) -> Result<Job, JobError> {
        let mut session = self.database.reader().await?;
        let mut job = get_job(&mut session, tenant, id).await?;
        if job.state == JobState::Queued {
            let position_key = bind![job.priority, id, tenant];
            let position: Option<i64> = session.value(sql!("queue_position"), position_key).await?;
            job.queue_position = position.map(i64::unsigned_abs);
        }
        Ok(job)
    }

    /// Reads each state separately, along its index, and merges the pages, so the cost of any filter is that of a few
    /// pages, regardless of the number of jobs.
    async fn list_jobs(&self, tenant: &Tenant, filter: &JobFilter, page: &PageRequest) -> Result<JobPage, JobError> {
        let mut jobs = self
            .database
            .read(async |session| {
                let mut jobs = Vec::new();
                if filter.states.is_empty() {
                    jobs = list_state(session, tenant, filter, None, page).await?;
                }
                for &state in &filter.states {
                    jobs.extend(list_state(session, tenant, filter, Some(state), page).await?);
                }
                Ok(jobs)
            })
            .await?;
        let sort_key = |job: &Job| (job.created_at, job.id);
        match page.order {
            Order::NewestFirst => jobs.sort_by_key(|job| std::cmp::Reverse(sort_key(job))),
            Order::OldestFirst => jobs.sort_by_key(sort_key),
        }
        jobs.dedup_by_key(|job| job.id);
        let more = jobs.len() > page.size as usize;
        jobs.truncate(page.size as usize);
        let next = jobs
            .last()
            .filter(|_| more)
            .map(|job| Cursor { created_at_ms: job.created_at.as_millisecond(), id: job.id });
        Ok(JobPage { jobs, next })
    }

    async fn get_batch(&self, tenant: &Tenant, id: BatchId) -> Result<Batch, JobError> {
        batches::get_batch(&mut self.database.reader().await?, tenant, id).await
    }

    async fn list_batches(&self, tenant: &Tenant, size: u32, after: Option<Cursor>) -> Result<BatchPage, JobError> {
        batches::list_batches(&mut self.database.reader().await?, tenant, size, after).await
    }

    async fn list_changes(&self, tenant: &Tenant, since: u64, limit: u32) -> Result<ChangePage, JobError> {
        changes::number_changes(&self.database).await?;
        changes::list_changes(&self.database, tenant, since, limit).await
    }

    async fn newest_change(&self, tenant: &Tenant) -> Result<u64, JobError> {
        changes::number_changes(&self.database).await?;
        changes::newest_change(&self.database, tenant).await
    }

    async fn get_trace(&self, tenant: &Tenant, id: JobId, after_seq: u64, limit: u32) -> Result<TracePage, JobError> {
        // State and points from one snapshot: otherwise `complete` could be reported before the last chunk is read.
        let (state, chunks) = self
            .database
            .read(async |session| {
                let state: Option<String> = session.value(sql!("job_state"), bind![id, tenant]).await?;
                let state = rows::state(&state.ok_or(JobError::NotFound)?)?;
                // A chunk has at least one point; the first chunk may begin before `after_seq`.
                let arguments = bind![id, after_seq, i64::from(limit) + 2];
                Ok((state, session.rows(sql!("trace_chunks_after"), arguments).await?))
            })
            .await?;
        let mut points: Vec<NumberedPoint> = Vec::new();
        for chunk in &chunks {
            points.extend(rows::json::<Vec<NumberedPoint>>("a trace chunk", &chunk.get::<String>(0)?)?);
        }
        points.retain(|p| p.seq > after_seq);
        let more = points.len() > limit as usize;
        points.truncate(limit as usize);
        let next_after_seq = points.last().map_or(after_seq, |p| p.seq);
        Ok(TracePage { points, next_after_seq, complete: state.is_final() && !more })
    }

    async fn get_artifact(
        &self,
        tenant: &Tenant,
        id: JobId,
        kind: ArtifactKind,
    ) -> Result<(JobState, Option<ArtifactRef>), JobError> {
        let mut session = self.database.reader().await?;
        let row = session.row(sql!("get_artifact"), bind![id, tenant, kind.name()]).await?;
        let row = row.ok_or(JobError::NotFound)?;
        if row.get::<Option<i64>>("purged_at")?.is_some() {
            return Err(JobError::Gone);
        }
        let artifact = match (row.get::<Option<String>>("path")?, row.get::<Option<i64>>("n_bytes")?) {
            (Some(path), Some(n_bytes)) => {
                let key = ArtifactKey::from_path(tenant, &path);
                let key = key.ok_or(JobError::Corrupt { what: "a blob's address", source: None })?;
                Some(ArtifactRef { kind, key, n_bytes: n_bytes.unsigned_abs() })
            }
            _ => None,
        };
        Ok((rows::state(&row.get::<String>("state")?)?, artifact))
    }

    async fn queue_length(&self, tenant: &Tenant, at_most: u32) -> Result<u32, JobError> {
        queue_length(&mut self.database.reader().await?, tenant, at_most).await
    }

    async fn stored_bytes(&self, tenant: &Tenant) -> Result<u64, JobError> {
        let n_bytes: Option<i64> = self.database.reader().await?.value(sql!("stored_bytes"), bind![tenant]).await?;
        Ok(n_bytes.unwrap_or(0).unsigned_abs())
    }

    async fn load(&self) -> Result<Load, JobError> {
        let row = self.database.reader().await?.row(sql!("load"), bind![]).await?;
        let row = row.ok_or(JobError::Corrupt { what: "the load", source: None })?;
        let age: i64 = row.get("oldest_ms")?;
        Ok(Load {
            queued: row.count("queued")?,
            running: row.count("running")?,
            oldest_queued: std::time::Duration::from_millis(age.max(0).unsigned_abs()),
            busy_workers: row.count("busy_workers")?,
            idle_workers: row.count("idle_workers")?,
        })
    }
}

/// The jobs of one state (of all states if `None`) on a page, and one more if there is a next page.
async fn list_state(
    session: &mut Session,
    tenant: &Tenant,
    filter: &JobFilter,
    state: Option<JobState>,
    page: &PageRequest,
) -> Result<Vec<Job>, JobError> {
    // Read along the first tag's index, unless another index selects fewer jobs: most jobs have succeeded, and few are
    // in any other state.
    let by_tag = !filter.tags.is_empty()
        && filter.external_ref.is_none()
        && filter.batch_id.is_none()
        && filter.study_id.is_none()
        && matches!(state, None | Some(JobState::Succeeded));
    const TAGS: [[&str; 2]; JobFilter::MAX_TAGS] =
        [["label_a", "value_a"], ["label_b", "value_b"], ["label_c", "value_c"], ["label_d", "value_d"]];
    let after = page.after;
    let newest = page.order == Order::NewestFirst;
    let mut values: Vec<(&str, Argument)> = vec![
        ("tenant", tenant.into()),
        // One more than the page holds tells whether there is a next page.
        ("size", (i64::from(page.size) + 1).into()),
    ];
    let mut wanted = vec![if newest { "newest" } else { "oldest" }, if by_tag { "by_label" } else { "by_job" }];
    let mut want = |name: &'static str, value: Option<Argument>| {
        if let Some(value) = value {
            wanted.push(name);
            values.push((name, value));
        }
    };
    want("state", state.map(Argument::from));
    want("method", filter.method.as_ref().map(Argument::from));
    want("reference", filter.external_ref.as_ref().map(Argument::from));
    want("batch", filter.batch_id.map(Argument::from));
    want("study", filter.study_id.map(Argument::from));
    want("created_from", filter.created_from.map(|t| t.as_millisecond().into()));
    want("created_before", filter.created_before.map(|t| t.as_millisecond().into()));
    for (i, ([tag, value], (name, text))) in TAGS.into_iter().zip(&filter.tags).enumerate() {
        values.extend([(tag, name.into()), (value, text.into())]);
        if i > 0 || !by_tag {
            wanted.push(tag);
        }
    }
    if let Some(after) = after {
        wanted.push(if newest { "after_newest" } else { "after_oldest" });
        values.push(("after_time", after.created_at_ms.into()));
        values.push(("after_id", after.id.into()));
    }
    let (created_at, id) = match by_tag {
        true => ("first_label.created_at", "first_label.job_id"),
        false => ("job_records.created_at", "job_records.id"),
    };
    let text = include_str!("queries/list_jobs.sql").replace("{created_at}", created_at).replace("{id}", id);
    let (text, names) = with_options(&text, &wanted);
    let mut arguments = Vec::new();
    for name in &names {
        let value = values.iter().find(|(n, _)| n == name).map(|(_, value)| value.clone());
        arguments.push(value.ok_or(JobError::Corrupt { what: "a list's query", source: None })?);
    }
    session.fetch(text, arguments).await?.iter().map(rows::job).collect()
}
