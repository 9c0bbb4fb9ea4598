"""What of a scan is skin: without eyeballs, teeth, lashes and other things that lie between lids and lips."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.arrays import Values
from omote.model.fitting.head_zones import HeadZones
from omote.model.fitting.lids.scan_slits import Slit, find_slit
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.parameter_space import ParameterSpace

# A component is skin of which this share lies nearest to skin beside the openings.
SHARE = 0.5
# Farther than this from the head, metres, a point does not say what it belongs to.
REACH = 0.02
# Eyes may be shut where one sees through less than this share of what is open between the lids of the fitted head. Open
# lids leave .63 to .9 of it, .23 with that head 3 mm off, in a cloud .33; shut ones .05, of a muzzle 3 mm off .14.
OPEN = 0.18
# Skin is looked at so near an eye, metres.
AROUND_EYE = 0.04


def keep_skin(surface: ScanSurface, zones: HeadZones, head: Values, /) -> ScanSurface:
    """The components of a surface that are skin of a head (V, 3); the one that covers most of it always is.

    surface: the scan's; zones: of the head; head (V, 3): metres.
    """
    away, nearest = cKDTree(head).query(surface.points[::8], workers=1)
    labels = surface.component[::8]
    near = away < REACH
    count = int(surface.component.max()) + 1
    every = np.bincount(labels[near], minlength=count)
    beside = np.bincount(labels[near & zones.closed[nearest]], minlength=count)
    skin = beside > SHARE * np.maximum(every, 1)
    skin[int(beside.argmax())] = True
    return surface.keep(skin[surface.component])


def may_be_shut(space: ParameterSpace, skin: tuple[Values, NDArray[np.integer]], head: Values, /) -> bool:
    """Whether one sees between the lids of neither eye.

    space: of the head; skin: points (n, 3), metres, and triangles (t, 3) of a scan without its eyeballs; head (V, 3):
    fitted to it, its lids aside.
    """
    slits = [find_slit(line, head, *skin) for line in space.lines if line.kind == "lids"]
    return all(_seen_share(slit) < OPEN for slit in slits)


def _seen_share(slit: Slit) -> float:
    """The share of a fitted head's opening that one sees through."""
    through = np.diff(np.clip(slit.open, 0.0, 1.0))[:, 0]
    return float(np.nansum(through * slit.lengths) / slit.lengths.sum())


def squares_around_eyes(space: ParameterSpace, skin: ScanSurface, head: Values, /) -> tuple[Values, NDArray[np.int32]]:
    """A cloud's skin near the eyes as points (n, 3) and triangles (t, 3): a square at each of its points, twice as wide
    as neighbours are apart.

    space: of the head; skin: of the scan; head (V, 3): fitted to it, metres.
    """
    middles = [head[line.loop].mean(axis=0) for line in space.lines if line.kind == "lids"]
    near = np.unique(np.concatenate(skin.tree.query_ball_point(middles, AROUND_EYE)).astype(np.intp))
    points = skin.points[near]
    normals = skin.normals[near]
    along = np.cross(normals, np.where(np.abs(normals[:, 1:2]) < 0.9, [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]))
    along *= skin.spacing / np.maximum(np.linalg.norm(along, axis=1), 1e-12)[:, None]
    across = np.cross(normals, along)
    corners = np.stack(
        [points - along - across, points + along - across, points + along + across, points - along + across]
    )
    order = np.arange(4 * len(near)).reshape(4, -1)
    triangles = np.concatenate([order[[0, 1, 2]].T, order[[0, 2, 3]].T]).astype(np.int32)
    return corners.reshape(-1, 3), triangles
