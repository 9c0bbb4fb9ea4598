"""`omote check` says what this machine can do, and what it lacks."""

import pytest

from omote.server import check as module
from omote.server.check import check_frame, check_pages, run_check, run_checks


def test_here_everything_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "FRAME_SECONDS", 60.0)  # however busy this machine is
    verdicts = list(run_checks())
    assert [passed for passed, _ in verdicts] == [True, True, True]
    sentences = "\n".join(sentence for _, sentence in verdicts)
    for word in ("omote", "Python", "numba", "pages", "faces", "expressions", "a frame takes"):
        assert word in sentences


@pytest.mark.parametrize(
    "error", [FileNotFoundError("run `make web`"), ValueError("bake again"), ImportError("no numba")]
)
def test_what_is_missing_is_a_bad_verdict_with_its_sentence(error: Exception) -> None:
    def failing() -> tuple[bool, str]:
        raise error

    assert run_check(failing) == (False, str(error))


def test_missing_pages_are_found(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> None:
        raise FileNotFoundError("the pages are not built: run `make web`.")

    monkeypatch.setattr("omote.server.http.static_pages.read_pages", missing)
    assert run_check(check_pages) == (False, "the pages are not built: run `make web`.")


def test_a_machine_that_is_too_slow_cannot_play(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "FRAME_SECONDS", 0.0)
    passed, sentence = check_frame()
    assert not passed
    assert "a frame takes" in sentence
