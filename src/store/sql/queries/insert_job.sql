-- insert_job
INSERT INTO jobs (
    id, tenant, state, method, method_version, parameters, source, target, priority, labels, external_ref,
    max_attempts, deadline_at, max_run_ms, retry_of, batch_id, cache_key, traceparent, study_id,
    study_task, created_at, scheduled_at
)
VALUES ($1, $2, 'queued', $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, $13, $14, $15, $16, $17, $18, $19, {now}, {now})
