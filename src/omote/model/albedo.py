"""The picture of a certain person on the skin: its colours, and how far they stand in place of what is painted."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.geometry.texture import paint
from omote.model.space.head_regions import Region, region_weights
from omote.model.space.parameter_space import ParameterSpace

SIDES = (1024, 2048)
"""Texels along a side: a stage holds 1.3 times 4 bytes a texel of each picture on air, 5.6 or 22 MB."""
_NEXT_TO_NOTHING = 1e-3  # coverage with which colours that are not seen still count: filters reach them at the edges

Light = NDArray[np.float32]


@dataclass(frozen=True, eq=False, repr=False)
class Albedo:
    """A picture on the texture coordinates that all faces share; two with the same texels are equal.

    Parameters
    ----------
    pixels : array of uint8, (k, k, 4)
        k is 1024 or 2048; sRGB, then the coverage: 255 where the picture stands in place of the painted skin, 0 where
        the painted skin shows. Row 0 is the top, as in glTF.

    Raises
    ------
    ValueError
        On another shape or type.
    """

    pixels: NDArray[np.uint8]

    def __post_init__(self) -> None:
        pixels = np.asarray(self.pixels)
        if pixels.dtype != np.uint8 or pixels.shape not in [(side, side, 4) for side in SIDES]:
            raise ValueError(
                f"a picture of skin has shape {pixels.shape} of {pixels.dtype}; expected (1024, 1024, 4) or "
                "(2048, 2048, 4) of uint8: sRGB and coverage"
            )
        kept = np.ascontiguousarray(pixels)
        kept = kept.copy() if kept.flags.writeable else kept
        kept.setflags(write=False)
        object.__setattr__(self, "pixels", kept)

    @cached_property
    def digest(self) -> str:
        """A name for exactly these texels, hexadecimal."""
        return hashlib.blake2b(self.pixels.data, digest_size=12).hexdigest()

    @cached_property
    def cover(self) -> float:
        """The mean coverage, 0 to 1."""
        return float(self.pixels[..., 3].mean(dtype=np.float64)) / 255.0

    @property
    def side(self) -> int:
        """Texels along a side."""
        return len(self.pixels)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Albedo) and (self is other or self.digest == other.digest)

    def __hash__(self) -> int:
        return hash(self.digest)

    def __repr__(self) -> str:
        return f"Albedo({self.side}, {self.digest})"


@dataclass(frozen=True, eq=False)
class SkinAtlas:
    """How the skin lies on its texture: source (k,) rows of the skin, uv (k, 2) from the upper left corner, triangles
    (t, 3) of those k."""

    source: NDArray[np.integer]
    uv: NDArray[np.floating]
    triangles: NDArray[np.integer]

    def spread(self, values: NDArray[np.floating], side: int, /) -> Values:
        """Paints values (V,) of the skin's vertices on the texture, (side, side)."""
        return paint(np.asarray(values)[self.source], self.uv, self.triangles, side)


Share = float | Light


@lru_cache(maxsize=4)
def mix_albedos(shares: Sequence[tuple[Albedo | None, float]], /) -> Albedo | None:
    """Mixes pictures by shares that sum to one (a tuple of them), in linear light; None where no face has one.

    None in the sum is a face without a picture: what is painted on it shows by its share. The last results stay.
    """
    shown = [(albedo, share) for albedo, share in shares if albedo is not None and share > 0.0]
    if not shown:
        return None
    if len(shown) == 1 and shown[0][1] >= 1.0 - 1e-9:
        return shown[0][0]
    return _blend(shown)


@lru_cache(maxsize=4)
def regional_albedo(
    space: ParameterSpace, atlas: SkinAtlas, rest: Albedo | None, chosen: tuple[tuple[Region, Albedo | None], ...], /
) -> Albedo | None:
    """The picture of a face with each chosen region from another one, smooth at the borders; None where no face has
    one. The last results stay.

    space: the space of the generic head; atlas: how the skin lies on its picture; rest: the picture of the face
    itself, None for none.
    """
    pictures = {albedo for albedo in (rest, *dict(chosen).values()) if albedo is not None}
    if not pictures or all(albedo == rest for _, albedo in chosen):
        return rest
    side = max(albedo.side for albedo in pictures)
    masks = _region_masks(space, atlas, [region for region, _ in chosen], side)
    shares: list[tuple[Albedo, Share]] = [(albedo, masks[region]) for region, albedo in chosen if albedo is not None]
    if rest is not None:
        shares.append((rest, 1.0 - sum(masks.values(), np.zeros((side, side), np.float32))))
    return _blend(shares)


def _region_masks(
    space: ParameterSpace, atlas: SkinAtlas, regions: Sequence[Region], side: int
) -> Mapping[Region, Light]:
    weights = region_weights(space)
    return {region: atlas.spread(weights[region], side).astype(np.float32) for region in regions}


def _blend(shares: Sequence[tuple[Albedo, Share]]) -> Albedo:
    """Colours by their coverage and share, coverage by its share."""
    side = max(albedo.side for albedo, _ in shares)
    light = np.zeros((side, side, 3), np.float32)
    covered = np.zeros((side, side), np.float32)
    weight = np.zeros((side, side), np.float32)
    for albedo, share in shares:
        times = side // albedo.side
        texels = albedo.pixels.repeat(times, axis=0).repeat(times, axis=1) if times > 1 else albedo.pixels
        coverage = texels[..., 3].astype(np.float32) / np.float32(255.0)
        own = np.asarray(share, np.float32) * (coverage + np.float32(_NEXT_TO_NOTHING))
        light += own[..., None] * _LINEAR[texels[..., :3]]
        weight += own
        covered += np.asarray(share, np.float32) * coverage
    colours = encode_light(light / np.maximum(weight, 1e-6)[..., None])
    alpha = np.rint(255.0 * np.minimum(covered, 1.0)).astype(np.uint8)
    return Albedo(np.concatenate([colours, alpha[..., None]], axis=2))


def _decoded() -> Light:
    code = np.arange(256) / 255.0
    return np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4).astype(np.float32)


_LINEAR = _decoded()


def decode_light(colours: NDArray[np.uint8], /) -> Light:
    """The linear light of sRGB colours (IEC 61966-2-1), 0 to 1, in the same shape."""
    return _LINEAR[colours]


def encode_light(light: NDArray[np.floating], /) -> NDArray[np.uint8]:
    """The sRGB colours of linear light; beyond 1 is white."""
    seen = np.minimum(np.maximum(light, np.float32(0.0)), np.float32(1.0))
    code = np.where(seen <= 0.0031308, 12.92 * seen, 1.055 * seen ** np.float32(1 / 2.4) - 0.055)
    return np.rint(255.0 * code).astype(np.uint8)
