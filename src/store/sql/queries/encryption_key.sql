-- encryption_key
SELECT key_id FROM encryption
