-- keep_blob
UPDATE blobs SET is_candidate = FALSE, removing_since = NULL WHERE tenant = $1 AND path = $2
