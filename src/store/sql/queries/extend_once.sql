-- extend_once
UPDATE idempotency_keys
SET expires_at = {now} + $4
WHERE tenant = $1 AND name = $2 AND token = $3 AND made IS NULL
