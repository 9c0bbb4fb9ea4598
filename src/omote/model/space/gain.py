"""Gains: in which strength a face answers expressions, region by region (docs/method.md, "The face's own strength")."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Literal, get_args

import numpy as np

from omote.arrays import Values
from omote.model.space.expression import Expression, refuse_name
from omote.model.space.head_regions import region_mask
from omote.model.space.parameter_space import ParameterSpace

FieldRegion = Literal["brows", "eyes", "nose", "cheeks", "mouth", "jaw"]
GainRegion = Literal[FieldRegion, "ears", "head"]
FIELD_REGIONS: tuple[FieldRegion, ...] = get_args(FieldRegion)
GAIN_REGIONS: tuple[GainRegion, ...] = get_args(GainRegion)
NEUTRAL_GAINS: Mapping[GainRegion, float] = MappingProxyType(
    {region: 0.0 if region in ("ears", "head") else 1.0 for region in GAIN_REGIONS}
)
"""The gains of a face that sets none: it wears the field as it is; its ears and its head do not turn, as people's."""
LEAST_GAIN = 0.0
MOST_GAIN = 4.0
LEAST_RATIO = 0.05
"""Of a radius R to itself: a gain that would bring it lower stops there, short of the axis."""
# Gains that differ by less are the same; no lower one is divided by.
_ROUNDING = 1e-9
_LEAST_INVERTED = 1e-3


@dataclass(frozen=True)
class Gain:
    """The strength in which a face answers expressions in one region.

    Parameters
    ----------
    region : str
        brows, eyes, nose, cheeks, mouth, jaw: what the expression's field does there; ears, head: how far they turn
        where the expression turns them.
    value : float
        0 to 4. 1 as the field says (with ears and head: as far as the expression says), 0 not at all.
    expression : str, optional
        The name of a built-in expression that alone is answered so; without it all that have no gain of their own here.

    Raises
    ------
    ValueError
        On unknown regions, names that nobody could call and values out of range.

    Examples
    --------
    >>> Gain = omote.Gain
    >>> dog = omote.Face("hound", cast.faces["dog"].positions, gains=[Gain("brows", 1.6), Gain("mouth", 2, "angry")])
    >>> dog.gains[0]
    Gain(region='brows', value=1.6, expression=None)

    References
    ----------
    docs/method.md, "The face's own strength"; docs/decisions/gains-and-animals.md.
    """

    region: GainRegion
    value: float
    expression: str | None = None

    def __post_init__(self) -> None:
        check_gain_region(self.region)
        if self.expression is not None:
            refuse_name(self.expression, f"the expression of the gain of {self.region}")
        number = self.value
        usable = isinstance(number, int | float | np.floating) and not isinstance(number, bool)
        if not usable or not LEAST_GAIN <= number <= MOST_GAIN:
            raise ValueError(
                f"the gain of {self.region} is {number!r}; expected a number from {LEAST_GAIN:g} (no answer) to "
                f"{MOST_GAIN:g}, 1 for the expression's own strength"
            )
        object.__setattr__(self, "value", float(number))


def check_gain_region(name: str, /) -> GainRegion:
    """The region of this name; ValueError where faces have no gain of it."""
    for region in GAIN_REGIONS:
        if region == name:
            return region
    raise ValueError(f"a gain is of region {name!r}; expected one of {', '.join(GAIN_REGIONS)}")


def validate_gains(gains: Iterable[Gain], what: str, /) -> tuple[Gain, ...]:
    """The gains of a face in one order, without those that change nothing; TypeError on what is no gain, ValueError
    where two are of one region and expression."""
    given = list(gains)
    for gain in given:
        if not isinstance(gain, Gain):
            raise TypeError(f"a gain of {what} is a {type(gain).__name__}; expected an omote.Gain")
    known = {(gain.region, gain.expression): gain for gain in given}
    if len(known) < len(given):
        keys = [(gain.region, gain.expression) for gain in given]
        twice = next(gain for number, gain in enumerate(given) if keys.index(keys[number]) < number)
        raise ValueError(
            f"{what} has two gains of {twice.region} for {twice.expression or 'all expressions'}; expected one"
        )
    ordered = sorted(known.values(), key=lambda gain: (GAIN_REGIONS.index(gain.region), gain.expression or ""))
    return tuple(gain for gain in ordered if not _is_idle(ordered, gain))


def _is_idle(gains: Sequence[Gain], gain: Gain) -> bool:
    """Whether a gain says what would hold without it."""
    others = [other for other in gains if other is not gain]
    return abs(gain.value - gain_of(others, gain.region, gain.expression)) < _ROUNDING


def gain_of(gains: Iterable[Gain], region: GainRegion, expression: str | None = None, /) -> float:
    """The gain of a region for an expression by name: its own, else that for all, else the neutral one.

    gains: those of the face.
    """
    value = NEUTRAL_GAINS[region]
    for gain in gains:
        if gain.region == region and gain.expression == expression and expression is not None:
            return gain.value
        if gain.region == region and gain.expression is None:
            value = gain.value
    return value


