-- insert_study
INSERT INTO studies (
    id, tenant, state, method, method_version, n_subjects, priority, labels, external_ref, max_attempts, max_queued,
    max_run_ms, traceparent, created_at
)
VALUES ($1, $2, 'queued', $3, $4, $5, $6, $7, $8, $9, $10, $11, $12, {now})
