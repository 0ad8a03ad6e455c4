-- blob_store_mark
SELECT text FROM facts WHERE name = 'blob_store'
