"""The face of a scan with its look: found, fitted, coloured, hair proposed; and the looks of faces of photographs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.arrays import Values
from omote.builtin.own_face import NoFaceError, fit_photographs, fit_scan
from omote.interchange.skin_texture import Canvas, decode_srgb, load_canvas, paint_skin, zones_of
from omote.model.appearance.hair_colour import find_hair_colour, find_scalp
from omote.model.appearance.look_suggestion import plain_look, suggest_look, wear_hair
from omote.model.appearance.photograph_albedo import take_photograph_albedo
from omote.model.appearance.taken_albedo import take_albedo
from omote.model.cast import Cast, Look
from omote.model.fitting.doubt import Doubt
from omote.model.fitting.find_head import HeadPlacement
from omote.model.fitting.fit_face import Fit, Follow, say_nothing
from omote.model.fitting.photographs.photograph import Photograph, PhotographCamera
from omote.model.fitting.photographs.photograph_fit import PhotographFit
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.transfer.compound import compound

FIRST_HAIR = "short"
"""What a face wears until its editor chooses."""
"""What people say for no hair."""
BALD = 0.3
"""Of the skin's linear light: where the scalp differs from the skin by less, no hair is seen; black hair on dark skin
differs by little light, but by much of it."""
FITTED = 0.7
PHOTOGRAPHS_FITTED = 0.5
"""The share of the work on a scan, and on photographs, that is done once the face is fitted."""


@dataclass(frozen=True, eq=False)
class ScanFace:
    """What came of a scan.

    place: where its head is, None where none was found; fit, look: its face, None where none could be made; failure:
    why, as a clause, "" for a face; doubts: what should be looked at; notes: what could not be taken over.
    """

    place: HeadPlacement | None
    fit: Fit | None
    look: Look | None
    doubts: tuple[Doubt, ...]
    notes: tuple[str, ...] = ()
    failure: str = ""

    @property
    def residual(self) -> NDArray[np.float64]:
        """How far the face is from the scan (V,), millimetres, nan where that shows nothing; empty without a face."""
        return np.zeros(0) if self.fit is None else self.fit.residual

    @property
    def worn(self) -> tuple[Face, Look]:
        """The face and its look; ValueError where there is none."""
        if self.fit is None or self.look is None:
            raise ValueError(f"no face was made of this scan: {self.failure}")
        return self.fit.face, self.look

    def describe(self) -> str:
        """How near the face is to the scan, in words."""
        residual = self.residual[np.isfinite(self.residual)]
        if not len(residual):
            return "nothing of it was seen"
        middle, worst = np.percentile(residual, [50, 95])
        return f"{middle:.2f} mm from the scan (95 of 100 points within {worst:.2f})"


def make_scan_face(
    cast: Cast, scan: Scan, /, *, name: str, landmarks: Mapping[str, ArrayLike], shut: bool | None = None,
    follow: Follow = say_nothing,
) -> ScanFace:  # fmt: skip
    """Finds the head in a scan, fits a face to it and takes its colours: the page, the command and imports do this.

    Parameters
    ----------
    cast : Cast
        The built-in one.
    scan : Scan
        In its own frame and unit.
    name : str
        The face's.
    landmarks : mapping of array_like (3,), by name
        As of `fit_scan`.
    shut : bool, optional
        Whether the eyes of the scan are shut; None looks.
    follow : callable
        Told how much is done, 0 to 1, and what is being done.

    Returns
    -------
    ScanFace
        With the face, or with why there is none.
    """

    def tell_fit(done: float, what: str) -> None:
        follow(FITTED * done, what)

    try:
        place, fitted = fit_scan(cast.space, scan, landmarks=landmarks, name=name, shut=shut, follow=tell_fit)
    except NoFaceError as error:
        return ScanFace(error.place, None, None, error.doubts, failure=str(error))
    follow(FITTED, "its colours")
    look, notes = suggest_scan_look(cast, load_canvas(cast.space), fitted, scan)
    return ScanFace(place, fitted, look, fitted.doubts, tuple(notes))


def suggest_scan_look(cast: Cast, canvas: Canvas, fitted: Fit, scan: Scan, /) -> tuple[Look, list[str]]:
    """The look of a face fitted to a scan before anybody has chosen, and what could not be taken over, in words.

    Parameters
    ----------
    cast : Cast
        The built-in one; of an animal the look of that from which it began is what the scan does not say.
    canvas : Canvas
        Of its skin.
    fitted : Fit
        To the scan.
    scan : Scan
        In its own frame; without colours, or on a cast without a texture, the first look stays.

    Returns
    -------
    tuple of Look and list of str
        With the scan's colours where they lie on the face; without hair where the scan shows none.
    """
    first = cast.looks.get(fitted.kind, Look(hair_style=FIRST_HAIR))
    if cast.atlas is None or (scan.colours is None and scan.texture is None):
        return first, []
    painted = paint_skin(canvas, plain_look(first))
    try:
        taken = take_albedo(cast.space, cast.atlas, fitted.face, scan, fitted.placement, painted)
    except ValueError as error:
        return first, [f"its colours were not taken over: {error}"]
    return bald_where_bare(suggest_look(first, taken, zones_of(canvas))), []


def bald_where_bare(look: Look, /) -> Look:
    """A look without hair where the scalp in its picture is as the skin is; else as it is."""
    hair = decode_srgb(look.hair)
    skin = decode_srgb(look.skin)
    if look.albedo is None or np.abs(hair - skin).max() >= BALD * skin.max():
        return look
    return wear_hair(replace(look, hair=Look().hair), "")


@dataclass(frozen=True, eq=False)
class PhotographFace:
    """A face made of photographs with its look; seen (k, k): 255 where a photograph shows a texel of its skin, 0 where
    it is filled in."""

    fit: PhotographFit
    look: Look
    seen: NDArray[np.uint8]


def make_photograph_face(
    cast: Cast, photographs: Sequence[Photograph], /, *, name: str, follow: Follow = say_nothing
) -> PhotographFace:
    """Fits a face to photographs of one person and takes their colours.

    cast: the built-in one; photographs: with their pictures; name: the face's; follow: told how much is done, 0 to 1,
    and what is being done. ValueError without photographs, and where none shows the face.
    """

    def tell_fit(done: float, what: str) -> None:
        follow(PHOTOGRAPHS_FITTED * done, what)

    fitted = fit_photographs(cast.space, photographs, name=name, follow=tell_fit)
    follow(PHOTOGRAPHS_FITTED, "its colours")
    look, seen, doubts = suggest_photograph_look(
        cast, load_canvas(cast.space), fitted.face, photographs, fitted.cameras, wear_units(cast, fitted)
    )
    return PhotographFace(replace(fitted, doubts=(*fitted.doubts, *doubts)), look, seen)


def wear_units(cast: Cast, fitted: PhotographFit, /) -> list[Values]:
    """The skin (V, 3) of a fitted face as it is in each photograph, metres: a sum of the compounds of its units.

    cast: the built-in one; fitted: with what the face does in each.
    """
    rest = fitted.face.positions.astype(np.float64)
    names = sorted({name for units in fitted.units for name in units})
    moves = {
        name: compound(cast.space, fitted.face, cast.expressions[name]).astype(np.float64) - rest for name in names
    }
    return [rest + sum((weight * moves[name] for name, weight in units.items()), np.zeros(3)) for units in fitted.units]


def suggest_photograph_look(
    cast: Cast, canvas: Canvas, face: Face, photographs: Sequence[Photograph], cameras: Sequence[PhotographCamera],
    worn: Sequence[Values] = (), /,
) -> tuple[Look, NDArray[np.uint8], tuple[str, ...]]:  # fmt: skip
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
    worn : sequence of ndarray, (V, 3)
        The skin as it is in each, metres; without them at rest.

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
    taken = take_photograph_albedo(cast.space, cast.atlas, face, photographs, cameras, painted, worn=worn)
    look = suggest_look(first, taken, zones_of(canvas))
    hair = find_hair_colour(
        cast.space, find_scalp(cast.space, cast.hair), face, photographs, cameras, look.skin
    )  # fmt: skip
    if hair.bare:
        look = wear_hair(replace(look, hair=first.hair), "")
    elif hair.colour is not None:
        look = replace(look, hair=hair.colour)
    return look, taken.seen, (hair.doubt,) if hair.doubt else ()
