-- insert_ticket
INSERT INTO tickets (hash, tenant, key_id, path, expires_at)
SELECT CAST($1 AS TEXT), CAST($2 AS TEXT), CAST($3 AS TEXT), CAST($4 AS TEXT), {now} + $5
WHERE (SELECT COUNT(*) FROM tickets WHERE tenant = $2 AND expires_at > {now}) < $6
