-- claim_job
UPDATE jobs
SET
    state = 'running',
    attempt = attempt + 1,
    lease_epoch = lease_epoch + 1,
    worker_id = $2,
    lease_expires_at = {now} + $3,
    started_at = {now},
    run_deadline_at = {now} + CASE WHEN max_run_ms < $4 THEN max_run_ms ELSE $4 END
WHERE id = $1 AND state = 'queued'
RETURNING lease_epoch
