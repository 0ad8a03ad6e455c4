-- enabled_webhooks
SELECT id, states FROM webhooks WHERE tenant = $1 AND is_enabled
