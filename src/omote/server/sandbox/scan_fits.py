"""Fits faces to scans in a child process with limits; what comes back is validated again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.builtin.own_face import fit
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.face_fit import fit as fit_to_space
from omote.model.space.parameter_space import ParameterSpace
from omote.server.sandbox.child_task import Limits, Tell, ignore_progress, run_limited

LIMITS = Limits(seconds=900, patience=1800.0, memory=6 * 2**30, files=64, writes=True)
_TOO_MUCH = "fitting a face to it needs more time or memory than any head; export the head alone, with fewer points"

Points = Mapping[str, tuple[float, float, float]]


@dataclass(frozen=True, eq=False)
class ScanFit:
    """A face that was fitted to a scan.

    residual (V,): millimetres from the scan, nan where it shows nothing; seen (V,): 0 to 1; doubts: sentences.
    """

    face: Face
    residual: NDArray[np.float64]
    seen: NDArray[np.float64]
    doubts: tuple[str, ...]

    def describe(self) -> str:
        """How near the face is to the scan, in words."""
        found = self.residual[np.isfinite(self.residual)]
        if not len(found):
            return "nothing of it was seen"
        middle, worst = np.percentile(found, [50, 95])
        return f"{middle:.2f} mm from the scan (95 of 100 points within {worst:.2f})"


class _PlainFit(msgspec.Struct, frozen=True, array_like=True):
    positions: bytes
    parts: dict[str, bytes]
    residual: bytes
    seen: bytes
    doubts: list[str]


def fit_in_child(
    space: ParameterSpace, scan: Scan, /, *, name: str, landmarks: Points | None = None, shut: bool | None = None,
    follow: Tell = ignore_progress,
) -> ScanFit:  # fmt: skip
    """Fits a face to a scan; ValueError with a sentence where that cannot be."""

    def work(_: Tell) -> bytes:
        found = fit(
            space, scan.positions, scan.triangles, colours=scan.colours, landmarks=landmarks, name=name, shut=shut
        )
        parts = {part: points.astype(np.float32).tobytes() for part, points in found.face.parts.items()}
        residual, seen = np.asarray(found.residual, np.float64), np.asarray(found.seen, np.float64)
        positions = found.face.positions.astype(np.float32).tobytes()
        return msgspec.msgpack.encode(
            _PlainFit(positions, parts, residual.tobytes(), seen.tobytes(), list(found.doubts))
        )

    answer = run_limited(work, LIMITS, exhausted=_TOO_MUCH, follow=follow)
    try:
        return _scan_fit(space, name, msgspec.msgpack.decode(answer, type=_PlainFit))
    except msgspec.MsgspecError as error:
        raise ValueError(_TOO_MUCH) from error


def _scan_fit(space: ParameterSpace, name: str, plain: _PlainFit) -> ScanFit:
    parts = {part: np.frombuffer(data, np.float32).reshape(-1, 3) for part, data in plain.parts.items()}
    face = Face(name, np.frombuffer(plain.positions, np.float32).reshape(-1, 3), parts)
    fit_to_space(space, face)  # refuses what is no face of this space
    residual, seen = np.frombuffer(plain.residual), np.frombuffer(plain.seen)
    if not len(residual) == len(seen) == space.vertex_count:
        raise ValueError(f"a fit brought back {len(residual)} distances; expected {space.vertex_count}")
    return ScanFit(face, residual, seen, tuple(plain.doubts))
