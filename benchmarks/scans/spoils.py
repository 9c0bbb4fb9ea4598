"""What happens to scans: noise, holes, halves, hair, glasses, few points; each spoils a head in its own frame."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from benchmarks.scans.strange_shapes import ball, join
from benchmarks.scans.true_heads import TrueHead
from omote.model.fitting.landmarks import SEVEN

Values = NDArray[np.float64]
Spoil = Callable[[TrueHead, np.random.Generator], TrueHead]

MILLION = 1_000_000
FEW = 500


def keep(head: TrueHead, chosen: NDArray[np.bool_]) -> TrueHead:
    """The head without the points that are not chosen."""
    number = np.cumsum(chosen) - 1
    triangles = head.triangles[chosen[head.triangles].all(axis=1)]
    return replace(head, points=head.points[chosen], triangles=number[triangles])


def retriangulate(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    """Other triangles, other points and another order, so that rows tell nothing."""
    cut = draw.uniform(size=len(head.triangles)) < 0.4
    chosen = head.triangles[cut]
    share = draw.dirichlet((4, 4, 4), len(chosen))
    middles = np.einsum("tk,tkc->tc", share, head.points[chosen])
    new = len(head.points) + np.arange(len(chosen))
    more = [np.stack([chosen[:, k], chosen[:, (k + 1) % 3], new], axis=1) for k in range(3)]
    return shuffle(
        replace(head, points=np.concatenate([head.points, middles]),
                triangles=np.concatenate([head.triangles[~cut], *more])), draw
    )  # fmt: skip


def shuffle(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    """The points in another order."""
    order = draw.permutation(len(head.points))
    triangles = np.argsort(order)[head.triangles]
    return replace(head, points=head.points[order], triangles=triangles[draw.permutation(len(triangles))])


def sample(head: TrueHead, count: int, draw: np.random.Generator) -> TrueHead:
    """A cloud of so many points of the surface."""
    a, b, c = (head.points[head.triangles[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    row = draw.choice(len(area), count, p=area / area.sum())
    share = draw.dirichlet((1, 1, 1), count)
    points = share[:, :1] * a[row] + share[:, 1:2] * b[row] + share[:, 2:] * c[row]
    return replace(head, points=points, triangles=np.zeros((0, 3), np.int64))


def _noise(size: float) -> Spoil:
    def spoil(head: TrueHead, draw: np.random.Generator) -> TrueHead:
        return replace(head, points=head.points + draw.normal(0, size / np.sqrt(3), head.points.shape))

    return spoil


def _holes(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    gone = np.zeros(len(head.points), bool)
    for _ in range(12):
        middle = head.points[draw.integers(len(head.points))]
        gone |= np.linalg.norm(head.points - middle, axis=1) < draw.uniform(0.006, 0.02)
    return keep(head, ~gone)


def _half(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    side = draw.choice([-1, 1])
    return keep(head, side * head.points[:, 0] > -draw.uniform(0.0, 0.02))


def _no_back(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    return keep(head, head.points[:, 2] > head.landmarks["nose_tip"][2] - draw.uniform(0.06, 0.1))


def _no_neck(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    return keep(head, head.points[:, 1] > head.landmarks["mouth_left"][1] - draw.uniform(0.04, 0.055))


def _one_side(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    """What a scanner sees from half the side."""
    yaw = draw.choice([-1, 1]) * draw.uniform(0.3, 0.7)
    a, b, c = (head.points[head.triangles[:, k]] for k in range(3))
    seen = np.cross(b - a, c - a) @ [np.sin(yaw), 0, np.cos(yaw)] > 0
    return replace(head, triangles=head.triangles[seen])


def _mirror(head: TrueHead, _draw: np.random.Generator) -> TrueHead:
    other = {name: name.replace("left", "?").replace("right", "left").replace("?", "right") for name in SEVEN}
    marks = {name: head.landmarks[other[name]] * [-1, 1, 1] for name in SEVEN}
    return replace(head, points=head.points * [-1, 1, 1], landmarks=marks)


def _few(head: TrueHead, _draw: np.random.Generator) -> TrueHead:
    """Vertices clustered on a lattice, as coarse as leaves about 500."""
    for cell in np.linspace(0.004, 0.06, 40):
        _, near = np.unique(np.floor(head.points / cell), axis=0, return_inverse=True)
        near = near.ravel()
        if near.max() < FEW:
            break
    count = np.bincount(near)
    points = np.stack([np.bincount(near, head.points[:, k]) / count for k in range(3)], axis=1)
    corners = near[head.triangles]
    flat = (corners == np.roll(corners, 1, axis=1)).any(axis=1)
    return replace(head, points=points, triangles=np.unique(corners[~flat], axis=0))


def _double(head: TrueHead, _draw: np.random.Generator) -> TrueHead:
    count = len(head.points)
    return replace(head, points=np.tile(head.points, (2, 1)),
                   triangles=np.concatenate([head.triangles, head.triangles + count]))  # fmt: skip


def _shoulders(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    return keep(head, head.points[:, 1] > head.landmarks["nose_tip"][1] - draw.uniform(0.3, 0.5))


def _hair(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    """A volume about the skull that leaves the face free, curls on it."""
    brow = head.landmarks["left_eye_inner"] * [0, 1, 1]
    points, triangles = ball(brow + np.array([0.0, 0.045, -0.075]), (0.105, 0.1, 0.115), 80)
    points = points + draw.normal(0, 0.004, points.shape)
    free = (points[:, 2] < brow[2] - 0.015) | (points[:, 1] > brow[1] + 0.07)
    hair = keep(replace(head, points=points, triangles=triangles), free)
    return _with(head, (hair.points, hair.triangles))


def _glasses(head: TrueHead, _draw: np.random.Generator) -> TrueHead:
    rims = []
    for side in ("left", "right"):
        outer = head.landmarks[f"{side}_eye_outer"]
        inner = head.landmarks[f"{side}_eye_inner"]
        middle = (outer + inner) / 2 + np.array([0.0, -0.003, 0.014])
        around = [np.array([0.025 * np.cos(a), 0.021 * np.sin(a), 0.0]) for a in np.linspace(0, 2 * np.pi, 40)]
        rims.append(join([ball(middle + off, (0.002,) * 3, 6) for off in around]))
    return _with(head, join(rims))


def _with(head: TrueHead, more: tuple[Values, NDArray[np.int64]]) -> TrueHead:
    points, triangles = join([(head.points, head.triangles), more])
    return replace(head, points=points, triangles=triangles)


def _inside_out(head: TrueHead, _draw: np.random.Generator) -> TrueHead:
    return replace(head, triangles=head.triangles[:, ::-1])


def _debris(head: TrueHead, draw: np.random.Generator) -> TrueHead:
    """Crumbs that float about, as scanners leave them."""
    size = np.ptp(head.points, axis=0)
    crumbs = [ball(head.points.mean(axis=0) + size * draw.uniform(-0.8, 0.8, 3), draw.uniform(0.002, 0.012, 3), 8)
              for _ in range(25)]  # fmt: skip
    return _with(head, join(crumbs))


SPOILS: Mapping[str, Spoil] = {
    "plain": lambda head, _: head,
    "noise .4 mm": _noise(0.0004), "noise 1 mm": _noise(0.001), "noise 2 mm": _noise(0.002),
    "holes": _holes, "half": _half, "no back": _no_back, "no neck": _no_neck, "from one side": _one_side,
    "mirrored": _mirror, "inside out": _inside_out, "doubled": _double, "debris": _debris,
    "hair": _hair, "glasses": _glasses, "500 points": _few,
    "cloud": lambda head, draw: sample(head, 20_000, draw),
    "cloud of 4,000": lambda head, draw: sample(head, 4_000, draw),
    "noisy cloud": lambda head, draw: _noise(0.001)(sample(head, 50_000, draw), draw),
    "a million points": lambda head, draw: sample(head, MILLION, draw),
}  # fmt: skip
"""What spoils any head, by name."""
BODY_SPOILS: Mapping[str, Spoil] = {
    "body": lambda head, _: head, "shoulders": _shoulders, "noisy body": _noise(0.001),
    "cloud of a body": lambda head, draw: sample(head, 60_000, draw),
}  # fmt: skip
"""What spoils whole bodies."""


def behead(head: TrueHead) -> TrueHead:
    """A body without its head."""
    return keep(head, head.points[:, 1] < head.landmarks["mouth_left"][1] - 0.1)


def pair(head: TrueHead, other: TrueHead, draw: np.random.Generator) -> TrueHead:
    """Two heads side by side."""
    return _with(
        head, (other.points + np.array([draw.uniform(0.3, 0.6), draw.uniform(-0.1, 0.1), 0.0]), other.triangles)
    )
