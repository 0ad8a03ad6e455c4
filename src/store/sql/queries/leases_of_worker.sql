-- leases_of_worker
SELECT id, crashes, max_attempts, cancel_requested
FROM jobs
WHERE state = 'running' AND worker_id = $1
{skip_locked}
