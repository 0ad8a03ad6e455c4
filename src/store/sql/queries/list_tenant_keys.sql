-- list_tenant_keys
SELECT *, (revoked_at IS NULL AND (expires_at IS NULL OR expires_at > {now})) AS is_valid
FROM api_keys
WHERE tenant = $1 AND ($2 IS NULL OR (created_at, id) < ($2, $3))
ORDER BY created_at DESC, id DESC
LIMIT $4
