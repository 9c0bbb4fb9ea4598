"""The reference of trackers names every protocol and every coefficient."""

from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from tools.website.tracker_reference import tracker_page


def test_every_protocol_and_coefficient_is_there() -> None:
    page = tracker_page()
    assert all(
        f"| `{each.name}` | {each.title} | {each.port or 'of the pages'} |" in page
        for each in TRACKER_PROTOCOLS.values()
    )
    assert all(f"`{name}`" in page for name in ARKIT_NAMES)
    assert page.endswith(".\n")
