"""Writes USD: a face as a UsdSkel character whose blend shapes are the morph targets of its scene.

UsdSkel (OpenUSD, "Skinning a Skeleton", "Blend Shapes"): below a SkelRoot lie a skeleton (the head or a figure's bones,
and a joint for each eyeball), an animation that holds one weight for each expression, and meshes bound to joints
(`usd_skeleton`). A mesh names only the shapes that move it; each holds only the vertices that move. Surfaces are
UsdPreviewSurface materials that show our painted pictures.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.interchange.exports.identifiers import identifiers
from omote.interchange.exports.usd_skeleton import SkeletonJoints, add_poses, add_skeleton, bind_joints, find_joints
from omote.interchange.formats.glb_writer import GENERATOR, ROWS, ExportScene, Material, MorphTarget, Shape

Files = dict[str, bytes]

COORDINATES = "st"
"""The primvar that holds texture coordinates, as all programs read it."""
NEEDS_USD = 'USD is written with the package usd-core: pip install "omote[usd]", or export GLB (.glb)'
_MADE = 320000000
"""Seconds since 1970: in 1980, where the calendar of ZIP begins."""
ORIGINAL = "omote:name"
"""The key of a prim's custom data that holds its name as it is in the cast, where identifiers cannot spell it."""


def add_material(stage: Any, path: str, material: Material, picture: str, relief: str = "") -> Any:
    """Adds a UsdPreviewSurface material at a path of a stage.

    picture, relief: the files of its picture and of its normals, "" for none.
    """
    from pxr import Sdf, UsdShade

    prim = UsdShade.Material.Define(stage, path)
    shader = _shader(stage, f"{path}/surface", "UsdPreviewSurface")
    prim.CreateSurfaceOutput().ConnectToSource(shader.CreateOutput("surface", Sdf.ValueTypeNames.Token))
    shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(material.roughness)
    shader.CreateInput("metallic", Sdf.ValueTypeNames.Float).Set(0.0)
    colour = shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f)
    if not picture:
        colour.Set(material.colour)
        return prim
    texture = _texture(stage, path, "picture", picture)
    if relief:
        normals = _texture(stage, path, "relief", relief, "raw")
        normals.CreateInput("scale", Sdf.ValueTypeNames.Float4).Set((2.0, 2.0, 2.0, 1.0))
        normals.CreateInput("bias", Sdf.ValueTypeNames.Float4).Set((-1.0, -1.0, -1.0, 0.0))
        shader.CreateInput("normal", Sdf.ValueTypeNames.Normal3f).ConnectToSource(
            normals.CreateOutput("rgb", Sdf.ValueTypeNames.Float3)
        )
    colour.ConnectToSource(texture.CreateOutput("rgb", Sdf.ValueTypeNames.Float3))
    if material.cut is not None:
        opacity = shader.CreateInput("opacity", Sdf.ValueTypeNames.Float)
        opacity.ConnectToSource(texture.CreateOutput("a", Sdf.ValueTypeNames.Float))
        shader.CreateInput("opacityThreshold", Sdf.ValueTypeNames.Float).Set(material.cut)
    return prim


def _texture(stage: Any, path: str, name: str, picture: str, colours: str = "sRGB") -> Any:
    """The shader that reads a picture at the texture coordinates; name: its own; colours: what the numbers are."""
    from pxr import Sdf

    reader = _shader(stage, f"{path}/coordinates", "UsdPrimvarReader_float2")
    reader.CreateInput("varname", Sdf.ValueTypeNames.String).Set(COORDINATES)
    texture = _shader(stage, f"{path}/{name}", "UsdUVTexture")
    texture.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(Sdf.AssetPath(picture))
    texture.CreateInput("sourceColorSpace", Sdf.ValueTypeNames.Token).Set(colours)
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


def has_usd() -> bool:
    """Whether the package that writes USD is installed; it is not loaded, for it is large."""
    return find_spec("pxr") is not None


def check_usd() -> None:
    """Raises ValueError that says what to install where USD cannot be written here."""
    try:
        import pxr.Usd  # noqa: F401
    except ImportError as error:
        raise ValueError(NEEDS_USD) from error


