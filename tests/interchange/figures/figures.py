"""Where a stage has an exported figure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from omote.interchange.figures.figure_rig import BARE, GARMENT, SHOES, ExportedFigure
from omote.model.body.posed_bones import PosedBones
from omote.perform.figures.figure import pose_figure
from omote.perform.figures.pose_mix import mix_poses

SUITED = (GARMENT, BARE, SHOES)
"""The meshes of a body in the stage suit, which has one colour."""


def posed_figure(figure: ExportedFigure, pose: str) -> PosedBones:
    """Its bones in a pose of the library."""
    return pose_figure(figure.space, figure.resting, mix_poses(figure.figures.poses, {pose: 1.0}, {}, {}))


def stage_points(figure: ExportedFigure, mesh: str, bones: PosedBones) -> np.ndarray:
    """The vertices of a mesh of the body (n, 3) in the scene, but for correctives, which files do not carry."""
    bare = replace(figure.resting, correctives=np.zeros_like(figure.resting.correctives))
    return replace(figure, resting=bare, rest=bones).worn(mesh)[0] + figure.shift
