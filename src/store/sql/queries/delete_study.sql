-- delete_study
DELETE FROM studies WHERE id = $1
