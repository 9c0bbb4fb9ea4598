"""The short form of `make trust`: some states of a crash, some failing calls, and planted bugs."""

import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.trust.disk_faults import DiskTrial, disk_trial
from tests.trust.trust_report import catch

SEED = 1
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(shutil.which("cc") is None, reason="the library before a program's calls has to be compiled"),
]


@pytest.fixture(scope="module")
def trial() -> Iterator[DiskTrial]:
    with tempfile.TemporaryDirectory() as folder, disk_trial(Path(folder), SEED) as made:
        yield made


@pytest.mark.parametrize("path", ["edit", "play", "recover"])
def test_no_acknowledged_save_is_lost_with_the_power(trial: DiskTrial, path: str) -> None:
    assert trial.lose_power(path, most=30).examples == {}


@pytest.mark.parametrize("path", ["edit", "export"])
def test_no_acknowledged_save_is_lost_where_calls_fail(trial: DiskTrial, path: str) -> None:
    assert trial.fail_calls(path, every=20).examples == {}


@pytest.mark.parametrize("bug", ["saves are not synced", "a save that fails is acknowledged"])
def test_a_planted_bug_is_caught(trial: DiskTrial, bug: str) -> None:
    assert catch(trial, bug, most=30, every=10)
