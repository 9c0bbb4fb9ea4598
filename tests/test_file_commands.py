"""`omote file`: what is in a show file, for people and for programs."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from omote.builtin import load_cast
from omote.cli import app
from omote.edit.store.import_items import make_document
from omote.file_commands import format_time
from omote.interchange.formats.cue_toml import read_cues
from omote.interchange.formats.expression_json import encode
from omote.model.cast import Cast
from omote.showfile.backup import back_up
from omote.showfile.changes import Content, StoredDocument, content_key
from omote.showfile.contents import pack_expression
from omote.showfile.show_file import ShowFile, open_show
from tests.showfile.authored_work import item, revision

RECIPE = b'{"kind":"expression","net":[],"vectors":[]}'


@pytest.fixture
def show(tmp_path: Path, cast: Cast) -> Iterator[ShowFile]:
    """A show that is played while it is looked into: two expressions, one saved twice."""
    opened = open_show(tmp_path / "a.omote")
    data = pack_expression(cast.expressions["smile"])
    key = content_key(data)
    opened.apply(
        [
            Content(key, data),
            item(1, name="smirk", label="Smirk [left]", tags=("wry",), head=2),
            item(2, name="sneer", deleted=True),
            revision(1, 1, content=key, recipe=RECIPE, note="first"),
            revision(1, 2, content=key, recipe=RECIPE, editor="Bo"),
            revision(1, 3, content=key, recipe=RECIPE, parent=1, aside=True),
        ]
    )
    yield opened
    opened.close()


def said(*arguments: object, status: int = 0) -> str:
    """What a command prints."""
    result = CliRunner().invoke(app, ["file", *map(str, arguments)], env={"COLUMNS": "160"})
    assert result.exit_code == status, result.output
    return result.output


def test_list_shows_own_work(show: ShowFile) -> None:
    text = said("list", show.path)
    assert "Smirk [left]" in text
    assert "sneer" in text
    smirk, sneer = json.loads(said("list", show.path, "--json"))
    assert smirk == {
        "kind": "expression",
        "name": "smirk",
        "label": "Smirk [left]",
        "revision": 2,
        "revisions": 3,
        "drafts": 0,
        "tags": "wry",
        "deleted": False,
    }
    assert sneer["deleted"] is True


def test_list_of_a_new_file_says_so(tmp_path: Path) -> None:
    open_show(tmp_path / "a.omote").close()
    assert "has no own faces or expressions yet" in said("list", tmp_path / "a.omote")


def test_history_tells_what_plays_and_what_is_aside(show: ShowFile) -> None:
    rows = json.loads(said("history", show.path, "smirk", "--json"))
    assert [(row["revision"], row["of"], row["by"], row["note"], row["state"]) for row in rows] == [
        (1, 0, "Ada", "first", ""),
        (2, 1, "Bo", "", "plays"),
        (3, 1, "Ada", "", "aside"),
    ]
    assert "plays" in said("history", show.path, "smirk", "--kind", "expression")
    assert "has never been saved" in said("history", show.path, "sneer")


def test_check_says_what_is_good_and_what_is_not(show: ShowFile) -> None:
    text = said("check", show.path)
    assert "BAD" not in text
    assert "a.omote is whole: schema" in text
    show.apply([revision(1, 4, content=show.stored().revisions[0].content, recipe=b"?")])
    text = said("check", show.path, status=1)
    assert "BAD   the recipe of revision 4 of smirk cannot be read" in text
    assert "a.omote is not all right. There is no good copy of it" in text
    back_up(show)
    text = said("check", show.path, status=1)
    assert "a.omote is not all right. It has good copies: omote show " in text


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("list", "none.omote"), "there is no show file none.omote; omote show none.omote makes one"),
        (("history", "none.omote", "smirk"), "there is no show file none.omote"),
        (("check", "none.omote"), "there is no show file none.omote; omote show none.omote makes one"),
    ],
)
def test_a_file_that_is_not_there_is_one_sentence(arguments: tuple[str, ...], sentence: str) -> None:
    text = said(*arguments, status=1)
    assert sentence in text
    assert text.count("\n") == 1


@pytest.mark.parametrize("command", [("list",), ("check",), ("history", "smirk")])
def test_an_empty_file_is_called_empty(command: tuple[str, ...], tmp_path: Path) -> None:
    for name, advice in (("a.omote", f"omote show {tmp_path / 'a.omote'} begins one in it"), ("a.txt", "")):
        (tmp_path / name).touch()
        text = said(command[0], tmp_path / name, *command[1:], status=1)
        assert f"{tmp_path / name} is an empty file: there is no show in it" in text
        assert advice in text
        assert text.count("\n") == 1


def test_a_lost_file_is_said_to_have_copies(show: ShowFile) -> None:
    back_up(show)
    show.close()
    show.path.unlink()
    text = said("check", show.path, status=1)
    assert (
        f"{show.path} is not there, but its good copies or its log are: omote show {show.path} brings it back" in text
    )
    assert "good  its good copy a.omote.good is whole" in text
    show.path.touch()
    assert f"{show.path} is empty, but its good copies" in said("list", show.path, status=1)


def test_a_damaged_file_without_a_copy_is_not_called_good(show: ShowFile) -> None:
    show.close()
    show.path.write_bytes(show.path.read_bytes()[:5000])
    text = said("check", show.path, status=1)
    assert "BAD   there is no good copy beside it" in text
    assert "good " not in text.replace("good copy", "copy")


def test_a_damaged_file_is_told_with_the_way_out(show: ShowFile, tmp_path: Path) -> None:
    (tmp_path / "x.json").touch()
    back_up(show)
    show.close()
    show.path.write_bytes(show.path.read_bytes()[:5000])
    for command in (("list",), ("history", "smirk"), ("import", tmp_path / "x.json")):
        text = said(command[0], show.path.with_suffix(""), *command[1:], status=1)
        assert f"It has good copies: omote show {show.path} opens the newest" in text
    for copy in tmp_path.glob("*.good*"):
        copy.unlink()
    assert f"There is no good copy of it: omote show {show.path} keeps it aside" in said("list", show.path, status=1)


def test_a_file_that_never_was_a_show_is_not_called_damaged(tmp_path: Path) -> None:
    notes = tmp_path / "notes.txt"
    notes.write_text("buy milk")
    text = said("check", notes, status=1).replace("\n", " ")
    assert "notes.txt is a text file and never was a show; it stays as it is" in text
    assert "damaged" not in text
    assert "good copy" not in text
    assert notes.read_text() == "buy milk"


def test_a_name_that_is_not_there_is_one_sentence(show: ShowFile) -> None:
    assert "no own face or expression 'grin'; there are: smirk, sneer" in said("history", show.path, "grin", status=1)


@pytest.mark.parametrize("seconds", [1e300, float("nan"), -1e300])
def test_a_time_that_no_clock_shows_is_a_question(seconds: float) -> None:
    assert format_time(seconds) == "?"


def test_an_expression_goes_out_of_one_show_file_and_into_another(show: ShowFile, tmp_path: Path) -> None:
    letter = tmp_path / "smirk.json"
    other = tmp_path / "other.omote"
    gone = CliRunner().invoke(app, ["file", "export", str(show.path), "smile", "-o", str(letter)])
    assert gone.exit_code == 0, gone.output
    come = CliRunner().invoke(app, ["file", "import", str(other), str(letter)])
    assert come.exit_code == 0, come.output
    assert f"{other} has 1 expression more." in come.output.replace("\n", "")
    listed = json.loads(CliRunner().invoke(app, ["file", "list", str(other), "--json"]).stdout)
    assert [(row["name"], row["label"], row["revision"]) for row in listed] == [("smile_2", "Smile 2", 1)]
    again = said("import", other, letter, letter)
    assert again.count("'Smile' is there already, exactly the same, as smile_2 (Smile 2)") == 2
    assert f"{other} has nothing more." in again
    both = said("import", other, letter, "--keep-both")
    assert "there is a 'Smile' already, so this one is called 'Smile 3'" in both
    names = [row["name"] for row in json.loads(said("list", other, "--json"))]
    assert names == ["smile_2", "smile_3"]


def test_what_cannot_come_in_leaves_no_file(tmp_path: Path) -> None:
    other = tmp_path / "other.omote"
    refused = CliRunner().invoke(app, ["file", "import", str(other), str(tmp_path / "none.json")])
    assert refused.exit_code == 1
    assert "there is no file" in refused.output
    assert not other.exists()


def test_a_label_in_an_untrusted_file_controls_no_terminal(show: ShowFile) -> None:
    show.apply([item(1, name="smirk", label="\x1b[31mred\x07\u202eder\n", head=2)])
    for text in (said("list", show.path), said("check", show.path), said("history", show.path, "smirk")):
        assert not {"\x1b", "\x07", "\u202e"} & set(text)
    assert r"\x1b[31mred\x07\u202eder\n" in said("list", show.path)


def test_what_comes_in_is_told_of_without_what_commands_a_terminal(tmp_path: Path) -> None:
    cast = load_cast()
    mail = make_document(cast.space, "\x1b]0;owned\x07", (), cast.expressions["smile"])
    (tmp_path / "mail.json").write_bytes(encode(mail))
    text = said("import", tmp_path / "other.omote", tmp_path / "mail.json", status=1)
    assert "\x1b" not in text
    assert "printable" in text


@pytest.mark.parametrize("command", [("list",), ("check",), ("history", "smirk")])
def test_a_path_that_no_disk_takes_is_refused(command: tuple[str, ...], tmp_path: Path) -> None:
    assert "too long" in said(command[0], tmp_path / ("x" * 300), *command[1:], status=1)


def test_a_file_whose_numbers_are_used_up_takes_nothing_more_and_says_so(tmp_path: Path) -> None:
    other = open_show(tmp_path / "b.omote")
    other.apply([item(2**63 - 1, name="last")])
    other.close()
    cast = load_cast()
    (tmp_path / "mail.json").write_bytes(encode(make_document(cast.space, "Wry", (), cast.expressions["smile"])))
    assert "too large" in said("import", other.path, tmp_path / "mail.json", status=1)


def test_documents_of_any_kind_are_listed_and_written(show: ShowFile, tmp_path: Path) -> None:
    body = b'{"face":"ann"}'
    show.apply([StoredDocument("pose", "bow", body)])
    listed = json.loads(said("list", show.path, "--documents", "pose", "--json"))
    assert listed == [{"kind": "pose", "name": "bow", "bytes": len(body)}]
    said("export", show.path, "bow", "--documents", "pose", "-o", tmp_path / "bow.json")
    assert (tmp_path / "bow.json").read_bytes() == body
    assert "there are: bow" in said(
        "export", show.path, "row", "--documents", "pose", "-o", tmp_path / "x.json", status=1
    )


def test_an_item_goes_out_whole_and_a_show_comes_in_whole(show: ShowFile, tmp_path: Path) -> None:
    alone = tmp_path / "smirk.omote"
    other = tmp_path / "other.omote"
    assert "holds the expression smirk whole, revisions: 3." in said("export", show.path, "smirk", "-o", alone)
    again = said("export", show.path, "smirk", "-o", alone, "--force", status=1)
    assert f"{alone} is there already, and a show file is never written over: give another name" in again
    assert f"{other} has 1 of smirk.omote more: Smirk [left]." in said("import", other, alone).replace("\n", " ")
    assert said("history", other, "smirk", "--json") == said("history", show.path, "smirk", "--json")
    again = said("import", other, alone)
    assert "'Smirk [left]' is there already, with the same history" in again
    assert "has nothing of smirk.omote more." in again
    assert "has 1 of a.omote more: Own." in said("import", other, show.path), "a deleted one stays deleted"
    assert "GOOD" in said("check", other).upper()


def test_nothing_of_a_show_that_is_not_right_comes_in(show: ShowFile, tmp_path: Path) -> None:
    show.apply(
        [item(3, name="odd", head=1), revision(3, 1, content=content_key(b"odd")), Content(content_key(b"odd"), b"odd")]
    )
    text = said("import", tmp_path / "other.omote", show.path, status=1).replace("\n", " ")
    assert "is not all right, so nothing of it was taken: revision 1 of odd" in text


def test_cues_go_out_as_text_and_come_in_again_and_are_the_same(tmp_path: Path) -> None:
    text, show = tmp_path / "evening.toml", tmp_path / "show.omote"
    text.write_text('[[cue]]\nnumber = "1"\n[cue.moves]\n"*/light" = { to = "flat" }\n\n[[cue]]\nnumber = "2"\n')
    assert "has the list main, cues: 2" in said("import", show, text)
    said("export", show, "cues", "-o", tmp_path / "out.toml")
    assert read_cues(tmp_path / "out.toml") == read_cues(text)
    said("export", show, "cues", "-o", tmp_path / "order.csv")
    assert len((tmp_path / "order.csv").read_text().splitlines()) == 3
    before = json.loads(said("list", show, "--documents", "cue", "--json"))
    said("import", show, tmp_path / "out.toml")
    assert json.loads(said("list", show, "--documents", "cue", "--json")) == before
    said("import", show, text, "--list", "matinee")
    assert len(json.loads(said("list", show, "--documents", "cue", "--json"))) == 4


def test_cues_that_are_wrong_are_said_line_by_line_and_change_nothing(tmp_path: Path) -> None:
    text, show = tmp_path / "evening.toml", tmp_path / "show.omote"
    text.write_text('[[cue]]\nnumber = "x"\n[cue.moves]\n"*/light" = { too = "flat" }\n')
    lines = said("import", show, text, status=1).splitlines()
    assert [line.partition("line ")[2][:2] for line in lines] == ["2:", "4:"]
    assert not show.exists()
    text.write_text('[[cue]]\nnumber = "1"\n')
    said("import", show, text)
    assert "there is no list of cues 'x' in this show" in said(
        "export", show, "cues", "--list", "x", "-o", tmp_path / "o.toml", status=1
    )
    assert "holds a list of cues: write" in said("export", show, "smile", "-o", tmp_path / "o.toml", status=1)
