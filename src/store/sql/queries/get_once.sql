-- get_once
SELECT fingerprint, token, made FROM idempotency_keys WHERE tenant = $1 AND name = $2
