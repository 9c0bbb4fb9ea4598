"""BVH of strangers: what is none is rejected at once, with a sentence."""

from __future__ import annotations

import time

import pytest

from omote.interchange.clips.bvh_reader import MOST_JOINTS, read_bvh
from tests.interchange.clips.humanoids import MIXAMO, bvh_of, moving

SOUND = bvh_of(moving(tuple(MIXAMO), frames=3), MIXAMO).decode()
HEAD = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 3 Zrotation Yrotation Xrotation "
TAIL = " End Site { OFFSET 0 1 0 } }\nMOTION Frames: 1 Frame Time: 0.1\n0 0 0"
MOTION = "\nMOTION Frames: {} Frame Time: {}\n"
HOSTILE = {
    "does not begin with HIERARCHY": "solid nothing",
    "no MOTION": HEAD,
    "the hierarchy is cut off": "HIERARCHY ROOT a {" + MOTION.format(1, 0.1) + "0",
    "more than": "HIERARCHY " + "JOINT a { " * (MOST_JOINTS + 1) + MOTION.format(1, 0.1),
    "two roots": HEAD + "} ROOT b {" + MOTION.format(1, 0.1),
    "channels; expected 6 at most": "HIERARCHY ROOT a { CHANNELS 999999999 Xrotation" + MOTION.format(1, 0.1),
    "expected places and rotations": "HIERARCHY ROOT a { CHANNELS 1 Wrotation }" + MOTION.format(1, 0.1),
    "an offset is": HEAD.replace("0 0 0", "nan 0 0") + TAIL,
    "'1e99'": HEAD.replace("0 0 0", "1e99 0 0") + TAIL,
    "frames every": SOUND.replace("Frames: 3", "Frames: -3"),
    "frames every 0 s": SOUND.replace("Frame Time: 0.0333333333", "Frame Time: 0"),
    "expected some": SOUND.replace("Frames: 3", "Frames: 999999999"),
    "holds what is no number": SOUND + "\nnone",
    "out of all reach": SOUND[: SOUND.index("Frame Time")] + "Frame Time: 0.1\n" + "1e30 " * 300,
    "no whole frame": SOUND[: SOUND.index("Frame Time")] + "Frame Time: 0.1\n1 2 3",
    "'{' where none is expected": HEAD + "{ {" + TAIL,
}


@pytest.mark.parametrize("said", HOSTILE)
def test_what_is_no_motion_is_rejected_at_once(said: str) -> None:
    begun = time.process_time()
    with pytest.raises(ValueError, match=said.replace("{", r"\{")):
        read_bvh(HOSTILE[said].encode())
    assert time.process_time() - begun < 1.0


def test_large_files_are_rejected_before_they_are_read() -> None:
    huge = SOUND.encode().replace(b"Frames: 3", b"Frames: 30000000") + b"0 " * 2**20
    begun = time.process_time()
    with pytest.raises(ValueError, match="at most"):
        read_bvh(huge)
    assert time.process_time() - begun < 1.0


def test_a_file_that_is_cut_off_has_the_frames_that_are_whole() -> None:
    read = read_bvh(SOUND[:-40].encode())
    assert len(read.table) == 2
    assert read.notes == ("it holds 2 of the 3 frames that it speaks of",)


def test_names_of_several_words_and_marks_of_an_encoding_are_read() -> None:
    text = SOUND.replace("mixamorig:Hips", "mixamorig Hips of one")
    assert read_bvh(b"\xef\xbb\xbf" + text.encode()).joints[0].name == "mixamorig Hips of one"
