"""The correctives of a frame: what its compounds are allowed, where its eyeballs stand, what moves with the skin."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from omote.arrays import Floats, Values
from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import predict_part
from omote.model.transfer.corrective_regions import find_corrective_regions
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.correctives import Eyeballs, correct_combination
from omote.perform.blending.region_masks import play_masks
from omote.perform.blending.weighted_sum import weighted_sum
from omote.perform.channels import eye_angles
from omote.perform.frame import Frame
from omote.perform.mix import Weights, combine, mix_in


def angles_of_eyes(cast: Cast, frame: Frame, channels: Mapping[str, float]) -> Values:
    """Yaw and pitch (radians) of both eyeballs, (2, 2): of the mix of a frame that shows around the eyes, and of the
    weights of channels, expressions of the cast by name."""
    return eye_angles(cast.expressions, mix_in("eyes", frame.expressions, frame.regions), channels)


def correct_frame(cast: Cast, frame: Frame, channels: Mapping[str, float], mixed: Floats) -> Floats:
    """The skin (V, 3) of a frame, corrected where compounds together fold or pierce what none does alone, metres.

    cast, frame: as `evaluate` takes them; channels: the frame's weights, its gaze included; mixed (V, 3): eq. 3.
    """
    regions = find_corrective_regions(cast.space)
    if regions is None or not _is_moved(frame, channels):
        return mixed
    fitted = [(s, fit(cast.space, cast.faces[face])) for face, s in frame.faces.items()]
    angles = angles_of_eyes(cast, frame, channels)
    balls = [(s, Eyeballs.of(face, regions.eyes, angles)) for s, face in fitted]
    centres = np.asarray(sum_points((s, ball.centres) for s, ball in balls))
    whole = Eyeballs(centres, np.asarray(sum(s * ball.radii for s, ball in balls)), angles)
    rest = weighted_sum([(s, face.positions) for s, face in fitted])
    return correct_combination(regions, rest, mixed, _allowed(cast, frame, channels), whole)


def _is_moved(frame: Frame, channels: Mapping[str, float]) -> bool:
    """Whether anything but the neutral expression weighs something."""
    mixes = (frame.expressions, channels, *frame.regions.values())
    return any(weight for mix in mixes for name, weight in mix.items() if name != NEUTRAL)


def _allowed(cast: Cast, frame: Frame, channels: Mapping[str, float]) -> Floats:
    """The allowances of all compounds, each times the size of its weight, of an expression's at most 1: beyond it lids
    press and triangles stay upright, as far as they do at 1. In each region of that region's own mix."""
    whole = _allowances(cast, frame, frame.expressions, channels)
    total = whole
    for region, mix in sorted(frame.regions.items()):
        if mix != frame.expressions:
            mask = play_masks(cast.space)[region].allowances
            total = total + mask * (_allowances(cast, frame, mix, channels) - whole)
    return total


def _allowances(cast: Cast, frame: Frame, mix: Weights, channels: Mapping[str, float]) -> Floats:
    compounds = compound_cache(cast)
    sizes = {
        (face, name): abs(s) * min(abs(weight), 1.0)
        for face, s in frame.faces.items()
        for name, weight in combine(((1.0, mix), (1.0, channels))).items()
        if name != NEUTRAL and s * weight
    }
    if not sizes:
        return np.zeros_like(compounds.allowance(next(iter(frame.faces)), NEUTRAL))
    return weighted_sum([(size, compounds.allowance(*key)) for key, size in sizes.items()])


def correct_parts(
    cast: Cast, frame: Frame, channels: Mapping[str, float], mixed: Floats, moved: Mapping[str, Floats]
) -> dict[str, Floats]:
    """The parts that are attached to the skin, moved with it where it is corrected: (n, 3) by name, metres.

    cast, frame, channels, mixed: as for `correct_frame`; moved: all parts as blended.
    """
    regions = find_corrective_regions(cast.space)
    if regions is None:
        return {}
    corrected = correct_frame(cast, frame, channels, mixed)
    if corrected is mixed:
        return {}
    move = corrected.astype(np.float64) - mixed
    return {
        part: (moved[part] + predict_part(cast.space, part, move)).astype(np.float32) for part in regions.attached_parts
    }


def sum_points(terms: Iterable[tuple[float, Values]]) -> Values:
    """The sum of weight times points, each (3,) or (n, 3)."""
    return sum((weight * points for weight, points in terms), start=np.zeros(3))
