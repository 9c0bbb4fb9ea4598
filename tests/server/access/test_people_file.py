"""The list beside a show file."""

from pathlib import Path

import pytest

from omote.server.access.people_file import change_people, new_person, open_people, people_path, read_people
from omote.show.access.access_role import ACCESS_ROLES
from omote.show.access.people_list import add_person
from omote.show.validation import Refusal


def test_a_new_list_has_a_token_for_each_role_and_its_owner_alone_reads_it(tmp_path: Path) -> None:
    path = people_path(tmp_path / "tour.omote")
    made = open_people(path)
    assert path.name == "tour.omote.people"
    assert [(each.role, each.name) for each in made.people] == [(role, role) for role in ACCESS_ROLES]
    assert path.stat().st_mode & 0o777 == 0o600
    assert open_people(path) == made
    assert open_people(tmp_path / "other.people").key != made.key
    assert sorted(each.name for each in tmp_path.iterdir()) == ["other.people", "tour.omote.people"]


def test_a_change_is_kept_whole_and_a_rejected_one_changes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.people"
    open_people(path)
    changed = change_people(path, lambda people: add_person(people, new_person("Ada", "view", 1.0, 2.0)))
    assert read_people(path) == changed
    assert changed.people[-1].until == 7201.0
    assert path.stat().st_mode & 0o777 == 0o600
    with pytest.raises(Refusal):
        change_people(path, lambda people: add_person(people, new_person("ada", "view", 1.0)))
    assert read_people(path) == changed


@pytest.mark.parametrize("content", [b"", b"[]", b'{"key": "12"}', b"\xff\xfe", b'{"key": "' + b"g" * 64 + b'"}'])
def test_what_is_no_list_is_said(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "a.people").write_bytes(content)
    with pytest.raises(ValueError, match=r"a\.people is no list of people .* delete it"):
        open_people(tmp_path / "a.people")
    assert (tmp_path / "a.people").read_bytes() == content


def test_a_folder_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="cannot be opened"):
        open_people(tmp_path / "gone" / "a.people")
    with pytest.raises(OSError, match="cannot be read"):
        read_people(tmp_path / "a.people")
