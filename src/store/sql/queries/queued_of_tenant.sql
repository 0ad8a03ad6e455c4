-- queued_of_tenant
-- The order is that of queue_of_tenant.
SELECT id
FROM jobs
WHERE state = 'queued' AND tenant = $1 AND scheduled_at <= {now} AND (deadline_at IS NULL OR deadline_at > {now})
ORDER BY priority DESC, created_at, id
LIMIT $2
