-- insert_webhook
INSERT INTO webhooks (id, tenant, url, states, secret, created_at) VALUES ($1, $2, $3, $4, $5, {now})
