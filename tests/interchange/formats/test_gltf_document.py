"""The JSON of a GLB: names as glTF spells them, and what is no document."""

import pytest

from omote.interchange.formats import gltf_document
from omote.interchange.formats.gltf_document import Document, parse_document, parse_document_as, shown_nodes


def test_names_are_those_of_the_format_and_others_are_passed_over() -> None:
    text = b'{"asset":{"version":"2.0"},"bufferViews":[{"buffer":0,"byteLength":8,"byteStride":4,"target":34962}]}'
    (view,) = parse_document(text).buffer_views
    assert (view.buffer, view.byte_length, view.byte_stride, view.byte_offset) == (0, 8, 4, 0)


@pytest.mark.parametrize("text", [b"", b"[]", b'{"nodes":{}}', b'{"nodes":[{"mesh":-1}]}', b'{"nodes":[{"mesh":NaN}]}'])
def test_what_is_no_document_is_refused(text: bytes) -> None:
    with pytest.raises(ValueError, match="no glTF document"):
        parse_document(text)


def test_a_document_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gltf_document, "LARGEST_JSON", 10)
    with pytest.raises(ValueError, match="11 bytes; expected 10 at most"):
        parse_document(b"{         }")


def test_the_chosen_scene_is_shown_with_all_below_it() -> None:
    text = b'{"nodes":[{"children":[2]},{},{},{"children":[3]}],"scenes":[{"nodes":[1]},{"nodes":[0,3,9]}],"scene":1}'
    assert shown_nodes(parse_document_as(Document, text)) == {0, 2, 3}
    assert shown_nodes(parse_document_as(Document, b'{"nodes":[{},{}]}')) == {0, 1}
