-- note_clock
INSERT INTO facts (name, number) VALUES ('clock', {now}) ON CONFLICT (name) DO UPDATE SET number = excluded.number
