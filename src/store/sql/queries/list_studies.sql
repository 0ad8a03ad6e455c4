-- list_studies
SELECT
    studies.*,
    (
        SELECT COUNT(*)
        FROM jobs
        WHERE jobs.study_id = studies.id AND jobs.state IN ('queued', 'running') AND jobs.method <> 'study'
    ) AS n_active
FROM studies
WHERE tenant = $1 AND ($2 IS NULL OR (created_at, id) < ($2, $3))
ORDER BY created_at DESC, id DESC
LIMIT $4
