-- update_webhook
UPDATE webhooks
SET url = $3, states = $4, is_enabled = $5, disabled_because = NULL
WHERE id = $1 AND tenant = $2
