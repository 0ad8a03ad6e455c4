-- lock_webhook_position
UPDATE counters SET value = value WHERE name = 'webhooks' RETURNING value
