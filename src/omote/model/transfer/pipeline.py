"""The stages of a compound, in order: how an expression is retargeted to a face (docs/method.md, "The smooth map").

`compile_expression` locates an expression on S, once for all faces. The paper's map (`omote.model.transfer.paper_map`)
moves the generic face by it, and `STAGES` transfer that displacement to any other face. Under transfer="paper" the
paper's map moves every face, and no stage below runs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer import fold_repair, mouth_bag_fit
from omote.model.transfer.detail_transfer import solve_detail
from omote.model.transfer.eyes import socket_clearance
from omote.model.transfer.eyes.eyeball_clearance import clear_eyeball
from omote.model.transfer.lid_lip_contact import close_contact
from omote.model.transfer.paper_map import Compiled, displace_generic, follow_anchors
from omote.model.transfer.smooth_map import SmoothMap, prepare_smooth_map

Floats = NDArray[np.float32]
Values = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class State:
    """A compound between two stages.

    space, face, smooth_map: what it is made for; displacement (V, 3): what the generic face does; source (V, 3): where
    that brings it; residual (inner, 3): the inner skin's own motion. sheet (V, 3): the face so far, of which only the
    sheet counts; repaired: the sheet as fold repair left it; skin (V, 3): all skin, final after the last stage. Metres.
    """

    space: ParameterSpace
    face: Face
    smooth_map: SmoothMap
    displacement: Values
    source: Values
    residual: Floats
    sheet: Values
    skin: Floats
    repaired: Values | None = None


Stage = Callable[[State], State]


def transfer_detail(state: State, /) -> State:
    """Adds the displacement to the face; within 2 mm the triangles take the generic face's deformation gradients.

    Deformation transfer (Sumner & Popovic 2004) as a screened Poisson equation, factorised once per face; gradients
    that miss less than a fifth stay (soft threshold). Rejected: the displacement alone creases and folds where
    triangles differ; gradients alone (one global solve) triple the error against people's true expressions; scaling by
    the size of the head is wrong, as people's amplitudes do not grow with it.
    """
    ready = state.smooth_map
    return replace(state, sheet=state.sheet + solve_detail(ready.detail, state.displacement, state.source, ready.gain))


def close_lids_and_lips(state: State, /) -> State:
    """Opens or closes lids and lips as far as on the generic face.

    Equality-constrained least squares (minimum norm): the smoothest displacement that gives each hat function along
    a line (eight on lids, seven on lips) its opening, solved once per face. Tried: one constraint per line, or three,
    closes lids unevenly; hard rims fold large eyes.
    """
    sheet = state.sheet.copy()
    _close_contacts(state, sheet)
    return replace(state, sheet=sheet)


def clear_eyeballs(state: State, /) -> State:
    """Pushes skin out of the eyeballs where it lies deeper than on the generic face.

    Projection onto a sphere along its normal, spread over five rings of neighbours by a decaying maximum. Returns the
    state itself where nothing lies too deep.
    """
    sheet = state.sheet.copy()
    pushed = [clear_eyeball(clearance, sheet, state.source) for clearance in state.smooth_map.clearances]
    return replace(state, sheet=sheet) if any(pushed) else state


def repair_folds(state: State, /) -> State:
    """Turns back triangles that are turned over here and not on the generic face; the round with the fewest counts.

    Gradient-domain patches: folded triangles take the generic face's deformation gradient, rotated by the polar
    decomposition from face to face, those around keep theirs; least squares by conjugate gradients, anchored to where
    the sheet was. Rejected: one global solve (see `transfer_detail`). A sheet that it has repaired already stays.
    """
    if state.sheet is state.repaired:
        return state
    ready = state.smooth_map
    sheet = fold_repair.repair(
        ready.geometry, state.sheet, state.source, ready.on_line, lambda sheet: _close_contacts(state, sheet)
    )
    return replace(state, sheet=sheet, repaired=sheet)


def weld_seams(state: State, /) -> State:
    """Puts the vertices of the sheet that are doubled at texture seams in one place, and inner skin at rest."""
    space, rest = state.space, fit(state.space, state.face).positions
    skin = np.where(space.on_sheet[:, None], state.sheet[space.welded], rest).astype(np.float32)
    return replace(state, skin=skin)


def follow_inner_skin(state: State, /) -> State:
    """Moves the inner skin (mouth bag, nostrils, lid pockets) by few anchors on the sheet and its own residual.

    A harmonic extension, solved once per topology and kept as the ten largest weights of each vertex. Rejected: a
    solve per compound, which would cost more than the whole compound.
    """
    inner, fitted, skin = state.space.inner, fit(state.space, state.face), state.skin.copy()
    follow_anchors(fitted.positions, inner.vertices, inner.anchors, inner.weights, state.residual, fitted.scale, skin)
    return replace(state, skin=skin)


def fit_mouth_bag(state: State, /) -> State:
    """Pushes the mouth bag behind the skin where it comes out.

    Rays from the cylinder's axis find its depth; projection along the skin's normal, spread over four rings by a
    decaying maximum, up to twelve rounds. Rejected: moving the bag's walls with the teeth improved no face.
    """
    return replace(state, skin=mouth_bag_fit.fit_mouth_bag(state.space, state.face, state.skin))


def fit_socket_lining(state: State, /) -> State:
    """Pushes the lining of the eye sockets behind the skin where it comes out.

    Rays from the cylinder's axis find the foremost skin; projection along its normal, up to four rounds.
    """
    return replace(state, skin=socket_clearance.fit_socket_lining(state.space, state.face, state.skin))


STAGES: tuple[Stage, ...] = (
    transfer_detail,
    close_lids_and_lips,
    clear_eyeballs,
    repair_folds,
    clear_eyeballs,  # repair may push lids into an eyeball again,
    repair_folds,  # and clearing them may fold
    weld_seams,
    follow_inner_skin,
    fit_mouth_bag,
    fit_socket_lining,
)
"""What the smooth map does to a face, in order."""

CONTINUOUS_STAGES = STAGES[: STAGES.index(clear_eyeballs)]
"""The stages whose result is continuous in the displacement; the inverse begins with them."""
SHEET_STAGES = STAGES[: STAGES.index(weld_seams)]
"""The stages that move the sheet: what the inverse ends with."""
LINEAR_INNER_STAGES = STAGES[: STAGES.index(fit_mouth_bag)]
"""The stages after which the inner skin is still linear in the residual, which extraction needs."""


def run(stages: Sequence[Stage], state: State, /) -> State:
    """The state after the stages, one after another."""
    for stage in stages:
        state = stage(state)
    return state


def start(space: ParameterSpace, face: Face, displacement: Values, residual: Floats, /) -> State:
    """The state before the first stage: the face at rest, the generic face displaced by (V, 3) metres."""
    ready = prepare_smooth_map(space, face)
    moved, rest = ready.generic + displacement, fit(space, face).positions
    return State(space, face, ready, displacement, moved, residual, ready.positions, rest)


def transfer_expression(
    space: ParameterSpace, face: Face, compiled: Compiled, /, stages: Sequence[Stage] = STAGES
) -> Floats:
    """A face wearing a compiled expression under the smooth map: (V, 3) float32, metres."""
    return run(stages, start(space, face, displace_generic(space, compiled), compiled.residual)).skin


def apply_smooth_map(
    space: ParameterSpace, face: Face, displacement: Values, /, stages: Sequence[Stage] = SHEET_STAGES
) -> Values:
    """The sheet of a face moved as a displacement (V, 3) moves the generic face: (V, 3) metres, float64."""
    still = np.zeros((len(space.inner.vertices), 3), np.float32)
    return run(stages, start(space, face, displacement, still)).sheet


def _close_contacts(state: State, sheet: Values) -> None:
    for contact in state.smooth_map.contacts:
        close_contact(contact, sheet, state.source)
