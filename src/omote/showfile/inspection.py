"""Inspects a show file: its contents and their integrity; only reads, also while a show plays it."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import get_args

import msgspec

from omote.interchange.formats.error_reasons import explain_error
from omote.model.recipes.recipe import KEY, AnyRecipe, sources
from omote.perform.name_lookup import find_name, fold
from omote.showfile.authored_rows import read_all, read_contents
from omote.showfile.backup import backup_paths
from omote.showfile.changes import Draft, Item, Kind, Revision, Stored
from omote.showfile.database_errors import technical_texts
from omote.showfile.identification import identify, locate_show
from omote.showfile.integrity import open_read_only, verify_integrity
from omote.showfile.recovery import explain_missing, is_lost
from omote.showfile.schema import AUTHORED_SINCE, SCHEMA_VERSION, CorruptShowFileError, ShowFileError


@dataclass(frozen=True)
class Inspection:
    """A show file's schema, the epoch of its last state (0 for none), its authored work."""

    version: int
    epoch: int
    stored: Stored = field(default_factory=Stored)
    contents: Mapping[str, bytes] = field(default_factory=dict)


def inspect_show(path: Path, /) -> Inspection:
    """All of a show file; ShowFileError with an error message where there is none, or it is damaged."""
    try:
        return _read_whole(path)
    except CorruptShowFileError as error:
        raise CorruptShowFileError(f"{error} {what_opens(path)}") from error


def _read_whole(path: Path) -> Inspection:
    path = locate_show(path) if path.is_symlink() else path
    version = verify_integrity(path)
    if version == 0:
        raise ShowFileError(explain_missing(path))
    with contextlib.closing(open_read_only(path)) as connection:
        connection.execute("BEGIN")  # one state, whatever is committed meanwhile
        row = connection.execute("SELECT epoch FROM journal").fetchone()
        epoch = int(row[0]) if row else 0
        if version < AUTHORED_SINCE:
            return Inspection(version, epoch)
        return Inspection(version, epoch, read_all(connection), dict(read_contents(connection)))


def item_named(stored: Stored, name: str, kind: Kind | None = None, /) -> Item:
    """The item that a person means by a name or a label; ShowFileError names those there are, or asks which kind.

    stored: the authored work; name: what the person typed; kind: None for either.
    """
    items = [item for item in stored.items if kind in (None, item.kind)]
    names = list(dict.fromkeys(item.name for item in items))
    try:
        meant = find_name(name, names, kind or "item", {item.name: item.label for item in items})
    except ValueError as error:
        there = f"there are: {', '.join(names) or 'none yet'}"
        several = fold(name) in map(fold, (*names, *(item.label for item in items)))
        raise ShowFileError(
            f"{error}." if several else f"there is no own face or expression {name!r}; {there}."
        ) from None
    matches = [item for item in items if item.name == meant]
    if len(matches) > 1:
        raise ShowFileError(f"there is a face and an expression {meant!r}; say which with --kind.")
    return matches[0]


def revisions_of(stored: Stored, item: Item, /) -> list[Revision]:
    """An item's revisions, oldest first.

    stored: the authored work; item: whose.
    """
    return [revision for revision in stored.revisions if revision.item == item.id]


def refuse_wrong(path: Path, inspection: Inspection, /) -> None:
    """Raises ShowFileError where not all of a show file can be used. path: its place; inspection: of it."""
    if wrong := [*_wrong_revisions(inspection), *_wrong_steps(inspection)]:
        raise ShowFileError(f"{path} is not all right, so nothing of it was taken: {wrong[0]} (omote file check).")


def holds_nothing(path: Path, /) -> bool:
    """Whether nothing is at a path that could be checked: no file or an empty one, and nothing left of a show."""
    return identify(path).kind in ("missing", "empty") and not is_lost(path)


def what_opens(path: Path, /) -> str:
    """What `omote show` would open of a file that is not all right, as a whole sentence."""
    if any(identify(backup).kind == "show" for backup in backup_paths(path)):
        return f"It has good copies: omote show {path} opens the newest, and keeps the damaged file aside."
    return f"There is no good copy of it: omote show {path} keeps it aside and starts neutral."


