"""Surfaces in USD: the picture is read at the texture coordinates, and alpha cuts holes where the glTF's does."""

from typing import Any

import pytest
from pxr import Usd, UsdShade

from omote.interchange.exports.usd_writer import COORDINATES, add_material
from omote.interchange.formats.glb_writer import Material


def made(stage: Any, material: Material, picture: str) -> Any:
    """The surface of a material on a stage."""
    return add_material(stage, "/skin", material, picture).ComputeSurfaceSource()[0]


def value(shader: Any, name: str) -> Any:
    """The value of an input."""
    return shader.GetInput(name).Get()


@pytest.mark.parametrize("cut", [None, 0.0, 0.5])
def test_a_picture_is_read_at_the_texture_coordinates(cut: float | None) -> None:
    stage = Usd.Stage.CreateInMemory()  # a prim does not outlive its stage
    surface = made(stage, Material("skin", b"png", roughness=0.25, cut=cut), "./face.skin.png")
    assert (surface.GetIdAttr().Get(), value(surface, "metallic")) == ("UsdPreviewSurface", 0.0)
    assert value(surface, "roughness") == pytest.approx(0.25)
    source, channel, _ = surface.GetInput("diffuseColor").GetConnectedSource()
    texture = UsdShade.Shader(source.GetPrim())
    assert (channel, value(texture, "file").path) == ("rgb", "./face.skin.png")
    assert (value(texture, "sourceColorSpace"), value(texture, "wrapS")) == ("sRGB", "clamp")
    reader = UsdShade.Shader(texture.GetInput("st").GetConnectedSource()[0].GetPrim())
    assert value(reader, "varname") == COORDINATES
    opacity = surface.GetInput("opacity")
    assert bool(opacity) == (cut is not None)
    if cut is not None:
        source, channel, _ = opacity.GetConnectedSource()
        assert (source.GetPrim(), channel) == (texture.GetPrim(), "a")
        assert value(surface, "opacityThreshold") == cut


def test_without_a_picture_it_has_its_colour() -> None:
    stage = Usd.Stage.CreateInMemory()  # a prim does not outlive its stage
    surface = made(stage, Material("paint", colour=(0.25, 0.5, 1.0)), "")
    assert value(surface, "diffuseColor") == (0.25, 0.5, 1.0)
    assert not surface.GetInput("diffuseColor").HasConnectedSource()
