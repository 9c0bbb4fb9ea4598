"""The positions of a frame (docs/method.md, "Bilinear and exact"). The head's direction is left to the stage."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Literal

import numpy as np

from omote.arrays import Floats
from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL, PlayRegion, check_play_region
from omote.model.space.ears import turn_ears
from omote.model.space.face_fit import FittedFace, fit, generic_face
from omote.model.transfer.compound import move_parts, turn_eyes
from omote.model.transfer.paper_map import apply_paper_map
from omote.perform.blending.answered_mix import AnsweredMix, RegionalMix, answered_mix
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.frame_correctives import angles_of_eyes, correct_frame, correct_parts, sum_points
from omote.perform.blending.region_masks import PlayMask, play_masks
from omote.perform.blending.weighted_sum import weighted_sum
from omote.perform.channels import channels_of, highest_weight, lowest_weight
from omote.perform.frame import Frame
from omote.perform.limits import check_known, check_within
from omote.perform.mix import Weights, combine
from omote.perform.saturation import saturate

Mode = Literal["bilinear", "exact"]
MODES: tuple[Mode, ...] = ("bilinear", "exact")
FARTHEST = 10.0
"""A weight's size at most: mixes made by hand may go far beyond their ends, and stay finite."""
ROUNDING = 1e-4
"""How far from one the weights of a mix may sum."""


def evaluate(cast: Cast, frame: Frame, mode: Mode = "bilinear") -> Floats:
    """The skin and inner skin of a frame.

    bilinear (eq. 3, with channels): sum_i s_i [sum_j t_j P_ij + sum_k c_k (P_ik - M_i)], where t_j of a vertex is the
    mean of the regions' own by how much of it belongs to each (`Frame.regions`);
    exact: the face sum_i s_i M_i wears the expression sum_j t_j D_j + sum_k c_k D_k, located anew (transfer="paper");
    with transfer="smooth" the generic face wears it so, and the faces follow by their own compounds.

    Parameters
    ----------
    cast : Cast
        The faces M_i and expressions D_j that the frame names.
    frame : Frame
        The weights s, t and c, from `Performer.advance`.
    mode : {"bilinear", "exact"}
        The formula; stages draw the first.

    Returns
    -------
    ndarray of float32, (V, 3)
        Metres; the head is not turned.

    Raises
    ------
    ValueError
        On an unknown mode, names that are not in the cast, weights that are not finite or do not sum to one on an axis,
        and channels out of range.
    TypeError
        On weights that are no numbers.

    Examples
    --------
    >>> performer = omote.Performer(cast)
    >>> performer.call_face("old", seconds=2)
    >>> omote.evaluate(cast, performer.advance(0.5)).shape
    (4278, 3)

    References
    ----------
    K. Arai (1993), equation 3; docs/method.md, "The mix".
    """
    channels, mixed = _blend(cast, frame, mode)
    return correct_frame(cast, frame, channels, mixed)


def evaluate_parts(cast: Cast, frame: Frame, mode: Mode = "bilinear") -> dict[str, Floats]:
    """The parts of a frame, eyeballs turned about their centres.

    Parameters
    ----------
    cast : Cast
        The faces and expressions that the frame names.
    frame : Frame
        The weights.
    mode : {"bilinear", "exact"}
        As of `evaluate`.

    Returns
    -------
    dict of ndarray of float32 (n, 3), by the name of a part
        Metres.

    Raises
    ------
    ValueError
        As `evaluate`.
    TypeError
        As `evaluate`.

    Examples
    --------
    >>> sorted(omote.evaluate_parts(cast, omote.Performer(cast).advance(0.0)))[:3]
    ['eye_left', 'eye_right', 'lashes']

    References
    ----------
    docs/method.md, "The mix".
    """
    channels, mixed = _blend(cast, frame, mode)
    moved = _exact_parts(cast, frame, channels, mixed) if mode == "exact" else _bilinear_parts(cast, frame, channels)
    moved |= correct_parts(cast, frame, channels, mixed, moved)
    fitted = [(weight, fit(cast.space, cast.faces[face])) for face, weight in frame.faces.items()]
    centres = {part: sum_points((weight, face.centres[part]) for weight, face in fitted) for part in cast.space.parts}
    return turn_eyes(cast.space, moved, centres, angles_of_eyes(cast, frame, channels))


