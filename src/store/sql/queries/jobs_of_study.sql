-- jobs_of_study
SELECT id, state FROM jobs WHERE study_id = $1 ORDER BY id {for_update}
