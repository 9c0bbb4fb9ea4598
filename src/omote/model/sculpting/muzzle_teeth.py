"""Teeth of a muzzle: rows that follow the lips, where a map of space leaves them as far behind as it is coarse.

A map through points of the skin carries what lies in the mouth by its own smoothness: a muzzle grows, and the teeth in
it stay. Points on teeth would pull the lips along. So the rows alone are bent, column by column, seen from above: their
edges go to a line behind the lower lip's, at the shares of its length that they have on the generic face, their ends
stay, their gums go a part of the way, and the tongue's tip stays behind them.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import gaussian_filter1d

from omote.arrays import Values
from omote.model.space.lid_lip_lines import chains
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.teeth_cage import cage_columns
from omote.model.transfer.gum_line import GUMS

SAMPLES = 800
# Deviation of the bell under which a line of lips or teeth is round, as a share of its samples.
LIPS_ROUND = 0.015
TEETH_ROUND = 0.0125
# How much farther inside of the lips a row lies at the mouth's sides, and the lower one everywhere, metres: lips are
# thicker there, and the rows meet edge to edge.
BESIDE_METRES = 0.005
UNDER_METRES = 0.0015
LOWER_BESIDE_METRES = 0.007
# How far each of a column's rows goes along: gum, middle, edge, behind. The skull's gum lies under a muzzle's nose and
# is ahead already; the lower jaw's would be left in the throat.
SHARES = {"teeth_upper": (0.0, 0.5, 1.0, 1.0), "teeth_lower": (0.4, 0.7, 1.0, 1.0)}
# The tongue's tip lies so far behind the lower teeth's edges, metres; the power by which its parts go along.
TIP_METRES = 0.011
TIP_POWER = 1.5


def follow_lips(space: ParameterSpace, skin: Values, parts: dict[str, Values], behind: float) -> None:
    """Bends the rows of teeth of parts along the lips of a face's skin (V, 3), in place, and the tongue with them.

    space: the space of the generic head; parts: (n, 3) each, metres; behind: how far behind the lower lip's line the
    front teeth's edges stand, metres. Where a space names no lips, or its teeth are no strips of columns, all stays.
    """
    line = next((line for line in space.lines if line.kind == "lips"), None)
    if line is None:
        return
    _, lower = chains(space.points, space.welded[line.loop])
    lip = skin[lower][:, [0, 2]]
    lip = lip[::-1] if lip[0, 0] > lip[-1, 0] else lip
    front = None
    for name, way in GUMS.items():
        columns = cage_columns(space.parts[name].points, upper=way > 0.0) if name in parts else None
        if columns is None:
            continue
        edges = parts[name][columns[:, 2]][:, [0, 2]]
        under, beside = (0.0, BESIDE_METRES) if way > 0.0 else (UNDER_METRES, LOWER_BESIDE_METRES)
        arch = _arch(edges, _inside(lip, behind + under, beside))
        goes = _at_shares(arch, space.parts[name].points[columns[:, 2]][:, [0, 2]]) - edges
        for row, share in zip(columns.T, SHARES[name], strict=True):
            parts[name][row[:, None], [0, 2]] += share * goes
        front = parts[name][columns[:, 2], 2].max()
    if front is not None and "tongue" in parts:
        ahead = parts["tongue"][:, 2]
        share = (ahead - ahead.min()) / np.ptp(ahead)
        ahead += (front - TIP_METRES - ahead.max()) * share**TIP_POWER


def _inside(lip: Values, behind: float, beside: float) -> Values:
    """A line so far inside of the lips (n, 2), from the right corner to the left one, seen from above, metres; farther
    by `beside` where they go straight back."""
    lip = _resample(lip, np.linspace(0.0, 1.0, SAMPLES))
    lip = gaussian_filter1d(lip, LIPS_ROUND * SAMPLES, axis=0, mode="nearest")
    along = np.gradient(lip, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    outward = np.column_stack([-along[:, 1], along[:, 0]])
    return lip - (behind + beside * np.abs(outward[:, :1])) * outward


def _arch(edges: Values, inside: Values) -> Values:
    """The line of the lips as far as it is ahead of a row's ends, and on to these: (n, 2), round where they meet."""
    ends = edges[[0, -1]]
    ahead = inside[inside[:, 1] > ends[:, 1].max()]
    line = _resample(np.concatenate([ends[:1], ahead, ends[1:]]), np.linspace(0.0, 1.0, SAMPLES))
    line = gaussian_filter1d(line, TEETH_ROUND * SAMPLES, axis=0, mode="nearest")
    line[[0, -1]] = ends
    return line


def _at_shares(line: Values, like: Values) -> Values:
    """Points of a line (n, 2) at the shares of its length that others (m, 2) have of theirs, from end to end."""
    lengths = _lengths(like)
    return _resample(line, lengths / lengths[-1])


def _resample(line: Values, shares: Values) -> Values:
    lengths = _lengths(line)
    return np.column_stack([np.interp(shares, lengths / lengths[-1], axis) for axis in line.T])


def _lengths(line: Values) -> Values:
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
