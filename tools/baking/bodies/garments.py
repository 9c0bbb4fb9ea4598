"""The garments of the cast: fields over the rows of the generic figure, measured along its arms, legs and trunk."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Mask
from omote.geometry.ramp import smooth_ramp
from omote.model.body.garment import Garment
from omote.model.body.skeleton import SIDES
from tools.baking.bodies.rig import Rig
from tools.baking.heads.basemesh import Floats, Ints

FARTHEST = 0.5
"""Metres inside or outside an edge beyond which a field says no more."""
THICK = 0.003
"""How far plain cloth stands off, metres."""
HEM_SLACK = 0.05
"""Metres of leg above a hem that are drawn inside a skirt, for who looks up into it."""
TUCKED = 0.06
"""Metres below the waist from which on a skirt hides the body: above, both are drawn, the skirt under cloth."""
ARM_BONES = ("clavicle", "shoulder", "upperarm", "lowerarm", "wrist", "metacarpal", "finger")
HAND_BONES = ("wrist", "metacarpal", "finger")
LEG_BONES = ("upperleg", "lowerleg", "foot", "toes")
FOOT_BONES = ("foot", "toes")


@dataclass(frozen=True)
class Places:
    """Where rows of the generic figure lie, (R,) each, metres.

    x, y, z: as they are; wrist: how far before the wrist, along the forearm;
    arm, hand, leg, foot: how much bones of these move a row, 0..1; skirt: whether it is of the skirt;
    heights: of what, by name.
    """

    x: Floats
    y: Floats
    z: Floats
    wrist: Floats
    arm: Floats
    hand: Floats
    leg: Floats
    foot: Floats
    skirt: Mask
    heights: Mapping[str, float]


def garments(
    rig: Rig, joints: Floats, generic: Floats, first_of_skirt: int, bones: Ints, weights: Floats
) -> list[Garment]:
    """All garments, the stage suit first.

    rig: of the figure; joints (J, 3), generic (R, 3): of the generic figure, metres; first_of_skirt: its first row;
    bones, weights (R, 8): of the rows.
    """
    at = _places(rig, joints, generic, first_of_skirt, bones, weights)
    return [make(at) for make in (_suit, _shirt, _dress, _kimono, _coat)]


def _places(rig: Rig, joints: Floats, generic: Floats, first_of_skirt: int, bones: Ints, weights: Floats) -> Places:
    places = rig.skeleton.places
    names = rig.skeleton.names

    def share(of: tuple[str, ...]) -> Floats:
        chosen = np.array([name.startswith(of) for name in names])
        return np.asarray((weights * chosen[bones]).sum(axis=1))

    wrist = np.full(len(generic), 1.0)
    for side in SIDES:
        elbow, end = (joints[places[f"{bone}.{side}"]] for bone in ("lowerarm01", "wrist"))
        along = (end - elbow) / np.linalg.norm(end - elbow)
        own = (generic[:, 0] > 0) == (side == "L")
        wrist = np.where(own, (end - generic) @ along, wrist)
    heights = {
        "waist": float(joints[places["spine03"]][1]),
        "knee": float(joints[places["lowerleg01.L"]][1]),
        "ankle": float(joints[places["foot.L"]][1]),
        "crotch": float(joints[places["upperleg01.L"]][1]) - 0.10,
        "shoulder": float(joints[places["upperarm01.L"]][1]),
        "neck": float(joints[places["neck01"]][1]),
    }
    skirt = np.arange(len(generic)) >= first_of_skirt
    x, y, z = generic.T
    return Places(
        x, y, z, wrist, share(ARM_BONES), share(HAND_BONES), share(LEG_BONES), share(FOOT_BONES), skirt, heights
    )  # fmt: skip


def _garment(name: str, label: str, at: Places, **fields: Floats) -> Garment:
    """A garment from its fields; cover, thick, trim, hidden: of the body; skirt_cover, skirt_trim: of the skirt, which
    is left out without them."""
    nowhere = np.full(len(at.x), -FARTHEST)
    body = {"cover": fields["cover"], "thick": fields["thick"]}
    body |= {what: fields.get(what, nowhere) for what in ("trim", "hidden")}
    of_skirt = {"cover": fields.get("skirt_cover", nowhere), "trim": fields.get("skirt_trim", nowhere)}
    of_skirt |= {"thick": np.zeros(len(at.x)), "hidden": nowhere}
    chosen = {
        what: np.clip(np.where(at.skirt, of_skirt[what], body[what]), -FARTHEST, FARTHEST).astype(np.float32)
        for what in body
    }
    return Garment(name, label, **chosen)


def _to_hands(at: Places) -> Floats:
    """Cover as far as the hands."""
    return np.asarray(0.2 * (0.5 - at.hand))


def _taper(at: Places) -> Floats:
    """1 where cloth lies, 0 on hands: how thick it may be."""
    return np.asarray(1.0 - smooth_ramp(0.3, 0.55, at.hand))


def _suit(at: Places) -> Garment:
    return _garment("suit", "Stage suit", at, cover=_to_hands(at), thick=THICK * _taper(at))


def _trousers(at: Places) -> Floats:
    """How wide trousers stand off below the hips: wider towards their ends, narrow again over shoes."""
    return np.asarray(0.014 * _down(at) * (1.0 - smooth_ramp(0.35, 0.75, at.foot)) * at.leg)


def _down(at: Places) -> Floats:
    """0 at the crotch, 1 at the ankles."""
    top = at.heights["crotch"]
    low = at.heights["ankle"]
    return np.clip((top - at.y) / (top - low), 0.0, 1.0)


def _shirt(at: Places) -> Garment:
    """A shirt over trousers of the second colour."""
    waist = at.heights["waist"] - 0.09
    hang = np.exp(-(((at.y - waist - 0.05) / 0.07) ** 2)) * (1.0 - at.arm)
    cuff = np.exp(-(((at.wrist - 0.07) / 0.06) ** 2)) * at.arm
    thick = (0.005 + 0.012 * hang + 0.009 * cuff) * _taper(at) + _trousers(at)
    trim = np.where(at.arm > 0.5, -FARTHEST, waist - at.y)
    return _garment("shirt", "Shirt and trousers", at, cover=_to_hands(at), thick=thick, trim=trim)


def _dress(at: Places) -> Garment:
    """A blouse with short sleeves, a belt, and a skirt to the knees."""
    hem = at.heights["knee"] - 0.03
    waist = at.heights["waist"] - 0.01
    sleeve = np.where(at.arm > 0.3, at.wrist - 0.33, FARTHEST)
    legs = np.where(at.leg > 0.5, at.y - at.heights["crotch"], FARTHEST)
    cover = np.minimum(sleeve, legs - 0.02)
    puff = np.exp(-(((at.wrist - 0.40) / 0.06) ** 2)) * smooth_ramp(0.5, 1.0, at.arm)
    thick = 0.004 + 0.016 * puff
    thick = thick * smooth_ramp(-0.03, 0.005, sleeve) * smooth_ramp(-0.03, 0.0, legs)
    belt = 0.022 - np.abs(at.y - waist)
    return _garment(
        "dress", "Dress", at, cover=cover, thick=thick, trim=np.where(at.arm > 0.5, -FARTHEST, belt),
        hidden=_under(at, waist - TUCKED, hem), skirt_cover=at.y - hem, skirt_trim=np.maximum(belt, hem + 0.03 - at.y),
    )  # fmt: skip


def _kimono(at: Places) -> Garment:
    """A robe to the ankles with wide sleeves, a sash, and what is worn under it at the neck."""
    hem = at.heights["ankle"] + 0.03
    waist = at.heights["waist"]
    wide = smooth_ramp(0.0, 1.0, np.clip((0.33 - at.wrist) / 0.30, 0.0, 1.0)) * smooth_ramp(0.5, 0.9, at.arm)
    thick = (0.006 + 0.05 * wide) * (1.0 - smooth_ramp(-0.01, 0.02, -at.wrist) * (at.arm > 0.5)) * _taper(at)
    sash = 0.075 - np.abs(at.y - waist - 0.02)
    throat = 0.30 * (at.y - (at.heights["shoulder"] - 0.13)) - np.abs(at.x)
    trim = np.where(at.arm > 0.5, -FARTHEST, np.maximum(sash, np.where(at.z > 0.0, throat, -0.1)))
    thick = thick + 0.008 * np.clip(sash / 0.02, 0.0, 1.0) * (1.0 - at.arm)
    return _garment(
        "kimono", "Kimono", at, cover=_to_hands(at), thick=thick, trim=trim,
        hidden=_under(at, waist - TUCKED, hem), skirt_cover=at.y - hem, skirt_trim=sash,
    )  # fmt: skip


def _coat(at: Places) -> Garment:
    """A coat to above the knees over trousers of the second colour."""
    hem = at.heights["knee"] + 0.12
    waist = at.heights["waist"]
    collar = at.y - (at.heights["neck"] - 0.012)
    loose = np.maximum(at.arm, smooth_ramp(waist + 0.02, waist + 0.12, at.y))
    thick = (0.004 + 0.008 * loose) * _taper(at)
    thick = np.where(at.leg > 0.5, THICK + _trousers(at), thick)
    trim = np.where(at.leg > 0.5, FARTHEST, np.where(at.arm > 0.5, -FARTHEST, np.maximum(collar, hem - at.y)))
    return _garment(
        "coat", "Coat and trousers", at, cover=_to_hands(at), thick=thick, trim=trim,
        hidden=_under(at, waist - TUCKED, hem), skirt_cover=at.y - hem,
    )  # fmt: skip


def _under(at: Places, top: float, hem: float) -> Floats:
    """What a skirt from a height to another hides of the body, which its arms may hang beside."""
    inside = np.minimum(top - at.y, at.y - hem - HEM_SLACK)
    return np.asarray(np.where(at.arm > 0.3, -FARTHEST, inside))
