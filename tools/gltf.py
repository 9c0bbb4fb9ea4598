"""What Khronos' validator and three.js make of GLB files; they run in Node, from web/node_modules."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from tools.node import ROOT, SENTENCE, find_node


def inspect(paths: Iterable[Path], /) -> list[dict[str, Any]]:
    """For each file {validator: {errors, warnings, infos, hints, said}, three: {root, meshes}}.

    RuntimeError where Node or its packages are missing.
    """
    path = find_node()
    if path is None:
        raise RuntimeError(SENTENCE)
    command = ["node", "tools/inspect_glb.mjs", *(str(file.absolute()) for file in paths)]
    environment = {**os.environ, "PATH": path}
    done = subprocess.run(command, cwd=ROOT / "web", env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"node could not inspect the files: {done.stderr.strip()}; run `make setup` first")
    return [json.loads(line) for line in done.stdout.splitlines()]
