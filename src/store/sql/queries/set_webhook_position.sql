-- set_webhook_position
UPDATE counters SET value = $1 WHERE name = 'webhooks'
