"""The published head, where the pinned wheel is at hand (it is, on a machine that has baked the cast)."""

import os
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from tools.bake import CACHE
from tools.baking.heads.basemesh import BaseMesh, read_base_mesh
from tools.baking.heads.head import Head, cut_head
from tools.baking.heads.moves import Move, all_moves
from tools.baking.layout import unwrap
from tools.baking.package import VARIABLE, WHEEL, Package
from tools.baking.skin.texels import Texels, texels_of


@pytest.fixture(scope="session")
def package() -> Package:
    """The pinned package."""
    wheel = Path(os.environ.get(VARIABLE, CACHE / WHEEL))
    if not wheel.is_file():
        pytest.skip(f"{WHEEL} is not at hand: the cast was baked elsewhere")
    return Package(wheel)


@pytest.fixture(scope="session")
def base(package: Package) -> BaseMesh:
    """The published base mesh."""
    return read_base_mesh(package.text("mpfb2/3dobjs/base.obj"))


@pytest.fixture(scope="session")
def head(base: BaseMesh) -> Head:
    """The head cut out of it."""
    return cut_head(base)


@pytest.fixture(scope="session")
def base_points(base: BaseMesh, head: Head) -> NDArray[np.float64]:
    """The whole base mesh (n, 3) in the head's frame, metres."""
    return head.metres(base.points)


@pytest.fixture(scope="session")
def generic(base: BaseMesh, head: Head) -> NDArray[np.float64]:
    """The generic skin (V, 3), metres."""
    return head.metres(base.points)[head.skin.vertices]


@pytest.fixture(scope="session")
def texels(head: Head, generic: NDArray[np.float64]) -> Texels:
    """What lies under each pixel of the skin's pictures."""
    return texels_of(head.skin, generic, unwrap(head.skin, generic))


@pytest.fixture(scope="session")
def moves(package: Package, base: BaseMesh, head: Head) -> dict[str, Move]:
    """What every expression does to the generic head."""
    return all_moves(package, base, head)
