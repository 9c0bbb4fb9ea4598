"""Paints the skin's albedo texture: what the stage's skin shader (skin_colour_shaders.ts) computes, without light."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Picture, Points
from omote.builtin import BakedMesh, load_mask, load_meshes
from omote.geometry.ramp import clamp_unit, smooth_ramp
from omote.geometry.texture import paint
from omote.interchange.formats.png import read_png
from omote.model.albedo import decode_light, encode_light
from omote.model.cast import Look
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[Any]

LAYERS = ("mask", "marks", "patches", "relief", "finish", "pelt", "level_folds", "upright_folds")
LINING = (0.62, 0.16, 0.14)  # linear light, of the inside of mouth and nostrils
RIM = 0.22  # of the brows' colour, the dark skin along lids and lips under fur

# Angle from straight ahead, radians, and the height where hair begins, metres over the eyes.
HAIRLINE = np.array(
    [(0, 0.079), (0.35, 0.077), (0.6, 0.071), (0.76, 0.06), (0.9, 0.04), (1.02, 0.02), (1.12, 0.0), (1.24, -0.006),
     (1.34, 0.008), (1.6, 0.022), (1.9, 0.0), (2.2, -0.045), (3.2, -0.07)]
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Canvas:
    """What the textures of all faces share: the skin's layers by name (k, k, 4), 0..1, and its hair (k, k)."""

    layers: dict[str, Values]
    hair: Values


def load_canvas(space: ParameterSpace, /) -> Canvas:
    """The canvas of the built-in cast's skin."""
    return build_canvas(read_png(load_mask()), load_meshes()[0], space.points)


def build_canvas(layers: Picture, skin: BakedMesh, generic: Points) -> Canvas:
    """Builds the canvas of a cast from layers (8k, k, 4), as the bake paints them, the skin's mesh and the generic face
    (V, 3)."""
    size = layers.shape[1]
    parts = layers.reshape(len(LAYERS), size, size, 4).astype(np.float32) / np.float32(255.0)
    hair = paint(hairline(generic)[skin.source], skin.uv, skin.triangles, size)
    return Canvas(dict(zip(LAYERS, parts, strict=True)), hair.astype(np.float32))


def hairline(points: Points) -> Points:
    """How much hair grows at points (n, 3) of the generic face, 0..1."""
    x, y, z = points.T
    height = np.interp(np.abs(np.arctan2(x, z - 0.03)), HAIRLINE[:, 0], HAIRLINE[:, 1])
    ear = np.where(y < 0.026, smooth_ramp(0.0, 1.0, (np.abs(x) - 0.0745) / 0.006), 0.0)
    return smooth_ramp(0.0, 1.0, (y - height) / 0.024 + 0.5) * (1.0 - ear)


