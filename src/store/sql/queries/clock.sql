-- clock
SELECT {now} AS present, (SELECT number FROM facts WHERE name = 'clock') AS seen
