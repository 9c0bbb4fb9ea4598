"""Refuses a wheel that could not play: pages and cast are built before, by `make wheel`, never by the build itself."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

NEEDED = (
    "src/omote/server/web/index.html",
    "src/omote/server/web/stage.html",
    "src/omote/server/web/console.html",
    "src/omote/server/web/editor.html",
    "src/omote/server/web/camera.html",
    "src/omote/builtin/cast.npz",
    "src/omote/builtin/figures.npz",
    "src/omote/builtin/identity_modes.npz",
    "src/omote/inputs/camera/landmark_map.npz",
    "src/omote/builtin/photographs/landmark_table.npz",
    "src/omote/builtin/photographs/skin_layers.npz",
    "src/omote/builtin/mask.png",
    "src/omote/builtin/NOTICE-CC0.md",
)


def missing_files(root: Path) -> list[str]:
    """What a wheel built in this folder would lack."""
    return [name for name in NEEDED if not (root / name).is_file()]


class CompleteWheel(BuildHookInterface[Any]):
    """Stops the build of a wheel without pages or cast; an editable install may come before both."""

    PLUGIN_NAME = "custom"

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002 - hatchling's signature
        """Raise RuntimeError with one sentence where a file is missing."""
        missing = missing_files(Path(self.root))
        if version != "editable" and missing:
            raise RuntimeError(f"A wheel without {', '.join(missing)} cannot play a show; build them first: make wheel")
