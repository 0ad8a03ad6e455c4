-- note_candidates_of_lapsed_holds
INSERT INTO blob_candidates (tenant, hash)
SELECT tenant, hash FROM blob_holds WHERE expires_at < CAST(unixepoch('subsec') * 1000 AS INTEGER)
ON CONFLICT DO NOTHING
