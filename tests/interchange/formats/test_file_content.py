"""Files that are none of what was expected are called what they are, and broken JSON is told with its place."""

import sqlite3
from pathlib import Path

import msgspec
import numpy as np
import pytest

from omote.interchange.formats import expression_json, glb_reader
from omote.interchange.formats.file_content import describe_content, explain_syntax
from omote.interchange.formats.png import png_bytes
from omote.interchange.scans.wavefront_reader import read_obj_pieces


def database(folder: Path) -> bytes:
    """The bytes of an SQLite file."""
    connection = sqlite3.connect(folder / "show.omote")
    connection.execute("CREATE TABLE t (a)")
    connection.commit()
    connection.close()
    return (folder / "show.omote").read_bytes()


def test_files_are_called_what_they_are(tmp_path: Path) -> None:
    files = {
        b"": "an empty file",
        b" \n": "an empty file",
        png_bytes(np.zeros((2, 2, 3), np.uint8)): "a picture (PNG)",
        database(tmp_path): "a show file or another database",
        b"glTF\x02\0\0\0": "a glTF binary (.glb)",
        b"v 1 2 3\n": "a shape (OBJ)",
        b"# Blender\nv 1 2 3\n": "a shape (OBJ)",
        b'{"omote": 1}': "JSON",
        b"Dear all,\n": "text",
        "\u6d99".encode() * 3000: "text",
        b"\0\1\2\3": "binary data of another kind",
        b"\xfa\xfb\xfc\xfd" * 9: "binary data of another kind",
    }
    assert {data: describe_content(data) for data in files} == files


@pytest.mark.parametrize("read", [expression_json.decode, glb_reader.read_glb, read_obj_pieces])
def test_each_reader_says_what_it_was_given_instead(read: object) -> None:
    assert callable(read)
    for data in (b"", png_bytes(np.zeros((2, 2, 3), np.uint8)), b"Dear all,\n", b"\0" * 30):
        with pytest.raises(ValueError, match=r"export|expected an expression") as refused:
            read(data)
        assert describe_content(data) in str(refused.value)


def test_a_document_that_is_cut_off_anywhere_is_said_to_be() -> None:
    whole = msgspec.json.format(
        msgspec.json.encode({"omote": "expression", "list": [1, 2.5, "a"], "nope": {}}), indent=2
    )
    assert explain_syntax(whole) is None
    for length in range(1, len(whole)):
        why = explain_syntax(whole[:length]) or ""
        assert why.startswith((f"it is cut off after {length} bytes", "it is no JSON from line")), (length, why)
        with pytest.raises(ValueError, match=r"cut off|no JSON from"):
            expression_json.decode(whole[:length])


def test_the_place_of_a_slip_in_json_is_told() -> None:
    assert explain_syntax(b'{"a": 1,\n "b": oops}') == (
        "it is no JSON from line 2, column 7 on: export it anew, or mend it there"
    )


def test_json_of_something_else_is_told_by_what_it_lacks() -> None:
    with pytest.raises(ValueError, match="JSON of another program"):
        expression_json.decode(b'{"asset": {"version": "2.0"}}')
