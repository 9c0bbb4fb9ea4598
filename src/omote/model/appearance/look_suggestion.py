"""The look that fits to a picture of skin: its colours by medians of zones, and no paint where the picture is."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.model.albedo import Light, decode_light, encode_light
from omote.model.appearance.taken_albedo import TakenAlbedo
from omote.model.cast import Look

ZONES = ("skin", "lip", "brow", "hair", "blush")
"""The colours of a look that lie on the skin."""
PLAIN: Mapping[str, float] = MappingProxyType(
    dict.fromkeys(("brows", "freckles", "stubble", "makeup", "fur", "stripes", "lacquer", "scalp"), 0.0)
)
"""Traits without which skin is painted that a picture lies on, or that a picture is carried on by."""
FEWEST = 50
"""Texels seen of a zone below which nothing is said of its colour."""
_DARK = 30.0  # percentile of the light of a brow's texels: between its hairs lies skin
_IN_ZONE = 0.6


def plain_look(look: Look, /) -> Look:
    """A look without what a picture of skin shows itself: brows, freckles, stubble, make-up, fur, shade of hair."""
    return Look(**{**vars(look), **PLAIN})


def wear_hair(look: Look, style: str, /) -> Look:
    """A look with a hair style, "" for none, and the shade on the scalp that goes with it: none on a bald head."""
    return Look(**{**vars(look), "hair_style": style, "scalp": Look().scalp if style else 0.0})


def suggest_look(look: Look, taken: TakenAlbedo, zones: Mapping[str, NDArray[Any]], /) -> Look:
    """The look of a face with a taken picture: so that what is painted, a mix or a panic is near to the picture.

    Parameters
    ----------
    look : Look
        What stays where the picture says nothing: the hair style, eyes, relief and finish.
    taken : TakenAlbedo
        The picture, and what of it was seen.
    zones : mapping of array (k, k), by a colour's name
        How much of each texel, 0 to 1, shows that colour of `ZONES`; others are ignored.

    Returns
    -------
    Look
        With the picture, the median colours of what was seen, and without that face's own painted brows, freckles,
        stubble and fur.

    Raises
    ------
    ValueError
        Where a zone has another size than the picture.
    """
    seen = taken.seen == 255
    light = decode_light(taken.albedo.pixels[..., :3])
    colours = {}
    for name in ZONES:
        zone = np.asarray(zones.get(name, np.zeros(seen.shape)))
        if zone.shape != seen.shape:
            raise ValueError(f"zone {name!r} has shape {zone.shape}; expected that of the picture, {seen.shape}")
        texels = light[seen & (zone > _IN_ZONE)]
        if len(texels) >= FEWEST:
            colours[name] = _colour(_darker(texels) if name == "brow" else texels)
    own = {trait: value for trait, value in PLAIN.items() if trait not in ("makeup", "lacquer", "scalp")}
    return Look(**{**vars(look), **colours, **own, "albedo": taken.albedo})


def _darker(texels: Light) -> Light:
    """The dark ones of texels (n, 3)."""
    shine = texels.sum(axis=1)
    return texels[shine <= np.percentile(shine, _DARK)]


def _colour(texels: Light) -> str:
    """The median of texels (n, 3) as "#rrggbb"."""
    return "#" + "".join(f"{int(code):02x}" for code in encode_light(np.median(texels, axis=0)))
