-- number_changes
WITH fresh AS (
    SELECT id, ROW_NUMBER() OVER (ORDER BY id) AS place FROM changes WHERE seq IS NULL ORDER BY id LIMIT 10000
)
UPDATE changes SET seq = $1 + fresh.place FROM fresh WHERE changes.id = fresh.id
