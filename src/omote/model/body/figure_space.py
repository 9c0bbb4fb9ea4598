"""The space of figures: the mesh that all bodies share with all heads, its skeleton, and how a head joins a body."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from omote.arrays import Floats, Indices, Points, Triangles, Values
from omote.geometry.mesh import freeze
from omote.model.body.skeleton import Skeleton

BONES_OF_A_ROW = 8
"""Bones that move one row of a figure at most: eight err by .22 mm where six err by 7 (measured on the package)."""


@dataclass(frozen=True, eq=False)
class FigureSpace:
    """One topology: the rows of the head's skin, then those of the body, of which a skirt is the last: V + B together.

    Parameters
    ----------
    head_rows : int
        V, rows of the head's skin.
    triangles : (t, 3) of int
        Of the body; its rim is among the head's rows.
    skeleton : Skeleton
        J bones.
    bones, weights : (V + B, 8) of int and float
        Which bones move a row, and how much each: they sum to one.
    shares : (V + B,) of float
        How much of a row's move dual quaternions make (`omote.geometry.skinning`): none where limbs part from the
        trunk, all of it elsewhere.
    edge : (e,) of int
        Rows of the head at which it meets the body: first the rim, which the body's triangles share, then the ring
        of the head above it.
    rim : int
        How many of `edge` are the rim.
    joined, join : (n,) of int and (n, e) of float
        Rows of the body (0 is its first) that follow the edge of a head, and by which shares: what the head's edge is
        off the body's own is spread over them.
    head_joint : (h,) of int
        Rows of the head whose mean, moved by `head_joint_offset` (3,) metres, is the joint that the head turns on.
    uvs, uv_rows
        Texture coordinates (k, 2), (0, 0) the upper left corner, and the row of `uvs` at each triangle's corner (t, 3).
    skirt : (s, 3) of int
        Triangles of the skirt, whose rows are the last of the body; garments show it or leave it out.
    bending, bending_hinges : (c,) of int
        Rows of the figure that have correctives, and which joint of
        `omote.model.body.correctives` calls them.

    References
    ----------
    docs/method.md, "Bodies"; M. Botsch and L. Kobbelt, An intuitive framework for real-time freeform modeling, 2004:
    the biharmonic shares of the join.
    """

    head_rows: int
    triangles: Triangles
    skeleton: Skeleton
    bones: Indices
    weights: Floats
    shares: Floats
    edge: Indices
    rim: int
    joined: Indices
    join: Floats
    head_joint: Indices
    head_joint_offset: Values
    uvs: Floats
    uv_rows: Triangles
    skirt: Triangles = field(default_factory=lambda: np.zeros((0, 3), np.int32))
    bending: Indices = field(default_factory=lambda: np.zeros(0, np.int32))
    bending_hinges: Indices = field(default_factory=lambda: np.zeros(0, np.int32))

    def __post_init__(self) -> None:
        count = len(self.bones)
        if self.bones.shape != (count, BONES_OF_A_ROW) or self.weights.shape != self.bones.shape:
            raise ValueError(
                f"a figure has bones {self.bones.shape} and weights {self.weights.shape}; "
                f"expected (rows, {BONES_OF_A_ROW}) for both"
            )
        if np.abs(self.weights.sum(axis=1) - 1.0).max(initial=0.0) > 1e-5:
            raise ValueError("the weights of a figure's rows do not sum to one")
        if self.join.shape != (len(self.joined), len(self.edge)):
            raise ValueError(f"the join is {self.join.shape}; expected ({len(self.joined)}, {len(self.edge)})")
        if self.bending.shape != self.bending_hinges.shape:
            raise ValueError(f"{len(self.bending)} rows bend on {len(self.bending_hinges)} hinges; expected one each")
        for name in (
            "triangles",
            "bones",
            "weights",
            "shares",
            "edge",
            "joined",
            "join",
            "head_joint",
            "uvs",
            "uv_rows",
            "skirt",
            "bending",
            "bending_hinges",
        ):
            freeze(getattr(self, name))

    @property
    def body_rows(self) -> int:
        """B, rows of the body below the head's rim."""
        return len(self.bones) - self.head_rows

    @cached_property
    def first_of_skirt(self) -> int:
        """The first row of the skirt; as many as there are rows where there is none."""
        return int(self.skirt.min()) if len(self.skirt) else len(self.bones)

    @cached_property
    def rim_rows(self) -> Indices:
        """The rows of the head that the body's triangles share."""
        return self.edge[: self.rim]


def join_head(space: FigureSpace, body: Points, edge: Points, head: Points) -> Points:
    """The rows of a body as they hang below a head, (B, 3) metres.

    The body is moved by the mean difference of the rims, and what is left between them is spread over the rows near
    the neck; so it is linear in both, and no gap can open.

    space: of both; body (B, 3): a body's rows below the rim, or a mix of bodies'; edge (e, 3): where it has the head's
    edge; head (V, 3): the rows of a face, or of a mix of faces.
    """
    off = head[space.edge] - edge
    shift = off[: space.rim].mean(axis=0)
    hung = body + shift
    hung[space.joined] += space.join @ (off - shift)
    return np.asarray(hung)


def hang_joints(space: FigureSpace, joints: Points, edge: Points, head: Points) -> Points:
    """The joints (J, 3) of a body below a head: moved with it, and the head's own put where the face has it.

    space, edge, head: as of `join_head`; joints (J, 3): a body's, or a mix of bodies'.
    """
    shift = (head[space.rim_rows] - edge[: space.rim]).mean(axis=0)
    hung = joints + shift
    hung[space.skeleton.places["head"]] = head[space.head_joint].mean(axis=0) + space.head_joint_offset
    return np.asarray(hung)
