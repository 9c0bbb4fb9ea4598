"""Reads a scan in whichever format its bytes are, and says of other files what they are and what to do."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from omote.interchange.formats.file_content import describe_content
from omote.interchange.formats.file_kinds import advise, suffixes_of
from omote.interchange.scans.cloud_reader import read_cloud
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.gltf_scan import read_gltf
from omote.interchange.scans.ply_reader import read_ply
from omote.interchange.scans.stl_reader import read_stl
from omote.interchange.scans.wavefront_reader import read_wavefront
from omote.model.fitting.scan import Scan

Reader = Callable[[bytes, Companions], Scan]

_MESHES: Mapping[str, Reader] = {
    ".ply": read_ply,
    ".obj": read_wavefront,
    ".stl": read_stl,
    **dict.fromkeys((".glb", ".gltf", ".vrm"), read_gltf),
}
READERS: Mapping[str, Reader] = {suffix: _MESHES.get(suffix, read_cloud) for suffix in suffixes_of("head")}
"""Readers by the suffix of a file's name; what is no mesh is a table of points."""
_BEGINNINGS: Mapping[bytes, str] = {
    b"ply\n": ".ply", b"ply\r": ".ply", b"glTF": ".glb", b"BLENDER": ".blend", b"Kaydara FBX": ".fbx",
    b"PXR-USDC": ".usdc", b"#usda": ".usda", b"PK\x03\x04": ".zip", b"\x1f\x8b": ".gz", b"\x89PNG": ".png",
    b"\xff\xd8\xff": ".jpg", b"GIF8": ".gif", b"ASTM-E57": ".e57", b"LASF": ".las", b"# .PCD": ".pcd",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class ScanFile:
    """A scan with sentences about what of its file could not be used."""

    scan: Scan
    notes: tuple[str, ...] = ()


def read_scan(suffix: str, data: bytes, beside: Companions | None = None, /) -> ScanFile:
    """Reads a scan by its bytes; suffix: of the file's name, which decides where these say nothing.

    ValueError, with what the file is and what to do, for any other file.

    data: the file; beside: what lies beside it.
    """
    if not data.strip():
        raise ValueError("the file is empty; copy or export it anew")
    suffix = suffix.lower()
    detected = next((kind for beginning, kind in _BEGINNINGS.items() if data.startswith(beginning)), suffix)
    if detected == ".zip" and suffix == ".usdz":
        detected = suffix
    if detected not in READERS:
        what = _name(detected, data)
        raise ValueError(f"the file is {what}, which is not read here; {advise(detected, 'head')}")
    companions = Companions() if beside is None else beside
    with np.errstate(invalid="ignore", over="ignore"):  # of numbers that are none, which are refused at the end
        return ScanFile(READERS[detected](data, companions), tuple(companions.notes))


def _name(suffix: str, data: bytes) -> str:
    described = describe_content(data)
    return (
        described
        if described not in ("text", "binary data of another kind")
        else f"{described} ({suffix or 'no suffix'})"
    )
