-- disable_webhook
UPDATE webhooks SET is_enabled = FALSE, disabled_because = $2 WHERE id = $1