def paint_skin(canvas: Canvas, look: Look) -> Picture:
    """Paints the skin (k, k, 3) of a look, sRGB, with the picture on it where it has one; k is the larger of the two's
    sides.

    canvas: of the cast; look: whose colours.
    """
    if look.albedo is None:
        return encode_light(_albedo(canvas, look))
    side = max(look.albedo.side, len(canvas.hair))
    at = enlarge(canvas, side // len(canvas.hair))
    painted = _albedo(at, look)
    return encode_light(_pictured(at, look, painted, side // look.albedo.side))


def enlarge(canvas: Canvas, times: int) -> Canvas:
    """A canvas with each texel as times by times of them."""
    if times <= 1:
        return canvas
    layers = {name: layer.repeat(times, axis=0).repeat(times, axis=1) for name, layer in canvas.layers.items()}
    return Canvas(layers, canvas.hair.repeat(times, axis=0).repeat(times, axis=1))


def zones_of(canvas: Canvas) -> dict[str, Values]:
    """Where each colour of a look shows on the skin, (k, k) 0..1 by its name; skin: cheeks, temples and forehead."""
    mask = canvas.layers["mask"]
    marked = np.maximum(np.maximum(mask[..., 0], mask[..., 1]), canvas.hair)
    return {
        "lip": smooth_ramp(0.4, 0.8, mask[..., 0]) * smooth_ramp(0.5, 0.7, mask[..., 3]),  # not the mouth's lining
        "brow": mask[..., 1],
        "blush": mask[..., 2],
        "hair": canvas.hair,
        "skin": np.where(marked < 0.02, smooth_ramp(0.85, 0.98, mask[..., 3]) * (mask[..., 2] > 0.05), 0.0),
    }


def decode_srgb(colour: str) -> NDArray[np.float32]:
    """Converts a colour "#rrggbb" to linear light, (3,)."""
    return decode_light(np.frombuffer(bytes.fromhex(colour[1:]), np.uint8))


def _albedo(at: Canvas, look: Look) -> Values:
    mask = at.layers["mask"]
    marks = at.layers["marks"]
    patches = at.layers["patches"]
    skin, lip, brow, hair = (decode_srgb(colour) for colour in (look.skin, look.lip, look.brow, look.hair))
    lips, lining = lips_of(at, look)
    fur = look.fur * (1.0 - lips)
    seen = _mix(
        _paint_bare_skin(at, look, skin, lip, brow), lip * _grey(0.86 + 0.28 * at.layers["finish"][..., 3]), lips * 0.9
    )
    seen = _mix(seen, _mix(_paint_fur(at, look, skin, brow), lip, patches[..., 0]), fur)
    hairs = clamp_unit((mask[..., 1] - (1.0 - 1.12 * look.brows)) * 2.6)
    seen = _mix(seen, brow, hairs * 0.92)
    seen = _mix(seen, brow * 0.5, patches[..., 3] * look.lacquer)
    seen = _mix(seen, hair * _grey(0.7 + 0.6 * marks[..., 3]), grown_of(at) * look.scalp)
    seen = _mix(seen, np.array(LINING, np.float32), lining)
    left = mask[..., 3]
    shaded: Values = seen * _grey(left * (0.7 + 0.3 * left))
    return shaded


def _pictured(at: Canvas, look: Look, painted: Values, times: int) -> Values:
    """The picture of a look over its painted skin, in linear light; make-up and shade of hair on both."""
    assert look.albedo is not None  # `paint_skin` asks first
    texels = look.albedo.pixels.repeat(times, axis=0).repeat(times, axis=1) if times > 1 else look.albedo.pixels
    brow, lip, hair = (decode_srgb(colour) for colour in (look.brow, look.lip, look.hair))
    mask, marks, patches = (at.layers[name] for name in ("mask", "marks", "patches"))
    seen = _mix(decode_light(texels[..., :3]), brow * 0.6 + lip * 0.18, patches[..., 2] * look.makeup * 0.85)
    seen = _mix(seen, brow * 0.5, patches[..., 3] * look.lacquer)
    seen = _mix(seen, hair * _grey(0.7 + 0.6 * marks[..., 3]), grown_of(at) * look.scalp)
    left = mask[..., 3]
    seen = seen * _grey(1.0 + (left * (0.7 + 0.3 * left) - 1.0) * 0.5)
    _, lining = lips_of(at, look)
    return _mix(painted, seen, texels[..., 3].astype(np.float32) / np.float32(255.0) * (1.0 - lining))


def grown_of(at: Canvas, /) -> Values:
    """How much of each texel hair of the scalp covers, (k, k) 0..1.

    at: the canvas of the cast.
    """
    marks = at.layers["marks"]
    return smooth_ramp(0.15, 0.9, at.hair + (marks[..., 3] - 0.5) * 2.8 * at.hair * (1.0 - at.hair))


def lips_of(at: Canvas, look: Look, /) -> tuple[Values, Values]:
    """How much of each texel is lip, and how much the mouth's lining, (k, k) 0..1 each.

    at: the canvas of the cast; look: whose lips.
    """
    red = at.layers["mask"][..., 0]
    left = at.layers["mask"][..., 3]
    narrow = 0.3 * look.age
    human = smooth_ramp(0.06 + narrow, 0.5 + narrow, red)
    lips = human + (smooth_ramp(0.86, 0.97, red) - human) * look.fur
    lining = smooth_ramp(0.55, 0.7, red) * (1.0 - smooth_ramp(0.38, 0.5, left))
    return np.maximum(lips, lining), lining


def _paint_bare_skin(at: Canvas, look: Look, skin: Values, lip: Values, brow: Values) -> Values:
    mask, marks, patches, finish = (at.layers[name] for name in ("mask", "marks", "patches", "finish"))
    blood = np.array([0.08, -0.34, -0.30], np.float32)
    seen = skin * (1.0 + look.pores * _grey(finish[..., 3] - 0.5) * blood)
    seen = seen * _grey(1.0 + (finish[..., 2] - 1.0) * 0.5 * look.pores)
    for layer, trait, tint in ((0, look.age, (0.70, 0.50, 0.42)), (1, look.freckles, (0.70, 0.50, 0.36))):
        seen = seen * (1.0 + _grey(marks[..., layer] * trait) * (np.array(tint, np.float32) - 1.0))
    seen = _mix(seen, decode_srgb(look.blush), mask[..., 2] * 0.4)
    seen = _mix(seen, 0.5 * brow + 0.14 * skin, marks[..., 2] * look.stubble * 0.78)
    return _mix(seen, brow * 0.6 + lip * 0.18, patches[..., 2] * look.makeup * 0.85)


def _paint_fur(at: Canvas, look: Look, skin: Values, brow: Values) -> Values:
    pelt = at.layers["pelt"]
    strand = at.layers["marks"][..., 3] - 0.5
    pale = pelt[..., 0] + (pelt[..., 2] - pelt[..., 0]) * look.stripes
    dark = pelt[..., 1] + (pelt[..., 3] - pelt[..., 1]) * look.stripes
    seen = _mix(_mix(skin, decode_srgb(look.coat), pale), brow, dark * 0.9)
    seen = _mix(seen, brow * RIM, at.layers["patches"][..., 1] * 0.92)
    shaded: Values = seen * _grey(1.0 + 1.15 * strand) + _grey(np.maximum(strand, 0.0) * 0.10)
    return shaded


def _mix(base: Values, other: Values, share: Values) -> Values:
    result: Values = base + (other - base) * share[..., None]
    return result


def _grey(value: Values) -> Values:
    result: Values = value[..., None]
    return result
