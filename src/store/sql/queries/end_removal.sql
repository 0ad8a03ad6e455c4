-- end_removal
DELETE FROM blobs WHERE tenant = $1 AND path = $2 AND removing_since = $3
