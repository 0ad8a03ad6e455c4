-- webhook_secrets
SELECT id, secret FROM webhooks
