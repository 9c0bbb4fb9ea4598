"""The nodes that a viewer shows."""

from omote.interchange.formats.gltf_document import parse_document_as
from omote.interchange.scans.gltf_scan import SceneDocument, shown_nodes


def test_the_chosen_scene_is_shown_with_all_below_it() -> None:
    text = b'{"nodes":[{"children":[2]},{},{},{"children":[3]}],"scenes":[{"nodes":[1]},{"nodes":[0,3,9]}],"scene":1}'
    assert shown_nodes(parse_document_as(SceneDocument, text)) == {0, 2, 3}
    assert shown_nodes(parse_document_as(SceneDocument, b'{"nodes":[{},{}]}')) == {0, 1}
