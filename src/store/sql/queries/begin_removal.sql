-- begin_removal
UPDATE blobs SET removing_since = {now} WHERE tenant = $1 AND path = $2 RETURNING removing_since
