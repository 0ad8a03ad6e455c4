-- insert_key
INSERT INTO api_keys (id, tenant, name, hash, scopes, created_at, expires_at) VALUES ($1, $2, $3, $4, $5, {now}, {now} + $6)
