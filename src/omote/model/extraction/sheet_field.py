"""The field on S of a displacement of a face's sheet (paper, section 2.2, steps 1a to 1d)."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.geometry.cylinder import wrap
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import project_to_surface

# Displacements below a nanometre are rest: fields stay empty where nothing moves.
REST = 1e-9


def measure_field(space: ParameterSpace, before: Values, moved: Values, /) -> Expression:
    """The expression of the sheet's displacement alone: inner skin and parts follow, without residuals.

    Parameters
    ----------
    space : ParameterSpace
        The space of the face.
    before : ndarray, (V, 3)
        The face at rest, metres.
    moved : ndarray, (V, 3)
        Where each vertex goes from there, metres; only the sheet counts.

    Returns
    -------
    Expression
        The field on S, under the rules of the space.
    """
    after = before + moved
    vertices = np.flatnonzero(space.on_sheet & (np.abs(moved) > REST).any(axis=1)).astype(np.int32)
    landing = project_to_surface(space, before, after[vertices], vertices)
    dtheta = np.zeros(len(before))
    dh = np.zeros(len(before))
    ratio = np.ones(len(before))
    corners = space.location_triangles[landing.triangles]
    from_first = wrap(space.theta[corners] - space.theta[corners[:, :1]])
    theta = space.theta[corners[:, 0]] + (landing.weights * from_first).sum(axis=1)
    dtheta[vertices] = wrap(theta - space.theta[vertices])
    dh[vertices] = (landing.weights * space.h[corners]).sum(axis=1) - space.h[vertices]
    surface = (landing.weights[..., None] * before[corners]).sum(axis=1)
    reference = before[vertices] if space.radius == "origin" else surface
    ratio[vertices] = _radius(space, after[vertices]) / np.maximum(_radius(space, reference), 1e-9)
    still = np.zeros((len(space.inner.vertices), 3))
    return Expression(dtheta, dh, ratio, still, radius=space.radius, transfer=space.transfer)


def _radius(space: ParameterSpace, points: Values) -> Values:
    return space.cylinder.unroll(points)[2]
