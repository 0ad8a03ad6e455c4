-- lock_matches_of_study
SELECT id FROM jobs WHERE study_id = $1 AND state = 'succeeded' ORDER BY id {for_update}