def usd_files(scene: ExportScene, stem: str, /, suffix: str) -> Files:
    """Encodes a scene as USD: the file STEM.SUFFIX first; unless it is a package (.usdz), then its pictures.

    ValueError where usd-core is not installed.

    scene: of one face; stem: of the files' names; suffix: .usdc, .usda or .usdz.
    """
    check_usd()
    pictures = {f"{stem}.{name}.png": data for name, data in _pictures(scene).items()}
    with tempfile.TemporaryDirectory(prefix="omote-") as folder:
        path = Path(folder) / f"{stem}{'.usdc' if suffix == '.usdz' else suffix}"
        stage = build_stage(scene, stem)  # a layer does not outlive its stage
        stage.GetRootLayer().Export(str(path))
        if suffix != ".usdz":
            return {path.name: path.read_bytes(), **pictures}
        for name, data in pictures.items():
            (path.parent / name).write_bytes(data)
        return {f"{stem}.usdz": _package(path, pictures)}


def build_stage(scene: ExportScene, stem: str, /) -> Any:
    """Builds the stage (pxr.Usd.Stage) of a scene; stem: what the files of its pictures begin with."""
    from pxr import Usd, UsdGeom, UsdShade, UsdSkel

    stage = Usd.Stage.CreateInMemory()
    top = "/" + identifiers([scene.name])[scene.name]
    root = UsdSkel.Root.Define(stage, top)
    _describe(stage, root.GetPrim(), scene)
    names = identifiers(scene.shapes[0].targets if scene.shapes else [])
    joints = find_joints(scene)
    add_skeleton(stage, top, joints, list(names.values()))
    if scene.rig is not None:
        for pose, prim in add_poses(stage, top, joints, scene.rig.motions).items():
            _name(prim, pose)
    surfaces = _surfaces(stage, top, scene, stem)
    boxes = [_box(shape) for shape in scene.shapes] or [np.zeros((2, 3), np.float32)]
    for shape, box in zip(scene.shapes, boxes, strict=False):
        mesh = _mesh(stage, top, shape, box)
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(surfaces[id(shape.material)])
        _bind(stage, mesh, shape, joints, names)
    UsdGeom.Boundable(root).CreateExtentAttr(_extent(np.stack([np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]])))
    return stage


def _describe(stage: Any, root: Any, scene: ExportScene) -> None:
    """What programs ask a stage first: its unit, its axes, its root; and whose it is."""
    from pxr import UsdGeom

    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetDefaultPrim(root)
    _name(root, scene.name)
    layer = stage.GetRootLayer()
    layer.documentation = str(scene.extras.get("notice", ""))
    layer.customLayerData = {"generator": GENERATOR, **{key: str(value) for key, value in scene.extras.items()}}


def _surfaces(stage: Any, top: str, scene: ExportScene, stem: str) -> dict[int, Any]:
    """The material of each mesh, by the identity of ours."""
    from pxr import UsdGeom

    UsdGeom.Scope.Define(stage, f"{top}/materials")
    materials = {id(shape.material): shape.material for shape in scene.shapes}
    return {
        key: add_material(
            stage,
            f"{top}/materials/{material.name}",
            material,
            f"./{stem}.{material.name}.png" if material.picture else "",
            f"./{stem}.{material.name}_relief.png" if material.relief else "",
        )
        for key, material in materials.items()
    }


def _name(prim: Any, name: str) -> None:
    """Keeps the name as it is in the cast beside the identifier."""
    if prim.GetName() != name:
        prim.SetDisplayName(name)
    prim.SetCustomDataByKey(ORIGINAL, name)


def _mesh(stage: Any, top: str, shape: Shape, box: NDArray[np.float32]) -> Any:
    """A mesh in the skeleton's space."""
    from pxr import Sdf, UsdGeom, Vt

    mesh = UsdGeom.Mesh.Define(stage, f"{top}/{shape.name}")
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(_points(shape)))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(shape.triangles), 3, np.int32)))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(shape.triangles.astype(np.int32).ravel()))
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(_contiguous(shape.normals)))
    mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    mesh.CreateDoubleSidedAttr(shape.material.both)
    mesh.CreateExtentAttr(_extent(box))
    _primvars(UsdGeom.PrimvarsAPI(mesh), shape, Sdf.ValueTypeNames)
    return mesh


