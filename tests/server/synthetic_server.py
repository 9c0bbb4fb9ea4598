"""A server process that plays the synthetic cast, as a supervisor starts it."""

import sys

import numpy as np

from omote.builtin import BakedMesh
from omote.server.bundle import Page
from omote.server.child import Material, main
from omote.server.library import Library
from tests import synthetic

MASK = b"\x89PNG\r\n\x1a\n"
PAGES = {path: Page(f"page {path}".encode(), "text/html", immutable=False) for path in ("/", "/stage", "/console")}


def drawn_mesh(name: str, triangles: np.ndarray, count: int) -> BakedMesh:
    """A mesh drawn without seams."""
    return BakedMesh(name, np.arange(count, dtype=np.int32), np.zeros((count, 2), np.float32), triangles)


def material() -> Material:
    """The synthetic cast and three pages of one line."""
    cast = synthetic.cast()
    meshes = [drawn_mesh("skin", cast.space.triangles, cast.space.vertex_count)]
    meshes += [drawn_mesh(name, part.triangles, len(part.points)) for name, part in cast.space.parts.items()]
    return Material(Library(cast, meshes, MASK), PAGES)


if __name__ == "__main__":
    sys.exit(main(load=material))
