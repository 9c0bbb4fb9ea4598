"""CSV files of Live Link Face: read by their header, over midnight, without dropped frames; real takes."""

from pathlib import Path

import pytest

from omote.inputs.takes.live_link_take import TimeCode, find_rate, read_live_link_take, read_time_code
from omote.inputs.trackers.arkit_names import ARKIT_NAMES

TAKES = Path(__file__).resolve().parents[4] / "shared" / "data" / "livelinkface"
HEADER = "Timecode,BlendShapeCount,JawRight,JawLeft,JawOpen,HeadYaw,HeadPitch,HeadRoll,LeftEyeYaw,RightEyeYaw\n"


def row(time: str, *values: float) -> str:
    return f"{time},61,{','.join(map(str, values))}\n"


def test_columns_are_found_by_their_names() -> None:
    take = read_live_link_take(HEADER + row("13:00:00:00.0", 0.25, 0.5, 0.75, 0.1, 0.2, 0.3, 0.4, 0.2))
    assert take.names == ("jawRight", "jawLeft", "jawOpen")
    assert list(take.values) == [(0.25, 0.5, 0.75)]
    assert take.head(0) == pytest.approx((-0.1, -0.2, 0.3))
    assert take.gaze(0) == pytest.approx((-0.3, 0.0))


def test_times_are_seconds_from_the_first_frame_over_midnight_too() -> None:
    times = ("23:59:59:30.0", "23:59:59:45.5", "00:00:00:00.0", "00:00:01:00.0")
    take = read_live_link_take(HEADER + "".join(row(time, *[0.1] * 8) for time in times))
    assert list(take.times) == pytest.approx([0.0, 15.5 / 60, 0.5, 1.5])
    assert read_time_code("1:02:03:04").at(60) == pytest.approx(3723 + 4 / 60)


