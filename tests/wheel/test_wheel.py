"""A wheel built here plays a show in an empty environment: no Node, no PyTorch, no repository.

A bare `pytest` leaves it out (`make wheel-test` runs it alone, `make test` with all others): it builds, installs and
starts a server.
"""

import asyncio
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import urllib.request
import venv
import zipfile
from collections.abc import Iterator
from importlib import metadata
from pathlib import Path
from typing import Any

import aiohttp
import msgspec
import numpy as np
import pytest
from packaging.requirements import Requirement

import hatch_build

pytestmark = pytest.mark.long

ROOT = Path(__file__).parent.parent.parent
SKIN_VERTICES = 4278  # of the CC0 head above the neck


def build(target: str, folder: Path) -> Path:
    """One distribution of this repository, made in `folder`."""
    command = [sys.executable, "-m", "hatchling", "build", "--target", target, "--directory", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    (built,) = folder.iterdir()
    return built


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of this repository."""
    return build("wheel", tmp_path_factory.mktemp("dist"))


@pytest.fixture(scope="module")
def scripts(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The programs of an environment that holds the wheel and what it says that it needs, and nothing else."""
    folder = tmp_path_factory.mktemp("empty")
    venv.create(folder, symlinks=os.name != "nt")
    scripts = folder / ("Scripts" if os.name == "nt" else "bin")
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--python", str(scripts / "python")]
    packages = Path(sysconfig.get_path("purelib", "venv", {"base": str(folder)}))
    copy_needed(wheel, packages)
    subprocess.run([*pip, "install", "-qq", "--no-index", str(wheel)], cwd=folder, check=True)
    copy_kernels(packages)
    return scripts


def copy_needed(wheel: Path, folder: Path) -> None:
    """Copies the packages that a wheel needs from the environment of these tests, compiled as they are there: to fetch
    and compile them anew takes minutes."""
    with zipfile.ZipFile(wheel) as archive:
        (info,) = {name.split("/")[0] for name in archive.namelist() if ".dist-info/" in name}
        asked = metadata.PathDistribution(zipfile.Path(archive, f"{info}/")).requires or []
    copied = set[str]()
    while asked:
        requirement = Requirement(asked.pop())
        if requirement.name in copied or (requirement.marker and not requirement.marker.evaluate({"extra": ""})):
            continue
        package = metadata.distribution(requirement.name)
        copied.add(requirement.name)
        asked += package.requires or []
        for file in package.files or []:
            if ".." not in file.parts:
                (folder / file).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(file.locate(), folder / file)


def copy_kernels(folder: Path) -> None:
    """Copies what Numba has compiled of the installed modules, which it takes for that of a source of the same time and
    size: each process of a show would compile for a quarter of a minute."""
    for index in (ROOT / "src").rglob("__pycache__/*.nbi"):
        source = index.parent.parent / f"{index.name.split('.')[0]}.py"
        installed = folder / source.relative_to(ROOT / "src")
        if source.exists() and installed.read_bytes() == source.read_bytes():
            os.utime(installed, ns=(source.stat().st_atime_ns, source.stat().st_mtime_ns))
            (installed.parent / "__pycache__").mkdir(exist_ok=True)
            for kernel in index.parent.glob(f"{index.stem}.*"):
                shutil.copy2(kernel, installed.parent / "__pycache__")


@pytest.fixture(scope="module")
def bare(scripts: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """An environment that knows only those programs and a home of its own."""
    home = str(tmp_path_factory.mktemp("home"))
    return {
        "PATH": str(scripts),
        "HOME": home,
        "XDG_STATE_HOME": home,
        "OPENBLAS_NUM_THREADS": "1",
        "PYTHONUNBUFFERED": "1",
    }


@pytest.fixture(scope="module")
def address(scripts: Path, bare: dict[str, str]) -> Iterator[str]:
    """Where a show of the installed wheel is served; the show ends with the tests."""
    command = [str(scripts / "omote"), "show", "--no-open", "--host", "127.0.0.1", "--port", "0"]
    with subprocess.Popen(
        command, cwd=bare["HOME"], env=bare, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as show:
        assert show.stdout is not None
        said = []
        try:
            for line in show.stdout:
                said.append(line)
                if found := re.search(r"http://127\.0\.0\.1:[1-9]\d*", line):
                    yield found[0]
                    break
            else:
                pytest.fail("the show ended without an address: " + "".join(said))
        finally:
            show.terminate()


def fetch(url: str) -> bytes:
    """What the show answers a browser."""
    asked = urllib.request.Request(url, headers={"Accept": "text/html,*/*"})
    with urllib.request.urlopen(asked, timeout=60) as answer:
        body: bytes = answer.read()
    return body


def welcomed(heard: list[dict[str, Any]]) -> bool:
    return any(message["type"] == "welcome" for message in heard)


async def first_states(address: str, count: int) -> list[dict[str, Any]]:
    """What a stage hears until it has its welcome and that many states; states may come before it has said hello."""
    heard: list[dict[str, Any]] = []
    async with aiohttp.ClientSession() as session, session.ws_connect(f"{address}/link") as link:
        version = msgspec.msgpack.decode(fetch(f"{address}/manifest"))["version"]
        await link.send_bytes(msgspec.msgpack.encode({"type": "hello", "role": "stage", "version": version}))
        while [message["type"] for message in heard].count("state") < count or not welcomed(heard):
            heard.append(msgspec.msgpack.decode(await link.receive_bytes(timeout=60)))
    return heard


def test_the_wheel_holds_pages_cast_and_notice(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        sizes = {entry.filename: entry.file_size for entry in archive.infolist()}
    needed = {name.removeprefix("src/") for name in hatch_build.NEEDED}
    assert needed <= sizes.keys()
    assert all(sizes[name] > 0 for name in needed)
    assert any(name.startswith("omote/server/web/static/") and name.endswith(".js") for name in sizes)
    assert any(name.endswith(".dist-info/licenses/LICENSE") for name in sizes)
    assert "omote/py.typed" in sizes


def test_type_checkers_read_the_types_of_the_installed_package(scripts: Path, tmp_path: Path) -> None:
    (tmp_path / "right.py").write_text("import omote\nomote.Performer(omote.load_cast()).call_face('old', seconds=2)\n")
    (tmp_path / "wrong.py").write_text("import omote\nomote.Performer(omote.load_cast()).call_face(3)\n")
    installed = ["--python-executable", str(scripts / "python")]
    check = [sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent", "--config-file=", *installed]
    told = subprocess.run([*check, "right.py", "wrong.py"], cwd=tmp_path, capture_output=True, text=True, check=False)
    found, summary = told.stdout.splitlines()
    assert found.startswith("wrong.py:2: error: ")
    assert 'Argument 1 to "call_face" of "CalledMix" has incompatible type "int"' in found
    assert summary.startswith("Found 1 error in 1 file")


def test_the_wheel_holds_nothing_else(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        tops = {name.split("/")[0] for name in archive.namelist()}
        assert not [name for name in archive.namelist() if "__pycache__" in name or "node_modules" in name]
    assert {top for top in tops if not top.endswith(".dist-info")} == {"omote"}


def test_the_source_archive_holds_pages_cast_and_notice_too(tmp_path: Path) -> None:
    with tarfile.open(build("sdist", tmp_path)) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames()}
    assert set(hatch_build.NEEDED) <= names
    assert not [name for name in names if "node_modules" in name or name.startswith(".venv")]


def test_neither_node_nor_torch_is_there(scripts: Path, bare: dict[str, str]) -> None:
    assert [shutil.which(program, path=bare["PATH"]) for program in ("node", "npm")] == [None, None]
    program = "from importlib.util import find_spec as f; print([f('torch'), f('anny')], f('omote').origin)"
    told = subprocess.run(
        [scripts / "python", "-c", program], env=bare, cwd=bare["HOME"], capture_output=True, text=True, check=True
    )
    assert told.stdout.startswith("[None, None]")
    assert str(scripts.parent) in told.stdout


def test_the_show_serves_its_pages(address: str) -> None:
    for page in ("", "/stage", "/console", "/editor"):
        text = fetch(f"{address}{page}").decode()
        assert "<!doctype html>" in text.lower()
        for script in re.findall(r'src="(/static/[^"]+)"', text):
            assert len(fetch(f"{address}{script}")) > 0


def test_the_show_serves_the_head(address: str) -> None:
    manifest = msgspec.msgpack.decode(fetch(f"{address}/manifest"))
    assert manifest["skin"] == SKIN_VERTICES
    assert len(manifest["faces"]) >= 8
    for face in manifest["faces"]:
        asset = msgspec.msgpack.decode(fetch(f"{address}{face['url']}"))
        positions = np.frombuffer(asset["positions"], np.float32).reshape(-1, 3)
        assert len(positions) == manifest["vertices"]
        assert np.isfinite(positions).all()
        assert 0.2 < np.ptp(positions[:, 1]) < 0.5


def test_the_show_plays(address: str) -> None:
    heard = asyncio.run(first_states(address, 3))
    states = [message for message in heard if message["type"] == "state"]
    assert len(states) >= 3
    for mix in ("faces", "expressions"):
        sums = [sum(state["characters"]["one"][mix].values()) for state in states]
        assert sums == pytest.approx([1.0] * len(states))
    numbers = [state["number"] for state in states]
    assert numbers == sorted(set(numbers))


def test_the_machine_is_said_to_be_able_to_play(scripts: Path, bare: dict[str, str]) -> None:
    check = "import omote.server.check as c; c.FRAME_SECONDS = 60.0; import omote.cli; omote.cli.main()"  # in its time
    command = [str(scripts / "python"), "-c", check, "check"]
    told = subprocess.run(command, env=bare, cwd=bare["HOME"], capture_output=True, text=True, check=False)
    assert (told.returncode, told.stderr) == (0, "")
