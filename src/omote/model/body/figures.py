"""The figures of a cast: the space that all bodies share, and the bodies by name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from omote.model.body.body import Body
from omote.model.body.correctives import SHAPES
from omote.model.body.figure_space import FigureSpace
from omote.model.body.garment import Garment
from omote.model.body.limb_field import LimbField
from omote.model.body.limbs import NO_LIMBS, LimbSpace
from omote.model.body.pose import STAND, Pose
from omote.model.body.pose_recipe import PoseRecipe
from omote.model.known_names import KnownNames


@dataclass(frozen=True, eq=False)
class Figures:
    """The space of figures and all bodies in it.

    Parameters
    ----------
    space : FigureSpace
        What they share.
    bodies : mapping of Body
        By name; a face without a body of its name wears the first.
    poses : mapping of Pose
        By name, "stand" among them, which turns nothing.
    garments : mapping of Garment
        By name; a look that names none of them wears the first.
    recipes : mapping of PoseRecipe
        What those poses that people wrote were made from, by name.
    limbs : LimbSpace
        Where rows lie on unrolled limbs.
    limb_fields : mapping of LimbField
        By the name of the channel that plays each.

    Raises
    ------
    ValueError
        Where a body, a pose, a garment or a limb field does not fit the space, or there is no body.
    """

    space: FigureSpace
    bodies: Mapping[str, Body]
    poses: Mapping[str, Pose]
    garments: Mapping[str, Garment] = field(default_factory=dict)
    recipes: Mapping[str, PoseRecipe] = field(default_factory=lambda: MappingProxyType({}))
    limbs: LimbSpace = NO_LIMBS
    limb_fields: Mapping[str, LimbField] = field(default_factory=lambda: MappingProxyType({}))

    def __post_init__(self) -> None:
        if not self.bodies:
            raise ValueError("figures have no body; expected one at least")
        bones = len(self.space.skeleton.names)
        for name, body in self.bodies.items():
            shapes = (body.positions.shape, body.edge.shape, body.joints.shape, body.ends.shape, body.correctives.shape)
            counts = (self.space.body_rows, len(self.space.edge), bones, bones, SHAPES * len(self.space.bending))
            expected = tuple((count, 3) for count in counts)
            if shapes != expected:
                raise ValueError(
                    f"body {name!r} has rows, edge, joints, ends and correctives of {shapes}; expected {expected}"
                )
        for name, pose in self.poses.items():
            if pose.turns.shape != (bones, 3):
                raise ValueError(f"pose {name!r} turns {len(pose.turns)} bones; expected {bones}")
        stand = self.poses.get(STAND)
        if stand is None or stand.turns.any() or stand.travel.any() or stand.feet.any() or stand.feet_turns.any():
            raise ValueError(
                f"figures have no pose {STAND!r} that turns nothing; expected it: every pose counts from it"
            )
        _refuse_strange_garments(self.garments, len(self.space.bones))
        _refuse_strange_fields(self.limb_fields, len(self.limbs.rows))
        object.__setattr__(self, "garments", MappingProxyType(KnownNames("garment", self.garments)))
        object.__setattr__(self, "bodies", MappingProxyType(KnownNames("body", self.bodies)))
        object.__setattr__(self, "poses", MappingProxyType(KnownNames("pose", self.poses)))

    def body_of(self, face: str) -> Body:
        """The body that belongs to a face, by its name."""
        return self.bodies.get(face) or next(iter(self.bodies.values()))


def _refuse_strange_garments(garments: Mapping[str, Garment], rows: int) -> None:
    for name, garment in garments.items():
        if len(garment.cover) != rows:
            raise ValueError(f"garment {name!r} covers {len(garment.cover)} rows; expected {rows}")


def _refuse_strange_fields(fields: Mapping[str, LimbField], rows: int) -> None:
    for name, limb_field in fields.items():
        if len(limb_field.values) != rows:
            raise ValueError(f"limb field {name!r} moves {len(limb_field.values)} rows; expected {rows}")