def verdicts(path: Path, /) -> Iterator[tuple[bool, str]]:
    """Yields the result of each integrity check with a message; the first failure may be the last."""
    try:
        inspection = _read_whole(path)
    except ShowFileError as error:
        yield False, str(error)
        for text in technical_texts(error):
            yield False, f"for whoever repairs it: {text}"
        yield from _copies(path, whole=False)
        return
    newest = "" if inspection.version == SCHEMA_VERSION else f", which omote show brings to {SCHEMA_VERSION}"
    yield True, f"{path.name} is whole: schema {inspection.version}{newest}"
    state = f"the state of epoch {inspection.epoch}" if inspection.epoch else "no state of a show yet"
    yield True, f"it holds {state}"
    size = sum(map(len, inspection.contents.values())) / 1e6
    yield True, f"{len(inspection.contents)} contents, {size:.1f} MB, and each is what its key says"
    yield from _check_authored(inspection)
    yield from _copies(path, whole=True)


def _check_authored(inspection: Inspection) -> Iterator[tuple[bool, str]]:
    stored = inspection.stored
    wrong = [*_wrong_revisions(inspection), *_wrong_steps(inspection)]
    counts = (
        f"{sum(item.kind == kind and not item.deleted for item in stored.items)} own {kind}s"
        for kind in reversed(get_args(Kind))
    )
    yield True, f"{', '.join(counts)}, {len(stored.revisions)} revisions"
    documents = (f"{len(named)} of kind {kind}" for kind, named in sorted(stored.documents.items()))
    yield True, f"{len(stored.drafts)} drafts with {len(stored.edits)} steps"
    yield True, f"documents: {', '.join(documents) or 'none'}"
    for sentence in wrong:
        yield False, sentence


def _wrong_revisions(inspection: Inspection) -> Iterator[str]:
    from omote.showfile.contents import ContentError, content_kind  # with the model: most commands need neither

    items = {item.id: item for item in inspection.stored.items}
    for revision in inspection.stored.revisions:
        item = items[revision.item]
        what = f"revision {revision.number} of {item.name}"
        try:
            kind = content_kind(inspection.contents[revision.content])
        except ContentError as error:
            yield f"{what}: {error}"
        else:
            if kind != item.kind:
                yield f"{what} makes no {item.kind}, but a different kind: {kind}"
        yield from _wrong_recipe(revision.recipe, what, inspection.contents)


def _wrong_steps(inspection: Inspection) -> Iterator[str]:
    names = {item.id: item.name for item in inspection.stored.items}
    for draft in inspection.stored.drafts:
        what = f"the draft of {names[draft.item]} by {draft.editor}"
        numbers = [edit.number for edit in inspection.stored.edits if _is_step(edit.item, edit.editor, draft)]
        if numbers != [*range(len(numbers))] or not draft.cursor < len(numbers):
            yield f"{what} shows step {draft.cursor}; it has {numbers}"
    for edit in inspection.stored.edits:
        what = f"step {edit.number} of the draft of {names[edit.item]} by {edit.editor}"
        yield from _wrong_recipe(edit.recipe, what, inspection.contents)


def _is_step(item: int, editor: str, draft: Draft) -> bool:
    return (item, editor) == (draft.item, draft.editor)


def _wrong_recipe(data: bytes, what: str, contents: Mapping[str, bytes]) -> Iterator[str]:
    try:
        recipe: AnyRecipe = msgspec.json.decode(data, type=AnyRecipe)
    except msgspec.DecodeError as error:
        yield f"the recipe of {what} cannot be read: {explain_error(error)}"
        return
    for source in sorted(sources(recipe)):
        if source.startswith(KEY) and source[len(KEY) :] not in contents:
            yield f"the recipe of {what} names {source}, which is not there"


def _copies(path: Path, *, whole: bool) -> Iterator[tuple[bool, str]]:
    """The good copies beside a file, of which a damaged one has need."""
    backups = [backup for backup in backup_paths(path) if backup.exists()]
    if not backups:
        yield whole, f"there is no good copy beside it{' yet; omote show makes one' if whole else ''}"
    for backup in backups:
        try:
            good = verify_integrity(backup) > 0
            yield good, f"its good copy {backup.name} is {'whole' if good else 'empty'}"
        except ShowFileError as error:
            yield False, f"its good copy is none: {error}"
    for kept in sorted(path.parent.glob(f"{path.name}.corrupt-*[0-9]")):
        yield True, f"{kept.name} is a corrupt file that was kept; delete it when nothing of it is missed"
