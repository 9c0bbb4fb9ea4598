"""A show file's authored work in plain dictionaries, and strategies for changes of it."""

from __future__ import annotations

from hypothesis import strategies as st

from omote.showfile.changes import (
    Change,
    Content,
    DocumentRemoval,
    Draft,
    Edit,
    Item,
    Revision,
    StoredDocument,
    content_key,
)
from tests.authoring import Tables

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
    item(head=1, tags=("wry", "left")),
    revision(),
    Content(KEYS[1], DATA[1]),
]


texts = st.text(st.characters(codec="utf-8"), max_size=8)
reals = st.floats(-1e300, 1e300)
ids = st.integers(1, 3)
editors = st.sampled_from(["ada", "bo"])
kinds = st.sampled_from(["layout", "bindings", "of no Omote yet"])
puts: st.SearchStrategy[Change] = st.one_of(
    st.sampled_from([Content(key, data) for key, data in zip(KEYS, DATA, strict=True)]),
    st.builds(
        item,
        ids,
        label=texts,
        tags=st.lists(texts, max_size=3).map(tuple),
        place=reals,
        deleted=st.booleans(),
        head=st.integers(0, 2),
    ),
    st.builds(
        revision,
        ids,
        st.integers(1, 3),
        parent=st.integers(0, 3),
        recipe=st.binary(max_size=5),
        content=st.sampled_from(KEYS),
        written=reals,
        note=texts,
        aside=st.booleans(),
    ),
    st.builds(Draft, ids, editors, st.integers(0, 3), st.integers(-1, 9)),
    st.builds(Edit, ids, editors, st.integers(0, 4), st.binary(max_size=5), texts),
    st.builds(StoredDocument, kinds, texts, st.binary(max_size=5)),
    st.builds(DocumentRemoval, kinds, texts),
)


class AuthoredTables(Tables):
    """What a show file should hold, in plain dictionaries."""

    def copy(self) -> AuthoredTables:
        """Another with the same."""
        return AuthoredTables(**{name: dict(rows) for name, rows in vars(self).items()})

    def make(self, change: Change) -> bool:
        """Makes a change; False where it must be refused."""
        if isinstance(change, Revision) and (there := self.revisions.get((change.item, change.number))) is not None:
            return there == change
        self.apply([change])
        return True

    @property
    def whole(self) -> bool:
        """Whether everything belongs to something."""
        owned = all(row.item in self.items and row.content in self.contents for row in self.revisions.values())
        heads = all(not row.head or (row.id, row.head) in self.revisions for row in self.items.values())
        drafts = all(row.item in self.items for row in self.drafts.values())
        return owned and heads and drafts and all(key[:2] in self.drafts for key in self.edits)
