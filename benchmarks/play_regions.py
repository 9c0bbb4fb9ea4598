"""What regional mixes do to faces that nobody tuned (docs/method.md, "Regions of a call").

Random faces (mixes of three of the cast) show one performed expression on the whole face and others in brows, eyes and
mouth. Counted: triangles turned over against the face at rest that are upright under each of the four alone. The peer:
the same mixes with hard borders, each vertex belonging to its strongest region whole. Then the time of such a frame
beside one without regions, on one core, in turns. The bars: folds in 2 of 100 frames at most and fewer than the peer; 4
times the time, for four mixes. Ends with 1 where a bar is missed.

Usage: python -m benchmarks.play_regions [--frames 100] [--seed 1993]
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core; read when NumPy is loaded

import argparse
import sys
from collections.abc import Mapping
from dataclasses import replace
from statistics import median
from time import thread_time
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import track
from rich.table import Table

from omote import Cast, load_cast
from omote.geometry.orientation import area_shares, rest_normals
from omote.model.known_names import PLAY_REGIONS, PlayRegion
from omote.perform.blending import evaluate as evaluator
from omote.perform.blending import frame_correctives
from omote.perform.blending.region_masks import PlayMask, play_masks
from omote.perform.frame import Frame

MOST_FRAMES = 0.02
MOST_TIME = 4.0
Masks = Mapping[PlayRegion, PlayMask]


def main() -> int:
    """Prints folds and times beside the bars."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1993)
    given = parser.parse_args()
    cast = load_cast()
    draw = np.random.default_rng(given.seed)
    soft = play_masks(cast.space)
    hard = _hard(play_masks(cast.space))
    frames = [_draw_frame(cast, draw) for _ in range(given.frames)]
    found = [
        (_new_folds(cast, each, soft), _new_folds(cast, each, hard)) for each in track(frames, "Looking for folds")
    ]
    ours, peer = (np.array(column) for column in zip(*found, strict=True))
    ratio = _time_ratio(cast, frames[:10])
    return _report(ours, peer, ratio)


def _draw_frame(cast: Cast, draw: np.random.Generator) -> Frame:
    names = [name for name, title in cast.titles.items() if title.kind == "performed"]
    shares = zip(draw.choice(list(cast.faces), 3, replace=False), draw.dirichlet(np.ones(3)), strict=True)
    worn = [str(name) for name in draw.choice(names, 4, replace=False)]
    regions = {region: {name: 1.0} for region, name in zip(PLAY_REGIONS, worn[:3], strict=False)}
    return Frame({str(name): float(share) for name, share in shares}, {worn[3]: 1.0}, regions=regions)


def _hard(masks: Masks) -> Masks:
    """Each vertex with its strongest region alone."""

    def strongest(shares: list[NDArray[np.float32]]) -> list[NDArray[np.float32]]:
        first = np.argmax(np.stack(shares), axis=0)
        return [(first == place).astype(np.float32) for place in range(len(shares))]

    skins = strongest([masks[region].skin for region in PLAY_REGIONS])
    allowed = strongest([masks[region].allowances for region in PLAY_REGIONS])
    return {
        region: replace(masks[region], skin=skins[place], allowances=allowed[place])
        for place, region in enumerate(PLAY_REGIONS)
    }


def _new_folds(cast: Cast, frame: Frame, masks: Masks) -> int:
    """Triangles that the regions turn over and none of their mixes alone."""
    with (
        patch.object(evaluator, "play_masks", lambda _: masks),
        patch.object(frame_correctives, "play_masks", lambda _: masks),
    ):
        folded = _folds(cast, frame)
    for mix in (frame.expressions, *frame.regions.values()):
        folded &= ~_folds(cast, replace(frame, expressions=mix, regions={}))
    return int(folded.sum())


def _folds(cast: Cast, frame: Frame) -> NDArray[np.bool_]:
    rest = sum(share * cast.faces[name].positions for name, share in frame.faces.items())
    triangles = cast.space.skin_triangles
    normals, sizes = rest_normals(np.asarray(rest), triangles)
    moved = evaluator.evaluate(cast, frame).astype(np.float64)
    turned: NDArray[np.bool_] = area_shares(moved, normals, sizes, triangles) <= 0.0
    return turned


def _time_ratio(cast: Cast, frames: list[Frame]) -> float:
    """The time of a frame with regions beside the same without."""
    ratios = []
    for _ in range(20):
        for frame in frames:
            times = []
            for each in (frame, replace(frame, regions={})):
                start = thread_time()
                evaluator.evaluate(cast, each)
                times.append(thread_time() - start)
            ratios.append(times[0] / times[1])
    return median(ratios)


def _report(ours: NDArray[np.int64], peer: NDArray[np.int64], ratio: float) -> int:
    table = Table(title=f"{len(ours)} frames of random faces, four expressions in four regions", title_justify="left")
    for column in ("measure", "ours", "hard borders", "bar"):
        table.add_column(column)
    frames = float((ours > 0).mean())
    worse = float((peer > 0).mean())
    table.add_row(
        "frames with new folds", f"{frames:.3f}", f"{worse:.3f}", f"{MOST_FRAMES:g}, and less than hard borders"
    )
    table.add_row("new folds per frame", f"{ours.mean():.2f}", f"{peer.mean():.2f}", "")
    table.add_row("time beside a frame without regions", f"{ratio:.2f}", "", f"{MOST_TIME:g}")
    Console().print(table)
    return 0 if frames <= MOST_FRAMES and frames < worse and ratio <= MOST_TIME else 1


if __name__ == "__main__":
    sys.exit(main())
