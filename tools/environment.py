"""Make `.venv` and install this package into it, at the versions of constraints.txt: `environment.py show` with what a
show uses, `environment.py test` with what checks and tests need.

Runs under the system's Python, which may be too old: it must be able to say so.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENT = ROOT / ".venv"
PYTHON = ENVIRONMENT / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
OLDEST = (3, 11)
EXTRAS = {"show": "https,discovery", "test": "test"}
"""The extras of pyproject.toml with which the package is installed, by what for."""
NO_VENV = (
    "Python could not make a virtual environment; it lacks the module venv or ensurepip "
    "(Debian, Ubuntu: sudo apt-get install python3-venv). Install it, then run the command again."
)
NO_PACKAGES = "The Python packages could not be installed; the lines above say why. Is the network there?"


def refusal(version: tuple[int, ...]) -> str | None:
    """The sentence that refuses a Python of this version; None where it is new enough."""
    if version[:2] >= OLDEST:
        return None
    return (
        f"This is Python {version[0]}.{version[1]}; Omote needs 3.11 or newer: name one, as in: make PYTHON=python3.12"
    )


def works(*command: str) -> bool:
    """Whether a command ends well; it runs in the repository and may print."""
    return subprocess.run(command, cwd=ROOT, check=False).returncode == 0


def make_environment() -> bool:
    """A `.venv` with pip in it, kept where it is already one; says whether it is there."""
    if PYTHON.exists() and works(str(PYTHON), "-c", "import pip"):
        return True
    print(f"  making .venv with Python {sys.version.split()[0]}", flush=True)
    return works(sys.executable, "-m", "venv", "--clear", str(ENVIRONMENT))


def install_packages(purpose: str) -> bool:
    """What a purpose of `EXTRAS` needs: build tools first, then the package itself without a build environment of its
    own: all of it is pinned."""
    print("  installing the pinned Python packages", flush=True)
    pip = [str(PYTHON), "-m", "pip", "install", "-qq", "--disable-pip-version-check", "--constraint", "constraints.txt"]
    pip.append("--no-compile")  # Python compiles what is imported, which is a small part of it
    return works(*pip, "hatchling") and works(*pip, "--no-build-isolation", "--editable", f".[{EXTRAS[purpose]}]")


def main(purpose: str) -> int:
    """Set up for a purpose of `EXTRAS`; on failure one sentence on stderr."""
    refused = refusal(sys.version_info[:2])
    if refused is None and not make_environment():
        refused = NO_VENV
    if refused is None and not install_packages(purpose):
        refused = NO_PACKAGES
    if refused is not None:
        print(refused, file=sys.stderr)
    return 0 if refused is None else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
