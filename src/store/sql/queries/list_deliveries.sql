-- list_deliveries
SELECT *
FROM webhook_deliveries
WHERE webhook_id = $1 AND ($2 IS NULL OR (created_at, id) < ($2, $3))
ORDER BY created_at DESC, id DESC
LIMIT $4
