"""The look of a face that was fitted to photographs: their picture on its skin, colours and hair that go with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.interchange.scan_look import FIRST_HAIR
from omote.interchange.skin_texture import Canvas, paint_skin, zones_of
from omote.model.appearance.hair_colour import find_hair_colour, find_scalp
from omote.model.appearance.look_suggestion import plain_look, suggest_look, wear_hair
from omote.model.appearance.photograph_albedo import take_photograph_albedo
from omote.model.cast import Cast, Look
from omote.model.fitting.photographs.photograph import Photograph
from omote.model.fitting.photographs.photograph_camera import PhotographCamera
from omote.model.space.face import Face


def suggest_photograph_look(
    cast: Cast, canvas: Canvas, face: Face, photographs: Sequence[Photograph], cameras: Sequence[PhotographCamera], /
) -> tuple[Look, NDArray[np.uint8], tuple[str, ...]]:
    """The look of a face fitted to photographs before anybody has chosen, what of it was seen, and doubts.

    Parameters
    ----------
    cast : Cast
        The built-in one, with a texture.
    canvas : Canvas
        Of its skin.
    face : Face
        Fitted to the photographs.
    photographs : sequence of Photograph
        With their pictures.
    cameras : sequence of PhotographCamera
        Of each.

    Returns
    -------
    tuple of Look, array of uint8 (k, k) and doubts
        With the photographs' colours and the colour of their hair, none on a bald head; 255 where a photograph shows
        the skin, 0 where it is filled in; what is not known of the hair, in sentences.

    Raises
    ------
    ValueError
        Where the cast has no texture, and where no photograph shows the face.
    """
    if cast.atlas is None:
        raise ValueError("this cast has no texture on which photographs could lie; expected the built-in one")
    first = Look(hair_style=FIRST_HAIR)
    painted = paint_skin(canvas, plain_look(first))
    taken = take_photograph_albedo(cast.space, cast.atlas, face, photographs, cameras, painted)
    look = suggest_look(first, taken, zones_of(canvas))
    hair = find_hair_colour(
        cast.space, find_scalp(cast.space, cast.hair), face, photographs, cameras, look.skin
    )  # fmt: skip
    if hair.bare:
        look = wear_hair(replace(look, hair=first.hair), "")
    elif hair.colour is not None:
        look = replace(look, hair=hair.colour)
    return look, taken.seen, (hair.doubt,) if hair.doubt else ()
