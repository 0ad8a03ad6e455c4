-- expired_leases
SELECT id, crashes, max_attempts, cancel_requested
FROM jobs
WHERE state = 'running' AND lease_expires_at < CAST(unixepoch('subsec') * 1000 AS INTEGER)
