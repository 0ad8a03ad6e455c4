-- count_old_once
SELECT COUNT(*) FROM idempotency_keys WHERE expires_at < {now}
