-- expired_leases
SELECT id, crashes, max_attempts, cancel_requested
FROM jobs
WHERE state = 'running' AND lease_expires_at < {now}
ORDER BY lease_expires_at
LIMIT 500
{skip_locked}
