-- What the service remembers of itself: the last time it saw, and the mark of its blob store.
CREATE TABLE facts (
    name   TEXT COLLATE "C" PRIMARY KEY,
    number BIGINT,
    text   TEXT
);

-- The place of a job in the queue: by when it came, whatever the clock said.
CREATE SEQUENCE job_places;
ALTER TABLE jobs ADD COLUMN place BIGINT;
UPDATE jobs SET place = placed.place
FROM (SELECT id, ROW_NUMBER() OVER (ORDER BY created_at, id) AS place FROM jobs) AS placed
WHERE placed.id = jobs.id;
SELECT setval('job_places', (SELECT COALESCE(MAX(place), 0) + 1 FROM jobs));
ALTER TABLE jobs ALTER COLUMN place SET DEFAULT nextval('job_places');
ALTER SEQUENCE job_places OWNED BY jobs.place;

DROP INDEX jobs_queue_of_tenant;
CREATE INDEX jobs_queue_of_tenant ON jobs (tenant, priority DESC, place) WHERE state = 'queued';
