"""A show file's authored work in plain dictionaries, and strategies for changes of it."""

from __future__ import annotations

from hypothesis import strategies as st

from omote.showfile.changes import (
    Change,
    Draft,
    DropDraft,
    DropPerformer,
    Edit,
    Item,
    PutBindings,
    PutContent,
    PutDraft,
    PutEdit,
    PutItem,
    PutLayout,
    PutPerformer,
    PutRevision,
    Revision,
    Stored,
    content_key,
)

DATA = [b"", b"one", b"two" * 3000]
KEYS = [content_key(data) for data in DATA]


def item(number: int = 1, **fields: object) -> Item:
    """An expression."""
    whole = {"id": number, "kind": "expression", "name": f"own-{number}", "label": "Own", **fields}
    return Item(**whole)  # type: ignore[arg-type]


def revision(item: int = 1, number: int = 1, **fields: object) -> Revision:
    """A save of it."""
    whole = {"item": item, "number": number, "parent": number - 1, "recipe": b"{}", "content": KEYS[1]}
    return Revision(**(whole | {"written": 1.5, "editor": "Ada"} | fields))  # type: ignore[arg-type]


FIRST: list[Change] = [
    PutItem(item(head=1, tags=("wry", "left"))),
    PutRevision(revision()),
    PutContent(KEYS[1], DATA[1]),
]


texts = st.text(st.characters(codec="utf-8"), max_size=8)
reals = st.floats(-1e300, 1e300)
ids = st.integers(1, 3)
editors = st.sampled_from(["ada", "bo"])
puts: st.SearchStrategy[Change] = st.one_of(
    st.sampled_from([PutContent(key, data) for key, data in zip(KEYS, DATA, strict=True)]),
    st.builds(
        PutItem,
        st.builds(
            lambda number, **fields: item(number, **fields),
            ids,
            label=texts,
            tags=st.lists(texts, max_size=3).map(tuple),
            place=reals,
            deleted=st.booleans(),
            head=st.integers(0, 2),
        ),
    ),
    st.builds(
        PutRevision,
        st.builds(
            lambda item, number, **fields: revision(item, number, **fields),
            ids,
            st.integers(1, 3),
            parent=st.integers(0, 3),
            recipe=st.binary(max_size=5),
            content=st.sampled_from(KEYS),
            written=reals,
            note=texts,
            aside=st.booleans(),
        ),
    ),
    st.builds(PutDraft, st.builds(Draft, ids, editors, st.integers(0, 3), st.integers(-1, 9))),
    st.builds(PutEdit, st.builds(Edit, ids, editors, st.integers(0, 4), st.binary(max_size=5), texts)),
    st.builds(DropDraft, ids, editors),
    st.builds(PutLayout, texts, st.binary(max_size=5)),
    st.builds(PutBindings, st.binary(max_size=5)),
    st.builds(PutPerformer, texts, st.binary(max_size=5)),
    st.builds(DropPerformer, texts),
)


class AuthoredTables:
    """What a show file should hold, in plain dictionaries."""

    def __init__(self) -> None:
        self.items: dict[int, Item] = {}
        self.revisions: dict[tuple[int, int], Revision] = {}
        self.drafts: dict[tuple[int, str], Draft] = {}
        self.edits: dict[tuple[int, str, int], Edit] = {}
        self.layouts: dict[str, bytes] = {}
        self.bindings: dict[int, bytes] = {}
        self.performers: dict[str, bytes] = {}
        self.contents: dict[str, bytes] = {}

    def copy(self) -> AuthoredTables:
        """Another with the same."""
        other = AuthoredTables()
        for name, rows in vars(self).items():
            setattr(other, name, dict(rows))
        return other

    def make(self, change: Change) -> bool:
        """Makes a change; False where it must be refused."""
        match change:
            case PutRevision(row):
                return self.revisions.setdefault((row.item, row.number), row) == row
            case PutContent(key, data):
                self.contents[key] = data
            case PutItem(row):
                self.items[row.id] = row
            case PutLayout(name, document):
                self.layouts[name] = document
            case PutBindings(document):
                self.bindings[1] = document
            case PutPerformer(name, document):
                self.performers[name] = document
            case DropPerformer(name):
                self.performers.pop(name, None)
            case _:
                self._make_in_draft(change)
        return True

    def _make_in_draft(self, change: Change) -> None:
        match change:
            case PutDraft(row):
                self.drafts[row.item, row.editor] = row
            case PutEdit(row):
                self._drop_edits(row.item, row.editor, row.number)
                self.edits[row.item, row.editor, row.number] = row
            case DropDraft(number, editor):
                if self.drafts.pop((number, editor), None):
                    self._drop_edits(number, editor, 0)

    def _drop_edits(self, number: int, editor: str, first: int) -> None:
        self.edits = {key: row for key, row in self.edits.items() if key[:2] != (number, editor) or key[2] < first}

    @property
    def whole(self) -> bool:
        """Whether everything belongs to something."""
        owned = all(row.item in self.items and row.content in self.contents for row in self.revisions.values())
        heads = all(not row.head or (row.id, row.head) in self.revisions for row in self.items.values())
        drafts = all(row.item in self.items for row in self.drafts.values())
        return owned and heads and drafts and all(key[:2] in self.drafts for key in self.edits)

    @property
    def stored(self) -> Stored:
        """The rows in order."""
        rows = {name: tuple(map(rows.__getitem__, sorted(rows))) for name, rows in vars(self).items()}
        del rows["layouts"], rows["contents"], rows["bindings"], rows["performers"]
        return Stored(**rows, layouts=self.layouts, bindings=self.bindings.get(1, b""), performers=self.performers)
