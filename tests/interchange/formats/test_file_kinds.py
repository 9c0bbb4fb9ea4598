"""What files can hold: one list, of which every door takes its part."""

import pytest

from omote.interchange.formats.file_kinds import FILE_CONTENTS, advise, may_be, suffixes_of
from omote.interchange.scans.scan_reader import READERS as SCAN_READERS
from omote.server.sandbox.import_files import READERS as IMPORT_READERS


def test_every_head_has_a_reader_at_both_doors() -> None:
    assert set(SCAN_READERS) == set(suffixes_of("head"))
    assert set(IMPORT_READERS) == set(suffixes_of("shape")) <= set(SCAN_READERS)


@pytest.mark.parametrize("suffix", FILE_CONTENTS)
def test_a_door_that_does_not_take_a_file_names_the_one_that_does(suffix: str) -> None:
    for wanted in ("head", "shape", "photograph"):
        if not may_be(f"anna{suffix}", wanted):
            assert "export it as" not in advise(f"anna{suffix}", wanted)
    assert advise(suffix, "head")


def test_a_suffix_in_capitals_is_the_same() -> None:
    assert may_be("ANNA.HEIC", "photograph", "head")
    assert not may_be("heic", "photograph")
