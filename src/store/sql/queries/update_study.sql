-- update_study
UPDATE studies
SET
    state = $3,
    step_id = $4,
    round = $5,
    n_before = $6,
    n_tasks = $7,
    n_made = $8,
    n_subjects = $9,
    error = $10,
    finished_at = CASE WHEN $11 THEN {now} END,
    expires_at = CASE WHEN $11 THEN {now} + $12 END,
    revision = revision + 1
WHERE id = $1 AND revision = $2 AND purged_at IS NULL
