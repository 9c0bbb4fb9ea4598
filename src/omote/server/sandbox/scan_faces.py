"""Finds, fits and colours the faces of scans in a child process with limits; what comes back is validated again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import msgspec
from numpy.typing import ArrayLike

from omote.builtin.own_face import NoFaceError, fit_scan
from omote.interchange.scan_face import PhotographFace, ScanFace, make_photograph_face, make_scan_face
from omote.model.cast import Cast
from omote.model.extraction.extracted_expression import ExtractedExpression, describe_uncertainty
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.scan import Scan
from omote.model.fitting.take_expressions import take_expressions
from omote.model.space.face_fit import fit
from omote.model.transfer.paper_map import refuse_foreign
from omote.server.sandbox.child_task import Limits, Tell, ignore_progress, run_limited

LIMITS = Limits(seconds=900, patience=7200.0, memory=6 * 2**30, files=64, writes=True)
_TOO_MUCH = "fitting a face to it needs more time or memory than any head; export the head alone, with fewer points"

Landmarks = Mapping[str, ArrayLike]


class TakenShapes(msgspec.Struct, frozen=True):
    """The shapes of a scan as expressions, each with how far it may be off on other faces, in words ("": nowhere); and
    sentences about the fit and about shapes that are no expressions."""

    expressions: dict[str, tuple[ExtractedExpression, str]]
    notes: list[str]


def fit_in_child(
    cast: Cast, scan: Scan, /, *, name: str, landmarks: Landmarks, shut: bool | None = None,
    follow: Tell = ignore_progress,
) -> ScanFace:  # fmt: skip
    """Makes a face of a scan as `make_scan_face`, with its parameters; follow: told the progress.

    ValueError with a sentence where it takes too much, and for what is no face of this cast's space.

    cast, scan, name, landmarks, shut: as of `make_scan_face`.
    """

    def work(tell: Tell) -> ScanFace:
        return make_scan_face(cast, scan, name=name, landmarks=landmarks, shut=shut, follow=tell)

    scan_face = run_limited(work, ScanFace, LIMITS, exhausted=_TOO_MUCH, follow=follow)
    if scan_face.fit is not None:
        fit(cast.space, scan_face.fit.face)  # refuses what is no face of this space
        if not len(scan_face.fit.residual) == len(scan_face.fit.seen) == cast.space.vertex_count:
            raise ValueError(
                f"a fit brought back {len(scan_face.fit.residual)} distances; expected {cast.space.vertex_count}"
            )
    return scan_face


def fit_photographs_in_child(
    cast: Cast, photographs: Sequence[Photograph], /, *, name: str, follow: Tell = ignore_progress
) -> PhotographFace:
    """Makes a face of photographs as `make_photograph_face`, with its parameters; ValueError as `fit_in_child`.

    cast, photographs, name: as of `make_photograph_face`; follow: told the progress.
    """

    def work(tell: Tell) -> PhotographFace:
        return make_photograph_face(cast, photographs, name=name, follow=tell)

    face = run_limited(work, PhotographFace, LIMITS, exhausted=_TOO_MUCH, follow=follow)
    fit(cast.space, face.fit.face)  # refuses what is no face of this space
    return face


def take_in_child(
    cast: Cast, scan: Scan, /, *, name: str, landmarks: Landmarks, advice: str, follow: Tell = ignore_progress
) -> TakenShapes:
    """Takes the shapes of a scan as expressions, from the face that `fit_in_child` makes of it.

    cast: the built-in one; scan: with shapes; name: the face's, at most 80 letters of it; landmarks: as of `fit_scan`;
    advice: what ends doubts about where the head is; follow: told the progress. ValueError where that is not sure, for
    nobody looks at this fit, and all faces would wear what was read off a fox's shoulder.
    """

    def work(tell: Tell) -> TakenShapes:
        try:
            place, fitted = fit_scan(cast.space, scan, landmarks=landmarks, name=name[:80], follow=tell)
        except NoFaceError as error:
            raise ValueError(f"{str(error).rstrip('.')}. {advice}") from error
        if place.doubts:
            raise ValueError(f"{' '.join(place.doubts)} {advice}")
        taken = take_expressions(cast.space, fitted, scan)
        described = {
            name: (expression, describe_uncertainty(cast.space, expression))
            for name, expression in taken.expressions.items()
        }
        return TakenShapes(described, [*map(str, fitted.doubts), *taken.notes])

    taken = run_limited(work, TakenShapes, LIMITS, exhausted=_TOO_MUCH, follow=follow)
    for expression, _ in taken.expressions.values():
        refuse_foreign(cast.space, expression)
    return taken