def _bind(stage: Any, mesh: Any, shape: Shape, joints: SkeletonJoints, names: Mapping[str, str]) -> None:
    """Binds a mesh to its joints, with the blend shapes that move it."""
    from pxr import Vt

    binding = bind_joints(mesh, joints, shape.name)
    moved = {name: rows for name, target in shape.targets.items() if len(rows := _moved_rows(target))}
    blend_shapes = [
        _blend_shape(stage, f"{mesh.GetPath()}/{names[name]}", name, shape.targets[name], rows)
        for name, rows in moved.items()
    ]
    if blend_shapes:
        binding.CreateBlendShapesAttr(Vt.TokenArray([names[name] for name in moved]))
        binding.CreateBlendShapeTargetsRel().SetTargets(blend_shapes)


def _primvars(variables: Any, shape: Shape, types: Any) -> None:
    """Texture coordinates, upwards from below; which vertex of the cast each is, and what is left of the light."""
    from pxr import UsdGeom, Vt

    upwards = np.stack([shape.uv[:, 0], 1.0 - shape.uv[:, 1]], axis=1).astype(np.float32)
    primvar = variables.CreatePrimvar(COORDINATES, types.TexCoord2fArray, UsdGeom.Tokens.vertex)
    primvar.Set(Vt.Vec2fArray.FromNumpy(upwards))
    if shape.rows is not None:
        primvar = variables.CreatePrimvar(ROWS, types.IntArray, UsdGeom.Tokens.vertex)
        primvar.Set(Vt.IntArray.FromNumpy(shape.rows.astype(np.int32)))
    if shape.shade is not None:
        primvar = variables.CreatePrimvar("shade", types.FloatArray, UsdGeom.Tokens.vertex)
        primvar.Set(Vt.FloatArray.FromNumpy(_contiguous(shape.shade)))


def _moved_rows(target: MorphTarget) -> NDArray[np.int32]:
    """The vertices that move or turn."""
    return np.flatnonzero(target.moves.any(axis=1) | target.turns.any(axis=1)).astype(np.int32)


def _blend_shape(stage: Any, path: str, name: str, target: MorphTarget, rows: NDArray[np.int32]) -> Any:
    """A blend shape of some vertices alone; returns its path."""
    from pxr import UsdSkel, Vt

    blend_shape = UsdSkel.BlendShape.Define(stage, path)
    blend_shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(_contiguous(target.moves[rows])))
    blend_shape.CreateNormalOffsetsAttr(Vt.Vec3fArray.FromNumpy(_contiguous(target.turns[rows])))
    blend_shape.CreatePointIndicesAttr(Vt.IntArray.FromNumpy(rows))
    _name(blend_shape.GetPrim(), name)
    return blend_shape.GetPath()


def _points(shape: Shape) -> NDArray[np.float32]:
    return _contiguous(shape.points + np.asarray(shape.place, np.float32))


def _contiguous(values: NDArray[np.floating]) -> NDArray[np.float32]:
    return np.ascontiguousarray(values, np.float32)


def _box(shape: Shape) -> NDArray[np.float32]:
    """The box (2, 3) around a mesh at rest and in every target, as USD's programs frame and cull it."""
    points = _points(shape)
    low = points.T.min(axis=1)
    high = points.T.max(axis=1)
    for target in shape.targets.values():
        rows = np.flatnonzero(target.moves.any(axis=1))
        moved = (points[rows] + target.moves[rows]).T.copy()  # rows of numbers side by side are summed up faster
        low = np.minimum(low, moved.min(axis=1, initial=np.inf))
        high = np.maximum(high, moved.max(axis=1, initial=-np.inf))
    return np.stack([low, high])


def _extent(box: NDArray[np.float32]) -> Any:
    from pxr import Vt

    return Vt.Vec3fArray.FromNumpy(_contiguous(box))


def _pictures(scene: ExportScene) -> dict[str, bytes]:
    """The pictures (PNG) of a scene's materials, by the material's name, and of their normals."""
    pictures = {shape.material.name: shape.material.picture for shape in scene.shapes}
    pictures |= {f"{shape.material.name}_relief": shape.material.relief for shape in scene.shapes}
    return {name: picture for name, picture in pictures.items() if picture is not None}


def _package(path: Path, pictures: Iterable[str]) -> bytes:
    """A package (USDZ) of a stage and its pictures, without compression, as the format wants it."""
    from pxr import Sdf

    package = path.with_suffix(".usdz")
    with Sdf.ZipFileWriter.CreateNew(str(package)) as writer:
        for name in (path.name, *pictures):
            os.utime(path.parent / name, (_MADE, _MADE))  # it writes this down, and the same face is the same bytes
            writer.AddFile(str(path.parent / name), name)
    return package.read_bytes()
