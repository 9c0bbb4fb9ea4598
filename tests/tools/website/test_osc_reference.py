"""The reference of OSC names every address, and what it says of one is what the parser takes."""

from omote.inputs.osc_addresses import ADDRESSES
from tools.website.osc_reference import osc_page

ROWS = {row.split("|")[1].strip(): row for row in osc_page().splitlines() if row.startswith("| `/")}


def test_each_address_has_a_row_with_what_it_does() -> None:
    for address in ADDRESSES:
        row = ROWS[f"`{address.pattern}`"]
        assert address.tells in row
        shown = address.values[address.path.count("{") :]
        assert all(value.name in row for value in shown), address.pattern
