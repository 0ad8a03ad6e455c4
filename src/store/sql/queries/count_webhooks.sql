-- count_webhooks
SELECT COUNT(*) FROM webhooks WHERE tenant = $1
