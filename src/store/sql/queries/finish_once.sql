-- finish_once
UPDATE idempotency_keys
SET made = $4, expires_at = {now} + $5
WHERE tenant = $1 AND name = $2 AND token = $3 AND made IS NULL
