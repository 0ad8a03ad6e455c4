-- delete_webhook
DELETE FROM webhooks WHERE id = $1 AND tenant = $2
