"""Turns back what a stranger's shape folds on the generic head: a face keeps upright only what that does.

What was read off one head is that head's noise and matches too: around the nostrils and in the corners of rolled lips
the generic head folded where the stranger does not, and every face would wear that. The bake does the same to the
cast's own units (`tools/baking/heads/fold_correction`).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.model.extraction.extracted_expression import ExtractedExpression
from omote.model.extraction.sheet_field import measure_field
from omote.model.space.face_fit import generic_face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.fold_repair import find_folds, turn_upright
from omote.model.transfer.lid_lip_contact import close_contact
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.smooth_map import SmoothMap, prepare_smooth_map

Values = NDArray[np.float64]

ROUNDS = 30
# Lips that go so far over each other, metres in the mean, close an open jaw: alone they are to lie over each other, and
# so is what they fold.
OVER = 0.012


def turn_field_upright(space: ParameterSpace, taken: ExtractedExpression, /) -> ExtractedExpression:
    """The expression without a triangle of the sheet turned over on the generic head; itself where none is.

    Lids and lips stay as far apart as they were. Inner skin and parts follow. Under transfer="paper", where nothing is
    repaired, it stays. Position based dynamics (Mueller et al. 2007), as in fold repair.
    """
    if space.transfer == "paper":
        return taken
    ready = prepare_smooth_map(space, generic_face(space))
    worn = ready.generic + displace_generic(space, compile_expression(space, taken))
    if closes_open_jaw(ready, worn):
        return taken
    mended = _turn_back(ready, worn)
    if mended is worn:
        return taken
    field = measure_field(space, ready.generic, (mended - ready.generic)[space.welded])
    return replace(taken, dtheta=field.dtheta, dh=field.dh, ratio=field.ratio)


def closes_open_jaw(ready: SmoothMap, worn: Values, /) -> bool:
    """Whether the lips of a generic head that wears something (V, 3) lie over each other as without the jaw that they
    are to close."""
    return any(
        float(((contact.source * contact.line.rungs(worn)).sum(axis=1) - contact.there).mean()) < -OVER
        for contact in ready.contacts
        if contact.line.kind == "lips"
    )


def _turn_back(ready: SmoothMap, worn: Values) -> Values:
    """The generic head (V, 3) with the fewest folds of all rounds; the same array where none is folded."""
    best, points, folded = worn, worn.copy(), find_folds(ready.geometry, worn, ready.generic)
    fewest = int(folded.sum())
    for _ in range(ROUNDS):
        if fewest == 0:
            break
        turn_upright(ready.geometry, points, ready.generic, folded)
        for contact in ready.contacts:
            close_contact(contact, points, worn)
        folded = find_folds(ready.geometry, points, ready.generic)
        if folded.sum() < fewest:
            best, fewest = points.copy(), int(folded.sum())
    return best
