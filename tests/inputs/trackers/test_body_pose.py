"""Bones by VMC: what we send of a figure comes back as the same pose, on our floor."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.inputs.face_output.figure_bones import FigureBones
from omote.inputs.trackers.body_pose import LEAST_HEIGHT, body_frame, builtin_rest
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.inputs.trackers.vmc_messages import VmcDecoder, encode_vmc
from omote.model.cast import Cast
from omote.perform.figures.figure import pose_figure
from omote.perform.figures.packed_pose import BESIDE_BONES, PLACES, unpack_pose
from omote.perform.figures.pose_mix import MixedPose, mix_poses
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallPose
from omote.show.objects.link import Hello
from omote.show.objects.state import FigureState
from omote.show.session import ShowSession

TICK = 1.0 / 60.0
REST = builtin_rest()
SKELETON = REST.figures.space.skeleton
STILL = (0.0, 0.0, 0.0)


def told(cast: Cast, pose: str) -> list[bytes]:
    """The packets of a figure that does a pose."""
    assert cast.figures is not None
    session = ShowSession(cast)
    session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
    session.receive("console", CallPose("one", "1", pose, 0.0), 0.0)
    character = session.tick(0.0).characters["one"]
    bones = FigureBones(cast.figures, cast.faces["generic"].positions.astype(np.float64))
    return encode_vmc({}, STILL, (0.0, 0.0), 0.0, bones.turns(character, cast.figures.poses))


def ways(pose: MixedPose) -> np.ndarray:
    """The direction of each bone of the humanoid from its parent, but of the head, which turns by the head's own."""
    at = pose_figure(REST.figures.space, REST.resting, pose).joints
    below = (REST.parents >= 0) & (np.array(REST.names) != "head")
    way = at[REST.bones[below]] - at[REST.bones[REST.parents[below]]]
    return np.asarray(way / np.linalg.norm(way, axis=1)[:, None])


def mixed_of(figure: FigureState) -> MixedPose:
    """The pose of a tracked figure that is seen whole."""
    assert figure.tracked is not None
    numbers = unpack_pose(figure.tracked.pose, len(SKELETON.names))
    turns, places = numbers[:-BESIDE_BONES], numbers[-BESIDE_BONES:]
    travel, feet, feet_turns = np.split(places, (3, PLACES))
    return MixedPose(turns.reshape(-1, 3), travel, feet.reshape(2, 3), feet_turns.reshape(2, 3))


@pytest.mark.parametrize("pose", ["wave", "think", "arms_crossed", "bow"])
def test_a_pose_that_is_sent_plays_as_it_was_on_another_show(pose: str) -> None:
    cast = load_cast()
    session = ShowSession(cast)
    trackers = TrackerInput(TRACKER_PROTOCOLS["vmc"], lambda: session)
    session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
    now = 0.0
    sent = {name: told(cast, name) for name in ("attention", pose)}
    for packets in [sent["attention"]] * 2 + [sent[pose]] * 150:
        for packet in packets:
            trackers.receive("10.0.0.8", packet, now)
        trackers.play(now)
        now += TICK
        figure = session.tick(now).characters["one"].figure
    assert figure is not None
    assert figure.tracked is not None
    assert max(figure.tracked.shares) > 0.99
    assert cast.figures is not None
    wanted = ways(mix_poses(cast.figures.poses, {pose: 1.0}, {}, {}))
    cosines = (ways(mixed_of(figure)) * wanted).sum(axis=1)
    assert np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0))).max() < 0.1


def test_feet_stand_on_our_floor_wherever_the_sender_s_hips_are() -> None:
    cast = load_cast()
    decoder = VmcDecoder()
    frames = [frame for packet in told(cast, "attention") for frame in decoder.decode(packet)]
    bones = frames[-1].bones
    assert bones is not None
    for height in (LEAST_HEIGHT, 0.5, 0.9, 1.4):
        frame = body_frame(REST, type(bones)(bones.turns, (0.0, height, 0.0), 0.0, head=True), {"stance"})
        ankles = frame.numbers[-BESIDE_BONES:][3:PLACES].reshape(2, 3)
        assert np.abs(ankles[:, 1]).max() < 2e-3, "leg lengths"
        assert frame.regions == ("head", "stance")