def _blend(cast: Cast, frame: Frame, mode: Mode) -> tuple[Mapping[str, float], Floats]:
    """The channels of a frame that can be played, and its skin (V, 3) before correctives."""
    check_playable(cast, frame)
    if not isinstance(mode, str) or mode not in MODES:
        raise ValueError(f"mode is {mode!r}; expected one of {', '.join(map(repr, MODES))}")
    channels = saturate(cast.expressions, frame, channels_of(cast.expressions, frame))
    return channels, (_exact if mode == "exact" else _bilinear)(cast, frame, channels)


def warm(cast: Cast) -> None:
    """Compiles every kernel that a frame of this cast needs, so that no frame of the show does."""
    name = next(iter(cast.faces))
    for mode in MODES:
        evaluate(cast, Frame({name: 1.0}, {NEUTRAL: 1.0}), mode)
        evaluate_parts(cast, Frame({name: 1.0}, {NEUTRAL: 1.0}), mode)


def _sum_compounds(
    cast: Cast, frame: Frame, channels: Mapping[str, float], at_rest: Callable[[str], Floats],
    compound: Callable[[str, str], Floats], mask: Callable[[PlayMask], Floats],
) -> Floats:  # fmt: skip
    """Eq. 3 of Arai (1993), P = sum_i s_i sum_j t_j P_ij, for any number of faces and expressions: (n, 3), metres.

    channels: weights c_k; their compounds hold faces at rest sum_k c_k times too often. at_rest: the positions (n, 3)
    of a face; compound: those of a face that wears an expression; mask: how much of each belongs to a region, (n, 1).
    """

    def worn(weights: Weights) -> list[tuple[float, Floats]]:
        return [(s * weights[name], compound(face, name)) for face, s in frame.faces.items() for name in weights]

    doubled = math.fsum(channels.values())
    rests = [(-s * doubled, at_rest(face)) for face, s in frame.faces.items() if doubled]
    total = weighted_sum(rests + worn(combine(((1.0, frame.expressions), (1.0, channels)))))
    for _, region, more in _regional(cast, frame):
        total += mask(region) * weighted_sum(worn(more))
    return total


def _regional(cast: Cast, frame: Frame) -> list[tuple[PlayRegion, PlayMask, Weights]]:
    """The regions that show another mix than the face, their masks, and by how much weights differ from the face's;
    they sum to nothing."""
    differ = {region: combine(((1.0, mix), (-1.0, frame.expressions))) for region, mix in sorted(frame.regions.items())}
    return [(region, play_masks(cast.space)[region], more) for region, more in differ.items() if more]


def _bilinear(cast: Cast, frame: Frame, channels: Mapping[str, float]) -> Floats:
    """Eq. 3 of the skin."""
    skin = compound_cache(cast).skin
    return _sum_compounds(cast, frame, channels, lambda face: cast.faces[face].positions, skin, lambda mask: mask.skin)


def _exact(cast: Cast, frame: Frame, channels: Mapping[str, float]) -> Floats:
    worn = _worn(cast, frame, channels)
    if cast.space.transfer == "smooth":
        return _bilinear(cast, frame, channels) + _nonlinear_part(cast, worn)
    face = _mix_faces(cast, frame.faces)
    skin = apply_paper_map(cast.space, face, worn.compile())
    return turn_ears(cast.space, face.positions, skin, worn.ears) if worn.ears.any() else skin


def _worn(cast: Cast, frame: Frame, channels: Mapping[str, float]) -> AnsweredMix:
    """What the faces make of the whole face's mix and channels, and of what regions show beyond it."""
    worn = answered_mix(cast, frame.faces, combine(((1.0, frame.expressions), (1.0, channels))))
    regions = [
        RegionalMix(region, mask, answered_mix(cast, frame.faces, more))
        for region, mask, more in _regional(cast, frame)
    ]
    return worn.with_regions(regions) if regions else worn


