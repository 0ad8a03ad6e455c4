-- insert_audit
INSERT INTO audit (position, at, tenant, key_id, action, resource, address, status, hash)
VALUES ($1, $2, $3, $4, $5, $6, $7, $8, $9)
