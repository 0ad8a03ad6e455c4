-- lapsed_holders
SELECT DISTINCT holder FROM blob_holds WHERE expires_at < {now} LIMIT 100
