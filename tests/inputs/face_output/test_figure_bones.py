"""Bones for other programs: a humanoid that wears them has hands and feet where the stage has them."""

import itertools

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.arrays import Points
from omote.builtin import load_cast
from omote.inputs.face_output.face_target import FaceTarget, encode_face
from omote.inputs.face_output.figure_bones import FigureBones
from omote.inputs.osc_packet import decode_packet
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.head_angles import BoneTurn
from omote.inputs.trackers.vmc_messages import BONE, ROOT, VmcDecoder
from omote.interchange.avatar.humanoid_figure import humanoid_bones
from omote.interchange.avatar.vrm0_extension import unity_name
from omote.interchange.figures.figure_rig import export_figure
from omote.perform.figures.figure import pose_figure
from omote.perform.figures.pose_mix import mix_poses
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallPose
from omote.show.objects.faders import SetHead
from omote.show.objects.link import Hello
from omote.show.objects.state import CharacterState
from omote.show.session import ShowSession

CAST = load_cast()
FIGURES = CAST.figures
assert FIGURES is not None
BONES = FigureBones(FIGURES, CAST.faces["generic"].positions.astype(np.float64))
AVATAR = export_figure(CAST, "generic", next(iter(FIGURES.bodies)), influences=4)
"""As VRM has it: joints that turn nothing rest in the T-pose."""
POSES = ["wave", "think", "bow", "point", "sit", "stand"]


def posed(pose: str, yaw: float = 0.0) -> CharacterState:
    """A character whose figure does a pose."""
    session = ShowSession(CAST)
    session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)
    session.receive("console", CallPose("one", "1", "shrug", 0.0), 0.0)
    session.receive("console", CallPose("one", "2", pose, 0.5), 0.0)
    session.receive("console", SetHead("one", yaw, 0.0, 0.0), 0.0)
    session.tick(0.0)
    return session.tick(0.5 if pose != "stand" else 0.25).characters["one"]


def worn(turns: dict[str, BoneTurn]) -> dict[str, Points]:
    """Where the joints of an avatar are that wears them, as a receiver turns them, metres from the hips."""
    rest = {joint.name: np.array(joint.place) for joint in AVATAR.joints}
    above = {joint.name: joint.parent for joint in AVATAR.joints}
    ours = {bone: unity_name(name) for name, bone in humanoid_bones().items()}
    frames: dict[str, np.ndarray] = {"": np.eye(3)}
    places: dict[str, Points] = {}
    for joint in AVATAR.joints:
        parent = above[joint.name]
        own = Rotation.from_quat(turns[ours[joint.name]].turn).as_matrix() if joint.name in ours else np.eye(3)
        frames[joint.name] = frames[parent] @ own
        away = rest[joint.name] - rest[parent] if parent else np.zeros(3)
        places[joint.name] = frames[parent] @ away + (places[parent] if parent else 0.0)
    return places


@pytest.mark.parametrize("pose", POSES)
def test_an_avatar_that_wears_the_bones_reaches_what_the_stage_s_figure_reaches(pose: str) -> None:
    assert FIGURES is not None
    character = posed(pose)
    assert character.figure is not None
    found = worn(BONES.turns(character, FIGURES.poses))
    mixed = mix_poses(FIGURES.poses, character.figure.poses, {}, {}, character.idle)
    stage = pose_figure(FIGURES.space, AVATAR.resting, mixed).joints
    stage -= stage[0]
    skeleton = FIGURES.space.skeleton
    legs, arms = (
        [f"{name}.{side}" for name, side in itertools.product(names, "LR")]
        for names in (("lowerleg01", "foot"), ("lowerarm01", "wrist", "finger2-3"))
    )
    for bone in (*legs, *arms, "head"):
        most = 0.001 if bone in legs else 0.025  # a humanoid's trunk bends in three places, ours in five
        assert np.linalg.norm(found[bone] - stage[skeleton.places[bone]]) < most, bone


def test_packets_hold_every_bone_once_and_our_own_decoder_reads_the_head() -> None:
    assert FIGURES is not None
    character = posed("wave", yaw=0.4)
    turns = BONES.turns(character, FIGURES.poses)
    names = {unity_name(name) for name in humanoid_bones()}
    assert turns.keys() == names >= {"Hips", "LeftThumbIntermediate", "RightLittleDistal", "UpperChest"}
    packets = encode_face(
        FaceTarget("vmc", "host", 1), character, dict.fromkeys(ARKIT_NAMES, 0.0), 1.0, lambda _: turns
    )
    assert max(map(len, packets)) < 1500
    messages = [message for packet in packets for message in decode_packet(packet)]
    sent = [str(message.arguments[0]) for message in messages if message.address == BONE]
    assert sorted(sent) == sorted([*names, "LeftEye", "RightEye"])
    assert [message.arguments[0] for message in messages if message.address == ROOT] == ["root"]
    hips = next(message for message in messages if message.arguments[:1] == ("Hips",))
    height = hips.arguments[2]
    assert isinstance(height, float)
    assert 0.7 < height < 1.3, "metres above the soles"
    decoder = VmcDecoder()
    frames = [frame for packet in packets for frame in decoder.decode(packet)]
    assert frames[-1].head is not None
    assert frames[-1].head[0] > 0.15, "neck and head; chest and spine have the rest of the turn"


def test_a_figure_of_which_nothing_is_called_sends_no_bones() -> None:
    assert FIGURES is not None
    session = ShowSession(CAST)
    assert BONES.turns(session.tick(0.0).characters["one"], FIGURES.poses) == {}
