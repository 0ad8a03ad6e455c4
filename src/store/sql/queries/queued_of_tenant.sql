-- queued_of_tenant
-- No pause is longer than a minute: a job that waits for later was scheduled by a clock that was set back since.
-- The order is that of queue_of_tenant.
SELECT id
FROM jobs
WHERE
    state = 'queued' AND tenant = $1 AND (scheduled_at <= {now} OR scheduled_at > {now} + 60000)
    AND (deadline_at IS NULL OR deadline_at > {now})
ORDER BY priority DESC, place
LIMIT $2
