-- get_study
SELECT
    studies.*,
    (
        SELECT COUNT(*)
        FROM jobs
        WHERE jobs.study_id = studies.id AND jobs.state IN ('queued', 'running') AND jobs.method <> 'study'
    ) AS n_active
FROM studies
WHERE id = $1 AND tenant = $2
