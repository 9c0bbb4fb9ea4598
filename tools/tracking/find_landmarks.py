"""Finds landmarks in pictures, in an environment of its own (mediapipe 0.10.9, numpy 1): pictures in, points out.

stdin: pictures of size x size x 3 bytes one after the other; stdout: for each a byte (found) and 478 x 3 float32.
Each picture is taken alone, as the first of a film: twice, as a film's tracker sees it.
"""

import os
import sys

os.environ["GLOG_minloglevel"] = "3"
import numpy as np


def main() -> None:
    """Reads until the input ends."""
    import mediapipe

    size = int(sys.argv[1])
    out = os.fdopen(os.dup(1), "wb")
    mesh = mediapipe.solutions.face_mesh.FaceMesh(
        static_image_mode=sys.argv[2] == "alone", max_num_faces=1, refine_landmarks=True
    )
    while data := sys.stdin.buffer.read(size * size * 3):
        picture = np.frombuffer(data, np.uint8).reshape(size, size, 3)
        found = mesh.process(picture).multi_face_landmarks
        points = np.zeros((478, 3), np.float32)
        if found:
            points[:] = [(p.x, p.y, p.z) for p in found[0].landmark]
        out.write(bytes([bool(found)]) + points.tobytes())
        out.flush()


main()
