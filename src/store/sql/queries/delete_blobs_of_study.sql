-- delete_blobs_of_study
DELETE FROM study_blobs WHERE study_id = $1