@pytest.mark.parametrize(("counted", "step"), [(60, 1), (60, 2), (30, 1), (25, 1), (24, 1), (50, 1)])
def test_the_rate_is_read_from_where_the_seconds_change(counted: int, step: int) -> None:
    codes = [TimeCode(n // counted, n % counted + 0.65) for n in range(0, 3 * counted, step)]
    assert find_rate(codes) == counted
    assert find_rate(codes[:5]) == 60


@pytest.mark.parametrize("rate", [30, 60])
def test_numbers_that_are_dropped_take_no_time(rate: int) -> None:
    """SMPTE 12M: numbers 0 and 1 (0 to 3 of 60) of each minute are left out, but for each tenth."""
    before = f"00:00:59;{rate - 1}"
    after = f"00:01:00;{rate // 15:02}"
    assert read_time_code(after).at(rate) - read_time_code(before).at(rate) == pytest.approx(1.001 / rate)
    hour = read_time_code("01:00:00;00").at(rate)
    assert hour == pytest.approx(3600.0, abs=0.01)


def test_dropped_frames_and_angles_that_were_not_recorded_are_left_out() -> None:
    text = HEADER + row("00:00:00:00", *[0.5] * 3, *[0.0] * 5) + "00:00:00:01,0,,,,,,,,\n" + "00:00:00:02,0\n"
    take = read_live_link_take("\ufeff" + text)
    assert (len(take.times), take.head(0), take.gaze(0)) == (1, None, None)


def test_it_is_said_that_eyes_which_converge_are_turned_by_their_mean() -> None:
    turned = [row("00:00:00:00", *[0.5] * 6, 0.1, 0.1), row("00:00:00:01", *[0.5] * 6, -0.02, 0.05)]
    assert list(read_live_link_take(HEADER + "".join(turned)).notes) == [
        "both eyes are turned by their mean; how far they converge (to 4 degrees) is lost"
    ]
    assert read_live_link_take(HEADER + turned[0]).notes == ()


def test_rows_without_a_face_are_counted_but_not_one_that_is_cut_off() -> None:
    faces = [row(f"00:00:00:{frame:02}", *[0.5] * 8) for frame in range(60)]
    none = ["00:00:01:30.000,0\n", "00:00:01:31.000,0,,,,,,,,\n"]
    take = read_live_link_take(HEADER + "".join([*faces, *none, row("00:00:02:00", *[0.5] * 8)]) + "00:00:03:00,6")
    assert len(take.times) == 61
    assert list(take.notes) == [
        "2 rows have no face (the first at 1.5 s); the motion goes on from the row before to the row after"
    ]


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "no column Timecode"),
        ("a,b\n1,2\n", "no column Timecode"),
        ("Timecode,HeadYaw\n00:00:00:00,1\n", "none of ARKit's"),
        (HEADER, "no frames"),
        (HEADER + row("now", *[0.0] * 8), "row 2 is left out: 'now' is no time code"),
        (HEADER + "00:00:00:00,61,0,5,0,25,1,0,0,0,0,0\n", "row 2 is left out: its commas"),
    ],
)
def test_what_cannot_be_read_is_said_with_its_row(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        read_live_link_take(text)


def test_what_is_no_number_costs_itself_and_a_wrong_time_its_row() -> None:
    text = (
        HEADER
        + row("00:00:00:00", 0.25, 0.5, 0.75, 0.1, *[0.0] * 4)
        + "00:00:00:01,61,0.5,wide,3,nan,0,0,0,0\n"
        + row("now", *[0.0] * 8)
        + "00:00:00:02,61,,0.5,-9,0.2,0,0,0,0\n"
    )
    take = read_live_link_take(text)
    assert list(take.values) == [(0.25, 0.5, 0.75), (0.5, 0.5, 1.5), (0.5, 0.5, -0.5)]
    assert [head[0] for head in take.heads] == [-0.1, -0.1, -0.2]
    assert list(take.notes) == [
        "row 3: jawLeft is no number (1 times)",
        "row 3: jawOpen is 3, so 1.5 is taken (2 times)",
        "row 3: an angle of the head is no number (1 times)",
        "row 4 is left out: 'now' is no time code such as 13:13:04:31.652 (1 times)",
        "row 5: jawRight is no number (1 times)",
    ]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("form", ["semicolons", "tabs", "commas", "quotes", "case"])
def test_a_table_as_a_spreadsheet_of_another_country_writes_it_is_read_alike(form: str, end: str) -> None:
    lines = [HEADER.strip(), row("00:00:00:00.25", 0.25, -0.5, 0.75, *[0.1] * 5).strip()]
    plain = read_live_link_take("\n".join(lines))
    written = {
        "semicolons": [line.replace(",", ";").replace(".", ",") for line in lines],
        "tabs": [line.replace(",", "\t").replace(".", ",") for line in lines],
        "commas": [line.replace(".", ",") for line in lines],
        "quotes": [",".join(f'"{cell.replace(".", ",")}"' for cell in line.split(",")) for line in lines],
        "case": [line.upper().replace(",", " , ") for line in lines],
    }
    take = read_live_link_take("\ufeff" + end + end.join(written[form]) + end)
    assert (take.names, list(take.values), take.notes) == (plain.names, list(plain.values), ())
    assert (take.head(0), take.gaze(0)) == (plain.head(0), plain.gaze(0))


@pytest.mark.data
@pytest.mark.parametrize(("name", "seconds"), [("alex_rom_3", 134.0), ("apfel", 64.0), ("S07-001", 67.0)])
def test_real_takes_are_read(name: str, seconds: float) -> None:
    if not TAKES.exists():
        pytest.skip("needs ../shared/data")
    take = read_live_link_take((TAKES / f"{name}.csv").read_text())
    assert set(take.names) == set(ARKIT_NAMES)
    assert take.seconds == pytest.approx(seconds, abs=2.0)
    assert take.head(0) is None  # these were recorded without the head
    assert take.gaze(0) is not None
