-- delete_job
DELETE FROM jobs WHERE id = $1
