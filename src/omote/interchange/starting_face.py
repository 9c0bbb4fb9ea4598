"""Finds the face that a shape starts from, or checks the one that is named: a wrong one would move every vertex.

An expression leaves a part of the head still, a face is another everywhere. Of 1,921 compounds (17 faces, 113
expressions) a twentieth of the skin moves less than a micrometre; between two faces of the cast it is .14 mm and more.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL
from omote.model.space.face import Face

Points = NDArray[np.floating]

STILL, QUIET = 0.05, 0.25
"""Shares of the skin that are compared: what every expression leaves still, and what most of them hardly move."""
ROUNDED = 1e-4
"""Metres by which a program may move what is still."""
NEARER, QUIETER = 4.0, 2.0
"""How many times nearer, in these two shares, another face is that a shape starts from."""
ELSEWHERE = 5e-4
"""Metres; a shape whose still share is farther away starts from no face of the cast."""


def find_start(cast: Cast, skin: Points, /) -> str:
    """The face of the cast that a shape's skin (V, 3) starts from, "" for none."""
    nearest = min(cast.faces, key=lambda name: _distances(skin, cast.faces[name]))
    return nearest if _distances(skin, cast.faces[nearest])[0] <= ROUNDED else ""


def check_start(cast: Cast, label: str, skin: Points, start: Face, /, *, named: bool, own_rest: bool = False) -> None:
    """ValueError where the skin (V, 3) of a shape shows that it starts from another face than `start`.

    label: the shape's, for the message; named: a person named the face, else the files did; own_rest: a shape at rest
    lies beside it, so that it may start from any face and move all of it.
    """
    still, quiet = _distances(skin, start)
    if still <= ROUNDED:
        return
    others = {name: _distances(skin, face) for name, face in cast.faces.items() if name != start.name}
    nearest = min(others, key=lambda name: others[name], default="")
    far = f"95 % of its skin lies more than {1000 * still:.1f} mm from {start.name!r} at rest"
    if nearest and others[nearest][0] * NEARER < still and others[nearest][1] * QUIETER < quiet:
        mend = f"say --face {nearest}" if named else "take it in alone, or with its own head at rest"
        raise ValueError(f"{label!r} starts from {nearest!r} and not from {start.name!r}: {far}; {mend}")
    if still > ELSEWHERE and not own_rest:
        raise ValueError(
            f"{label!r} does not start from {start.name!r}: {far}, which no expression does, and no face of the cast "
            f"explains it better; add the head that it starts from, at rest, as a shape named {NEUTRAL!r}, and move "
            "and scale the head nowhere before it is exported"
        )


def _distances(skin: Points, face: Face) -> tuple[float, float]:
    """Within which distances, metres, of a face the nearest shares of a skin lie: STILL, QUIET."""
    still, quiet = (int(share * len(skin)) for share in (STILL, QUIET))
    apart = np.partition(np.linalg.norm(skin - face.positions, axis=1), (still, quiet))
    return float(apart[still]), float(apart[quiet])
