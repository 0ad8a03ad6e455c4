-- note_candidates_of_holder
UPDATE blobs
SET is_candidate = TRUE
WHERE (tenant, path) IN (SELECT tenant, path FROM blob_holds WHERE holder = $1)
