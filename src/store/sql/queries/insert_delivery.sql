-- insert_delivery
INSERT INTO webhook_deliveries (id, webhook_id, tenant, event, payload, traceparent, state, next_at, wait_ms, created_at)
VALUES ($1, $2, $3, $4, $5, $6, 'pending', {now}, 0, {now})
