-- requeue_job
UPDATE jobs
SET
    state = 'queued',
    scheduled_at = {now} + $2,
    worker_id = NULL,
    lease_expires_at = NULL,
    run_deadline_at = NULL,
    started_at = NULL
WHERE id = $1 AND state = 'running'
