"""Bodies: shapes with the topology of the generic body, as faces are of the generic face."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Floats
from omote.geometry import mesh
from omote.model.space.expression import refuse_name


@dataclass(frozen=True, eq=False)
class Body:
    """One shape with the topology of the generic body (a global deformation).

    Parameters
    ----------
    name : str
        1 to 80 printable characters.
    positions : array_like, (B, 3)
        Skin below the head's rim, metres, in the head's frame (y = 0 at the eyes); kept as float32, read-only.
    edge : array_like, (e, 3)
        Where this body has the edge of a head (`FigureSpace.edge`).
    joints : array_like, (J, 3)
        Where its bones begin.
    ends : array_like, (J, 3)
        Where they end.
    size : float
        By how much it is drawn larger than its person is: children are enlarged, so that they fill a stage that is
        framed for adults.
    correctives : array_like, (4 c, 3)
        What is added to the rows that bend (`FigureSpace.bending`, c of them) before they are skinned, metres: the
        first corrective of their joints (`omote.model.body.correctives`), then the second, third and fourth.

    Raises
    ------
    ValueError
        On other shapes, values that are not finite and names that nobody could call.

    References
    ----------
    K. Arai (1993), section 2.1: global deformation data; section 5.3: whole characters.
    """

    name: str
    positions: Floats
    edge: Floats
    joints: Floats
    ends: Floats
    size: float = 1.0
    correctives: Floats = field(default_factory=lambda: np.zeros((0, 3), np.float32))

    def __post_init__(self) -> None:
        refuse_name(self.name, "a body")
        for what in ("positions", "edge", "joints", "ends"):
            object.__setattr__(self, what, _freeze(getattr(self, what), f"{what} of body {self.name!r}"))
        if len(self.correctives):
            object.__setattr__(self, "correctives", _freeze(self.correctives, f"correctives of body {self.name!r}"))
        if not 0.1 <= self.size <= 10.0:
            raise ValueError(f"the size of body {self.name!r} is {self.size}; expected 0.1 to 10")


def _freeze(points: ArrayLike, name: str) -> Floats:
    return mesh.freeze(np.ascontiguousarray(mesh.validate_points(points, name=name), dtype=np.float32))
