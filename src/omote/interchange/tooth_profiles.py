"""The measures of teeth, and the outline of one across its width: crown, gum line and what lies behind.

The table is the stages' too (tools/messages.py); web/src/face/head/tooth_profiles.ts draws the same outline.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from omote.arrays import Values


@dataclass(frozen=True)
class Tooth:
    """A tooth; millimetres.

    width; height: from the gum line in its middle to its edge; depth, edge: from outside to inside where it leaves the
    gum, and at its edge; corner, power: how far its corners lie behind its middle, and the power by which they do (1.3
    is a point, 4 a round corner); hollow: how far the middle of a grinding face is hollowed; over: how far its edge
    stands out of the row's. One of no height has not come through: where it is, gum is as high as its edge would be.
    """

    width: float
    height: float
    depth: float
    edge: float
    corner: float
    power: float
    hollow: float = 0.0
    over: float = 0.0


@dataclass(frozen=True)
class ToothRow:
    """The teeth of one half of a jaw from the middle, and where the row lies in its cage; millimetres.

    over, inside: how far the row's edge stands beyond the cage's, and how far inside of the cage it lies; vault: how
    far above the cage's gum the palate is in its middle (the floor of the mouth: below, less than 0).
    """

    over: float
    inside: float
    vault: float
    teeth: Sequence[Tooth]


# Widths and heights of the upper front teeth as measured (P. Magne, G. O. Gallucci, U. C. Belser, 2003: centrals 8.3 to
# 9.2 by 9.4 to 11, laterals 7.1 to 7.4, canines 7.9, premolars 7.8); molars, lower teeth and depths by the dentist's
# rule of thumb. Of milk teeth the incisors of a one-year-old, half out of its gums (as large as its arch, which faces
# scale, makes them). A carnivore has a third small incisor where people have the canine, and its fang behind it.
JAWS: Mapping[str, Mapping[str, ToothRow]] = {
    "upper": {
        "person": ToothRow(
            over=0,
            inside=0,
            vault=4,
            teeth=(
                Tooth(8.6, 10.4, 6.6, 1.3, 0.7, 5),
                Tooth(6.8, 9.4, 6.0, 1.2, 0.9, 4, 0, -0.45),
                Tooth(7.7, 10.2, 7.2, 1.4, 1.6, 1.7, 0, 0.1),
                Tooth(7.1, 8.6, 8.6, 5.2, 1.3, 2, 1.2, -0.3),
                Tooth(6.9, 8.2, 8.6, 5.4, 1.4, 1.8, 1.3, -0.4),
                Tooth(10.2, 7.4, 10.0, 6.6, 1.3, 2.4, 1.5, -0.4),
                Tooth(9.4, 7.0, 10.0, 6.6, 1.3, 2.4, 1.5, -0.5),
            ),
        ),
        "milk": ToothRow(
            over=0,
            inside=0,
            vault=4,
            teeth=(
                Tooth(8.2, 5.0, 6.0, 1.4, 0.9, 3.2, 0, -0.6),
                Tooth(6.6, 4.2, 5.6, 1.3, 1.2, 3, 0, -1.2),
                *(Tooth(width, 0, 8.0, 0, 0, 1, 0, -4.8) for width in (7.0, 7.0, 7.6, 9.0, 9.0)),
            ),
        ),
        "carnivore": ToothRow(
            over=0,
            inside=0.6,
            vault=4,
            teeth=(
                Tooth(5.0, 6.0, 5.0, 1.2, 1.6, 2.2, 0, -1.5),
                Tooth(5.0, 6.2, 5.0, 1.2, 1.8, 2.2, 0, -1.3),
                Tooth(5.6, 7.6, 5.4, 1.0, 2.8, 1.6, 0, -0.6),
                Tooth(7.6, 13.0, 6.6, 2.2, 8.5, 1.2, 0, 4.2),
                Tooth(9.5, 6.6, 5.2, 1.0, 4.8, 1.3, 0, -1.6),
                Tooth(13.0, 9.0, 6.4, 1.2, 6.2, 1.25, 0, 0.2),
                Tooth(9.6, 6.4, 8.0, 3.6, 3.6, 1.5, 0.8, -1.0),
            ),
        ),
    },
    "lower": {
        "person": ToothRow(
            over=1.6,
            inside=2.4,
            vault=-1,
            teeth=(
                Tooth(5.2, 9.0, 5.8, 1.2, 0.6, 4),
                Tooth(5.8, 9.2, 5.9, 1.2, 0.7, 3.4),
                Tooth(6.9, 10.2, 7.0, 1.4, 1.9, 1.5, 0, 0.3),
                Tooth(7.0, 8.6, 7.4, 4.6, 1.6, 1.7, 1.1, -0.3),
                Tooth(7.1, 8.2, 7.8, 5.0, 1.4, 1.9, 1.2, -0.5),
                Tooth(11.0, 7.4, 9.4, 6.4, 1.2, 2.4, 1.5, -0.6),
                Tooth(10.4, 7.0, 9.4, 6.4, 1.2, 2.4, 1.5, -0.7),
            ),
        ),
        "milk": ToothRow(
            over=1.6,
            inside=2.4,
            vault=-1,
            teeth=(
                Tooth(5.6, 4.6, 5.4, 1.2, 0.7, 3.2, 0, -1.4),
                Tooth(5.8, 4.0, 5.4, 1.2, 0.9, 3, 0, -2.0),
                *(Tooth(width, 0, 8.0, 0, 0, 1, 0, -5.6) for width in (6.6, 6.8, 7.4, 9.0, 9.0)),
            ),
        ),
        "carnivore": ToothRow(
            over=1.0,
            inside=3.0,
            vault=-1,
            teeth=(
                Tooth(4.0, 5.4, 4.6, 1.1, 1.3, 2.2, 0, -1.8),
                Tooth(4.2, 5.6, 4.6, 1.1, 1.5, 2.2, 0, -1.6),
                Tooth(4.6, 6.4, 5.0, 1.0, 2.2, 1.8, 0, -1.2),
                Tooth(7.0, 12.5, 6.2, 2.0, 8.5, 1.2, 0, 4.2),
                Tooth(9.5, 6.2, 4.8, 1.0, 4.4, 1.3, 0, -2.0),
                Tooth(13.5, 8.6, 5.8, 1.1, 5.8, 1.25, 0, -0.4),
                Tooth(9.6, 6.0, 7.0, 3.2, 3.2, 1.5, 0.8, -1.6),
            ),
        ),
    },
}
"""Whose teeth: those of the face at rest, a baby's (a look's `milk`), and those that fur brings (a carnivore's)."""
TEETH = 7
"""Of a half of a jaw."""
RIBS = 18
"""Rows across a jaw: from the outer gum over the crown to the inner gum, then to the middle of palate or floor."""
SHORT = 3.0
UNDER = 3.0
"""Millimetres by which the drawn gum ends before the cage's, and inside of it: there it comes through cheeks first."""
LOWEST_GUM = 18.0
"""Molars have less gum than this in their cage, and as much above them; millimetres."""
MOST_CROWN = 0.66
"""How much of the way from edge to gum a crown may take."""
BEYOND = (1.12, 1.7, 2.7)
"""Places behind the last tooth, in halves of its width from its middle, at which the gum goes on; at the last it is
gone."""
FRONT = ((0.02, 0.8), (0.22, 0.22), (0.5, 0.0), (0.8, 0.35), (0.95, 0.85))
"""How far up the crown its outline is followed on the outer side, and by how much it is rounded in there, mm."""


Rib = tuple[float, float, float, float]
"""A point of an outline: up and inward, millimetres; height; share of the way to the other side."""


def jaw_table() -> dict[str, Any]:
    """The measures as plain numbers by name."""
    return {jaw: {whose: asdict(row) for whose, row in rows.items()} for jaw, rows in JAWS.items()}


def outline(tooth: Tooth, row: ToothRow, t: float, reach: float, /) -> Values:
    """The outline of a tooth at t (-1..1 across it), (RIBS, 4): millimetres up towards the gum and inward, from the
    cage's edge and outer side; height: 0 at the gum line, 1 at the edge, less than 0 on gum; share of the way to the
    same place on the other side.

    The gum climbs between teeth (papillae), the crown's corners are round, and its sides go in, so that teeth stand
    apart. Beyond -1 and 1 there is gum alone, which sinks up to the last place of BEYOND: so a row's end is closed.
    row: that the tooth stands in; reach: millimetres from the cage's edge to its gum.
    """
    far = abs(t)
    high = max(reach, LOWEST_GUM) + row.vault
    across = [(0.85 * high, tooth.depth + 2, -0.6, 0.2), (high, tooth.depth + 2, -1.0, 0.5)]
    ribs = _crown(tooth, row, far, reach) if far <= 1.0 and tooth.height > 0.0 else _ridge(tooth, row, far, reach)
    found: Values = np.array([*ribs, *across]) + np.array([0.0, row.inside, 0.0, 0.0])
    return found


def _ridge(tooth: Tooth, row: ToothRow, far: float, reach: float) -> list[Rib]:
    """Gum without a tooth, and behind the last one: half an ellipse over palate or floor."""
    gum = min(tooth.height - tooth.over - row.over, MOST_CROWN * reach)
    low = max(reach - SHORT, gum + 1.5)
    left = (BEYOND[-1] - max(far, 1.0)) / (BEYOND[-1] - 1.0)
    around = np.linspace(0.0, np.pi, RIBS - 2)
    rise = left * np.sin(around)
    beside = UNDER + (tooth.depth + 1.1 - UNDER) * (0.5 - 0.5 * np.cos(around))
    return [(low - (low - gum) * up, inward, 0.88 * up - 1.0, 0.0) for up, inward in zip(rise, beside, strict=True)]


def _crown(tooth: Tooth, row: ToothRow, far: float, reach: float) -> list[Rib]:
    edge = tooth.corner * far**tooth.power - tooth.over - row.over
    full = min(tooth.height - tooth.over - row.over, MOST_CROWN * reach)
    front = full - 0.4 * tooth.height * far**2.4
    back = full - 0.28 * tooth.height * far**2.4
    aside = 0.45 * far * far + 1.1 * far**5
    last = reach - SHORT
    ground = 0.28 * tooth.depth if tooth.hollow > 0 else 0.6
    inner = ground + tooth.edge
    neck = tooth.depth - 0.4 - aside

    def crown(gum: float, share: float, inward: float) -> Rib:
        return (gum + (edge - gum) * share, inward, share, 0.0)

    return [
        (max(last, front + 1.5), UNDER, -1.0, 0.0),
        (max(front + 1.2, 0.5 * (front + last)), 0.7, -0.55, 0.0),
        (front + 0.8, -0.1 + 0.4 * aside, -0.12, 0.0),
        (front - 0.1, 0.2 + 0.55 * aside, -0.01, 0.0),
        *(crown(front, share, inward + aside) for share, inward in FRONT),
        (edge, min(ground + aside, neck), 1.0, 0.0),
        (edge + tooth.hollow * (1 - far * far), min(ground + 0.5 * tooth.edge, neck), 1.0, 0.0),
        (edge + 0.1, min(inner, neck + 0.2), 1.0, 0.0),
        crown(back, 0.6, 0.5 * (inner + neck)),
        crown(back, 0.15, neck),
        (back - 0.05, tooth.depth, -0.01, 0.0),
        (back + 0.25 * (last - back), tooth.depth + 1.1, -0.3, 0.0),
    ]
