"""The smooth map from the generic face to another: contact kept, nothing folded (method.md, section 3, the recipe)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.contact import Contact, closed, contact_of
from omote.model.lines import Line
from omote.model.unfold import FAR, NEAR, Sheet, relax, sheet_of, turned_over

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]

# Rounds with the lines held and small patches, then with the lines free, larger patches, weaker anchors.
_HELD_ROUNDS, _FREE_ROUNDS = 6, 8
# Steps of the inverse at most, and the error in metres at which it ends.
_INVERSIONS, _EXACT = 100, 1e-10


@dataclass(frozen=True, eq=False)
class Carrier:
    """What is solved once per face: its sheet, its lines' contacts, and the vertices on the lines (V,)."""

    generic: Values
    positions: Values
    rest: Values
    sheet: Sheet
    contacts: tuple[Contact, ...]
    on_line: Mask


def carrier_of(generic: Values, positions: Values, triangles: NDArray[np.int32], lines: tuple[Line, ...], /) -> Carrier:
    """Ready to carry displacements of the generic face (V, 3) to the face with positions (V, 3); triangles: the
    sheet's."""
    sheet = sheet_of(generic, positions, triangles)
    a, b, c = generic[triangles].transpose(1, 0, 2)
    on_line = np.zeros(len(generic), np.bool_)
    for line in lines:
        on_line[line.loop] = True
    contacts = tuple(contact_of(line, generic, positions, sheet) for line in lines)
    return Carrier(generic, positions, np.cross(b - a, c - a), sheet, contacts, on_line)


def carried(carrier: Carrier, displacement: Values, /) -> Values:
    """The face (V, 3) moved as the generic face is by a displacement (V, 3); only the sheet has a meaning."""
    moved = carrier.generic + displacement
    return _unfolded(carrier, _in_contact(carrier, displacement), moved)


def uncarried(carrier: Carrier, positions: Values, /) -> Values:
    """The displacement (V, 3) of the generic face that is carried to positions (V, 3): the inverse of `carried`.

    Exact where the positions fold nothing that the generic face does not. Half steps: a line twice as wide answers a
    whole step with one as large the other way.
    """
    displacement = positions - carrier.positions
    for _ in range(_INVERSIONS):
        lack = positions - _in_contact(carrier, displacement)
        if np.abs(lack).max() < _EXACT:
            break
        displacement = displacement + 0.5 * lack
    return displacement


def _in_contact(carrier: Carrier, displacement: Values) -> Values:
    positions = carrier.positions + displacement
    for contact in carrier.contacts:
        closed(contact, positions, carrier.generic + displacement)
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
