-- has_unnumbered_changes
SELECT EXISTS (SELECT 1 FROM changes WHERE number IS NULL)
