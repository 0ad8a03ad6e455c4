-- note_candidates_of_holder
INSERT INTO blob_candidates (tenant, hash)
SELECT tenant, hash FROM blob_holds WHERE holder = ?1
ON CONFLICT DO NOTHING
