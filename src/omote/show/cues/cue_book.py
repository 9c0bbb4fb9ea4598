"""The cues of a show in their lists, and every edit of them: what was edited is taken back by whoever wants, without
end.

A book is a value, and so is an edit: what it found and what it left. The log of edits is only added to; which edit is
taken back next follows from it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeVar

import msgspec

from omote.perform.cues.cue import Cue, CueList, check_cue_number, check_cues, write_cue_number
from omote.perform.limits import check_known
from omote.show.objects.cues import CueEdit, StoredCue, StoredCueList
from omote.show.objects.documents import Document
from omote.showfile.changes import DocumentRemoval, StoredDocument

MOST_LISTS = 16
LONGEST_LIST_NAME = 40
FIRST_LIST = "main"
"""The list that a new show has."""

Kept = TypeVar("Kept", bound=Document)


@dataclass(frozen=True)
class CueBook:
    """The cues of a show. cues: by identity; orders: by list, the identities of its cues in the order of GO; edits: all
    that were made, the oldest first."""

    cues: Mapping[str, Cue] = field(default_factory=dict)
    orders: Mapping[str, tuple[str, ...]] = field(default_factory=lambda: {FIRST_LIST: ()})
    edits: tuple[CueEdit, ...] = ()

    def cues_of(self, name: str) -> CueList:
        """The cues of a list (name), in the order of GO."""
        return tuple(self.cues[identity] for identity in self.orders[name])

    def list_of(self, identity: str) -> str:
        """The list that a cue stands in; ValueError where there is no such cue any more."""
        for name, order in self.orders.items():
            if identity in order:
                return name
        raise ValueError("this cue is not there any more: somebody has deleted it")

    @property
    def undone(self) -> tuple[list[int], list[int]]:
        """The places in the log of the edits that can be taken back, and of those that can be done again, the next one
        last."""
        done: list[int] = []
        back: list[int] = []
        for place, edit in enumerate(self.edits):
            if edit.does == "undo":
                back += [done.pop()] if done else []
            elif edit.does == "redo":
                done += [back.pop()] if back else []
            elif edit.does == "edit":
                done.append(place)
                back = []
            else:
                done = []
                back = []
        return done, back


def edit_cues(
    book: CueBook, what: str, by: str, cues: Mapping[str, Cue | None], orders: Mapping[str, Sequence[str] | None]
) -> CueBook:
    """The book after an edit, with that in its log.

    Parameters
    ----------
    book : CueBook
        As it is.
    what, by : str
        What is done, and who does it, for people.
    cues : mapping
        The cues that change, by identity; None for one that goes.
    orders : mapping
        The lists whose order changes, by name; None for one that goes.

    Returns
    -------
    CueBook
        The same book where nothing changes.

    Raises
    ------
    ValueError
        Where two cues of a list would have one number, a list too many cues, or the show too many lists or none.
    """
    changed = {identity: cue for identity, cue in cues.items() if book.cues.get(identity) != cue}
    moved = {
        name: None if order is None else list(order)
        for name, order in orders.items()
        if order is None or tuple(order) != book.orders.get(name)
    }
    if not changed and not moved:
        return book
    edit = CueEdit(
        what=what,
        by=by,
        cues_before={identity: book.cues.get(identity) for identity in changed},
        cues_after=changed,
        orders_before={name: _listed(book.orders.get(name)) for name in moved},
        orders_after=moved,
    )
    return _checked(_with(book, edit, edit.cues_after, edit.orders_after))


def undo(book: CueBook, by: str) -> CueBook:
    """The book with the last edit taken back; ValueError where there is none. by: who does it."""
    done, _ = book.undone
    if not done:
        raise ValueError("there is no edit of cues to take back")
    edit = book.edits[done[-1]]
    return _with(book, CueEdit(edit.what, by, does="undo"), edit.cues_before, edit.orders_before)


def redo(book: CueBook, by: str) -> CueBook:
    """The book with the edit that was taken back last done again; ValueError where there is none. by: who does it."""
    _, back = book.undone
    if not back:
        raise ValueError("there is no edit of cues to do again")
    edit = book.edits[back[-1]]
    return _with(book, CueEdit(edit.what, by, does="redo"), edit.cues_after, edit.orders_after)


def new_identities(book: CueBook, count: int) -> list[str]:
    """Identities that no cue of the book has had before, count of them: the log names them all."""
    return [f"{len(book.edits):x}-{number:x}" for number in range(count)]


def place_number(book: CueBook, name: str, number: str) -> int:
    """Where a cue of a number belongs in a list of the book (name): behind the last one whose number is not higher,
    from 0."""
    order = [thousandths(cue.number) for cue in book.cues_of(name)]
    return max((place + 1 for place, other in enumerate(order) if other <= thousandths(number)), default=0)


def thousandths(number: str) -> int:
    """The number of a cue in whole thousandths, which orders cues as their numbers do."""
    whole, _, decimals = check_cue_number(number).partition(".")
    return int(whole) * 1000 + int(decimals.ljust(3, "0"))


def next_number(book: CueBook, name: str, after: str | None) -> str:
    """A free number for a new cue of a list.

    book: with the list; name: of the list; after: the cue that it comes behind, by identity, None for the end of the
    list. The next whole number where that is free, else the number between two with the fewest decimals.
    """
    order = book.orders[name]
    place = len(order) if after is None else order.index(after) + 1
    taken = [thousandths(book.cues[identity].number) for identity in order]
    before = taken[place - 1] if place else 0
    behind = taken[place] if place < len(order) else 99_999_000
    for step in (1000, 500, 100, 10, 1):
        tried = before - before % step + step
        if before < tried < behind and tried not in taken:
            return write_cue_number(tried / 1000)
    raise ValueError("there is no free number between these two cues: renumber the list first")


def renumbered(book: CueBook, name: str, first: str, step: str) -> dict[str, Cue]:
    """The cues of a list of the book with new numbers, by identity. name: of the list; first: the first number; step:
    from each to the next."""
    apart = thousandths(step)
    if apart == 0:
        raise ValueError("the step between two numbers is 0; give one above it, such as 1")
    begin = thousandths(first)
    numbers = (write_cue_number((begin + place * apart) / 1000) for place in range(len(book.orders[name])))
    return {
        identity: replace(book.cues[identity], number=number)
        for identity, number in zip(book.orders[name], numbers, strict=True)
    }


def take_in_list(book: CueBook, name: str, cues: Sequence[Cue], by: str) -> CueBook:
    """The book with a list as it comes from a text, where a cue is known by its number: it is the same cue still.

    name: of the list, which may be new; cues: in the order of GO; by: who brings them.
    """
    known = {cue.number: cue.identity for cue in book.cues_of(name)} if name in book.orders else {}
    new = iter(new_identities(book, len(cues)))
    placed = [replace(cue, identity=known.get(cue.number) or next(new)) for cue in check_cues(cues)]
    gone = dict.fromkeys(book.orders.get(name, ()))
    changed: dict[str, Cue | None] = {**gone, **{cue.identity: cue for cue in placed}}
    return edit_cues(book, f"take in {name}", by, changed, {check_list_name(name): [cue.identity for cue in placed]})


def check_list_name(name: str) -> str:
    """Returns the name of a list without spaces around it; ValueError for none and for one that is too long."""
    text = " ".join(name.split())
    if not 0 < len(text) <= LONGEST_LIST_NAME:
        raise ValueError(f"a list of cues cannot be called {name!r:.60}; give 1 to {LONGEST_LIST_NAME} letters")
    return text


def changes_between(before: CueBook, after: CueBook) -> list[StoredDocument | DocumentRemoval]:
    """What the show file has to keep to come from one book to the next. before, after: the books."""
    changes: dict[tuple[str, str], Document | None] = {}
    for identity in {**before.cues, **after.cues}:
        cue = after.cues.get(identity)
        if cue is not before.cues.get(identity):
            changes[StoredCue.kind, identity] = None if cue is None else StoredCue(cue)
    if before.orders != after.orders:
        for place, (name, order) in enumerate(after.orders.items()):
            changes[StoredCueList.kind, name] = StoredCueList(list(order), place)
        gone = before.orders.keys() - after.orders.keys()
        changes |= {(StoredCueList.kind, name): None for name in gone}
    for number in range(len(before.edits), len(after.edits)):
        changes[CueEdit.kind, f"{number:08d}"] = after.edits[number]
    return [
        DocumentRemoval(kind, name) if document is None else StoredDocument(kind, name, document.encode())
        for (kind, name), document in changes.items()
    ]


def read_book(documents: Callable[[str], Mapping[str, bytes]]) -> tuple[CueBook, list[str]]:
    """The book that a show file keeps, and what of it cannot be read, in sentences: one cue costs that cue.

    documents: those (JSON) of a kind, by name.
    """
    cues, lists, edits = (documents(kind.kind) for kind in (StoredCue, StoredCueList, CueEdit))
    lost: list[str] = []
    read_cues = {name: _read(body, StoredCue, f"the cue {name}", lost) for name, body in cues.items()}
    found = {name: kept.cue for name, kept in read_cues.items() if kept is not None}
    orders = sorted(
        (kept.place, name, kept.order)
        for name, body in lists.items()
        if (kept := _read(body, StoredCueList, f"the list of cues {name}", lost))
    )
    kept_orders = {
        name: tuple(identity for identity in dict.fromkeys(order) if identity in found) for _, name, order in orders
    }
    listed = dict.fromkeys(identity for order in kept_orders.values() for identity in order)
    book = CueBook(
        {identity: found[identity] for identity in listed}, kept_orders or {FIRST_LIST: ()}, _read_log(edits, lost)
    )
    return book, lost


def _read_log(edits: Mapping[str, bytes], lost: list[str]) -> tuple[CueEdit, ...]:
    """The log; nothing is taken back across an edit that cannot be read."""
    unreadable = CueEdit("what cannot be read", "", does="unreadable")
    return tuple(_read(edits[name], CueEdit, f"the edit of cues {name}", lost) or unreadable for name in sorted(edits))


def _read(body: bytes, kind: type[Kept], what: str, lost: list[str]) -> Kept | None:
    try:
        return msgspec.json.decode(body, type=kind)
    except (ValueError, TypeError, RecursionError) as error:
        lost.append(f"{what} cannot be read ({error}) and is left out.")
        return None


def _listed(order: Sequence[str] | None) -> list[str] | None:
    return None if order is None else list(order)


def _with(
    book: CueBook,
    edit: CueEdit,
    cues: Mapping[str, Cue | None],
    orders: Mapping[str, Sequence[str] | None],
) -> CueBook:
    changed = {**book.cues, **cues}
    moved = {**book.orders, **orders}
    return CueBook(
        {identity: cue for identity, cue in changed.items() if cue is not None},
        {name: tuple(order) for name, order in moved.items() if order is not None},
        (*book.edits, edit),
    )


def _checked(book: CueBook) -> CueBook:
    if not 0 < len(book.orders) <= MOST_LISTS:
        raise ValueError(f"a show has 1 to {MOST_LISTS} lists of cues, not {len(book.orders)}")
    for name in book.orders:
        check_list_name(name)
        check_cues(book.cues_of(name))
    return book


def find_cue(book: CueBook, name: str, number: str) -> Cue:
    """The cue of a number in a list of the book (name); ValueError where there is none, with those near it."""
    by_number: dict[str, Cue] = {cue.number: cue for cue in book.cues_of(name)}
    return by_number[check_known(number, by_number, "cue of this list")]
