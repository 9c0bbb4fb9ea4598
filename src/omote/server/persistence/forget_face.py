"""Removes own faces and sounds for good from a show file that no show plays: nothing of them is left in its bytes, nor
in the good copies beside it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from omote.edit.store.whole_items import item_sources
from omote.model.recipes.recipe import KEY
from omote.server.persistence.offline_show import open_offline_show
from omote.show.objects.documents import contents_of, names_in, read_document
from omote.show.objects.sounds import StoredSound
from omote.showfile.backup import back_up, backup_paths, refuse_foreign, remove
from omote.showfile.changes import Item, Stored
from omote.showfile.inspection import item_named
from omote.showfile.recording_file import open_recording, recording_path, sound_key
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import ShowFile

SAMPLE = 48
EVERY = 1000
"""Bytes of a content that are looked for in other files, and how far apart: pages of SQLite part contents."""


@dataclass(frozen=True)
class Forgotten:
    """The labels of what was removed, and notes: what else went."""

    labels: tuple[str, ...]
    notes: tuple[str, ...] = ()


def forget_faces(path: Path, names: Sequence[str], /, *, copies: bool = False) -> Forgotten:
    """Removes faces with revisions, drafts and contents, the last state where that plays them, sounds with their bytes,
    and the good copies of before; a good copy of what is left is made.

    Parameters
    ----------
    path : Path
        The show file, which no show plays.
    names : sequence of str
        Names or labels of own faces, and names of sounds.
    copies : bool
        Whether damaged copies beside the file that hold them are removed too.

    Returns
    -------
    Forgotten
        What went.

    Raises
    ------
    ShowFileError
        On a name that no own face and no sound has, where others are made of them, and where damaged copies hold them
        and are to stay; nothing is changed.
    OSError, sqlite3.Error
        Where the disk fails; the same call again goes on.
    """
    with open_offline_show(path) as show:
        stored = show.stored()
        contents = show.contents()
        sounds = {name: _sound_named(stored, name) for name in names if name in _sounds_in(stored)}
        items = list(dict.fromkeys(item_named(stored, name, "face") for name in names if name not in sounds))
        _refuse_dependents(stored, items)
        heard = {sound.content for sound in sounds.values()} - _contents_of_others(stored, sounds)
        keys = _own_keys(stored, items) | heard
        damaged = [copy for copy in _damaged_copies(show.path) if _holds(copy, [contents[key] for key in keys])]
        if damaged and not copies:
            raise ShowFileError(
                f"{' and '.join(copy.name for copy in damaged)} beside it hold{'s' * (len(damaged) < 2)} it too, so "
                "nothing was removed: --copies removes what was put aside there with it."
            )
        for backup in (
            *backup_paths(show.path),
            *damaged,
        ):  # first: a call that is cut off finds the face still, and goes on
            if backup not in damaged:
                refuse_foreign(backup, show.path)
            remove(backup)
        recorded = keys | {sound_key(sound.sound) for sound in sounds.values()}
        notes = (*_forget_recorded(show.path, recorded), *_notes(show, stored, items))
        show.erase(_removals(items, sounds, sorted(keys), clear_state=_is_played(show, items)))
        back_up(show)
    return Forgotten((*(item.label for item in items), *sounds), notes)


def _sounds_in(stored: Stored) -> Mapping[str, bytes]:
    return stored.documents.get(StoredSound.kind, {})


def _sound_named(stored: Stored, name: str) -> StoredSound:
    try:
        return read_document(StoredSound, _sounds_in(stored)[name])
    except ValueError as error:
        raise ShowFileError(f"the sound {name} cannot be read, so nothing was removed: {error}.") from error


def _contents_of_others(stored: Stored, sounds: Collection[str]) -> set[str]:
    """The contents that documents need beside some sounds (by name)."""
    rows = ((kind, *named) for kind, of_kind in stored.documents.items() for named in of_kind.items())
    others = (row for row in rows if row[0] != StoredSound.kind or row[1] not in sounds)
    return {key for kind, _, body in others for key in contents_of(kind, body)}


def _forget_recorded(path: Path, keys: Collection[str]) -> Iterator[str]:
    """Removes what was recorded while it needed these contents (keys). path: of the show file."""
    recording = recording_path(path)
    if not recording.exists():
        return
    with closing(open_recording(recording)) as recorded:
        seconds = recorded.forget(keys)
    if seconds:
        yield f"{seconds / 60.0:.1f} minutes of the show's recording, which needed it, went with it."


def _refuse_dependents(stored: Stored, items: Sequence[Item]) -> None:
    """ShowFileError where the look of other items is made of these."""
    ids = {item.id for item in items}
    names = {item.name for item in items}
    keys = {KEY + revision.content for revision in stored.revisions if revision.item in ids}
    others = [item for item in stored.items if item.id not in ids and item_sources(stored, item.id) & (keys | names)]
    if others:
        raise ShowFileError(
            f"{', '.join(item.name for item in others)} {'are' if len(others) > 1 else 'is'} made of "
            f"{', '.join(sorted(names))}: name {'them' if len(others) > 1 else 'it'} too, to forget all of it."
        )


def _own_keys(stored: Stored, items: Sequence[Item]) -> set[str]:
    """Keys of the contents that only these items name."""
    ids = {item.id for item in items}
    own = {name for item in ids for name in item_sources(stored, item) if name.startswith(KEY)}
    others = {name for item in stored.items if item.id not in ids for name in item_sources(stored, item.id)}
    return {name.removeprefix(KEY) for name in own - others}


def _removals(
    items: Sequence[Item], sounds: Collection[str], keys: Sequence[str], *, clear_state: bool
) -> Iterator[tuple[str, tuple[str | int, ...]]]:  # fmt: skip
    for item in items:
        yield "UPDATE item SET head = 0 WHERE id = ?", (item.id,)
        for table in ("edit", "draft", "revision"):
            yield f"DELETE FROM {table} WHERE item = ?", (item.id,)
        yield "DELETE FROM item WHERE id = ?", (item.id,)
        yield "DELETE FROM journal_aside WHERE instr(snapshot, CAST(? AS BLOB)) > 0", (item.name,)
    for name in sounds:
        yield "DELETE FROM document WHERE kind = ? AND name = ?", (StoredSound.kind, name)
    for key in keys:
        yield "DELETE FROM content WHERE key = ?", (key,)
    if clear_state:
        yield "DELETE FROM journal", ()


def _is_played(show: ShowFile, items: Sequence[Item]) -> bool:
    snapshot = show.journal().snapshot or b""
    return any(item.name.encode() in snapshot for item in items)


def _notes(show: ShowFile, stored: Stored, items: Sequence[Item]) -> Iterator[str]:
    if _is_played(show, items):
        yield "the last state of the show played it: the show starts neutral."
    names = [item.name for item in items]
    rows = ((kind, *named) for kind, of_kind in stored.documents.items() for named in of_kind.items())
    still = [name if name == kind else f"{kind} {name}" for kind, name, body in rows if names_in(kind, body, names)]
    if still:
        yield f"its name still stands in {', '.join(still)}: take it out there."


def _damaged_copies(path: Path) -> list[Path]:
    """Files that recovery has put aside."""
    return sorted(file for file in path.parent.glob(f"{_escape(path.name)}.corrupt-*") if file.is_file())


def _escape(name: str) -> str:
    return "".join(f"[{letter}]" if letter in "*?[" else letter for letter in name)


def _holds(path: Path, contents: Sequence[bytes]) -> bool:
    data = path.read_bytes()
    samples = [
        content[at : at + SAMPLE]
        for content in contents
        for at in range(len(content) // 3, len(content) - SAMPLE, EVERY)
    ]
    return any(sample in data for sample in samples)
