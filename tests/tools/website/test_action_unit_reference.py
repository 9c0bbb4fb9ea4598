"""Action units as a page and as data, from one source."""

import csv
import io

from omote.builtin import load_cast
from omote.model.action_units import action_units
from tools.website.action_unit_reference import action_unit_page, action_unit_table


def test_page_and_data_say_the_same_of_every_unit() -> None:
    page = action_unit_page()
    titles = load_cast().titles
    lines = list(csv.DictReader(io.StringIO(action_unit_table())))
    assert [line["channel"] for line in lines] == [n for n, t in titles.items() if t.kind in ("arkit", "makehuman")]
    for line in lines:
        assert line["facs"] == "+".join(action_units(line["channel"]))
        row = f"| `{line['channel']}` | {line['label']} | {line['facs'] or '-'} | {line['names']} |"
        assert page.count(row) == 1
    assert "| AU12 | Lip corner puller | `mouth-corner-puller` |" in page
    assert "| AU45 | Blink | `eyeBlinkLeft`, `eyeBlinkRight` |" in page
    assert "| AU30 | Jaw sideways | AU30 is jawLeft or jawRight |" in page
