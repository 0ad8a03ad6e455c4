-- end_job
UPDATE jobs
SET
    state = $2,
    error = $3,
    finished_at = {now},
    expires_at = {now} + $4,
    worker_id = NULL,
    lease_expires_at = NULL,
    run_deadline_at = NULL
WHERE id = $1 AND state IN ('queued', 'running')
