"""How far apart the lids of a scan are, rung by rung, as somebody ahead of the eye sees it.

A fitted face's lids lie up to millimetres beside the scan's, and skin that far from the edge of a lid moves less than
the edge. So whether lids meet is read off the scan itself: along each rung of a line on the fitted face, what is seen
through the scan's opening, at rest and wearing a shape. No edge of a lid has to be found, and no lining, whatever the
triangles (docs/decisions/scans-and-foreign-shapes.md).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Mask, Values
from omote.geometry.depth_map import draw_depth
from omote.model.space.lid_lip_lines import RUNGS, Line

# What lies so far behind the lids, metres, is seen through between them: linings, the back of the head, nothing.
DEEP = 0.0025
PIXEL = 1.5e-4
# An opening tells nothing that is less than so many metres, or than this share of the widest: at their corners lids are
# as wide as they are thick.
LEAST = 5e-4
NARROW = 0.25
# Rungs are looked along so far beyond their ends: a share of their length and metres.
BEYOND = (0.5, 0.001)
SAMPLES = 200
# A line is known of which this share of rungs shows an opening at rest.
KNOWN = 0.5
# Lids have edges, and what makers leave open between these the lashes hide: less than this share is shut.
SHUT = 0.2
# How much of it each lid does is told by the largest of these weights that leaves so much of the opening, or by the
# lids beside; the upper one does so much where nothing tells.
WEIGHTS = (0.75, 0.5, 0.25)
APART = (0.1, 0.95)
UPPER = 0.9
# The edge of a lid is the nearest of so many samples of a rung beside what is open.
BESIDE = 6
# The depth of a picture has to be positive, metres.
_AWAY = 1.0


@dataclass(frozen=True, eq=False)
class Slit:
    """The opening between two lids of a scan, seen from ahead of the fitted face's.

    line: of the lids; lengths (RUNGS,): of its rungs on the fitted face, metres; picture (3, 4): from points and one to
    pixels right and down, and depth; size: pixels wide and high; triangles (t, 3): the scan's skin in it; shares
    (RUNGS, SAMPLES): where the rungs are looked at, 0 at the lower end and 1 at the upper one; places (RUNGS, SAMPLES,
    2), depths (RUNGS, SAMPLES): the pixels there, and the depth of the lids; open (RUNGS, 2): between which shares it
    is open at rest, nan where it is not.
    """

    line: Line
    lengths: Values
    picture: Values
    size: tuple[int, int]
    triangles: NDArray[np.int32]
    shares: Values
    places: NDArray[np.intp]
    depths: Values
    open: Values

    @property
    def known(self) -> bool:
        """Whether the scan shows an opening here."""
        return bool(np.isfinite(self.open[:, 0]).mean() > KNOWN)

    def remains(self, points: Values, /) -> Values:
        """How much of the opening at rest the scan's points (n, 3), metres, leave open at each rung, (RUNGS,), nan
        where it is not open at rest."""
        left = np.nan_to_num(np.diff(_look(self, points))[:, 0])
        return np.asarray(left / np.diff(self.open)[:, 0])

    def shut_by(self, points: Values, moves: Values, /) -> Values | None:
        """How much of the opening the upper lid shuts at each rung (RUNGS,), the lower one the rest, where a shape
        shuts it; None where it leaves the lids apart.

        points (n, 3): the scan at rest; moves (n, 3): the shape's displacements; metres.
        """
        height = np.diff(self.open)[:, 0]
        metres = np.nan_to_num(self.lengths * height)
        if not self.known or metres @ np.nan_to_num(self.remains(points + moves)) > SHUT * metres.sum():
            return None
        shares = np.full(RUNGS, np.nan)
        for weight in WEIGHTS:
            now = _look(self, points + weight * moves)
            remains = np.diff(now)[:, 0] / height
            fresh = np.isnan(shares) & (remains > APART[0]) & (remains < APART[1])
            shares[fresh] = (self.open - now)[fresh, 1] / (height * (1.0 - remains))[fresh]
        told = np.flatnonzero(np.isfinite(shares))
        if not len(told):
            return np.full(RUNGS, UPPER)
        return np.clip(np.interp(np.arange(RUNGS), told, shares[told]), 0.0, 1.0)


def find_slit(line: Line, skin: Values, points: Values, triangles: NDArray[np.integer], /) -> Slit:
    """The opening between the lids of a scan where a fitted face has a line.

    line: of lids; skin (V, 3): the face; points (n, 3): the scan's; metres in one frame; triangles (t, 3): its skin,
    without eyeballs.
    """
    upper, lower = (
        np.einsum("rk,rkc->rc", np.abs(line.weights[:, ends]), skin[line.vertices[:, ends]])
        for ends in (slice(0, 2), slice(2, 4))
    )
    length = np.linalg.norm(upper - lower, axis=1)
    beyond = BEYOND[0] + BEYOND[1] / np.maximum(length, LEAST)
    shares = -beyond[:, None] + (1.0 + 2.0 * beyond)[:, None] * np.linspace(0.0, 1.0, SAMPLES)
    asked = lower[:, None] + shares[..., None] * (upper - lower)[:, None]
    picture = _look_from_ahead(skin[line.loop], asked.reshape(-1, 3))
    at, below, above = (_draw(picture, where.reshape(-1, 3)) for where in (asked, lower, upper))
    wide, high = (int(most) + 2 for most in at.max(axis=0)[:2])
    corners = _draw(picture, points)[triangles][..., :2]
    inside = ((corners.max(axis=1) >= 0.0) & (corners.min(axis=1) <= (wide, high))).all(axis=1)
    depths = below[:, 2:] + np.clip(shares, 0.0, 1.0) * (above - below)[:, 2:]
    slit = Slit(
        line, length, picture, (wide, high), np.ascontiguousarray(triangles[inside], np.int32), shares,
        at[:, :2].reshape(*shares.shape, 2).astype(np.intp), depths, np.tile([0.0, 1.0], (RUNGS, 1)),
    )  # fmt: skip
    found = _look(slit, points)
    height = np.nan_to_num(found[:, 1] - found[:, 0]) * length
    found[height < max(LEAST, NARROW * height.max())] = np.nan
    return replace(slit, open=found)


def _look_from_ahead(loop: Values, asked: Values) -> Values:
    """The picture (3, 4) of what is ahead of a loop (n, 3), with the points (m, 3) that are asked in it."""
    along = loop[loop[:, 0].argmax()] - loop[loop[:, 0].argmin()]
    along /= np.linalg.norm(along)
    ahead = np.linalg.svd(loop - loop.mean(axis=0))[2][2]
    ahead = ahead * np.sign(ahead[2])
    ahead = ahead - along * (along @ ahead)
    ahead /= np.linalg.norm(ahead)
    axes = np.stack([along / PIXEL, np.cross(along, ahead) / PIXEL, -ahead])
    start = (asked @ axes.T).min(axis=0) - (1.0, 1.0, _AWAY)
    return np.column_stack([axes, -start])


def _draw(picture: Values, points: Values) -> Values:
    return points @ picture[:, :3].T + picture[:, 3]


def _look(slit: Slit, points: Values) -> Values:
    """The shares (RUNGS, 2) of the rungs between which one sees through, nan where nowhere: of several openings the one
    that shares most with the slit's, and none that shares nothing."""
    depth = draw_depth(_draw(slit.picture, points), slit.triangles, *slit.size)
    through = depth[slit.places[..., 1], slit.places[..., 0]] > slit.depths + DEEP
    found = np.full((RUNGS, 2), np.nan)
    for rung in np.flatnonzero(np.isfinite(slit.open[:, 0])):
        found[rung] = _find_opening(through[rung], slit.shares[rung], slit.open[rung])
    return found


