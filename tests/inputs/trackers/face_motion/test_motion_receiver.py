"""FMV3 as the vendor's golden bytes have it: names first, then frames; nothing is guessed."""

import math
import struct

import pytest

from omote.inputs.trackers.face_motion.motion_message import Kind, MotionMessage
from omote.inputs.trackers.face_motion.motion_receiver import NONCE, MotionReceiver, ask_for_motion
from omote.inputs.trackers.tracker_frame import TrackerError
from tests.inputs.trackers.packets import SESSION, motion_frame, motion_schema

GOLDEN_FRAME = bytes.fromhex(
    "464d5633040128000807060504030201010000000a0000007518730d3c000000000001003c00000064000000c063ffff409c0000"
    "0000a03f000020c000007040cdcccc3dcdcc4cbe9a99993e000080400000a0400000c0400000e0400000004100001041"
)
"""`i32_custom_unicode` of the vendor's golden_vectors.json: jawOpen 100, two names of its own with -40000 and 40000."""
GOLDEN_SCHEMA = bytes.fromhex(
    "464d563303002800080706050403020101000000000000000000000031010000000001003101000011223344556677881e00bc0210270000"
    "040000007b22736368656d615f76657273696f6e223a312c22617070223a22466163656d6f74696f6e3364222c2270726f66696c65223a22"
    "666163656d6f74696f6e33642d6f74686572222c22626c656e645f6e616d6573223a5b226a61774f70656e222c22e78bace887aae381aee7"
    "ac91e9a194222c226d79437573746f6d536d696c65225d2c22626c656e645f656e636f64696e67223a22693136222c22626c656e645f756e"
    "6974223a2270657263656e74222c22706f73655f6c61796f7574223a22686561645f7278797a5f7078797a5f72696768744579655f727879"
    "7a5f6c6566744579655f7278797a222c22726f746174696f6e5f756e6974223a22646567726565222c22706f736974696f6e5f756e697422"
    "3a226d65746572227d"
)
"""`initial_facemotion3d`, which answers another program's hello."""


def schema(number: int = 1, nonce: int = NONCE, revision: int = 4, rate: int = 30, **changed: object) -> bytes:
    names = ["eyeBlinkLeft", "jawOpen"]
    return motion_schema(names, number, nonce, revision, rate, **changed)


def frame(sequence: int, values: tuple[int, ...] = (25, 50), number: int = 1, flags: int = 1) -> bytes:
    return motion_frame(values, sequence, number, flags)


@pytest.fixture
def answers() -> list[bytes]:
    """What the phone was sent."""
    return []


@pytest.fixture
def receiver(answers: list[bytes]) -> MotionReceiver:
    return MotionReceiver(answers.append)


def kinds(answers: list[bytes]) -> list[Kind]:
    return [Kind(each[4]) for each in answers]


def test_the_golden_frame_is_read(receiver: MotionReceiver, answers: list[bytes]) -> None:
    names = ["jawOpen", "独自の笑顔", "customWide"]
    assert receiver.decode(schema(blend_names=names, blend_encoding="i32")) == []
    assert answers == [MotionMessage(Kind.SCHEMA_ACK, SESSION, 1).encode()]
    (found,) = receiver.decode(GOLDEN_FRAME)
    assert found.weights == {"jawOpen": 1.0, "独自の笑顔": -0.5, "customWide": 1.5}  # as far as ours go
    assert found.head == pytest.approx((math.radians(-2.5), math.radians(-1.25), math.radians(-3.75)))
    assert found.gaze == pytest.approx((math.radians(6.5), math.radians(-5.5)))
    assert found.found


def test_the_golden_names_for_another_program_s_hello_are_rejected(receiver: MotionReceiver) -> None:
    with pytest.raises(TrackerError, match="answers another program"):
        receiver.decode(GOLDEN_SCHEMA)


def test_a_phone_that_begins_by_itself_is_heard(receiver: MotionReceiver, answers: list[bytes]) -> None:
    receiver.decode(schema(nonce=0))
    assert kinds(answers) == [Kind.SCHEMA_ACK]
    assert receiver.decode(frame(1))[0].weights == {"eyeBlinkLeft": 0.25, "jawOpen": 0.5}


def test_a_frame_before_its_names_asks_for_them_once_a_while(receiver: MotionReceiver, answers: list[bytes]) -> None:
    for sequence in range(30):
        with pytest.raises(TrackerError, match="names has not come"):
            receiver.decode(frame(sequence))
    assert kinds(answers) == [Kind.GET_SCHEMA]


