"""The browser that the browser tests drive: one already here, else Debian's, else Playwright's own download.

`find_browser()` looks and changes nothing; `python tools/browser.py` also installs (the Makefile calls it once).
"""

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from ctypes.util import find_library
from pathlib import Path

from omote.server.headless.chromium import find_chromium

ROOT = Path(__file__).resolve().parent.parent
DOWNLOADS = ROOT / ".venv" / "browsers"
DOWNLOADED = ("chromium-*/chrome-linux*/chrome", "chromium-*/chrome-mac*/*.app/Contents/MacOS/*")

# Libraries that a bare Debian lacks, and their packages. Without EGL Chromium falls back to a renderer that is three
# times slower; Playwright's driver does not start without atomic.
DEBIAN_LIBRARIES = {"EGL": ("libegl1", "libegl-mesa0", "libgl1-mesa-dri"), "atomic": ("libatomic1",)}
DEBIAN = ("chromium", *(package for packages in DEBIAN_LIBRARIES.values() for package in packages))
SENTENCE = (
    "No browser for the browser tests: none is installed and none could be fetched. Install Chromium "
    "(Debian, Ubuntu: sudo apt-get install " + " ".join(DEBIAN) + ") "
    "or set OMOTE_BROWSER to the path of a Chromium or Chrome, then run the command again."
)
NO_DRIVER = (
    "Playwright, which drives the browser, does not start ({}); on Debian, Ubuntu: sudo apt-get install libatomic1"
)


def find_browser(environment: Mapping[str, str] = os.environ, downloads: Path = DOWNLOADS) -> Path | None:
    """The path of a Chromium or Chrome: the one `omote render` takes, else an earlier download; None without either.

    Raises FileNotFoundError where OMOTE_BROWSER names no file: a wish that cannot be met is not silently replaced.
    """
    try:
        return find_chromium(environment)
    except FileNotFoundError:
        if environment.get("OMOTE_BROWSER"):
            raise
    downloaded = [path for pattern in DOWNLOADED for path in sorted(downloads.glob(pattern), reverse=True)]
    return next((path for path in downloaded if path.is_file()), None)


def can_use_apt() -> bool:
    """Whether this user may install Debian packages here."""
    return hasattr(os, "geteuid") and os.geteuid() == 0 and shutil.which("apt-get") is not None


def install_debian(*packages: str) -> bool:
    """Install Debian packages; says whether it worked."""
    print("  apt-get install", *packages, flush=True)
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    for command in (["update"], ["install", "--yes", "--no-install-recommends", *packages]):
        run = subprocess.run(["apt-get", "-qq", *command], env=environment, capture_output=True, text=True, check=False)
        if run.returncode:
            print(run.stderr.strip(), file=sys.stderr)
            return False
    return True


def install_playwright() -> bool:
    """Let Playwright download its own Chromium into .venv/browsers; says whether it worked."""
    print("  Playwright downloads its own Chromium", flush=True)
    environment = {**os.environ, "PLAYWRIGHT_BROWSERS_PATH": str(DOWNLOADS)}
    command = [sys.executable, "-m", "playwright", "install", "--no-shell", "chromium"]
    return subprocess.run(command, env=environment, check=False).returncode == 0


def missing_libraries() -> list[str]:
    """The Debian packages of libraries that are not here."""
    return [name for library, names in DEBIAN_LIBRARIES.items() if find_library(library) is None for name in names]


def provide_browser() -> Path | None:
    """A browser, installed where none was; None where that was not possible."""
    browser = find_browser()
    wanted = [*(["chromium"] if browser is None else []), *missing_libraries()]
    if wanted and can_use_apt():
        install_debian(*wanted)
        browser = find_browser()
    if browser is None and install_playwright():
        browser = find_browser()
    return browser


def driver_trouble() -> str | None:
    """Why Playwright's driver does not start, in its own words; None where it does."""
    run = subprocess.run([sys.executable, "-m", "playwright", "--version"], capture_output=True, text=True, check=False)
    return None if run.returncode == 0 else (run.stderr.strip().splitlines() or ["no reason given"])[-1]


def refusal(browser: Path | None) -> str | None:
    """The sentence that says what is missing; None where the tests can run."""
    if browser is None:
        return SENTENCE
    trouble = driver_trouble()
    return None if trouble is None else NO_DRIVER.format(trouble)


def main() -> int:
    """Provide the browser and print its path; on failure one sentence on stderr."""
    try:
        browser = provide_browser()
    except FileNotFoundError as error:
        print(error, file=sys.stderr)
        return 1
    refused = refusal(browser)
    print(refused or f"  browser for the tests: {browser}", file=sys.stderr if refused else sys.stdout)
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
