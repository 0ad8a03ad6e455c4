-- next_webhook
-- The webhook that was served longest ago, of those with deliveries that are due; of a tenant, at most $1 at the same time.
SELECT w.id
FROM webhooks AS w
WHERE
    w.next_at <= {now}
    AND EXISTS (
        SELECT 1 FROM webhook_deliveries AS d WHERE d.webhook_id = w.id AND d.state = 'pending' AND d.next_at <= {now}
    )
    AND (SELECT COUNT(*) FROM webhooks AS busy WHERE busy.tenant = w.tenant AND busy.busy_until > {now}) < $1
ORDER BY w.served_at, w.id
LIMIT 1
