-- expired_leases
SELECT id, crashes, max_attempts, cancel_requested
FROM jobs
-- A lease of more than a day was given by a clock that was set back since; whoever holds it renews it within seconds.
WHERE state = 'running' AND (lease_expires_at < {now} OR lease_expires_at > {now} + 86400000)
ORDER BY lease_expires_at
LIMIT 500
{skip_locked}
