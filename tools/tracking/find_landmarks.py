"""Finds landmarks in the pictures of a film, in an environment of its own (mediapipe 0.10.9, numpy 1).

stdin: pictures, each its side in pixels (4 bytes) and side x side x 3 bytes; stdout: for each a byte (found) and
478 x 3 float32. First argument: the packed models of the camera page's npm package, which replace the wheel's own.
"""

import os
import sys
from pathlib import Path

os.environ["GLOG_MINLOGLEVEL"] = "3"
import mediapipe
import numpy as np

MODELS = {
    "face_landmark/face_landmark_with_attention.tflite": (0, 2495952),
    "face_landmark/face_landmark.tflite": (2495952, 3737848),
    "face_detection/face_detection_short_range.tflite": (3757224, 3986256),
}
"""Where the package's loader says that each model lies."""


def unpack_models(packed: Path) -> None:
    """Puts the package's models in the place of the wheel's."""
    data = packed.read_bytes()
    folder = Path(mediapipe.__file__).parent / "modules"
    for name, (first, end) in MODELS.items():
        model = folder / name
        if model.read_bytes() != data[first:end]:
            model.write_bytes(data[first:end])


def main() -> None:
    """Reads until the input ends."""
    out = os.fdopen(os.dup(1), "wb")
    unpack_models(Path(sys.argv[1]))
    mesh = mediapipe.solutions.face_mesh.FaceMesh(static_image_mode=False, max_num_faces=1, refine_landmarks=True)
    while head := sys.stdin.buffer.read(4):
        side = int.from_bytes(head, "little")
        picture = np.frombuffer(sys.stdin.buffer.read(side * side * 3), np.uint8).reshape(side, side, 3)
        found = mesh.process(picture).multi_face_landmarks
        points = np.zeros((478, 3), np.float32)
        if found:
            points[:] = [(p.x, p.y, p.z) for p in found[0].landmark]
        out.write(bytes([bool(found)]) + points.tobytes())
        out.flush()


main()
