-- forget_candidate
DELETE FROM blob_candidates WHERE tenant = ?1 AND hash = ?2
