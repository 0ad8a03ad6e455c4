-- delete_changes_of_job
DELETE FROM changes WHERE job_id = $1
