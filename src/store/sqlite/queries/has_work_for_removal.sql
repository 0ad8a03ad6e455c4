-- has_work_for_removal
SELECT
    EXISTS (SELECT 1 FROM blob_candidates)
    OR EXISTS (SELECT 1 FROM blob_holds WHERE expires_at < CAST(unixepoch('subsec') * 1000 AS INTEGER))
