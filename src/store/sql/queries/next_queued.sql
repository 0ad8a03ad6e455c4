-- next_queued
SELECT id
FROM jobs
WHERE state = 'queued' AND scheduled_at <= {now} AND (deadline_at IS NULL OR deadline_at > {now})
ORDER BY priority DESC, created_at, id
LIMIT 1
{skip_locked}