def mix_gains(gains: Sequence[tuple[Sequence[Gain], float]], /) -> tuple[Gain, ...]:
    """The gains of a mix of faces: gains by shares that sum to one."""
    keys = dict.fromkeys((gain.region, gain.expression) for some, _ in gains for gain in some)
    mixed = [
        Gain(region, _within(math.fsum(share * gain_of(some, region, name) for some, share in gains)), name)
        for region, name in keys
    ]
    return validate_gains(mixed, "a mix of faces")


def _within(value: float) -> float:
    return min(max(value, LEAST_GAIN), MOST_GAIN)


def regional_gains(gains: Sequence[Gain], regions: Mapping[str, Sequence[Gain]], /) -> tuple[Gain, ...]:
    """The gains with those of each region from another face's gains. regions: gains by the name of the region."""
    kept = [gain for gain in gains if gain.region not in regions]
    taken = [gain for region, others in regions.items() for gain in others if gain.region == region]
    return validate_gains([*kept, *taken], "a face")


def override_gains(gains: Sequence[Gain], own: Sequence[Gain], /) -> tuple[Gain, ...]:
    """The gains with own ones in place of those of the same region and expression."""
    known = {(gain.region, gain.expression): gain for gain in gains}
    known |= {(gain.region, gain.expression): gain for gain in own}
    return validate_gains(known.values(), "a face")


def changes_field(gains: Sequence[Gain], expression: str = "", /) -> bool:
    """Whether the field of an expression by name is answered otherwise than it is. gains: those of the face."""
    return any(gain_of(gains, region, expression) != 1.0 for region in FIELD_REGIONS)


@dataclass(frozen=True, eq=False)
class FieldGain:
    """The gain of every vertex: skin (V,), parts (n,) by name."""

    skin: Values
    parts: Mapping[str, Values]


def field_gain(space: ParameterSpace, gains: Sequence[Gain], expression: str = "", /) -> FieldGain | None:
    """The gain of each vertex for an expression by name, None where it is 1 everywhere; smooth, as the regions' masks.

    gains: those of the face.

    Raises ValueError where the space has no two eyeballs to measure the regions by.
    """
    over = {region: gain_of(gains, region, expression) - 1.0 for region in FIELD_REGIONS}
    masks = [(more, region_mask(space, region)) for region, more in over.items() if more]
    if not masks:
        return None
    skin = sum((more * mask.skin for more, mask in masks), np.ones(space.vertex_count))
    parts = {
        name: sum((more * mask.parts[name] for more, mask in masks), np.ones(len(part.points)))
        for name, part in space.parts.items()
    }
    return FieldGain(skin, parts)


def answer(
    space: ParameterSpace, gains: Sequence[Gain], expression: Expression, /, limited: FieldGain | None = None
) -> Expression:
    """The expression as a face with these gains answers it: the field, and what inner skin and parts do beyond it,
    times the gain of each vertex; ears' and head's turn times theirs. Eyeballs and pupils stay the expression's.

    space: the space of the generic head.

    limited: the gain of each vertex, in place of `field_gain`. It is the expression itself where that changes nothing.
    """
    ears = gain_of(gains, "ears", expression.name) * expression.ears
    head = gain_of(gains, "head", expression.name) * expression.head
    turned = expression
    if not (np.array_equal(ears, expression.ears) and np.array_equal(head, expression.head)):
        turned = replace(expression, ears=ears, head=head)
    factor = field_gain(space, gains, expression.name) if limited is None else limited
    return turned if factor is None else multiply_field(space, turned, factor)


def ask(space: ParameterSpace, gains: Sequence[Gain], answered: Expression, /) -> Expression:
    """The expression that is answered so by a face with these gains, by its field and ears: what extraction from that
    face needs.

    space: the space of the generic head.

    Where a gain is 0 only rest can be answered: the field rests there, and so do ears.
    """
    if answered.ears.any():
        gain = gain_of(gains, "ears", answered.name)
        answered = replace(answered, ears=answered.ears / gain if gain > _LEAST_INVERTED else 0.0 * answered.ears)
    factor = field_gain(space, gains, answered.name)
    if factor is None:
        return answered
    parts = {name: _invert(values) for name, values in factor.parts.items()}
    return multiply_field(space, answered, FieldGain(_invert(factor.skin), parts))


def _invert(values: Values) -> Values:
    seen = values > _LEAST_INVERTED
    return np.where(seen, 1.0 / np.where(seen, values, 1.0), 0.0)


def multiply_field(space: ParameterSpace, expression: Expression, factor: FieldGain, /) -> Expression:
    """The expression with its field, its residuals and those of parts times a factor per vertex.

    space: the space of the generic head.
    """
    ratio = np.maximum(1.0 + factor.skin * (expression.ratio - 1.0), LEAST_RATIO)
    return replace(
        expression,
        dtheta=factor.skin * expression.dtheta,
        dh=factor.skin * expression.dh,
        ratio=np.where(factor.skin == 1.0, expression.ratio, ratio),
        residual=factor.skin[space.inner.vertices, None] * expression.residual,
        parts={name: factor.parts[name][:, None] * rest for name, rest in expression.parts.items()},
    )
