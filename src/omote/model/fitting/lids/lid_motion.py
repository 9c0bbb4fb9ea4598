"""Lids of the generic head meet where a scan's do, bin by bin along their line; where they do not, it is said."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Indices, Values
from omote.model.space.face_fit import generic_face
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.fold_repair import SheetGeometry
from omote.model.transfer.lid_lip_contact import BINS, hat_functions, solve_responses
from omote.model.transfer.smooth_map import prepare_smooth_map
from omote.model.weak_cache import weakly_cached

# Lids that meet lie over each other by this share of the opening, as the cast's own do.
OVERLAP = 0.03
# Lids that a scan shuts and that stay open here by more than this share at any bin are told of; so are lids that move
# by more than this share where the scan shows no opening.
LEFT_OPEN = 0.05
GUESSED = 0.25


@dataclass(frozen=True, eq=False)
class LidPair:
    """Two lids of the generic head: rest (V, 3); ways (RUNGS, 3) from the lower to the upper one, lengths (RUNGS,)
    metres of that; near (m,), response (m, 2 b, 3): the displacement of the vertices near the line that lifts the upper
    lid in a bin by a metre, then that which lifts the lower one."""

    line: Line
    rest: Values
    ways: Values
    lengths: Values
    near: Indices
    response: Values

    def opening(self, positions: Values, /) -> Values:
        """How far positions (V, 3) have the lids apart at each rung, (RUNGS,), in its length at rest."""
        return np.asarray((self.ways * self.line.rungs(positions)).sum(axis=1) / self.lengths)


@weakly_cached
def lid_pairs(space: ParameterSpace, /) -> tuple[LidPair, ...]:
    """The lids of a space's generic head, solved once."""
    ready = prepare_smooth_map(space, generic_face(space))
    return tuple(_solve_pair(line, ready.generic, ready.geometry) for line in space.lines if line.kind == "lids")


def _solve_pair(line: Line, generic: Values, sheet: SheetGeometry) -> LidPair:
    rungs = line.rungs(generic)
    lengths = np.linalg.norm(rungs, axis=1)
    ways = rungs / lengths[:, None]
    asked = np.einsum("br,rk,rc->brkc", hat_functions(BINS[line.kind]), np.abs(line.weights), ways)
    sides = np.zeros((2, *asked.shape))
    sides[0, :, :, :2] = asked[:, :, :2]
    sides[1, :, :, 2:] = asked[:, :, 2:]
    near, response = solve_responses(line, sides.reshape(-1, *asked.shape[1:]), generic, sheet)
    return LidPair(line, generic, ways, lengths, near, response)


def shut_lids(pair: LidPair, worn: Values, upper: Values, /) -> Values:
    """The generic head (V, 3), worn, with lids that meet, in the mean of each bin.

    pair: of the lids; worn (V, 3): metres; upper (RUNGS,): how much of what is open the upper lid shuts.
    """
    missing = (pair.opening(worn) + OVERLAP) * pair.lengths
    lifts = np.stack([-upper * missing, (1.0 - upper) * missing])
    result = worn.copy()
    bins = hat_functions(BINS[pair.line.kind])
    result[pair.near] += np.einsum("vbc,b->vc", pair.response, (lifts @ bins.T).ravel())
    return result


def describe_lids(
    space: ParameterSpace, name: str, worn: Values, shut: Mapping[str, Values | None], /
) -> list[str]:  # fmt: skip
    """What of a shape's lids could not be carried to the generic head (V, 3) that wears it, in sentences.

    space: of the head; name: the shape's; worn (V, 3): metres; shut: of the lids between which the scan shows an
    opening at rest, by line, how it shuts them; None where it leaves them apart.
    """
    told = list[str]()
    for pair in lid_pairs(space):
        bins = hat_functions(BINS[pair.line.kind])
        share = (bins @ (pair.opening(worn) * pair.lengths)) / (bins @ pair.lengths)
        eye = pair.line.name.removeprefix("lid_")
        if pair.line.name not in shut:
            if np.abs(share - 1.0).mean() > GUESSED:
                told.append(
                    f"{name!r} moves the {eye} eye's lids, but at rest the scan shows no opening between them: how far "
                    "they close is a guess."
                )
        elif shut[pair.line.name] is not None and share.max() > LEFT_OPEN:
            told.append(f"{name!r} shuts the {eye} eye of the scan, but leaves {share.max():.0%} of it open here.")
    return told
