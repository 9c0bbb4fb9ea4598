"""A standby whose servers play the synthetic cast, as a supervisor starts it."""

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.builtin import BakedMesh
from omote.model.cast import Cast
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.static_pages import Page
from omote.server.persistence import disk_wait, restore
from omote.server.supervision.show_process import ShowMaterial
from omote.server.supervision.standby import main
from omote.show.session import ShowSession
from tests import synthetic

Result = TypeVar("Result")

MASK = b"\x89PNG\r\n\x1a\n"
PAGES = {path: Page(f"page {path}".encode(), "text/html", immutable=False) for path in ("/", "/stage", "/console")}


def drawn(name: str, triangles: NDArray[np.int32], count: int) -> BakedMesh:
    """A mesh drawn without seams."""
    open_sky = np.full(count, 255, np.uint8)
    return BakedMesh(name, np.arange(count, dtype=np.int32), np.zeros((count, 2), np.float32), triangles, open_sky)


def meshes(cast: Cast) -> list[BakedMesh]:
    """The meshes of a cast, drawn without seams."""
    space = cast.space
    parts = [drawn(name, part.triangles, len(part.points)) for name, part in space.parts.items()]
    return [drawn("skin", space.triangles, space.vertex_count), *parts]


def material() -> ShowMaterial:
    """The synthetic cast and three pages of one line."""
    cast = synthetic.cast()
    return ShowMaterial(CastDocuments(cast, meshes(cast), MASK), PAGES)


def poisoned(*_: object) -> ShowSession:
    """Kills whoever restores a state."""
    raise ArithmeticError("the state is poisoned")


def wait_for_disk(work: Callable[..., Result]) -> Callable[..., Result]:
    """Does what the disk does only while the file is not there that stands for its stall."""

    def waiting(*arguments: object) -> Result:
        while Path(os.environ["SYNTHETIC_STALL"]).exists():
            time.sleep(0.01)
        return work(*arguments)

    return waiting


if __name__ == "__main__":
    restore.FIRST_LIVELINESS = 0.0  # what tests play is all that moves
    if os.environ.get("SYNTHETIC_STALL"):
        for work in ("open_journal", "probe_disk"):
            setattr(disk_wait, work, wait_for_disk(getattr(disk_wait, work)))
    if os.environ.get("SYNTHETIC_POISON"):
        ShowSession.restored = poisoned  # type: ignore[method-assign, assignment]
        msgspec.msgpack.decode = lambda *_, **__: None  # type: ignore[assignment]
    sys.exit(main(load=material))