def _find_opening(through: Mask, shares: Values, expected: Values) -> Values:
    ends = np.flatnonzero(np.diff(through, prepend=False, append=False)).reshape(-1, 2)
    if not len(ends):
        return np.full(2, np.nan)
    half = 0.5 * (shares[1] - shares[0])
    runs = np.column_stack([shares[ends[:, 0]] - half, shares[ends[:, 1] - 1] + half])
    common = np.minimum(runs[:, 1], expected[1]) - np.maximum(runs[:, 0], expected[0])
    most = int(common.argmax())
    return runs[most] if common[most] > 0.0 else np.full(2, np.nan)


def find_edges(slit: Slit, points: Values, /) -> Values:
    """Where the edges of the lids of a scan's points (n, 3) are, (RUNGS, 2, 3) metres, the lower and the upper one of
    each rung; nan where the slit is not open."""
    depth = draw_depth(_draw(slit.picture, points), slit.triangles, *slit.size)
    found = np.full((RUNGS, 2, 3), np.nan)
    back = np.linalg.inv(slit.picture[:, :3])
    for rung in np.flatnonzero(np.isfinite(slit.open[:, 0])):
        for end, way in enumerate((-1, 1)):
            at = int(np.searchsorted(slit.shares[rung], slit.open[rung, end])) - (end == 0)
            pixels = slit.places[rung, np.clip(at + way * np.arange(BESIDE), 0, SAMPLES - 1)]
            away = depth[pixels[:, 1], pixels[:, 0]]
            spot = [*(pixels[0] + 0.5), away[np.isfinite(away)].min(initial=slit.depths[rung].max())]
            found[rung, end] = back @ (spot - slit.picture[:, 3])
    return found
