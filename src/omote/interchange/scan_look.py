"""The look of a face that was fitted to a scan: the scan's own picture on its skin, and colours that go with it."""

from __future__ import annotations

from omote.interchange.skin_texture import Canvas, paint_skin, zones_of
from omote.model.appearance.look_suggestion import plain_look, suggest_look
from omote.model.appearance.taken_albedo import take_albedo
from omote.model.cast import Cast, Look
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.similarity import Similarity


def find_look(cast: Cast, canvas: Canvas, face: Face, scan: Scan, placement: Similarity, look: Look, /) -> Look:
    """The look of a face fitted to a scan.

    Parameters
    ----------
    cast : Cast
        The built-in one.
    canvas : Canvas
        Of its skin.
    face : Face
        Fitted to the scan.
    scan : Scan
        In its own frame.
    placement : Similarity
        From the scan to the face.
    look : Look
        What the scan does not say: hair, eyes, finish.

    Returns
    -------
    Look
        With the scan's colours; `look` itself where the scan has none, or the cast no texture for them.

    Raises
    ------
    ValueError
        Where the colours lie nowhere on the face.
    """
    if cast.atlas is None or (scan.colours is None and scan.texture is None):
        return look
    painted = paint_skin(canvas, plain_look(look))
    taken = take_albedo(cast.space, cast.atlas, face, scan, placement, painted)
    return suggest_look(look, taken, zones_of(canvas))
