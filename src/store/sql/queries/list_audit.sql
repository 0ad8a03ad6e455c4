-- list_audit
SELECT * FROM audit WHERE position > $1 ORDER BY position LIMIT $2
