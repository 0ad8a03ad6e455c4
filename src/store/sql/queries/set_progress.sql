-- set_progress
INSERT INTO job_progress (job_id, fraction, phase, iteration, message, energy_latest)
VALUES ($1, $2, $3, $4, $5, $6)
ON CONFLICT (job_id) DO UPDATE SET
    fraction = CASE WHEN job_progress.fraction > excluded.fraction THEN job_progress.fraction ELSE excluded.fraction END,
    phase = excluded.phase,
    iteration = excluded.iteration,
    message = excluded.message,
    energy_latest = excluded.energy_latest
