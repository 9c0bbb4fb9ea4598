"""Files of a scan: names that are no paths, limits, and which of them is the scan."""

import pytest

from omote.server.scans import scan_upload
from omote.server.scans.scan_upload import MOST_FILES, choose_scan, clean_name
from tests.server.scans.conftest import ScanHarness


@pytest.mark.parametrize(
    "sent", ["../../etc/anna.ply", "/tmp/anna.ply", "C:\\scans\\anna.ply", "--anna.ply", "\n.anna.ply"]
)
def test_a_name_from_a_page_is_no_path(sent: str) -> None:
    assert clean_name(sent) == "anna.ply"


def test_the_scan_is_chosen_among_what_lies_beside_it() -> None:
    assert choose_scan(["a.mtl", "A.OBJ", "skin.JPG"]) == "A.OBJ"


@pytest.mark.parametrize(
    ("names", "why"),
    [
        (["a.blend"], "Blender"),
        (["a.exe"], "export it as one of"),
        (["a"], "export it as one of"),
        (["a.obj", "b.zip"], "unpack"),
        (["a.jpg"], "without a scan"),
        (["a.obj", "b.ply"], "one at a time"),
        ([], "nothing came without a scan"),
    ],
)
def test_what_is_no_scan_is_refused_with_what_to_do(names: list[str], why: str) -> None:
    with pytest.raises(ValueError, match=why):
        choose_scan(names)


@pytest.mark.asyncio
async def test_too_much_is_refused_and_leaves_nothing(
    scan_harness: ScanHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scan_upload, "LARGEST", 10)
    status, body = await scan_harness.bring({"anna.obj": b"123456", "anna.mtl": b"12345"})
    assert (status, b"too large" in body) == (400, True)
    assert (await scan_harness.bring({"anna.obj": b"123456", "anna.mtl": b"1234"}))[0] == 200
    many = {f"{number}.png": b"" for number in range(MOST_FILES + 1)}
    status, body = await scan_harness.bring(many)
    assert (status, b"files came" in body) == (400, True)
    assert len(scan_harness.folders()) == 1
