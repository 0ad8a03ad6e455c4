-- copy_progress
INSERT INTO job_progress (job_id, fraction, phase, iteration, message, energy_latest)
SELECT $1, fraction, phase, iteration, message, energy_latest FROM job_progress WHERE job_id = $2
