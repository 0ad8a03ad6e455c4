-- job_state
SELECT state FROM jobs WHERE id = $1 AND tenant = $2
