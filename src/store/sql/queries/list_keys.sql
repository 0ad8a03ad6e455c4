-- list_keys
SELECT *, (revoked_at IS NULL AND (expires_at IS NULL OR expires_at > {now})) AS is_valid FROM api_keys ORDER BY created_at, id
