-- claim_job
UPDATE jobs
SET
    state = 'running',
    attempt = attempt + 1,
    lease_epoch = lease_epoch + 1,
    worker_id = ?2,
    lease_expires_at = CAST(unixepoch('subsec') * 1000 AS INTEGER) + ?3,
    started_at = CAST(unixepoch('subsec') * 1000 AS INTEGER)
WHERE id = ?1 AND state = 'queued'
