"""The channels that play limb fields: expressions that leave the face alone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from omote.model.body.limb_recipe import LIMB_KIND
from omote.model.cast import Cast
from omote.model.space.expression import Expression, Title

REGION = "body"


def with_limb_channels(cast: Cast) -> Cast:
    """A cast with an expression for each limb field of its figures, under the field's name.

    The expression is the field at rest: it moves no head, but is called, mixed, faded, cued and recorded as all are,
    and figures wear the limb field by its weight.

    cast: with figures, or without, which leaves it as it is.

    Raises
    ------
    ValueError
        Where an expression has the name of a field.
    """
    fields = {} if cast.figures is None else cast.figures.limb_fields
    taken = fields.keys() & cast.expressions.keys()
    if taken:
        raise ValueError(f"the cast has expressions {', '.join(sorted(taken))}; give the limb fields other names")
    still = np.zeros(cast.space.vertex_count)
    channels = {
        name: Expression(
            dtheta=still, dh=still, ratio=np.ones_like(still), residual=np.zeros((len(cast.space.inner.vertices), 3)),
            radius=cast.space.radius, transfer=cast.space.transfer, name=name,
        )
        for name in fields
    }  # fmt: skip
    titles = {name: Title(field.label, LIMB_KIND, REGION) for name, field in fields.items()}
    return replace(cast, expressions={**cast.expressions, **channels}, titles={**cast.titles, **titles})
