-- first_unnumbered_change
SELECT MIN(seq) FROM changes WHERE number IS NULL AND seq IS NOT NULL
