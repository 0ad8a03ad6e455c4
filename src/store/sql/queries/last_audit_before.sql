-- last_audit_before
SELECT position, hash
FROM audit
WHERE position < $2 AND position < (SELECT COALESCE(MIN(position), $2) FROM audit WHERE at >= $1)
ORDER BY position DESC
LIMIT 1
