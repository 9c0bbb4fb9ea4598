"""The table of OSC's addresses: every one is found as it is written, and what is near is named where none is."""

import re

import pytest

from omote.inputs.osc_addresses import ADDRESSES, REMEMBERED_LENGTH, find_address
from omote.inputs.osc_packet import OscError


def test_every_address_is_found_as_it_is_written() -> None:
    words = {"name": "smile", "region": "eyes", "layer": "smile", "part": "all", "language": "de"}
    for address in ADDRESSES:
        found, character, named = find_address(address.pattern.format(character="one", **words))
        assert found is address
        assert character == ("" if address.of_show else "one")
        assert named == [words[name] for name in re.findall(r"{(\w+)}", address.path)]


def test_an_address_with_a_wrong_letter_is_told_the_right_one() -> None:
    for address in ADDRESSES:
        written = address.pattern.replace("{character}", "one")
        word = address.path.partition("/")[0]
        with pytest.raises(OscError, match="near are") as raised:
            find_address(written.replace(f"/{word}", f"/{word[:-1]}/{word[-1]}", 1))
        assert written in str(raised.value)


def test_a_long_address_is_rejected_with_its_beginning() -> None:
    with pytest.raises(OscError) as raised:
        find_address("/omote/" + "x" * 10 * REMEMBERED_LENGTH)
    assert len(str(raised.value)) < 400
