-- list_webhooks
SELECT *
FROM webhooks
WHERE tenant = $1 AND ($2 IS NULL OR (created_at, id) < ($2, $3))
ORDER BY created_at DESC, id DESC
LIMIT $4
