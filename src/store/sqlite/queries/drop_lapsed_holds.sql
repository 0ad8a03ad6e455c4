-- drop_lapsed_holds
DELETE FROM blob_holds WHERE expires_at < CAST(unixepoch('subsec') * 1000 AS INTEGER)
