-- get_webhook
SELECT * FROM webhooks WHERE id = $1 AND tenant = $2
