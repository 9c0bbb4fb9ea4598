"""Poses as people write them: joints by their names, angles in degrees as anatomy counts them."""

from __future__ import annotations

from typing import Annotated

import msgspec

Degrees = Annotated[float, msgspec.Meta(ge=-200.0, le=200.0)]
Legs = Annotated[float, msgspec.Meta(ge=-3.0, le=3.0)]
Curl = Annotated[float, msgspec.Meta(ge=-1.0, le=1.5)]
Turn = tuple[Degrees, Degrees, Degrees]
STILL: Turn = (0.0, 0.0, 0.0)


class Arm(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An arm, degrees: raised forward and spread to the side, which add up as the sides of a right angle do (both 90:
    up by 127 degrees, half forward, half aside); twist it inward about itself; elbow bends; forearm turns the palm
    inward and down (+) or up; wrist bends to the palm and to the thumb's side; shrug lifts the shoulder, reach brings
    it forward.

    curls: of thumb, index, middle, ring and little finger, -0.2 (stretched) to 1 (a fist); fan: fingers apart, -0.5 to
    1."""

    raised: Degrees = 0.0
    spread: Degrees = 0.0
    twist: Degrees = 0.0
    elbow: Degrees = 0.0
    forearm: Degrees = 0.0
    wrist: tuple[Degrees, Degrees] = (0.0, 0.0)
    shrug: Degrees = 0.0
    reach: Degrees = 0.0
    curls: tuple[Curl, Curl, Curl, Curl, Curl] = (0.0, 0.0, 0.0, 0.0, 0.0)
    fan: Curl = 0.0


class Leg(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A leg: where its ankle is, leg lengths out, up and ahead of the stand; where its foot points, degrees: toes up,
    outward, and its inner edge up; knee: how far the knee points outward, degrees; toes bend up, degrees."""

    at: tuple[Legs, Legs, Legs] = (0.0, 0.0, 0.0)
    foot: Turn = STILL
    knee: Degrees = 0.0
    toes: Degrees = 0.0


class PoseRecipe(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="kind", tag="pose"):
    """A pose of any body.

    hips: where they go, leg lengths to the character's left, up and ahead; turn: of the hips; trunk: of the spine;
    head: of neck and head; each bent forward, turned to the character's left and leant to its left, degrees. left,
    right: arms; left_leg, right_leg.
    """

    hips: tuple[Legs, Legs, Legs] = (0.0, 0.0, 0.0)
    turn: Turn = STILL
    trunk: Turn = STILL
    head: Turn = STILL
    left: Arm = Arm()
    right: Arm = Arm()
    left_leg: Leg = Leg()
    right_leg: Leg = Leg()


class NamedPose(PoseRecipe, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A pose of the library. name, label: what programs and what people call it."""

    name: str
    label: str = ""
