-- queue_of_tenant
SELECT id, parameters, source, target, {now} - scheduled_at AS waited_ms
FROM jobs
WHERE state = 'queued' AND tenant = $1 AND scheduled_at <= {now} AND (deadline_at IS NULL OR deadline_at > {now})
ORDER BY priority DESC, created_at, id
LIMIT $2
