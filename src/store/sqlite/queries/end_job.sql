-- end_job
UPDATE jobs
SET
    state = ?2,
    error = ?3,
    finished_at = CAST(unixepoch('subsec') * 1000 AS INTEGER),
    worker_id = NULL,
    lease_expires_at = NULL
WHERE id = ?1 AND state IN ('queued', 'running')
