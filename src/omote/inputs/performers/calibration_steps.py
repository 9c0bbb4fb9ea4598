"""The faces of the guided minute before a camera, in their order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from omote.inputs.camera.guided_steps import NEUTRAL

READY_SECONDS = 1.6
"""To read what comes and to make the face."""
HOLD_SECONDS = 2.2
"""Of which the frames are collected."""
REST_SECONDS = 2.0
"""Of a face at rest, where nothing is known of a performer."""
_ADVICE = {
    NEUTRAL: "Look straight ahead, relaxed, lips closed",
    "shut": "Shut both eyes, gently",
    "wide": "Open your eyes wide",
    "smile": "Smile, as broad as you can",
    "pucker": "Pucker your lips, as for a kiss",
    "aa": "Say aa, mouth wide open",
    "ee": "Say ee, lips wide",
    "oo": "Say oo, lips round",
    "browsUp": "Raise your brows",
    "browsDown": "Frown: brows down",
    "left": "Look to your left with the eyes alone",
    "right": "Look to your right with the eyes alone",
    "up": "Look up with the eyes alone",
    "down": "Look down with the eyes alone",
    "puff": "Puff both cheeks, lips closed",
}


@dataclass(frozen=True)
class CalibrationStep:
    """A face to make. name: as frames are filed by; advice: what the performer is told; hold: seconds collected."""

    name: str
    advice: str
    hold: float = HOLD_SECONDS


CALIBRATION_STEPS: Mapping[str, CalibrationStep] = MappingProxyType(
    {name: CalibrationStep(name, advice) for name, advice in _ADVICE.items()}
)
"""All steps by name: four seconds each, a minute together."""
REST_STEP = CalibrationStep(NEUTRAL, _ADVICE[NEUTRAL], REST_SECONDS)
"""The only step of a start without the guided minute."""
