"""The rig of an exported figure: its neck follows the face without a gap, and its poses are ours."""

from __future__ import annotations

import numpy as np

import omote
from omote.interchange.export_face import SKIN, named_compound_meshes
from omote.interchange.figures.figure_rig import export_figure
from omote.interchange.formats.rig import Rig
from omote.model.body.figure_space import join_head
from omote.perform.figures.figure import skinning_bones
from tests.interchange.figures.figures import SUITED, posed_figure

CAST = omote.load_cast()
FIGURE = export_figure(CAST, "kaori", "heavy", influences=4)


def test_suit_hands_and_shoes_follow_an_expression_as_the_body_does() -> None:
    worn = named_compound_meshes(CAST, "kaori", "jawOpen")[SKIN]
    space = FIGURE.space
    body = FIGURE.body
    heads = FIGURE.resting.rows[: space.head_rows], worn
    below = [join_head(space, body.positions.astype(np.float64), body.edge.astype(np.float64), head) for head in heads]
    moved = np.concatenate([heads[1] - heads[0], below[1] - below[0]])
    shapes = FIGURE.body_shapes({"jawOpen": worn})
    assert [shape.name for shape in shapes] == list(SUITED)
    for shape in shapes:
        aim = FIGURE.meshes[shape.name].blend @ moved
        np.testing.assert_allclose(shape.targets["jawOpen"].moves, aim, atol=1e-6)
    assert np.abs(shapes[0].targets["jawOpen"].moves).max() > 0.001


def test_a_pose_of_the_rig_turns_every_bone_as_ours_does() -> None:
    rig = Rig(FIGURE.joints, FIGURE.inverse, {}, "head", {})
    motion = FIGURE.motion("cheer")
    posed = skinning_bones(FIGURE.space, FIGURE.resting, posed_figure(FIGURE, "cheer"))
    turns = np.empty_like(motion.turns)
    places = np.empty((len(turns), 3))
    for joint, (parent, step) in enumerate(zip(rig.parents, rig.steps, strict=True)):
        turns[joint] = motion.turns[joint] if parent < 0 else turns[parent] @ motion.turns[joint]
        places[joint] = motion.travel if parent < 0 else places[parent] + turns[parent] @ step
    np.testing.assert_allclose(turns @ FIGURE.bound.turns, posed.turns, atol=1e-9)
    np.testing.assert_allclose(places, posed.joints + FIGURE.shift, atol=1e-9)
