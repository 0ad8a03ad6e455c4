-- due_deliveries
-- What was never attempted comes before what failed: a change does not wait behind the retries of others.
SELECT id, payload, attempts, traceparent
FROM webhook_deliveries
WHERE webhook_id = $1 AND state = 'pending' AND next_at <= {now}
ORDER BY CASE WHEN attempts = 0 THEN 0 ELSE 1 END, next_at, id
LIMIT $2
