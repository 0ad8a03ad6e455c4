-- webhooks_to_tell
SELECT id, states FROM webhooks WHERE tenant = $1 AND is_enabled
