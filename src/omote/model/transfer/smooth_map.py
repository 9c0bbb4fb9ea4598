"""The smooth map from the generic face to another: contact kept, nothing folded (method.md, section 3, the recipe)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from omote.model.space.lid_lip_lines import Line
from omote.model.transfer.detail_transfer import Detail, detail_of, detailed
from omote.model.transfer.eyeball_clearance import Ball, Clearance, clearance_of, cleared
from omote.model.transfer.fold_repair import FAR, NEAR, Sheet, relax, sheet_of, turned_over
from omote.model.transfer.lid_lip_contact import Contact, closed, contact_of, growth_of

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Rounds with the lines held and small patches, then with the lines free, larger patches, weaker anchors.
_HELD_ROUNDS, _FREE_ROUNDS = 6, 8
# Steps of the inverse at most, the error in metres at which it ends, and how many steps it looks back.
_INVERSIONS, _EXACT, _MEMORY = 120, 1e-8, 30
# Steps of the inverse through clearance and unfolding, which are no smooth maps, and the error that asks for them.
_POLISHING, _CLOSE = 60, 2e-6


@dataclass(frozen=True, eq=False)
class Carrier:
    """What is solved once per face: its sheet and detail, its lines' contacts, the vertices on the lines (V,), and its
    eyeballs' clearances."""

    generic: Values
    positions: Values
    rest: Values
    sheet: Sheet
    detail: Detail
    contacts: tuple[Contact, ...]
    on_line: Mask
    clearances: tuple[Clearance, ...]
    growth: Values


def carrier_of(
    generic: Values, positions: Values, triangles: NDArray[np.int32], lines: tuple[Line, ...],
    balls: tuple[tuple[Ball, Ball], ...] = (), /,
) -> Carrier:  # fmt: skip
    """Ready to carry displacements of the generic face (V, 3) to the face with positions (V, 3); triangles: the
    sheet's; balls: each eyeball of the generic face with the same one of this face."""
    sheet = sheet_of(generic, positions, triangles)
    a, b, c = generic[triangles].transpose(1, 0, 2)
    on_line = np.zeros(len(generic), np.bool_)
    for line in lines:
        on_line[line.loop] = True
    contacts = tuple(contact_of(line, generic, positions, sheet) for line in lines)
    clearances = tuple(clearance_of(generic, positions, triangles, there, here) for there, here in balls)
    rest = np.cross(b - a, c - a)
    growth = growth_of(generic, contacts)
    return Carrier(generic, positions, rest, sheet, detail_of(sheet), contacts, on_line, clearances, growth)


def carried(carrier: Carrier, displacement: Values, /) -> Values:
    """The face (V, 3) moved as the generic face is by a displacement (V, 3); only the sheet has a meaning."""
    moved = carrier.generic + displacement
    positions = _in_contact(carrier, displacement)
    _clear(carrier, positions, moved)
    positions = _unfolded(carrier, positions, moved)
    pushed = positions.copy()
    # Unfolding may push lids into the ball again; out they go, and what that folds is unfolded once more.
    return _unfolded(carrier, pushed, moved) if _clear(carrier, pushed, moved) else positions


def _clear(carrier: Carrier, positions: Values, moved: Values) -> bool:
    pushed = [cleared(clearance, positions, moved) for clearance in carrier.clearances]
    return any(pushed)


def uncarried(carrier: Carrier, positions: Values, /) -> Values:
    """The displacement (V, 3) of the generic face that is carried to positions (V, 3): the inverse of `carried`.

    Exact where the positions fold nothing that the generic face does not and no eyeball pierces; there the whole map is
    inverted as far as it goes. By fixed points with memory (Anderson 1965): plain steps do not end where a face's
    triangles are much larger than the generic one's.
    """
    smooth = _solved(partial(_in_contact, carrier), positions, positions - carrier.positions, _INVERSIONS)
    if np.abs(carried(carrier, smooth) - positions).max() < _CLOSE:
        return smooth
    return _solved(partial(carried, carrier), positions, smooth, _POLISHING)


def _solved(map_: Callable[[Values], Values], positions: Values, start: Values, most: int) -> Values:
    """Where a map gives the positions (V, 3), or the nearest it came to them in so many steps."""
    displacement, best, least = start, start, np.inf
    steps, changes = list[Values](), list[Values]()
    before: tuple[Values, Values] | None = None
    for _ in range(most):
        lack = positions - map_(displacement)
        error = float(np.abs(lack).max())
        if error < least:
            best, least = displacement, error
        if error < _EXACT:
            break
        if before is not None:
            steps, changes = [*steps, before[0]][-_MEMORY:], [*changes, lack - before[1]][-_MEMORY:]
        step = _next_step(lack, steps, changes)
        before = (step, lack)
        displacement = displacement + step
    return best


def _next_step(lack: Values, steps: list[Values], changes: list[Values]) -> Values:
    """Half of what lacks, after those earlier steps, together, whose changes explain it best."""
    if not steps:
        return 0.5 * lack
    known = np.stack(changes)
    share, *_ = np.linalg.lstsq(known.reshape(len(known), -1).T, lack.ravel(), rcond=1e-10)
    result: Values = 0.5 * (lack - np.tensordot(share, known, 1)) - np.tensordot(share, np.stack(steps), 1)
    return result


def _in_contact(carrier: Carrier, displacement: Values) -> Values:
    moved = carrier.generic + displacement
    positions = carrier.positions + detailed(carrier.detail, displacement, moved, carrier.growth)
    for contact in carrier.contacts:
        closed(contact, positions, moved)
    return positions


def folds(carrier: Carrier, positions: Values, moved: Values, /) -> Mask:
    """The sheet triangles (T,) turned over on the face but not on the source."""
    here, there = np.empty(len(carrier.rest), np.bool_), np.empty(len(carrier.rest), np.bool_)
    turned_over(positions, carrier.sheet.triangles, carrier.sheet.normals, here)
    turned_over(moved, carrier.sheet.triangles, carrier.rest, there)
    result: Mask = here & ~there
    return result


def _unfolded(carrier: Carrier, positions: Values, moved: Values) -> Values:
    sheet, nothing = carrier.sheet, np.zeros_like(carrier.on_line)
    bad = folds(carrier, positions, moved)
    best, fewest = positions, int(bad.sum())
    for turn in range(_HELD_ROUNDS + _FREE_ROUNDS):
        if fewest == 0:
            break
        free = turn >= _HELD_ROUNDS
        positions = positions.copy()
        relax(
            positions, moved, bad, nothing if free else carrier.on_line, 3 if free else 2, FAR if free else NEAR,
            sheet.triangles, sheet.starts, sheet.fans, sheet.gradients, sheet.plane, sheet.turns, sheet.source,
        )  # fmt: skip
        if free:
            for contact in carrier.contacts:
                closed(contact, positions, moved)
        bad = folds(carrier, positions, moved)
        if bad.sum() < fewest:
            best, fewest = positions, int(bad.sum())
    return best
