"""`omote play-take`: what it says of files and shows that are not there; played into a show in tests/client."""

import socket
from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.client.connect import connect
from omote.inputs.takes.packet_capture import Packet, encode_capture
from omote.take_commands import _tell, read_take
from tests.inputs.takes.test_live_link_take import HEADER, row
from tests.inputs.trackers.packets import live_link_face


@pytest.mark.parametrize(
    ("name", "data", "said"),
    [
        ("take.csv", b"", "take.csv: it is empty"),
        ("take.pcap", b"", "take.pcap: it is empty"),
        ("notes.txt", b"what to buy", "it is no recording by its name: play a table of Live Link Face (.csv), or"),
        ("pic.jpg", b"\xff\xd8\xff", ".pcap, .pcapng"),
        ("take.pcap", b"\xd4\xc3", "no capture"),
    ],
)
def test_what_is_no_recording_is_said(tmp_path: Path, name: str, data: bytes, said: str) -> None:
    path = tmp_path / name
    path.write_bytes(data)
    done = CliRunner().invoke(app, ["play-take", str(path)])
    assert done.exit_code == 1
    assert said in done.stderr


def test_a_recording_that_is_cut_off_is_read_and_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    packets = [Packet(number / 60.0, "10.0.0.7", 11111, live_link_face([0.5] * 61)) for number in range(3)]
    whole = b"".join(encode_capture(packets))
    table = HEADER + row("00:00:00:00", *[0.5] * 8) + row("00:00:00:01", *[0.5] * 8)
    for name, data, count in (("a.pcap", whole, 3), ("a.csv", table.encode(), 2)):
        path = tmp_path / name
        path.write_bytes(data)
        assert len(read_take(path).times) == count
        assert capsys.readouterr().err == ""
        path.write_bytes(data[:-6])
        assert len(read_take(path).times) == count - 1
        assert f"{name} is cut off" in capsys.readouterr().err


@pytest.mark.parametrize("speed", ["0", "-1", "21", "fast", "nan"])
def test_a_speed_that_is_none_is_said(tmp_path: Path, speed: str) -> None:
    done = CliRunner().invoke(app, ["play-take", str(tmp_path / "take.csv"), "--speed", speed])
    assert done.exit_code == 2
    assert "is no speed; give a number from 0.05 to 20" in " ".join(done.stderr.replace("│", " ").split())


@pytest.mark.parametrize(
    ("data", "said"), [(b"\xff\xfe", "no text"), (b"a,b\n", "no column Timecode"), (None, "not there")]
)
def test_a_file_that_is_no_take_is_said(tmp_path: Path, data: bytes | None, said: str) -> None:
    path = tmp_path / "take.csv"
    if data is not None:
        path.write_bytes(data)
    done = CliRunner().invoke(app, ["play-take", str(path)])
    assert done.exit_code == 1
    assert said in done.stderr
    assert "take.csv" in done.stderr


def test_a_show_that_is_not_there_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        "omote.client.connect.connect.__kwdefaults__",
        {**(connect.__kwdefaults__ or {}), "timeout": 0.2},
    )
    path = tmp_path / "take.csv"
    path.write_text(HEADER + row("00:00:00:00", *[0.5] * 8))
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        done = CliRunner().invoke(app, ["play-take", str(path), "--show", f"http://127.0.0.1:{taken.getsockname()[1]}"])
    assert done.exit_code == 1
    waits, why = done.stderr.splitlines()
    assert "take.csv waits for the show at http://127.0.0.1:" in waits
    assert "no show" in why


def test_a_take_is_recorded_by_name_and_read_by_its_suffix(tmp_path: Path) -> None:
    path = tmp_path / "take.pcap"
    packets = [Packet(0.1 * count, "10.0.0.7", 11111, live_link_face([0.25] * 61)) for count in range(3)]
    path.write_bytes(b"".join(encode_capture(packets)))
    assert len(read_take(path).times) == 3
    for word, said in (("mediapipe", "cannot be recorded"), ("vcm", "vmc")):
        done = CliRunner().invoke(app, ["record-take", str(path), "--listen", word])
        assert done.exit_code == 1
        assert said in done.stderr


def test_a_capture_that_cannot_be_read_is_said(tmp_path: Path) -> None:
    path = tmp_path / "take.pcap"
    path.write_bytes(b"hello")
    done = CliRunner().invoke(app, ["play-take", str(path)])
    assert done.exit_code == 1
    assert "take.pcap" in done.stderr
    assert "no capture" in done.stderr


def test_a_port_that_is_taken_is_said_before_anything_is_recorded(tmp_path: Path) -> None:
    path = tmp_path / "take.pcap"
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("", 0))
        word = f"livelink:{taken.getsockname()[1]}"
        done = CliRunner().invoke(app, ["record-take", str(path), "--listen", word])
    assert done.exit_code == 1
    assert done.stderr.count("\n") == 1
    assert "another program has it" in done.stderr
    assert not path.exists()


def test_a_recording_of_nothing_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stop(*_: object, opened: Callable[[int], None], **__: object) -> int:
        opened(11111)
        return 0

    monkeypatch.setattr("omote.server.devices.trackers.take_recorder.record_take", stop)
    done = CliRunner().invoke(app, ["record-take", str(tmp_path / "take.pcap"), "--listen", "livelink"])
    assert done.exit_code == 1
    assert "Live Link Face is recorded at port 11111 into take.pcap; Ctrl-C ends it." in done.stderr
    assert "no packet came, so take.pcap was not written" in done.stderr


def test_a_recording_says_how_it_does(capsys: pytest.CaptureFixture[str]) -> None:
    for count, silent in ((0, 1.0), (90, 0.2), (90, 5.0), (90, 6.0), (0, 10.0)):
        _tell(count, "10.0.0.7", silent)
    assert capsys.readouterr().out.splitlines() == [
        "  no packet yet",
        "  90 packets, the newest from 10.0.0.7",
        "  nothing for 5 s after 90 packets",
        "  nothing for 10 s",
    ]
