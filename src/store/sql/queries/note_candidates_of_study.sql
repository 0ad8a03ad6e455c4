-- note_candidates_of_study
UPDATE blobs
SET is_candidate = TRUE
WHERE (tenant, path) IN (SELECT tenant, path FROM study_blobs WHERE study_id = $1)
