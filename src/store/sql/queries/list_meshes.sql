-- list_meshes
SELECT *
FROM meshes
WHERE tenant = $1 AND ($2 IS NULL OR (created_at, hash) < ($2, $3))
ORDER BY created_at DESC, hash DESC
LIMIT $4
