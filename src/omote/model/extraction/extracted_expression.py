"""What extraction gives: an expression that says how far it may be off on other faces (docs/method.md, "What a
compound does not say")."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from omote.model.space.expression import Expression
from omote.model.space.head_regions import region_weights
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

TOLD = 1e-3
"""Metres; uncertainty below it is not told in words: what an extraction may be off on other faces."""


@dataclass(frozen=True, eq=False)
class ExtractedExpression(Expression):
    """An expression taken from a face, with what that face could not tell of it.

    Several fields can give the same displacement of a face, since the map turns folds back, pushes lids off eyeballs
    and the mouth bag behind the lips. It is worn like any expression; sums and edits of it are plain expressions.

    Parameters
    ----------
    dtheta, dh, ratio : array_like, (V,)
        The field on S, as of `omote.Expression`.
    residual : array_like, (inner, 3)
        What the inner skin does beyond it, metres.
    parts : mapping of array_like (n, 3), by the name of a part
        The same of the parts.
    eyes : array_like, (2, 2)
        Turns of the eyeballs, radians.
    radius, transfer, name : str
        The rules under which it was taken; extraction gives no name.
    pupil : float
        Nothing, 0: a displacement does not say it.
    ears : array_like, (2, 3)
        Turns of the ears, radians.
    head : array_like, (3,)
        Turn of the head, radians.
    uncertainty : ndarray of float64, (V,)
        How far the skin of other faces may be off, metres: 0 where the displacement says it, or a sum of known
        expressions does. An estimate, good on the sheet and low inside the mouth: `benchmarks/extraction.py` says how
        often it holds.

    Examples
    --------
    >>> dog, jaw = cast.faces["dog"], cast.expressions["jawOpen"]
    >>> moved = omote.compound(cast.space, dog, jaw) - dog.positions
    >>> omote.extract(cast.space, dog, moved, known=[jaw]).uncertainty.max()
    np.float64(0.0)

    References
    ----------
    docs/method.md, "What a compound does not say"; docs/decisions/0085-extraction-says-what-a-face-cannot-tell.md.
    """

    uncertainty: Values = field(default_factory=lambda: np.zeros(0))


def describe_uncertainty(space: ParameterSpace, taken: ExtractedExpression, /) -> str:
    """What an extracted expression's uncertainty means, in words: how much, and in which region; "" below TOLD."""
    worst = int(taken.uncertainty.argmax()) if len(taken.uncertainty) else 0
    if not len(taken.uncertainty) or taken.uncertainty[worst] < TOLD:
        return ""
    weights = region_weights(space)
    region = max(weights, key=lambda name: float(weights[name][worst]))
    place = "inside the mouth" if not space.on_sheet[worst] and region in ("mouth", "jaw") else f"at the {region}"
    return (
        "several expressions give this shape on this face; on others it may be some "
        f"{1000 * taken.uncertainty[worst]:.1f} mm off {place}"
    )
