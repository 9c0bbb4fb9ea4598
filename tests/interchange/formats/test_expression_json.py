"""Expressions as JSON: number for number there and back, and nothing that no head could do."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.formats import expression_json
from omote.interchange.formats.expression_json import (
    Control,
    ExpressionFile,
    decode,
    encode,
    from_dense,
    schema,
    space_digest,
    to_dense,
)
from omote.model.cast import Cast
from omote.model.space.complexion import Complexion
from omote.model.space.expression import Expression
from tests import synthetic

SCHEMA = Path(__file__).parents[3] / "docs" / "expression.schema.json"


def document(**changes: Any) -> ExpressionFile:
    """A document of the synthetic smile."""
    smile = synthetic.cast().expressions["smile"]
    whole = {"label": "smile", "tags": ["mouth"], "space": space_digest(synthetic.space()), "dense": to_dense(smile)}
    return ExpressionFile(omote="expression", version=1, **{**whole, **changes})


def moved(expression: Expression, part: str) -> bool:
    """Whether an expression moves a part of itself."""
    return part in expression.parts and bool(expression.parts[part].any())


def same(one: Expression, other: Expression) -> bool:
    """Whether two expressions are the same in every number."""
    fields = ("dtheta", "dh", "ratio", "residual", "eyes", "ears", "head", "complexion")
    parts = {*one.parts, *other.parts}
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in fields) and all(
        not (moved(one, name) or moved(other, name)) or np.array_equal(one.parts[name], other.parts[name])
        for name in parts
    )


def test_turns_of_ears_and_head_and_blood_come_back_and_are_left_out_where_there_are_none(cast: Cast) -> None:
    still = cast.expressions["smile"]
    turning = replace(still, ears=np.arange(6.0).reshape(2, 3) / 10, head=np.array([0.1, -0.2, 0.3]))
    turning = replace(turning, complexion=Complexion(0.5, 0.0, -0.25, 1.0, 0.1, 1.0, 0.5))
    read = decode(encode(document(dense=to_dense(turning)))).dense
    assert read is not None
    assert same(from_dense(cast.space, read), turning)
    plain = encode(document(dense=to_dense(still)))
    assert b'"ears"' not in plain
    assert b'"complexion"' not in plain


@pytest.mark.parametrize("name", synthetic.EXPRESSIONS)
def test_an_expression_comes_back_in_every_number(name: str, cast: Cast) -> None:
    expression = cast.expressions[name]
    read = decode(encode(document(dense=to_dense(expression)))).dense
    assert read is not None
    assert same(from_dense(cast.space, read), expression)


@given(st.lists(st.tuples(st.floats(-7, 7), st.floats(-10, 10), st.floats(1e-3, 100)), min_size=1, max_size=5))
def test_control_points_come_back_in_every_number(vectors: list[tuple[float, float, float]]) -> None:
    control = Control(points=[(theta, h) for theta, h, _ in vectors], vectors=vectors)
    assert decode(encode(document(control=control, dense=None))).control == control


def test_the_schema_in_the_docs_is_that_of_the_code() -> None:
    assert SCHEMA.read_bytes() == schema(), "run `python -m tools.schema`"


def test_documents_are_as_the_schema_says(cast: Cast) -> None:
    rules = json.loads(schema())
    plain = json.loads(encode(document(control=Control([(0.0, 0.1)], [(0.0, 0.0, 1.0)]))))
    assert set(rules["$defs"]["ExpressionFile"]["required"]) <= plain.keys()
    assert plain.keys() <= rules["$defs"]["ExpressionFile"]["properties"].keys()
    assert plain["dense"].keys() == rules["$defs"]["Dense"]["properties"].keys() - {"ears", "head", "complexion"}
    assert rules["$defs"]["ExpressionFile"]["additionalProperties"] is False


WRONG = {
    "NaN": (b'"pupil": 0.0', b'"pupil": NaN'),
    "no end": (b'"pupil": 0.0', b'"pupil": 1e999'),
    "too wide a pupil": (b'"pupil": 0.0', b'"pupil": 11'),
    "another version": (b'"version": 1', b'"version": 2'),
    "something else": (b'"omote": "expression"', b'"omote": "face"'),
    "unknown": (b'"version": 1', b'"version": 1, "script": "x"'),
    "no label": (b'"label": "smile"', b'"label": ""'),
    "a row below all": (b'"rows": [', b'"rows": [-1, '),
    "a row beyond all": (b'"rows": [', b'"rows": [9999999999, '),
    "a strange head": (space_digest(synthetic.space()).encode(), b"../../secrets"),
    "cut short": (b"}\n", b""),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_no_document_is_refused(name: str) -> None:
    data = encode(document())
    before, after = WRONG[name]
    assert before in data
    with pytest.raises(ValueError, match=r"expected an expression of Omote as docs/exchange\.md has it"):
        decode(data.replace(before, after, 1))


def test_rows_that_do_not_belong_together_are_refused(cast: Cast) -> None:
    dense = to_dense(cast.expressions["jawOpen"])
    inner = int(np.flatnonzero(~cast.space.on_sheet)[0])
    for rows, sentence in (
        (dense.sheet.rows[1:], "differ in number"),
        ([dense.sheet.rows[0], *dense.sheet.rows[:-1]], "each once"),
        ([cast.space.vertex_count, *dense.sheet.rows[1:]], "each once"),
        ([inner, *dense.sheet.rows[1:]], "rows of inner skin"),
    ):
        sheet = msgspec.structs.replace(dense.sheet, rows=rows)
        with pytest.raises(ValueError, match=sentence):
            from_dense(cast.space, msgspec.structs.replace(dense, sheet=sheet))
    strange = msgspec.structs.replace(dense, parts={"trunk": dense.inner})
    with pytest.raises(ValueError, match="moves a part 'trunk'; expected some of eye_left"):
        from_dense(cast.space, strange)


def test_a_document_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(expression_json, "LARGEST", 10)
    with pytest.raises(ValueError, match="expected 10 at most"):
        decode(b" " * 11)


def test_the_digest_is_that_of_one_head_under_one_rule() -> None:
    space = synthetic.space()
    assert space_digest(space) == space_digest(space)
    assert space_digest(space.under("paper")) != space_digest(space)
