"""Fits faces to scans in a child process with limits; what comes back is validated again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_mask, load_meshes
from omote.builtin.own_face import fit
from omote.interchange.formats.png import read_png
from omote.interchange.scan_look import suggest_scan_look
from omote.interchange.skin_texture import build_canvas
from omote.model.cast import Cast, Look
from omote.model.fitting.doubt import Doubt, DoubtKind
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.face_fit import fit as fit_to_space
from omote.model.space.parameter_space import ParameterSpace
from omote.server.sandbox.child_task import Limits, Tell, ignore_progress, run_limited
from omote.showfile.contents import pack_face, unpack_face

LIMITS = Limits(seconds=900, patience=1800.0, memory=6 * 2**30, files=64, writes=True)
_TOO_MUCH = "fitting a face to it needs more time or memory than any head; export the head alone, with fewer points"

Points = Mapping[str, tuple[float, float, float]]


@dataclass(frozen=True, eq=False)
class ScanFit:
    """A face that was fitted to a scan.

    look: with the scan's colours, where it has any; residual (V,): millimetres from the scan, nan where it shows
    nothing; seen (V,): 0 to 1; doubts: sentences; notes: what could not be taken over.
    """

    face: Face
    look: Look
    residual: NDArray[np.float64]
    seen: NDArray[np.float64]
    doubts: tuple[Doubt, ...]
    notes: tuple[str, ...] = ()

    def describe(self) -> str:
        """How near the face is to the scan, in words."""
        found = self.residual[np.isfinite(self.residual)]
        if not len(found):
            return "nothing of it was seen"
        middle, worst = np.percentile(found, [50, 95])
        return f"{middle:.2f} mm from the scan (95 of 100 points within {worst:.2f})"


class _PlainFit(msgspec.Struct, frozen=True, array_like=True):
    content: bytes
    residual: bytes
    seen: bytes
    doubts: list[tuple[str, DoubtKind]]
    notes: list[str]


def fit_in_child(
    cast: Cast, scan: Scan, /, *, name: str, landmarks: Points | None = None, shut: bool | None = None,
    follow: Tell = ignore_progress,
) -> ScanFit:  # fmt: skip
    """Fits a face of the built-in cast's head to a scan; ValueError with a sentence where that cannot be."""

    def work(_: Tell) -> bytes:
        found = fit(
            cast.space, scan.positions, scan.triangles, colours=scan.colours, landmarks=landmarks, name=name, shut=shut
        )
        canvas = build_canvas(read_png(load_mask()), load_meshes()[0], cast.space.points)
        look, notes = suggest_scan_look(cast, canvas, found, scan)
        residual, seen = np.asarray(found.residual, np.float64), np.asarray(found.seen, np.float64)
        content = pack_face(found.face, look)
        doubts = [(str(doubt), doubt.kind) for doubt in found.doubts]
        return msgspec.msgpack.encode(_PlainFit(content, residual.tobytes(), seen.tobytes(), doubts, notes))

    answer = run_limited(work, LIMITS, exhausted=_TOO_MUCH, follow=follow)
    try:
        return _scan_fit(cast.space, name, msgspec.msgpack.decode(answer, type=_PlainFit))
    except msgspec.MsgspecError as error:
        raise ValueError(_TOO_MUCH) from error


def _scan_fit(space: ParameterSpace, name: str, plain: _PlainFit) -> ScanFit:
    face, look = unpack_face(plain.content, name)
    fit_to_space(space, face)  # refuses what is no face of this space
    residual, seen = np.frombuffer(plain.residual), np.frombuffer(plain.seen)
    if not len(residual) == len(seen) == space.vertex_count:
        raise ValueError(f"a fit brought back {len(residual)} distances; expected {space.vertex_count}")
    return ScanFit(face, look, residual, seen, tuple(Doubt(*each) for each in plain.doubts), tuple(plain.notes))
