-- lock_queued
SELECT id, tenant
FROM jobs
WHERE
    id = $1 AND state = 'queued' AND (scheduled_at <= {now} OR scheduled_at > {now} + 60000)
    AND (deadline_at IS NULL OR deadline_at > {now})
{skip_locked}
