-- drop_hold
DELETE FROM blob_holds WHERE holder = $1
