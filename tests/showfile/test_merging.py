"""What newer rows add to a whole copy leaves it whole, and takes nothing from it."""

from pathlib import Path

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from omote.showfile.changes import Change, Draft, Edit, PutDraft, PutItem, Stored
from omote.showfile.merging import changes_since
from omote.showfile.show_file import open_show
from tests.showfile.ledger import DATA, FIRST, KEYS, AuthoredTables, item, puts, revision

histories = st.lists(st.lists(puts, min_size=1, max_size=3), max_size=12)


def played(kept: AuthoredTables, lists: list[list[Change]]) -> AuthoredTables:
    """The ledger after those of the lists that can be made."""
    for changes in lists:
        wanted = kept.copy()
        if all(wanted.make(change) for change in changes) and wanted.whole:
            kept = wanted
    return kept


def merged(good: AuthoredTables, found: Stored, contents: dict[str, bytes]) -> AuthoredTables:
    """The copy with what is newer."""
    result = good.copy()
    assert all(result.make(change) for change in changes_since(good.stored, good.contents.keys(), found, contents))
    assert result.whole
    return result


def started() -> AuthoredTables:
    """A ledger with one item, its revision and a draft."""
    return played(AuthoredTables(), [FIRST, [PutDraft(Draft(1, "ada", 1, 0))]])


@given(histories, histories)
@settings(max_examples=25)
def test_with_all_rows_the_copy_becomes_the_newer_state(before: list[list[Change]], after: list[list[Change]]) -> None:
    good = played(started(), before)
    later = played(good.copy(), after)
    result = merged(good, later.stored, later.contents)
    assert result.items == later.items
    assert result.revisions == later.revisions
    assert result.layouts == later.layouts
    assert result.contents == later.contents
    for draft in later.stored.drafts:
        steps = [edit.number for edit in later.stored.edits if (edit.item, edit.editor) == (draft.item, draft.editor)]
        if -1 < draft.cursor < len(steps) and steps == [*range(len(steps))]:
            assert draft in result.stored.drafts


@given(histories, histories, st.data())
@settings(max_examples=25)
def test_with_some_rows_the_copy_loses_nothing_and_stays_whole(
    before: list[list[Change]], after: list[list[Change]], data: st.DataObject
) -> None:
    good = played(started(), before)
    later = played(good.copy(), after)

    def some(rows: tuple[object, ...]) -> tuple[object, ...]:
        return tuple(row for row in rows if data.draw(st.booleans()))

    rows = later.stored
    found = Stored(some(rows.items), some(rows.revisions), some(rows.drafts), some(rows.edits))  # type: ignore[arg-type]
    contents = {key: later.contents[key] for key in some(tuple(later.contents))}  # type: ignore[index]
    result = merged(good, found, contents)  # type: ignore[arg-type]
    assert good.revisions.items() <= result.revisions.items()
    assert good.contents.items() <= result.contents.items()
    assert good.items.keys() | {item.id for item in found.items} == result.items.keys()
    assert good.drafts.keys() <= result.drafts.keys()


def test_a_draft_with_missing_steps_leaves_the_copys_draft_and_is_cut_where_there_is_none() -> None:
    steps = tuple(Edit(1, "ada", number, b"", "") for number in (0, 1, 3))
    found = Stored(items=(item(),), drafts=(Draft(1, "ada", 0, 3),), edits=steps)
    cut = merged(played(AuthoredTables(), [[PutItem(item())]]), found, {})
    assert (cut.stored.drafts, cut.stored.edits) == ((Draft(1, "ada", 0, 1),), steps[:2])
    assert merged(started(), found, {}).stored.drafts == (Draft(1, "ada", 1, 0),)


def test_a_head_whose_revision_is_lost_goes_to_the_newest_that_is_there() -> None:
    good = started()
    found = Stored(
        items=(item(head=4),), revisions=(revision(number=2), revision(number=3, aside=True), revision(number=5))
    )
    assert merged(good, Stored(items=found.items), {}).items[1].head == 1
    assert merged(good, found, {KEYS[1]: DATA[1]}).items[1].head == 5
    lone = played(AuthoredTables(), [])
    assert merged(lone, found, {}).items[1].head == 0


@given(histories)
@settings(max_examples=10, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
def test_a_show_file_takes_the_changes(tmp_path: Path, after: list[list[Change]]) -> None:
    (tmp_path / "a.omote").unlink(missing_ok=True)
    good = started()
    later = played(good.copy(), after)
    show = open_show(tmp_path / "a.omote")
    show.apply([*FIRST, PutDraft(Draft(1, "ada", 1, 0))])
    show.apply(changes_since(show.stored(), show.contents().keys(), later.stored, later.contents))
    assert show.stored().revisions == later.stored.revisions
    show.close()
