-- begin_once
INSERT INTO idempotency_keys (tenant, name, fingerprint, token, expires_at)
VALUES ($1, $2, $3, $4, {now} + $5)
ON CONFLICT (tenant, name) DO UPDATE SET
    fingerprint = excluded.fingerprint, token = excluded.token, made = NULL, expires_at = excluded.expires_at
WHERE idempotency_keys.expires_at < {now}
