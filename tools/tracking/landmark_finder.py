"""Finds landmarks in pictures by the camera page's own model: in Chromium, or natively, twenty times as fast.

Native: `python -m venv ENV; ENV/bin/pip install mediapipe==0.10.9 "numpy<2"`, then OMOTE_MEDIAPIPE=ENV/bin/python; it
is given the models of the page's npm package, so that both find the same points (within .05 to .44 pixels of 288).
"""

from __future__ import annotations

import base64
import os
import subprocess
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.png import png_bytes
from tools.browser import ROOT, find_browser

LANDMARKS = 478
PACKAGE = ROOT / "web" / "node_modules" / "@mediapipe" / "face_mesh"
MOST_LOOKS = 6
SETTLED = 0.35
"""Pixels."""
PAGE = """<script src="/face_mesh.js"></script><script>
const mesh = new FaceMesh({ locateFile: (name) => "/" + name });
mesh.setOptions({ maxNumFaces: 1, refineLandmarks: true, useCpuInference: true });
let found = null;
mesh.onResults(({ multiFaceLandmarks: faces }) => { found = faces?.[0]?.map(({ x, y, z }) => [x, y, z]) ?? null; });
window.look = async (url) => {
  const image = new Image();
  image.src = url;
  await image.decode();
  await mesh.send({ image });
  return found;
};
</script>"""
KINDS = {".js": "text/javascript", ".wasm": "application/wasm"}
Points = NDArray[np.float32]


class Looks(Protocol):
    """Whatever finds landmarks in the next picture of a film."""

    def look(self, picture: NDArray[np.uint8]) -> Points | None:
        """The points (478, 3) in the next picture; None where no face is found."""

    def close(self) -> None:
        """Ends it."""


def find(finder: Looks, picture: NDArray[np.uint8]) -> Points | None:
    """The points (478, 3) in a picture that follows no other; None where no face is found.

    The model looks where the face was in the picture before: it is shown the same one until it has settled there, as it
    has in a film.

    finder: the model; picture (h, w, 3).
    """
    points = finder.look(picture)
    for _ in range(MOST_LOOKS - 1):
        before = points
        points = finder.look(picture)
        if points is None or (before is not None and _moved(before, points) * len(picture) < SETTLED):
            break
    return points


def open_finder() -> Looks:
    """The native model where OMOTE_MEDIAPIPE names its Python, else the page's in Chromium."""
    python = os.environ.get("OMOTE_MEDIAPIPE")
    return NativeFinder(python) if python else ChromiumFinder()


class NativeFinder:
    """The model in a process of its own environment."""

    def __init__(self, python: str) -> None:
        script = Path(__file__).with_name("find_landmarks.py")
        model = PACKAGE / "face_mesh_solution_packed_assets.data"
        self._process = subprocess.Popen(
            [python, str(script), str(model)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )

    def look(self, picture: NDArray[np.uint8]) -> Points | None:
        """The points (478, 3) in the next picture; None where no face is found."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(len(picture).to_bytes(4, "little") + picture.tobytes())
        self._process.stdin.flush()
        answer = self._process.stdout.read(1 + 12 * LANDMARKS)
        if not answer:
            raise RuntimeError("the native landmark model has ended; run tools/tracking/find_landmarks.py to see why")
        return np.frombuffer(answer, np.float32, offset=1).reshape(LANDMARKS, 3) if answer[0] else None

    def close(self) -> None:
        """Ends the process."""
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()


class ChromiumFinder:
    """The npm package as it is, on a bare page in a headless Chromium, with the settings of the camera page."""

    def __init__(self) -> None:
        from playwright.sync_api import sync_playwright

        self._playwright = sync_playwright().start()
        self._browser = self._playwright.chromium.launch(executable_path=str(find_browser()), args=["--no-sandbox"])
        self._page = self._browser.new_page()
        self._page.set_default_timeout(120_000)
        self._page.route("**/*", _serve)
        self._page.goto("http://localhost:9/")

    def look(self, picture: NDArray[np.uint8]) -> Points | None:
        """The points (478, 3) in the next picture; None where no face is found."""
        url = "data:image/png;base64," + base64.b64encode(png_bytes(picture)).decode()
        found = self._page.evaluate("(url) => window.look(url)", url)
        return None if found is None else np.array(found, np.float32)

    def close(self) -> None:
        """Ends the browser."""
        self._browser.close()
        self._playwright.stop()


def _serve(route: Any) -> None:
    name = route.request.url.rsplit("/", 1)[-1]
    path = PACKAGE / name
    if not name:
        route.fulfill(body=PAGE, content_type="text/html")
    elif path.is_file():
        route.fulfill(body=path.read_bytes(), content_type=KINDS.get(path.suffix, "application/octet-stream"))
    else:
        route.fulfill(status=404, body="")


def _moved(before: Points, after: Points) -> float:
    """How far points have moved, in pictures (root mean square)."""
    return float(np.sqrt(((after - before)[:, :2] ** 2).sum(axis=1).mean()))
