-- note_worker
INSERT INTO workers (name, seen_at) VALUES ($1, {now}) ON CONFLICT (name) DO UPDATE SET seen_at = excluded.seen_at
