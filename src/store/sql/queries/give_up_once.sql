-- give_up_once
DELETE FROM idempotency_keys WHERE tenant = $1 AND name = $2 AND token = $3 AND made IS NULL
