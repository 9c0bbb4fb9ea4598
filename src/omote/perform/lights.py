"""The lights that a show can call, by name; what they look like is the stages' own (`web/src/face/light/lights.ts`)."""

from __future__ import annotations

from collections.abc import Mapping

FIRST_LIGHT = "theatre"
"""What a show begins with."""
LIGHTS: Mapping[str, str] = {"theatre": "Theatre", "portrait": "Portrait", "flat": "Flat (keying)"}
"""The lights in the order of the console, with what they are called there."""


def check_light(name: str) -> str:
    """Returns the name of a light; ValueError that lists all of them for an unknown one."""
    if name not in LIGHTS:
        raise ValueError(f"there is no light {name!r}; choose one of {', '.join(LIGHTS)}")
    return name
