"""How fast a machine makes compounds: by deformation transfer, at whose pace bars in seconds are asked, and by ours."""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np

from benchmarks.maps.methods import deformation
from benchmarks.maps.source import load_source
from omote.model.cast import Cast
from omote.stage_data.assets import compound_asset

PEER_MILLISECONDS = 1.8
"""What a compound took deformation transfer on the machine for which issue 13 set its bars of time."""
UNITS = 40


def measure_pace(faces: Sequence[str]) -> float:
    """How many times as long as there deformation transfer takes here for a compound of faces of the cast, on one core:
    the median over some units of each; what it prepares once for a face is not counted."""
    source = load_source(UNITS)
    seconds = []
    for name in faces:
        peer = deformation(source, source.cast.faces[name])
        for unit in source.moves:
            begun = time.monotonic()
            peer(unit)
            seconds.append(time.monotonic() - begun)
    return 1e3 * float(np.median(seconds)) / PEER_MILLISECONDS


def measure_one_core(cast: Cast, faces: Sequence[str], expressions: Sequence[str]) -> list[float]:
    """Seconds that one core needs to compute these compounds of each face, with nothing else to do."""
    compound_asset(cast, cast.faces["generic"], expressions[0])  # kernels are loaded
    seconds = []
    for face in faces:
        begun = time.monotonic()
        for name in expressions:
            compound_asset(cast, cast.faces[face], name)
        seconds.append(time.monotonic() - begun)
    return seconds
