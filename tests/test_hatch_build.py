"""The build hook: a wheel without pages or cast is refused with a sentence, an editable install is not."""

from pathlib import Path

import pytest

import hatch_build


def hook(root: Path) -> hatch_build.CompleteWheel:
    """The hook as hatchling makes it for a project in `root`."""
    return hatch_build.CompleteWheel(str(root), {}, None, None, "", "wheel")  # type: ignore[arg-type]


def complete(root: Path) -> Path:
    """A project with everything that a wheel needs."""
    for name in hatch_build.NEEDED:
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_bytes(b"x")
    return root


def test_a_whole_wheel_is_built(tmp_path: Path) -> None:
    hook(complete(tmp_path)).initialize("standard", {})


@pytest.mark.parametrize("name", hatch_build.NEEDED)
def test_a_wheel_that_lacks_a_file_is_refused_by_its_name(tmp_path: Path, name: str) -> None:
    (complete(tmp_path) / name).unlink()
    with pytest.raises(RuntimeError, match=rf"without {name} cannot play a show; build them first: make wheel"):
        hook(tmp_path).initialize("standard", {})


def test_an_editable_install_may_come_first(tmp_path: Path) -> None:
    hook(tmp_path).initialize("editable", {})
