"""The stages of a compound, in order: how an expression is retargeted to a face (docs/method.md, "The smooth map").

`compile_expression` locates an expression on S, once for all faces. The paper's map (`omote.model.transfer.paper_map`)
moves the generic face by it, and `STAGES` transfer that displacement to any other face. Under transfer="paper" the
paper's map moves every face, and no stage below runs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from omote.arrays import Floats, Values
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer import fold_repair, mouth_bag_fit, socket_skin
from omote.model.transfer.eyeball_clearance import clear_eyeball
from omote.model.transfer.lid_lip_contact import close_contact
from omote.model.transfer.paper_map import Compiled, displace_generic, follow_anchors
from omote.model.transfer.smooth_map import SmoothMap, prepare_smooth_map, solve_detail


@dataclass(frozen=True, eq=False)
class PartialCompound:
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


Stage = Callable[[PartialCompound], PartialCompound]


def transfer_detail(partial: PartialCompound, /) -> PartialCompound:
    """Adds the displacement to the face; within 2 mm the triangles take the generic face's deformation gradients.

    Deformation transfer (Sumner & Popovic 2004) as a screened Poisson equation, factorised once per face; gradients
    that miss less than a fifth stay (soft threshold). Rejected: the displacement alone creases and folds where
    triangles differ; gradients alone (one global solve) triple the error against people's true expressions; scaling by
    the size of the head is wrong, as people's amplitudes do not grow with it.
    """
    ready = partial.smooth_map
    return replace(
        partial, sheet=partial.sheet + solve_detail(ready.detail, partial.displacement, partial.source, ready.gain)
    )


def close_lids_and_lips(partial: PartialCompound, /) -> PartialCompound:
    """Opens or closes lids and lips as far as on the generic face.

    Equality-constrained least squares (minimum norm): the smoothest displacement that gives each hat function along
    a line (eight on lids, seven on lips) its opening, solved once per face. Tried: one constraint per line, or three,
    closes lids unevenly; hard rims fold large eyes.
    """
    sheet = partial.sheet.copy()
    _close_contacts(partial, sheet)
    return replace(partial, sheet=sheet)


def clear_eyeballs(partial: PartialCompound, /) -> PartialCompound:
    """Pushes skin out of the eyeballs where it lies deeper than on the generic face.

    Projection onto a sphere along its normal, spread over five rings of neighbours by a decaying maximum. Returns the
    partial itself where nothing lies too deep.
    """
    sheet = partial.sheet.copy()
    pushed = [clear_eyeball(clearance, sheet, partial.source) for clearance in partial.smooth_map.clearances]
    return replace(partial, sheet=sheet) if any(pushed) else partial


def repair_folds(partial: PartialCompound, /) -> PartialCompound:
    """Turns back triangles that are turned over here and not on the generic face; the round with the fewest counts.

    Gradient-domain patches: folded triangles take the generic face's deformation gradient, rotated by the polar
    decomposition from face to face, those around keep theirs; least squares by conjugate gradients, anchored to where
    the sheet was. Rejected: one global solve (see `transfer_detail`). A sheet that it has repaired already stays.
    """
    if partial.sheet is partial.repaired:
        return partial
    ready = partial.smooth_map
    sheet = fold_repair.repair(
        ready.geometry, partial.sheet, partial.source, ready.on_line, lambda sheet: _close_contacts(partial, sheet)
    )
    return replace(partial, sheet=sheet, repaired=sheet)


def weld_seams(partial: PartialCompound, /) -> PartialCompound:
    """Puts the vertices of the sheet that are doubled at texture seams in one place, and inner skin at rest."""
    space = partial.space
    rest = fit(partial.space, partial.face).positions
    skin = np.where(space.on_sheet[:, None], partial.sheet[space.welded], rest).astype(np.float32)
    return replace(partial, skin=skin)


def follow_inner_skin(partial: PartialCompound, /) -> PartialCompound:
    """Moves the inner skin (mouth bag, nostrils, lid pockets) by few anchors on the sheet and its own residual.

    A harmonic extension, solved once per topology and kept as the ten largest weights of each vertex. Rejected: a
    solve per compound, which would cost more than the whole compound.
    """
    inner = partial.space.inner
    fitted = fit(partial.space, partial.face)
    skin = partial.skin.copy()
    follow_anchors(fitted.positions, inner.vertices, inner.anchors, inner.weights, partial.residual, fitted.scale, skin)
    return replace(partial, skin=skin)


def fit_mouth_bag(partial: PartialCompound, /) -> PartialCompound:
    """Pushes the mouth bag behind the skin where it comes out.

    Rays from the cylinder's axis find its depth; projection along the skin's normal, spread over four rings by a
    decaying maximum, up to twelve rounds. Rejected: moving the bag's walls with the teeth improved no face.
    """
    return replace(partial, skin=mouth_bag_fit.fit_mouth_bag(partial.space, partial.face, partial.skin))


def fit_socket_lining(partial: PartialCompound, /) -> PartialCompound:
    """Pushes the lining of the eye sockets behind the skin where it comes out.

    Rays from the cylinder's axis find the foremost skin; projection along its normal, up to four rounds.
    """
    return replace(partial, skin=socket_skin.fit_socket_lining(partial.space, partial.face, partial.skin))


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


def run(stages: Sequence[Stage], partial: PartialCompound, /) -> PartialCompound:
    """The partial compound after the stages, one after another."""
    for stage in stages:
        partial = stage(partial)
    return partial


def start(space: ParameterSpace, face: Face, displacement: Values, residual: Floats, /) -> PartialCompound:
    """The partial compound before the first stage: the face at rest, the generic face displaced by (V, 3) metres.

    space: the space of the generic head; displacement: of the generic face (V, 3), metres; residual: of the inner skin
    (n, 3), metres.
    """
    ready = prepare_smooth_map(space, face)
    moved = ready.generic + displacement
    rest = fit(space, face).positions
    return PartialCompound(space, face, ready, displacement, moved, residual, ready.positions, rest)


def transfer_expression(
    space: ParameterSpace, face: Face, compiled: Compiled, /, stages: Sequence[Stage] = STAGES
) -> Floats:
    """A face wearing a compiled expression under the smooth map: (V, 3) float32, metres.

    space: the space of the generic head; stages: of the transfer, in their order.
    """
    return run(stages, start(space, face, displace_generic(space, compiled), compiled.residual)).skin


def apply_smooth_map(
    space: ParameterSpace, face: Face, displacement: Values, /, stages: Sequence[Stage] = SHEET_STAGES
) -> Values:
    """The sheet of a face moved as a displacement (V, 3) moves the generic face: (V, 3) metres, float64.

    space: the space of the generic head; stages: of the transfer, in their order.
    """
    still = np.zeros((len(space.inner.vertices), 3), np.float32)
    return run(stages, start(space, face, displacement, still)).sheet


def _close_contacts(partial: PartialCompound, sheet: Values) -> None:
    for contact in partial.smooth_map.contacts:
        close_contact(contact, sheet, partial.source)
