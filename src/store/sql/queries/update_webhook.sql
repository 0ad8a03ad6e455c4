-- update_webhook
UPDATE webhooks
SET url = $3, states = $4, is_enabled = $5, disabled_because = NULL, failures = 0, next_at = busy_until
WHERE id = $1 AND tenant = $2
