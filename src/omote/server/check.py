"""Checks whether this machine can play: versions, pages, cast, the time of one frame (`omote check`)."""

from __future__ import annotations

import platform
import time
from collections.abc import Callable, Iterator
from importlib.metadata import version

import numpy as np

FRAME_SECONDS = 1.0 / 60.0
LIBRARIES = ("numpy", "numba", "aiohttp", "msgspec")

Verdict = tuple[bool, str]


def run_checks() -> Iterator[Verdict]:
    """Yields the verdict of each check: versions, pages, cast, the time of a frame."""
    libraries = ", ".join(f"{name} {version(name)}" for name in LIBRARIES)
    yield True, f"omote {version('omote')} on Python {platform.python_version()}, {platform.system()}; {libraries}"
    for check in (check_pages, check_frame):
        yield run_check(check)


def run_check(check: Callable[[], Verdict]) -> Verdict:
    """Runs one check; an exception counts as a failed verdict with its message."""
    try:
        return check()
    except (OSError, ValueError, ImportError) as error:
        from omote.showfile.database_errors import describe_error

        return False, describe_error(error)


def check_pages() -> Verdict:
    """Checks that the pages are built."""
    from omote.server.http.static_pages import read_pages

    pages = read_pages()
    return True, f"pages: {len(pages)} files, {sum(len(page.body) for page in pages.values()) / 1024:.0f} KB"


def check_frame() -> Verdict:
    """Checks that the cast is baked and that one frame is computed in less than a frame's time."""
    from omote.perform.blending.evaluate import evaluate
    from omote.perform.performer import Performer
    from omote.server.http.cast_documents import built_in_documents

    cast = built_in_documents().cast
    performer = Performer(cast)
    face = list(cast.faces)[-1]
    expression = list(cast.expressions)[-1]
    performer.call_face(face, seconds=1.0)
    performer.call_expression(expression, seconds=1.0)
    evaluate(cast, performer.advance(0.5))
    times = []
    for _ in range(10):
        begun = time.perf_counter()
        evaluate(cast, performer.advance(0.01))
        times.append(time.perf_counter() - begun)
    taken = float(np.median(times))
    named = f"cast: {len(cast.faces)} faces, {len(cast.expressions)} expressions"
    return taken < FRAME_SECONDS, f"{named}; a frame takes {taken * 1000:.2f} ms of {FRAME_SECONDS * 1000:.1f} ms"
