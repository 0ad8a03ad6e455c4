-- lock_study
SELECT state, revision FROM studies WHERE id = $1 AND tenant = $2 {for_update}
