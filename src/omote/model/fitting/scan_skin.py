"""What of a scan is skin: without eyeballs, teeth, lashes and other things that lie between lids and lips."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from omote.arrays import Values
from omote.model.fitting.head_zones import HeadZones
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace

# A component is skin of which this share lies nearest to skin beside the openings.
SHARE = 0.5
# Farther than this from the head, metres, a point does not say what it belongs to.
REACH = 0.02
# Eyes may be shut where the skin fills so much of the eye's opening; the opening is looked at so near its middle.
FILLED = 0.5
CORE = 0.4
# Such skin is sought so near, metres, and faces out by so much (cosine).
DEEP = 0.03
OUT = 0.3


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


def may_be_shut(space: ParameterSpace, skin: ScanSurface, head: Values, /) -> bool:
    """Whether the skin fills what is open between the lids of a head (V, 3) that was fitted without them.

    space: of the head; skin: the scan's surface without eyeballs; head (V, 3): metres.
    """
    filled = [_filled_share(line, skin, head) for line in space.lines if line.kind == "lids"]
    return min(filled, default=0.0) > FILLED


def _filled_share(line: Line, skin: ScanSurface, head: Values) -> float:
    """The share of an eye's opening, its middle, before which there is skin that faces out."""
    loop = head[line.loop]
    middle = loop.mean(axis=0)
    points = (middle + (loop - middle) * CORE * np.linspace(0.0, 1.0, 6)[:, None, None]).reshape(-1, 3)
    near = skin.tree.query_ball_point(middle, DEEP)
    if not near:
        return 0.0
    _, _, axes = np.linalg.svd(loop - middle)
    ahead = axes[2] * np.sign(axes[2] @ skin.normals[near].mean(axis=0))
    off = skin.points[near][:, None] - points[None]
    depth = off @ ahead
    beside = np.sqrt(np.maximum((off**2).sum(axis=2) - depth**2, 0.0))
    out = (skin.normals[near] @ ahead > OUT)[:, None]
    met = (beside < 2.0 * skin.spacing) & (depth > 0.0) & out
    return float(met.any(axis=0).mean())
