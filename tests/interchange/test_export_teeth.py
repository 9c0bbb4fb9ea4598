"""Teeth stay behind lips where a program adds targets of an exported face up, without what stages correct."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from omote.builtin import load_cast, load_mask, load_meshes
from omote.geometry.proximity import nearest_triangles, winding_numbers
from omote.interchange.export_face import SKIN, ExportContext, build_scene, named_compound_meshes
from omote.interchange.formats.glb_writer import Shape
from omote.model.transfer.gum_line import GUMS
from omote.perform.speech.visemes import MOUTH_UNITS, VISEMES, mouth_of

CAST = load_cast()
EMOTIONS = ("joy", "angry", "sad", "smile", "surprise")
THROUGH = 3e-4
"""Metres: what an eye still passes over (benchmarks/mouths.py)."""
Points = NDArray[np.float64]


@cache
def shapes_of(face: str) -> dict[str, Shape]:
    """Skin and teeth as a file has them, with the targets of speech and of the presets of an avatar."""
    context = ExportContext(CAST, load_meshes(), load_mask())
    poses = [(name, named_compound_meshes(CAST, face, name)) for name in (*MOUTH_UNITS, *EMOTIONS)]
    scene = build_scene(context, face, poses, hair=False)
    return {shape.name: shape for shape in scene.shapes if shape.name in (SKIN, *GUMS)}


def pierced(face: str, weights: Mapping[str, float]) -> float:
    """How far teeth of a sum of targets lie outside of its skin, other than through the open lips, metres."""
    summed = {
        name: shape.points.astype(np.float64)
        + sum((weight * shape.targets[target].moves for target, weight in weights.items()), np.zeros(3))
        for name, shape in shapes_of(face).items()
    }
    skin = np.zeros_like(CAST.space.points)
    skin[shapes_of(face)[SKIN].rows] = summed[SKIN]
    corners = skin[CAST.space.location_triangles]
    count = len(CAST.space.sheet_triangles)
    teeth = np.concatenate([summed[name] for name in GUMS])
    out = teeth[winding_numbers(corners, teeth) < 0.5]
    away, through = (nearest_triangles(part, out)[0] for part in (corners[:count], corners[count:]))
    return float(away[away < through].max(initial=0.0))


@pytest.mark.parametrize("face", ["dog", "man"])
@pytest.mark.parametrize("open_by", [0.3, 0.6, 1.0])
def test_lips_close_over_an_open_jaw_without_teeth_through_them(face: str, open_by: float) -> None:
    """The lower teeth of the dog came .94 mm through its lip."""
    assert pierced(face, {"jawOpen": open_by, "mouthClose": open_by}) < 1e-4


@settings(max_examples=15)
@given(
    face=st.sampled_from(["dog", "man"]),
    spoken=st.lists(st.floats(0.0, 1.0), min_size=len(VISEMES), max_size=len(VISEMES)),
    emotion=st.sampled_from(EMOTIONS),
    felt=st.floats(0.0, 1.0),
)
def test_no_tooth_comes_through_a_lip_that_talks(face: str, spoken: list[float], emotion: str, felt: float) -> None:
    total = max(sum(spoken), 1e-3)
    mouth = mouth_of(np.array(spoken) / total)
    weights = {unit: float(weight) for unit, weight in zip(MOUTH_UNITS, mouth, strict=True)}
    assert pierced(face, weights | {emotion: felt}) < THROUGH
