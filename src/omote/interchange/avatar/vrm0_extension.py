"""The JSON of `VRM`, the extension of VRM 0.x, from that of 1.0: what the older one cannot say becomes the stricter.

VRM Consortium, specification/0.0: https://github.com/vrm-c/vrm-specification/tree/master/specification/0.0
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from omote.interchange.formats.glb_writer import Json

EXTENSION = "VRM"
PRESETS = {
    "happy": "joy", "angry": "angry", "sad": "sorrow", "relaxed": "fun", "neutral": "neutral",
    "aa": "a", "ih": "i", "ou": "u", "ee": "e", "oh": "o",
    "blink": "blink", "blinkLeft": "blink_l", "blinkRight": "blink_r",
    "lookUp": "lookup", "lookDown": "lookdown", "lookLeft": "lookleft", "lookRight": "lookright",
}  # fmt: skip
"""What 0.x calls the presets of 1.0; `surprised` is none there."""
OTHER = "unknown"
THUMBS = {
    f"{side}Thumb{new}": f"{side}Thumb{old}"
    for side in ("left", "right")
    for new, old in (("Metacarpal", "Proximal"), ("Proximal", "Intermediate"))
}
"""What 0.x calls the bones of thumbs, which begin at the hand there too."""
USERS = {
    "onlyAuthor": "OnlyAuthor",
    "onlySeparatelyLicensedPerson": "ExplicitlyLicensedPerson",
    "everyone": "Everyone",
}
STRAIGHT = [0, 0, 0, 1, 1, 1, 1, 0]
"""A curve of Unity from (0, 0) to (1, 1): place, value and both slopes of each end."""
FULL = 100
"""A weight of 1."""
_HUMANOID = {
    "armStretch": 0.05, "legStretch": 0.05, "upperArmTwist": 0.5, "lowerArmTwist": 0.5, "upperLegTwist": 0.5,
    "lowerLegTwist": 0.5, "feetSpacing": 0, "hasTranslationDoF": False,
}  # fmt: skip
"""Unity's own defaults."""


def describe_vrm0(vrm: Json, materials: Iterable[str], generator: str, /) -> Json:
    """The extension of 0.x that says what one of 1.0 says; meshes stand at the nodes from 1 on, in their order.

    vrm: the JSON of 1.0; materials: their names, in order; generator: which program wrote it.
    """
    bones = vrm["humanoid"]["humanBones"]
    joints = [
        {"bone": THUMBS.get(name, name), "node": bone["node"], "useDefaultValues": True} for name, bone in bones.items()
    ]
    presets = vrm["expressions"]["preset"]
    customs = vrm["expressions"]["custom"]
    named = list(materials)
    groups = [_group(name, PRESETS.get(name, OTHER), expression, named) for name, expression in presets.items()]
    groups += [_group(name, OTHER, expression, named) for name, expression in customs.items()]
    return {
        "exporterVersion": generator,
        "specVersion": "0.0",
        "meta": _meta(vrm["meta"]),
        "humanoid": {"humanBones": joints, **_HUMANOID},
        "firstPerson": _first_person(vrm, bones["head"]["node"]),
        "blendShapeMaster": {"blendShapeGroups": groups},
        "secondaryAnimation": {"boneGroups": [], "colliderGroups": []},
        "materialProperties": [_material(name) for name in named],
    }


def _meta(meta: Json) -> Json:
    """0.x knows who may use a model, three uses, and licences of Creative Commons: all else is a prohibition."""
    free = "otherLicenseUrl" in meta
    return {
        "title": meta["name"],
        "version": "",
        "author": ", ".join(meta["authors"]),
        "contactInformation": "",
        "reference": meta["copyrightInformation"],
        "allowedUserName": USERS[meta["avatarPermission"]],
        "violentUssageName": _allowed(meta["allowExcessivelyViolentUsage"]),
        "sexualUssageName": _allowed(meta["allowExcessivelySexualUsage"]),
        "commercialUssageName": _allowed(meta["commercialUsage"] == "corporation"),
        "otherPermissionUrl": "",
        "licenseName": "CC0" if free else "Redistribution_Prohibited",
        "otherLicenseUrl": "",
    }


def _allowed(allowed: bool) -> str:
    return "Allow" if allowed else "Disallow"


def _group(name: str, preset: str, expression: Json, materials: Sequence[str]) -> Json:
    binds = [
        {"mesh": bind["node"] - 1, "index": bind["index"], "weight": round(FULL * bind["weight"], 4)}
        for bind in expression.get("morphTargetBinds", [])
    ]
    values = [
        {"materialName": materials[bind["material"]], "propertyName": "_Color", "targetValue": bind["targetValue"]}
        for bind in expression.get("materialColorBinds", [])
    ]
    alike = preset in (OTHER, name.lower())
    called = name[0].upper() + name[1:] if alike else preset.title()  # LookUp, Joy, A, Blink_L, as programs ask
    return {"name": called, "presetName": preset, "binds": binds, "materialValues": values, "isBinary": False}


def _first_person(vrm: Json, head: int) -> Json:
    """What a model sees of itself, and its gaze; forward is +z of Unity here, though the model looks along -z."""
    annotated = vrm["firstPerson"]["meshAnnotations"]
    gaze = vrm.get("lookAt", {})
    view: Json = {
        "firstPersonBone": head,
        "firstPersonBoneOffset": dict(zip("xyz", gaze.get("offsetFromHeadBone", (0.0, 0.0, 0.0)), strict=True)),
        "meshAnnotations": [
            {"mesh": annotation["node"] - 1, "firstPersonFlag": _capital(annotation["type"])}
            for annotation in annotated
        ],
        "lookAtTypeName": "BlendShape",
    }
    for name in ("HorizontalInner", "HorizontalOuter", "VerticalDown", "VerticalUp"):
        reach = gaze.get(f"rangeMap{name}", {"inputMaxValue": 90.0, "outputScale": 0.0})
        view[f"lookAt{name}"] = {"curve": STRAIGHT, "xRange": reach["inputMaxValue"], "yRange": reach["outputScale"]}
    return view


def _capital(word: str) -> str:
    return word[0].upper() + word[1:]


def _material(name: str) -> Json:
    """A material that is as glTF says."""
    empty: Json = {f"{kind}Properties": {} for kind in ("float", "vector", "texture")}
    empty |= {"keywordMap": {}, "tagMap": {}}
    return {"name": name, "renderQueue": 2000, "shader": "VRM_USE_GLTFSHADER", **empty}


def unity_name(bone: str) -> str:
    """Unity's name (`HumanBodyBones`, as VMC and VRM 0.x have it) for a bone of VRM 1.0: the thumb's are others."""
    name = THUMBS.get(bone, bone)
    return name[0].upper() + name[1:]
