"""Dense correspondence and rigid registration of anatomical surfaces.

    import homolog
    match = homolog.match("source.nii.gz", "target.nii.gz")
    match.reliable, match.transform, match.correspondences, match.warped

Works with a running service (``HOMOLOG_URL``, ``HOMOLOG_KEY`` or :class:`Service`), else with one of its own, which it starts
from the program in this package and which ends with the process.
"""

from ._client.models import JobDocument, ProblemDocument, ResultDocument
from ._face import default_service, match, match_async, match_many, match_many_async, study, study_async
from ._inputs import Surface
from ._match import Match, Matches, Mesh, Study
from ._service import HomologError, Service

__all__ = [
    "HomologError", "JobDocument", "Match", "Matches", "Mesh", "ProblemDocument", "ResultDocument", "Service", "Study", "Surface",
    "default_service", "match", "match_async", "match_many", "match_many_async", "study", "study_async",
]
