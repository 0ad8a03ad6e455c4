-- note_candidates_of_study_blob
UPDATE blobs
SET is_candidate = TRUE
WHERE (tenant, path) IN (SELECT tenant, path FROM study_blobs WHERE study_id = $1 AND name = $2 AND path <> $3)
