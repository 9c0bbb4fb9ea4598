"""Surfaces of USD stages: UsdPreviewSurface materials that show our painted pictures."""

from __future__ import annotations

from typing import Any

from omote.interchange.formats.glb_writer import Material

COORDINATES = "st"
"""The primvar that holds texture coordinates, as all programs read it."""


def add_material(stage: Any, path: str, material: Material, picture: str) -> Any:
    """Adds a UsdPreviewSurface material at a path of a stage; picture: the file of its picture, "" for none."""
    from pxr import Sdf, UsdShade

    made = UsdShade.Material.Define(stage, path)
    shader = _shader(stage, f"{path}/surface", "UsdPreviewSurface")
    made.CreateSurfaceOutput().ConnectToSource(shader.CreateOutput("surface", Sdf.ValueTypeNames.Token))
    shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(material.roughness)
    shader.CreateInput("metallic", Sdf.ValueTypeNames.Float).Set(0.0)
    colour = shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f)
    if not picture:
        colour.Set(material.colour)
        return made
    texture = _texture(stage, path, picture)
    colour.ConnectToSource(texture.CreateOutput("rgb", Sdf.ValueTypeNames.Float3))
    if material.cut is not None:
        opacity = shader.CreateInput("opacity", Sdf.ValueTypeNames.Float)
        opacity.ConnectToSource(texture.CreateOutput("a", Sdf.ValueTypeNames.Float))
        shader.CreateInput("opacityThreshold", Sdf.ValueTypeNames.Float).Set(material.cut)
    return made


def _texture(stage: Any, path: str, picture: str) -> Any:
    """The shader that reads a picture at the texture coordinates."""
    from pxr import Sdf

    reader = _shader(stage, f"{path}/coordinates", "UsdPrimvarReader_float2")
    reader.CreateInput("varname", Sdf.ValueTypeNames.String).Set(COORDINATES)
    texture = _shader(stage, f"{path}/picture", "UsdUVTexture")
    texture.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(Sdf.AssetPath(picture))
    texture.CreateInput("sourceColorSpace", Sdf.ValueTypeNames.Token).Set("sRGB")
    for wrap in ("wrapS", "wrapT"):
        texture.CreateInput(wrap, Sdf.ValueTypeNames.Token).Set("clamp")
    place = texture.CreateInput("st", Sdf.ValueTypeNames.Float2)
    place.ConnectToSource(reader.CreateOutput("result", Sdf.ValueTypeNames.Float2))
    return texture


def _shader(stage: Any, path: str, kind: str) -> Any:
    from pxr import UsdShade

    shader = UsdShade.Shader.Define(stage, path)
    shader.CreateIdAttr(kind)
    return shader
