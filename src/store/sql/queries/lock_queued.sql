-- lock_queued
SELECT id, tenant
FROM jobs
WHERE id = $1 AND state = 'queued' AND scheduled_at <= {now} AND (deadline_at IS NULL OR deadline_at > {now})
{skip_locked}
