"""What a show is opened with comes to its servers as it was typed, also when the files are gone meanwhile."""

import argparse
from pathlib import Path

import pytest

from omote.server.access.access_setup import (
    OPEN_TO_ALL,
    AccessOptions,
    add_access_options,
    load_access,
    read_access_options,
)
from omote.server.access.people_file import open_people


def read(words: list[str]) -> AccessOptions:
    parser = argparse.ArgumentParser()
    add_access_options(parser)
    return read_access_options(parser.parse_args(words))


@pytest.mark.parametrize(
    "options",
    [AccessOptions(), AccessOptions("a b", "c", "d", "e"), AccessOptions("", "c", "d", embed="https://a.b http://c")],
)
def test_options_come_back_as_they_were(options: AccessOptions) -> None:
    assert read(options.words) == options


def test_a_server_has_the_list_of_its_standby_where_the_file_is_gone(tmp_path: Path) -> None:
    path = tmp_path / "a.people"
    said = list[str]()
    people = open_people(path)
    setup = load_access(AccessOptions(str(path)))
    path.unlink()
    control = setup.open_control(said.append)
    assert control is not None
    assert control.people == people
    assert len(said) == 1


def test_a_list_that_cannot_be_read_opens_no_show(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="cannot be read"):
        load_access(AccessOptions(str(tmp_path / "gone.people")))


def test_on_this_machine_alone_there_is_no_list() -> None:
    assert load_access(AccessOptions()) == OPEN_TO_ALL
    assert OPEN_TO_ALL.open_control(print) is None
