"""Accessors of several buffers, and entries that a document names."""

import numpy as np
import pytest

from omote.interchange.formats.gltf_document import AccessorReader, entry, parse_document

TEXT = (
    b'{"buffers":[{"byteLength":4},{"byteLength":16}],"bufferViews":[{"buffer":1,"byteOffset":4,"byteLength":12}],'
    b'"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":1}]}'
)


def test_numbers_come_from_the_buffer_that_the_view_names() -> None:
    second = b"skip" + np.array([1.5, -2.0, 8.0], "<f4").tobytes()
    reader = AccessorReader(parse_document(TEXT), (b"none", second))
    np.testing.assert_array_equal(reader.numbers(0, 3, "it"), [[1.5, -2.0, 8.0]])
    with pytest.raises(ValueError, match="buffer view 0 does not hold the 1 values"):
        AccessorReader(parse_document(TEXT), (b"none",)).numbers(0, 3, "it")


def test_an_entry_that_is_not_there_is_named() -> None:
    assert entry("ab", 1, "letter") == "b"
    with pytest.raises(ValueError, match="speaks of letter 2 and has 2"):
        entry("ab", 2, "letter")
