"""Rigs: the joints of a scene, and how its meshes hang on them, whatever the format."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from omote.arrays import Indices, Points, Values

Position = tuple[float, float, float]


@dataclass(frozen=True)
class Joint:
    """A joint at rest: metres in the scene, and the name of its parent, which comes before it; "" for the root."""

    name: str
    place: Position
    parent: str = ""


@dataclass(frozen=True, eq=False)
class Motion:
    """A pose of the joints. turns (J, 3, 3): the rotation of each against its parent; travel (3,): where the first is,
    metres."""

    turns: Values
    travel: Points


@dataclass(frozen=True, eq=False)
class Rig:
    """Joints that turn nothing at rest, and meshes on them.

    joints: parents first; inverse (J, 4, 4): from where the meshes' vertices are kept to each joint's own frame (the
    inverse of its place there); weights: by the name of a mesh, how much each joint moves each vertex (n, J), sum one;
    carrier: the joint on which all other meshes hang; motions: poses by name.
    """

    joints: tuple[Joint, ...]
    inverse: Values
    weights: Mapping[str, csr_array]
    carrier: str
    motions: Mapping[str, Motion]

    @property
    def parents(self) -> Indices:
        """The place (J,) of each joint's parent, -1 of the first."""
        places = {joint.name: place for place, joint in enumerate(self.joints)}
        return np.array([places.get(joint.parent, -1) for joint in self.joints])

    @property
    def steps(self) -> Points:
        """Where each joint is from its parent (J, 3), metres; the first from the origin."""
        places = np.array([joint.place for joint in self.joints])
        parents = self.parents
        return np.asarray(np.where(parents[:, None] < 0, places, places - places[parents]))


def strongest_weights(weights: csr_array, count: int, /) -> tuple[Indices, Values]:
    """The joints that move each vertex most, (n, count) of both: their places and weights, which fall and sum to one.

    weights (n, J): of all joints; count: how many are kept.
    """
    whole = weights.toarray()
    joints = np.argsort(-whole, axis=1, kind="stable")[:, :count]
    kept = np.take_along_axis(whole, joints, axis=1)
    return np.where(kept > 0.0, joints, 0).astype(np.int32), kept / kept.sum(axis=1, keepdims=True)


def whole_weights(weights: Values, most: int, /) -> Indices:
    """Weights as whole numbers that sum to `most`: what rounding leaves goes to the first.

    weights (n, k): which fall and sum to one; most: what stands for one.
    """
    whole = np.rint(most * weights).astype(np.int64)
    whole[:, 0] += most - whole.sum(axis=1)
    return whole.astype(np.int32)
