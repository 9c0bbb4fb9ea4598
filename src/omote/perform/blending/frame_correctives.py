"""The correctives of a frame: what its compounds are allowed, where its eyeballs stand, what moves with the skin."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

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

Floats = NDArray[np.float32]


def angles_of_eyes(cast: Cast, frame: Frame, channels: Mapping[str, float]) -> NDArray[np.float64]:
    """Yaw and pitch (radians) of both eyeballs, (2, 2): of the mix that shows around the eyes, and of channels."""
    return eye_angles(cast.expressions, mix_in("eyes", frame.expressions, frame.regions), channels)


def correct_frame(cast: Cast, frame: Frame, channels: Mapping[str, float], mixed: Floats) -> Floats:
    """The mix with its correctives, where compounds together fold or pierce what none does alone."""
    regions = find_corrective_regions(cast.space)
    if regions is None or not _is_moved(frame, channels):
        return mixed
    fitted = [fit(cast.space, cast.faces[face]) for face in frame.faces]
    factors = list(frame.faces.values())
    angles = angles_of_eyes(cast, frame, channels)
    balls = [Eyeballs.of(face, regions.eyes, angles) for face in fitted]
    whole = Eyeballs(
        np.asarray(sum_points((s, ball.centres) for s, ball in zip(factors, balls, strict=True))),
        np.asarray(sum(s * ball.radii for s, ball in zip(factors, balls, strict=True))), angles,
    )  # fmt: skip
    rest = weighted_sum([face.positions for face in fitted], factors)
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
    return weighted_sum([compounds.allowance(*key) for key in sizes], list(sizes.values()))


def correct_parts(
    cast: Cast, frame: Frame, channels: Mapping[str, float], mixed: Floats, moved: Mapping[str, Floats]
) -> dict[str, Floats]:  # fmt: skip
    """The parts that are attached to the skin, moved with it where it is corrected."""
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


def sum_points(terms: Iterable[tuple[float, NDArray[np.float64]]]) -> NDArray[np.float64]:
    """The sum of weight times points, each (3,) or (n, 3)."""
    return sum((weight * points for weight, points in terms), start=np.zeros(3))
