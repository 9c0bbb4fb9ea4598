"""Headers of PLY files: elements, properties, texture."""

from omote.interchange.scans.ply_reader import Element, Property, parse_header

TEXT = (
    b"ply\r\nformat binary_big_endian 1.0\r\ncomment by hand\r\ncomment TextureFile my head.png\r\nobj_info x\r\n"
    b"element vertex 3\r\nproperty float x\r\nproperty uchar red\r\nelement face 1\r\n"
    b"property list uchar int vertex_indices\r\nend_header\r\n"
)


def test_a_header_is_read_with_either_end_of_line() -> None:
    for data in (TEXT, TEXT.replace(b"\r\n", b"\n"), TEXT.replace(b"\r\n", b"\r")):
        header = parse_header(data + b"abc")
        assert (header.order, header.textures) == (">", ("my head.png",))
        assert header.elements == [
            Element("vertex", 3, [Property("x", "f4"), Property("red", "u1")]),
            Element("face", 1, [Property("vertex_indices", "i4", "u1")]),
        ]
        assert (data + b"abc")[header.body :] == b"abc"
