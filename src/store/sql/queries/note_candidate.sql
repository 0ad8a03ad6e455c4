-- note_candidate
UPDATE blobs SET is_candidate = TRUE WHERE tenant = $1 AND path = $2
