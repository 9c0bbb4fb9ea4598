"""The look of a face that was fitted to a scan: the scan's own picture on its skin, and colours that go with it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from omote.interchange.skin_texture import Canvas, decode_srgb, paint_skin, zones_of
from omote.model.appearance.look_suggestion import plain_look, suggest_look, wear_hair
from omote.model.appearance.taken_albedo import take_albedo
from omote.model.cast import Cast, Look
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.similarity import Similarity

FIRST_HAIR = "short"
"""What a face wears until its editor chooses."""
NO_HAIR = "none"
"""What people say for no hair."""
BALD = 0.3
"""Of the skin's linear light: where the scalp differs from the skin by less, no hair is seen; black hair on dark skin
differs by little light, but by much of it."""


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


def suggest_scan_look(
    cast: Cast, canvas: Canvas, fitted: Fit, scan: Scan, /
) -> tuple[Look, list[str]]:  # fmt: skip
    """The look of a face fitted to a scan before anybody has chosen, and what could not be taken over, in words; a
    scan without hair makes a face without, an animal has the fur of that from which it began. fitted: to the
    scan; else as `find_look`."""
    face, placement = fitted.face, fitted.placement
    first = cast.looks.get(fitted.kind, Look(hair_style=FIRST_HAIR))
    try:
        look = find_look(cast, canvas, face, scan, placement, first)
    except ValueError as error:
        return first, [f"its colours were not taken over: {error}"]
    return bald_where_bare(look), []


def bald_where_bare(look: Look, /) -> Look:
    """A look without hair where the scalp in its picture is as the skin is; else as it is."""
    hair, skin = decode_srgb(look.hair), decode_srgb(look.skin)
    if look.albedo is None or np.abs(hair - skin).max() >= BALD * skin.max():
        return look
    return wear_hair(replace(look, hair=Look().hair), "")


def choose_hair(cast: Cast, word: str, /) -> str | None:
    """The hair style that a word names, "" for none, None where no word is given; ValueError for another word."""
    if word.lower() == NO_HAIR or not word:
        return "" if word else None
    if word not in cast.hair:
        raise ValueError(f"there is no hair {word!r}; choose one of {', '.join(cast.hair)}, or {NO_HAIR}")
    return word
