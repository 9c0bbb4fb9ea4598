"""Which Python is good enough to set up with."""

import tomllib

import pytest

from tools import environment
from tools.environment import refusal


@pytest.mark.parametrize("version", [(3, 11), (3, 13), (4, 0)])
def test_a_new_python_is_taken(version: tuple[int, int]) -> None:
    assert refusal(version) is None


@pytest.mark.parametrize("version", [(2, 7), (3, 10)])
def test_an_old_python_is_refused_with_what_to_do(version: tuple[int, int]) -> None:
    sentence = refusal(version)
    assert sentence is not None
    assert f"{version[0]}.{version[1]}" in sentence
    assert "make PYTHON=" in sentence


@pytest.mark.parametrize(
    ("made", "installed", "said"), [(False, True, environment.NO_VENV), (True, False, environment.NO_PACKAGES)]
)
def test_what_fails_is_said_in_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], made: bool, installed: bool, said: str
) -> None:
    monkeypatch.setattr(environment, "make_environment", lambda: made)
    monkeypatch.setattr(environment, "install_packages", lambda _: installed)
    assert environment.main("show") == 1
    assert capsys.readouterr().err == said + "\n"


def test_what_is_installed_for_a_purpose_is_an_extra_of_the_package() -> None:
    extras = tomllib.loads((environment.ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    assert {extra for names in environment.EXTRAS.values() for extra in names.split(",")} <= extras.keys()
