-- get_job
SELECT * FROM job_records WHERE id = $1 AND tenant = $2 AND method <> 'study'
