-- next_delivery
SELECT d.id, d.webhook_id, d.event, d.payload, d.attempts, w.url, w.secret, w.is_enabled
FROM webhook_deliveries AS d
JOIN webhooks AS w ON w.id = d.webhook_id
WHERE d.state = 'pending' AND d.next_at <= {now}
ORDER BY d.next_at
LIMIT 1