def test_names_that_come_again_are_acknowledged_again(receiver: MotionReceiver, answers: list[bytes]) -> None:
    receiver.decode(schema())
    receiver.decode(frame(5))
    receiver.decode(schema())
    assert kinds(answers) == [Kind.SCHEMA_ACK] * 2
    assert receiver.decode(frame(5)) == []  # the same frame
    assert len(receiver.decode(frame(6))) == 1


def test_new_names_replace_the_old_ones(receiver: MotionReceiver) -> None:
    receiver.decode(schema())
    receiver.decode(schema(2, blend_names=["jawOpen"]))
    with pytest.raises(TrackerError, match="names has not come"):
        receiver.decode(frame(1))
    assert receiver.decode(frame(2, (30,), number=2))[0].weights == {"jawOpen": 0.3}


def test_older_frames_are_left_out_and_numbers_begin_again(receiver: MotionReceiver) -> None:
    receiver.decode(schema())
    numbers = [0xFFFFFFFE, 0xFFFFFFFF, 0, 0xFFFFFFFF, 1, 1, 0x80000001]
    assert [len(receiver.decode(frame(number))) for number in numbers] == [1, 1, 1, 0, 1, 0, 0]


def test_a_phone_hears_that_it_is_heard(receiver: MotionReceiver, answers: list[bytes]) -> None:
    receiver.decode(schema(rate=30))
    for sequence in range(1, 121):
        receiver.decode(frame(sequence))
    assert kinds(answers) == [Kind.SCHEMA_ACK, Kind.PING, Kind.PING]
    assert receiver.decode(MotionMessage(Kind.PONG, SESSION, sequence=60).encode()) == []


def test_a_lost_face_is_a_loss_and_a_recording_is_none(receiver: MotionReceiver) -> None:
    receiver.decode(schema())
    assert [receiver.decode(frame(n, flags=flags))[0].found for n, flags in ((1, 0), (2, 1), (3, 2))] == [
        False, True, True,
    ]  # fmt: skip


def test_over_tcp_nothing_is_acknowledged(answers: list[bytes]) -> None:
    receiver = MotionReceiver(answers.append, stream=True)
    receiver.decode(schema())
    assert len(receiver.decode(frame(1))) == 1
    assert answers == []


def test_text_frames_are_read_too(receiver: MotionReceiver) -> None:
    assert receiver.decode(b"jawOpen&25|=head#0,0,0|")[0].weights == {"jawOpen": 0.25}


def test_a_hello_says_what_is_wanted() -> None:
    asked = ask_for_motion(1)
    assert (len(asked), asked[4], asked[40:]) == (48, Kind.HELLO, bytes.fromhex("3c00b00404000000"))


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (schema(revision=5), "revision 5 of FMV3, expected 4"),
        (schema(rate=90), "another rate"),
        (schema(0), "no number"),
        (schema(blend_names=["a", "a"]), "one twice"),
        (schema(blend_names=[""]), "cannot be read"),
        (schema(blend_unit="share"), "cannot be read"),
        (schema(more=1), "cannot be read"),
        (MotionMessage(Kind.SCHEMA, SESSION, 1, payload=b"x").encode(), "no beginning"),
        (MotionMessage(Kind.ERROR, SESSION, payload=b"BUSY").encode(), "the phone says: BUSY"),
        (b"hello", "no coefficient"),
    ],
)
def test_what_cannot_be_used_is_rejected(receiver: MotionReceiver, data: bytes, why: str) -> None:
    with pytest.raises(TrackerError, match=why):
        receiver.decode(data)


def test_frames_of_another_size_are_rejected_and_an_angle_that_is_none_costs_itself(receiver: MotionReceiver) -> None:
    receiver.decode(schema())
    with pytest.raises(TrackerError, match="54 bytes, expected 52"):
        receiver.decode(frame(1, (1, 2, 3)))
    payload = struct.pack("<2h12f", 1, 2, math.nan, *([0.0] * 11))
    (found,) = receiver.decode(MotionMessage(Kind.FRAME, SESSION, 1, 2, 1, payload=payload).encode())
    assert (found.weights["jawOpen"], found.head, found.gaze) == (0.02, None, (0.0, 0.0))


def test_a_text_that_is_cut_is_read_up_to_there_where_others_were_whole(receiver: MotionReceiver) -> None:
    assert receiver.decode(b"jawOpen-40")[0].weights == {"jawOpen": 0.4}, "a sender that ends no field"
    receiver.decode(b"smile-10|jawOpen-80|")
    assert receiver.decode(b"smile-20|jawOpen-8")[0].weights == {"smile": 0.2}
