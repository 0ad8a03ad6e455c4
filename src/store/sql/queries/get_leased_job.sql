-- get_leased_job
SELECT * FROM job_records WHERE id = $1
