"""The names of the files in an archive; the archive itself: `tests/test_recording_commands.py`."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from omote.server.recording.archive import file_name


@given(st.text(max_size=40))
def test_a_list_of_any_name_is_a_file_of_one_folder(name: str) -> None:
    made = file_name(name)
    assert len(made) == len(name)
    assert not set(made) & set("/\\:.\0")
