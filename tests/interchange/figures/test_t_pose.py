"""The T-pose as VRM has it, on every body: arms and fingers along x, palms down, legs straight, toes ahead."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.builtin import load_figures
from omote.interchange.figures.t_pose import pose_t
from omote.model.body.skeleton import SIDES
from omote.model.body.stand import OUT
from omote.perform.figures.figure import resting_figure

CAST = omote.load_cast()
FIGURES = load_figures()
SKELETON = FIGURES.space.skeleton


@pytest.mark.parametrize("name", [*FIGURES.bodies])
def test_limbs_lie_as_vrm_wants_them(name: str) -> None:
    body = FIGURES.bodies[name]
    figure = resting_figure(FIGURES, {name: 1.0}, CAST.faces[name].positions.astype(np.float64))
    ends = body.ends + (figure.joints[0] - body.joints[0])
    bones = pose_t(SKELETON, figure, ends)

    def way(first: str, second: str) -> np.ndarray:
        away = bones.joints[SKELETON.places[second]] - bones.joints[SKELETON.places[first]]
        return np.asarray(away / np.linalg.norm(away))

    for side in SIDES:
        out = np.array([OUT[side], 0.0, 0.0])
        half = np.array([OUT[side], 0.0, 1.0]) / np.sqrt(2.0)
        for first, second in (("upperarm01", "lowerarm01"), ("lowerarm01", "wrist"), ("wrist", "finger3-1")):
            loose = (
                2e-3 if first == "lowerarm01" else 1e-9
            )  # its second bone takes a part of the twist, a little off it
            np.testing.assert_allclose(way(f"{first}.{side}", f"{second}.{side}"), out, atol=loose)
        for finger in range(1, 6):
            wanted = half if finger == 1 else out
            for number in (1, 2):
                bone = f"finger{finger}-{number}.{side}", f"finger{finger}-{number + 1}.{side}"
                if np.linalg.norm(ends[SKELETON.places[bone[0]]] - figure.joints[SKELETON.places[bone[1]]]) < 1e-4:
                    np.testing.assert_allclose(way(*bone), wanted, atol=0.02)
            tip = SKELETON.places[f"finger{finger}-3.{side}"]
            along = bones.turns[tip] @ (ends[tip] - figure.joints[tip])
            np.testing.assert_allclose(along / np.linalg.norm(along), wanted, atol=1e-9)
        across = way(f"finger5-1.{side}", f"finger2-1.{side}")
        assert across[2] > 0.9  # the index finger is before the little one, so the palm looks down
        for first, second in (("upperleg01", "lowerleg01"), ("lowerleg01", "foot")):
            np.testing.assert_allclose(way(f"{first}.{side}", f"{second}.{side}"), [0.0, -1.0, 0.0], atol=1e-9)
        toes = SKELETON.places[f"toes.{side}"]
        ahead = bones.joints[toes] + bones.turns[toes] @ (ends[toes] - figure.joints[toes])
        ahead = ahead - bones.joints[SKELETON.places[f"foot.{side}"]]
        assert abs(ahead[0]) < 1e-9 < ahead[2]
    still = [SKELETON.places[bone] for bone in ("root", "spine01", "neck03", "head", "clavicle.L", "clavicle.R")]
    np.testing.assert_allclose(bones.joints[still], figure.joints[still], atol=1e-12)
