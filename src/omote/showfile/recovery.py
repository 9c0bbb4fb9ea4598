"""What becomes of a corrupt or lost show file: it is kept, and its newest whole backup takes its place.

The backup is copied and verified under another name before anything is renamed; a recovery that is cut off leaves no
show file, or the corrupt one, and is begun again by the next start.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from omote.showfile.backup import backup_paths, put_in_place, refuse_foreign, remove
from omote.showfile.identification import SUFFIX, identify, is_own_log, reject_foreign, require_show
from omote.showfile.integrity import verify_integrity
from omote.showfile.schema import CorruptShowFileError, ShowFileError


@dataclass(frozen=True)
class Recovery:
    """How a show file was recovered.

    kept: where the corrupt file lies now, None where there was none; copied: when the backup in its place was made
    (seconds since 1970), None where there was no whole one.
    """

    kept: Path | None
    copied: float | None


def is_lost(path: Path, /) -> bool:
    """Whether a show file is missing or empty that was more before: a backup or its log is there."""
    if path.exists() and path.stat().st_size > 0:
        return False
    log = path.with_name(path.name + "-wal")
    return any(backup.exists() for backup in backup_paths(path)) or (log.exists() and log.stat().st_size > 0)


def name_show(path: Path, /) -> Path:
    """The path of a show to open or make: `evening` means `evening.omote`, unless `evening` is or was something."""
    if path.suffix or not path.name or path.exists() or path.is_symlink() or is_lost(path):
        return path
    return path.with_name(path.name + SUFFIX)


def explain_missing(path: Path, /) -> str:
    """Why no show can be read at a path where nothing or an empty file lies, as a whole sentence."""
    empty = path.exists()
    if is_lost(path):
        what = "is empty" if empty else "is not there"
        return f"{path} {what}, but its good copies or its log are: omote show {path} brings it back."
    if empty:
        begins = f"; omote show {path} begins one in it" if path.suffix.lower() == SUFFIX else ""
        return f"{path} is an empty file: there is no show in it{begins}."
    near = path.with_name(path.name + SUFFIX)
    hint = f"did you mean {near}?" if near.is_file() else f"omote show {path} makes one."
    return f"there is no show file {path}; {hint}"


def reject_unproven(path: Path, /) -> None:
    """Rejects, by ShowFileError, where no show is, was or may be begun; only reads, and makes nothing beside it."""
    if reject_foreign(path).kind != "missing" and not is_lost(path):
        require_show(path)
    if not any(backup.exists() for backup in backup_paths(path)):
        _require_proof(path)


def recover_show(path: Path, /) -> Recovery:
    """Puts the newest whole backup in the place of a corrupt or lost show file; no file is removed.

    Where no backup is whole there is no show file afterwards. ShowFileError where nothing proves that it was a show
    (its header, a whole backup beside it) or a backup is of a newer Omote, OSError where the disk fails: all is as it
    was, or another call does the rest.
    """
    draft = path.with_name(path.name + ".recovered")
    reject_foreign(path)
    refuse_foreign(draft, path)
    try:
        backup, broken = _copy_newest(path, draft)
        if backup is None:
            _require_proof(path)
        for file in broken:
            move_aside(file)  # later backups would take its place
        kept = move_aside(path)
        if backup is None:
            return Recovery(kept, None)
        put_in_place(draft, path)
        return Recovery(kept, backup.stat().st_mtime)
    finally:
        remove(draft)


def _copy_newest(path: Path, draft: Path) -> tuple[Path | None, list[Path]]:
    """Copies the newest backup that is whole, if any; also those before it, which are not."""
    broken: list[Path] = []
    for backup in backup_paths(path):
        if identify(backup).kind in ("missing", "foreign"):
            continue
        remove(draft)
        shutil.copyfile(backup, draft)
        shutil.copymode(backup, draft)  # who may read it
        try:
            if verify_integrity(draft):
                return backup, broken
        except CorruptShowFileError:
            pass
        broken.append(backup)
    return None, broken


def _require_proof(path: Path) -> None:
    """ShowFileError where nothing but a backup could tell that a file, or a log alone, is what is left of a show."""
    if identify(path).kind == "remains":
        raise ShowFileError(
            f"{path} is damaged so far that nothing tells what it was, and no whole copy of it lies beside it; it "
            "stays as it is. Move it away to begin a new show under this name, or name another file."
        )
    log = path.with_name(path.name + "-wal")
    if log.exists() and not path.exists() and not is_own_log(path):
        raise ShowFileError(
            f"{log} lies where the log of a show belongs, and was written by another program; it stays as it is. Move "
            "it away, or name another file."
        )


def move_aside(path: Path, /) -> Path | None:
    """Renames a corrupt show file, and its log, to the first free `<name>.corrupt-<n>`; gives the new path.

    None where there is no file; a log without one is moved all the same.
    """
    names = [name for name in ("", "-wal", "-shm") if path.with_name(path.name + name).exists()]
    number = 1
    while any(path.with_name(f"{path.name}.corrupt-{number}{name}").exists() for name in names):
        number += 1
    kept = path.with_name(f"{path.name}.corrupt-{number}")
    for name in names:
        path.with_name(path.name + name).rename(kept.with_name(kept.name + name))
    return kept if "" in names else None
