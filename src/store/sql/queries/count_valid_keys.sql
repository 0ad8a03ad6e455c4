-- count_valid_keys
SELECT COUNT(*) FROM api_keys
WHERE tenant = $1 AND revoked_at IS NULL AND (expires_at IS NULL OR expires_at > {now})
