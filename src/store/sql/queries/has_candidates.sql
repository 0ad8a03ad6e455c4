-- has_candidates
SELECT
    EXISTS (SELECT 1 FROM blobs WHERE is_candidate)
    OR EXISTS (SELECT 1 FROM blob_holds WHERE expires_at < {now})
