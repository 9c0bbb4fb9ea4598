"""Faces as VRM files: every face of the cast in both versions, validated, and played by three-vrm in Chromium.

errors, warnings: of Khronos' validator; the name of VRM 0.x's extension is one warning in every file of it. presets and
customs: what three-vrm finds by name (0.x has no preset `surprised`). off: how far from our compounds three-vrm has the
farthest vertex of any of them, at full weight. on air: how far that is from what stages draw, where sums are corrected
(`mouthClose` without an open jaw, lashes of a blink), which targets cannot do; told, not judged.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from playwright.sync_api import Browser, sync_playwright
from rich.console import Console
from rich.progress import track
from rich.table import Table

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.avatar.export_vrm import TURNED, vrm_bytes
from omote.interchange.avatar.preset_expressions import PRESETS, preset_weights
from omote.interchange.avatar.vrm_licence import VERSIONS, Credit, Version
from omote.interchange.export_face import ExportContext
from tests.browser.avatar_page import NEAR, PERFECT_SYNC, blended, distances, on_air, open_avatar
from tests.browser.conftest import KIOSK, PAGES, QUIET, RENDERER
from tools.browser import SENTENCE, find_browser
from tools.gltf import inspect

NAMELESS = {"1.0": 0, "0.x": 1}
"""Warnings that a version's own extension earns by its name."""


@dataclass(frozen=True)
class Found:
    """What one file is like: bytes, what the validator counts, what three-vrm finds and misses, metres."""

    size: int
    errors: int
    warnings: int
    presets: int
    customs: int
    off: float
    on_air: float


def measure(browser: Browser, context: ExportContext, face: str, version: Version, folder: Path) -> Found:
    """Writes one face and has it judged."""
    file = folder / f"{face}.vrm"
    file.write_bytes(vrm_bytes(context, face, [], Credit(("Omote",), version=version)))
    (seen,) = inspect([file])
    names = {**preset_weights(context.cast), **PERFECT_SYNC}
    if version == "0.x":
        names["Surprised"] = names.pop("surprised")
    with open_avatar(browser, file) as page:
        found = page.evaluate("window.avatar.found")
        far = distances(page, names, partial(blended, face), TURNED if version == "0.x" else np.ones(3))
    judged = seen["validator"]
    named = len(found["presets"]), len(found["customs"])
    differ = max(corrected(face, weights) for weights in names.values())
    return Found(file.stat().st_size, judged["errors"], judged["warnings"], *named, max(far.values()), differ)


def corrected(face: str, weights: Mapping[str, float]) -> float:
    """How far what is on air is from the compounds alone, metres."""
    drawn = on_air(face, weights)
    summed = blended(face, weights)
    return max(float(np.abs(drawn[name] - summed[name]).max()) for name in drawn)


def is_good(found: Found, version: Version) -> bool:
    """Whether a file holds every bar."""
    all_named = found.presets + found.customs == len(PRESETS) + len(PERFECT_SYNC)
    return not found.errors and found.warnings == NAMELESS[version] and all_named and found.off <= NEAR


def main(faces: Sequence[str], versions: Sequence[Version]) -> int:
    """Prints the table; 0 when every bar is held."""
    cast = load_cast()
    console = Console(width=110)
    path = find_browser()
    context = ExportContext(cast, load_meshes(), load_mask())
    table = Table(title="VRM of the cast, in three-vrm (off in mm)")
    for column in ("face", "version", "MB", "errors", "warnings", "presets", "customs", "off", "on air", "held"):
        table.add_column(column, justify="left" if column == "face" else "right")
    assert path is not None, SENTENCE
    held = True
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        options = [*RENDERER, *PAGES, *KIOSK, *QUIET]
        browser = playwright.chromium.launch(executable_path=str(path), chromium_sandbox=False, args=options)
        for face in track(faces or [*cast.faces], "faces", console=console):
            for version in versions:
                found = measure(browser, context, face, version, Path(folder))
                good = is_good(found, version)
                held &= good
                counts = map(str, (found.errors, found.warnings, found.presets, found.customs))
                off = f"{1000 * found.off:.4f}", f"{1000 * found.on_air:.2f}"
                table.add_row(face, version, f"{found.size / 1e6:.1f}", *counts, *off, "yes" if good else "NO")
        browser.close()
    console.print(table)
    console.print(f"bars: no error, no warning but the name of 0.x, all by name, off <= {1000 * NEAR} mm")
    return 0 if held else 1


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("faces", nargs="*", help="all, where none is named")
    parser.add_argument("--version", choices=VERSIONS, action="append", help="both, where none is named")
    arguments = parser.parse_args()
    sys.exit(main(arguments.faces, arguments.version or VERSIONS))
