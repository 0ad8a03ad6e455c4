-- has_webhooks
SELECT EXISTS (SELECT 1 FROM webhooks)
