"""Which Node is good enough, and where it is looked for."""

from pathlib import Path

import pytest

import tools.node
from tools.node import OLDEST, has_node, major_version


def node(folder: Path, version: str, *, npm: bool = True) -> str:
    """A folder with a program that says it is this version of Node."""
    for name, text in {"node": f"#!/bin/sh\necho {version}\n", **({"npm": "#!/bin/sh\n"} if npm else {})}.items():
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
    return str(folder)


@pytest.mark.parametrize(("text", "major"), [("v20.20.2\n", 20), ("v8.1.0", 8), ("", 0), ("command not found", 0)])
def test_the_major_version_is_read(text: str, major: int) -> None:
    assert major_version(text) == major


@pytest.mark.parametrize(("version", "enough"), [(OLDEST - 1, False), (OLDEST, True), (OLDEST + 4, True)])
def test_an_old_node_is_not_taken(tmp_path: Path, version: int, enough: bool) -> None:
    assert has_node(node(tmp_path, f"v{version}.0.0")) is enough


def test_a_node_without_npm_is_not_taken(tmp_path: Path) -> None:
    assert not has_node(node(tmp_path, "v22.0.0", npm=False))


def test_an_empty_path_has_none(tmp_path: Path) -> None:
    assert not has_node(str(tmp_path))


def test_where_node_cannot_be_had_one_sentence_is_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(tools.node, "find_node", lambda: None)
    assert tools.node.main("web", "npm", "ci") == 1
    assert capsys.readouterr().err == tools.node.SENTENCE + "\n"


def test_the_exit_status_of_the_program_is_passed_on(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "fails").write_text("#!/bin/sh\nexit 3\n")
    (tmp_path / "fails").chmod(0o755)
    monkeypatch.setattr(tools.node, "find_node", lambda: str(tmp_path))
    assert tools.node.main("web", "fails") == 3
