-- set_blob_store_mark
INSERT INTO facts (name, text) VALUES ('blob_store', $1) ON CONFLICT (name) DO NOTHING
