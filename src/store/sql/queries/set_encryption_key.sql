-- set_encryption_key
INSERT INTO encryption (one, key_id) VALUES (1, $1) ON CONFLICT (one) DO UPDATE SET key_id = excluded.key_id
