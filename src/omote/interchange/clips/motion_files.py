"""Files of strangers that hold the motion of a body: the one place where they are read and judged."""

from __future__ import annotations

from omote.interchange.clips.bvh_humanoid import bvh_motion
from omote.interchange.clips.humanoid_motion import HumanoidMotion
from omote.interchange.clips.vrma_reader import vrma_motion
from omote.interchange.formats.file_kinds import suffix_of

READERS = {".bvh": bvh_motion, ".vrma": vrma_motion}


def read_motion(name: str, data: bytes) -> HumanoidMotion:
    """The motion in a file.

    Parameters
    ----------
    name : str
        Of the file: its ending says what it is.
    data : bytes
        All of it.

    Raises
    ------
    ValueError
        For a file that is none of these, or holds no motion of a person.
    """
    reader = READERS.get(suffix_of(name))
    if reader is None:
        raise ValueError(f"{name[:80]!r} is no motion of a body by its name; give {' or '.join(READERS)}")
    if not data.strip():
        raise ValueError("it is empty")
    return reader(data)