def _nonlinear_part(cast: Cast, worn: AnsweredMix) -> Floats:
    """What the generic face wears when fields add on S, less the same mix of its compounds: (V, 3), metres.

    The smooth map carries displacements, and carries this one as it is: nothing where one expression is worn.
    """
    source = fit(cast.space, generic_face(cast.space))
    alone = worn.compounds()
    total = math.fsum(weight for _, weight in alone)
    mixed = apply_paper_map(cast.space, source, worn.compile())
    alone_terms = [(-weight, positions) for positions, weight in alone]
    return weighted_sum([(1.0, mixed), (total - 1.0, source.positions), *alone_terms])


def _mix_faces(cast: Cast, weights: Mapping[str, float]) -> FittedFace:
    """The fitted face sum s_i M_i; sizes of residuals and parts mix like the positions."""
    fitted = [(s, fit(cast.space, cast.faces[face])) for face, s in weights.items()]
    positions = weighted_sum([(s, face.positions) for s, face in fitted])
    cylinder = cast.space.cylinder
    radii = np.hypot(positions[:, 0] - np.float32(cylinder.x), positions[:, 2] - np.float32(cylinder.z))
    return FittedFace(
        positions=positions,
        radii=radii,
        scale=weighted_sum([(s, face.scale) for s, face in fitted]),
        parts={part: weighted_sum([(s, face.parts[part]) for s, face in fitted]) for part in cast.space.parts},
        sizes={part: sum(s * face.sizes[part] for s, face in fitted) for part in cast.space.parts},
        centres={},
    )


def _exact_parts(cast: Cast, frame: Frame, channels: Mapping[str, float], mixed: Floats) -> dict[str, Floats]:
    worn = _worn(cast, frame, channels)
    rest = {part: worn.part_residual(part) for part in cast.space.parts}
    return move_parts(cast.space, _mix_faces(cast, frame.faces), mixed, rest)


def _bilinear_parts(cast: Cast, frame: Frame, channels: Mapping[str, float]) -> dict[str, Floats]:
    """Eq. 3 of all parts."""
    parts = compound_cache(cast).parts

    def blend(part: str) -> Floats:
        return _sum_compounds(
            cast, frame, channels, lambda face: fit(cast.space, cast.faces[face]).parts[part],
            lambda face, name: parts(face, name)[part], lambda mask: mask.parts[part],
        )  # fmt: skip

    return {part: blend(part) for part in cast.space.parts}


def check_playable(cast: Cast, frame: Frame) -> None:
    """Refuses a frame that names what a cast has not, or whose weights cannot be played: TypeError, ValueError."""
    if not isinstance(cast, Cast) or not isinstance(frame, Frame):
        raise TypeError(f"got {type(cast).__name__} and {type(frame).__name__}; expected a Cast and a Frame")
    if not isinstance(frame.regions, Mapping):
        raise TypeError(f"the frame's regions are {type(frame.regions).__name__}; expected mixes by region")
    _refuse_no_average(frame.faces, cast.faces, "face")
    _refuse_no_average(frame.expressions, cast.expressions, "expression")
    for region, mix in frame.regions.items():
        _refuse_no_average(mix, cast.expressions, f"{check_play_region(region)} expression")
    for name, weight in _pairs_of(frame.channels, "channel"):
        what = f"the channel {check_known(name, cast.expressions, 'channel')}"
        check_within(weight, lowest_weight(cast.expressions, name), highest_weight(cast.expressions, name), what)


def _refuse_no_average(weights: Mapping[str, float], names: Mapping[str, object], what: str) -> None:
    total = math.fsum(
        check_within(weight, -FARTHEST, FARTHEST, f"the weight of the {what} {check_known(name, names, what)}")
        for name, weight in _pairs_of(weights, what)
    )
    if abs(total - 1.0) > ROUNDING:
        raise ValueError(f"the weights of the frame's {what}s sum to {total:.6g}; expected one: a mix is an average")


def _pairs_of(weights: Mapping[str, float], what: str) -> Iterable[tuple[str, float]]:
    if not isinstance(weights, Mapping):
        raise TypeError(f"the frame's {what}s are {type(weights).__name__}; expected weights by name")
    return weights.items()
