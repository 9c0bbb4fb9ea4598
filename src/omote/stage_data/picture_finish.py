"""What is done to a drawn picture: a mask around the face, and a mean luminance and a contrast that it is to have.

Luminance is relative luminance (CIE Y, 0 to 1) of linear sRGB (IEC 61966-2-1); contrast is its standard deviation over
its mean (RMS contrast). What is transparent or masked does not count, and a background comes behind it afterwards.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy import ndimage
from scipy.spatial import Delaunay

from omote.arrays import Indices, Mask, Picture, Values
from omote.geometry import mesh
from omote.geometry.depth_map import draw_depth
from omote.model.albedo import decode_light, encode_light
from omote.model.fitting.head_zones import head_zones
from omote.model.space.parameter_space import ParameterSpace
from omote.model.weak_cache import weakly_cached
from omote.stage_data.picture_setting import Clipped, Setting

LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
# Samples a side of a pixel at a mask's edge.
FINE = 3
# Skin whose normal goes down more than this is the underside of the chin.
UNDERSIDE = -0.7
# The outline of a face is rounded off over this share of its height.
ROUNDED = 0.04
ROUNDS = 60
# How near the mean of luminance, and its deviation, have to come: a quarter of the step between two bytes.
EXACT = 0.25 / 255.0
DARK = 1e-6


class Luminance(NamedTuple):
    """The mean of relative luminance, 0 to 1, and its standard deviation over that."""

    mean: float
    contrast: float


class Finished(NamedTuple):
    """A picture (height, width, 4), and what of it was cut off to match; None where nothing was to be matched."""

    picture: Picture
    clipped: Clipped | None


@weakly_cached
def face_triangles(space: ParameterSpace, /) -> Indices:
    """The triangles (t, 3) of the sheet from chin to hairline, without ears.

    The face falls into thirds: from the chin to the nose, from there to the brows, and from these to the hairline.
    """
    zone = head_zones(space).face & (mesh.normals(space.points, space.triangles)[:, 1] > UNDERSIDE)
    _, y, z = space.points.T
    chin = y[zone].min()
    brows = y[zone].max()
    above = space.on_sheet & (y > brows) & (y < brows + 0.5 * (brows - chin)) & (z > z[zone].min())
    unrolled = np.column_stack([space.theta, space.h])
    wide = np.abs(space.theta) <= np.abs(space.theta[zone]).max()
    hull = Delaunay(unrolled[zone | (above & wide)])
    inside = space.on_sheet & (hull.find_simplex(unrolled) >= 0) & (zone | (z > z[zone].min()))
    result: Indices = space.sheet_triangles[inside[space.sheet_triangles].all(axis=1)]
    return result


def finish_picture(
    picture: Picture, setting: Setting, places: Values | None = None, triangles: Indices | None = None, /
) -> Finished:
    """The picture (height, width, 4) with the setting's mask, mean luminance and contrast, and what is cut off for
    them; ValueError where it cannot have them.

    setting: of the picture; places (n, 3), triangles (t, 3): of the face, for a mask: right and down as shares of the
    picture, depth.
    """
    colours = decode_light(picture[..., :3]).astype(np.float64)
    share = picture[..., 3] / 255.0
    if setting.mask:
        assert places is not None
        assert triangles is not None
        share = share * draw_mask(setting, places, triangles)
    colours, clipped = match_luminance(colours, share, setting.luminance, setting.contrast)
    if setting.background is not None:
        code = np.array([int(setting.background[at : at + 2], 16) for at in (1, 3, 5)], np.uint8)
        colours = share[..., None] * colours + (1.0 - share[..., None]) * decode_light(code)
        share = np.ones(share.shape)
    alpha = np.rint(255.0 * share).astype(np.uint8)
    return Finished(np.concatenate([encode_light(colours), alpha[..., None]], axis=-1), clipped)


def draw_mask(setting: Setting, places: Values, triangles: Indices, /) -> Values:
    """How much of each pixel (height, width) a mask leaves, 0 to 1.

    setting: with the kind of mask and the picture's size; places (n, 3), triangles (t, 3): of the face.
    """
    size = np.array([setting.width, setting.height])
    if setting.mask == "oval":
        seen = size * places[np.unique(triangles), :2]
        middle = 0.5 * (seen.min(axis=0) + seen.max(axis=0))
        half = 0.5 * np.ptp(seen, axis=0)
        across, down = (np.arange(FINE * side) + 0.5 for side in size)
        off_x, off_y = (
            (at / FINE - centre) / long for at, centre, long in zip((across, down), middle, half, strict=True)
        )
        inside = off_y[:, None] ** 2 + off_x[None] ** 2 <= 1.0
    else:
        screen = np.column_stack([FINE * size * places[:, :2], places[:, 2]])
        inside = _round_off(np.isfinite(draw_depth(screen, triangles, *(int(FINE * side) for side in size))))
    cover: Values = inside.reshape(setting.height, FINE, setting.width, FINE).mean(axis=(1, 3))
    return cover


def _round_off(inside: Mask) -> Mask:
    """An area without holes, eyes and the open mouth filled, whose outline follows no single triangles."""
    rows = np.flatnonzero(inside.any(axis=1))
    reach = ROUNDED * (np.ptp(rows) + 1.0 if len(rows) else 0.0)
    pad = int(3.0 * reach) + 1
    wide = np.pad(inside, pad)
    closed = ndimage.binary_closing(wide, iterations=max(int(reach), 1))
    soft = ndimage.gaussian_filter(ndimage.binary_fill_holes(closed).astype(np.float64), reach)
    rounded: Mask = soft[pad:-pad, pad:-pad] > 0.5
    return rounded


def match_luminance(
    colours: Values, share: Values, luminance: float | None, contrast: float | None, /
) -> tuple[Values, Clipped | None]:
    """Linear colours (height, width, 3) whose luminance has this mean and this deviation over the mean, None keeps the
    one that there is; and what was cut off, None where nothing was to be matched. Every pixel keeps its hue; where a
    colour would leave the cube it turns greyer, at its luminance.

    colours: 0 to 1; share (height, width): how much each pixel counts; luminance: 0 to 1; contrast: of it.
    ValueError where no such picture is.
    """
    if luminance is None and contrast is None:
        return colours, None
    counted = share > 0.0
    if not counted.any():
        raise ValueError("there is nothing in the picture whose luminance could be matched")
    before = colours[counted] @ LUMINANCE
    weights = share[counted] / share[counted].sum()
    mean, deviation = _measure(before, weights)
    wanted = mean if luminance is None else luminance
    spread = wanted * (deviation / max(mean, DARK) if contrast is None else contrast)
    line = _fit_luminance(before, weights, wanted, spread)
    result = colours.copy()
    result[counted] = _relight(colours[counted], before, _clip(line))
    beyond = (float(weights[line < -EXACT].sum()), float(weights[line > 1.0 + EXACT].sum()))
    return result, Clipped(*beyond)


def _clip(luminances: Values) -> Values:
    clipped: Values = np.minimum(np.maximum(luminances, 0.0), 1.0)
    return clipped


def _measure(luminance: Values, weights: Values) -> tuple[float, float]:
    mean = float(weights @ luminance)
    return mean, float(np.sqrt(max(float(weights @ (luminance - mean) ** 2), 0.0)))


def _fit_luminance(before: Values, weights: Values, mean: float, deviation: float) -> Values:
    """Luminances (n,) on one straight line over those before, with this mean and deviation once they are clipped to 0
    and 1."""
    centre, width = _measure(before, weights)
    slope = deviation / max(width, DARK)
    middle = mean
    for _ in range(ROUNDS):
        line: Values = middle + slope * (before - centre)
        found, spread = _measure(_clip(line), weights)
        if abs(found - mean) < 0.1 * EXACT and abs(spread - deviation) < 0.1 * EXACT:
            return line
        middle += mean - found
        slope *= (deviation + DARK) / (spread + DARK)
    if abs(found - mean) < EXACT and abs(spread - deviation) < EXACT:
        return line
    raise ValueError(
        f"the picture cannot have a mean luminance of {mean:.4g} and a contrast of {deviation / mean:.3g}: the nearest "
        f"is {found:.4g} and {spread / max(found, DARK):.3g}; ask for less of one"
    )


def _relight(colours: Values, before: Values, after: Values) -> Values:
    """Colours (n, 3) at other luminances (n,), their hue kept; greyer where they would leave the cube."""
    dark = before < DARK
    lit = np.where(dark[:, None], after[:, None], colours * (after / np.where(dark, 1.0, before))[:, None])
    over = np.maximum(lit.max(axis=1) - after, DARK)
    grey = np.minimum(1.0, (1.0 - after) / over)
    relit: Values = after[:, None] + (lit - after[:, None]) * grey[:, None]
    return relit


def measure_luminance(picture: Picture, /) -> Luminance:
    """The luminance of a picture (height, width, 4); its pixels count by their alpha."""
    share = picture[..., 3].ravel() / 255.0
    light = decode_light(picture[..., :3]).astype(np.float64).reshape(-1, 3) @ LUMINANCE
    mean, deviation = _measure(light, share / max(share.sum(), DARK))
    return Luminance(mean, deviation / max(mean, DARK))
