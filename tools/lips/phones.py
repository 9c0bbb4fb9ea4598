"""Which viseme a phone looks like by the names that festival's and flite's voices use."""

from __future__ import annotations

from omote.inputs.voices.phones import MARKS, Shapes

_RADIO = {  # of the English voices
    "PP": "p b m em",
    "FF": "f v",
    "TH": "th dh",
    "DD": "t d dx",
    "kk": "k g ng",
    "CH": "ch jh sh zh",
    "SS": "s z",
    "nn": "n l el en nx",
    "RR": "r er axr",
    "U": "w uw uh",
    "I": "y iy ih ix",
    "aa": "aa ae ah",
    "E": "eh ax",
    "O": "ao",
    "aa I": "ay",
    "E I": "ey",
    "O I": "oy",
    "O U": "ow",
    "aa U": "aw",
}
_LATIN = {  # of the other voices; what is missing stays without a viseme
    "PP": "p b m pp bb mm b^",
    "FF": "f v ff vv",
    "TH": "T D",
    "DD": "t d tt dd d' t' dy ty d^",
    "kk": "k g kk gg ng N x G kh gh",
    "CH": "ch dz^ c^ s^ z^ S Z sh zh tS dZ ts^ zz",
    "SS": "s z ts dz ss c",
    "nn": "n l nn ll n~ n* L J gn ny n^ ly",
    "RR": "r rr r^",
    "I": "j i I i1 yy y^",
    "U": "w u u1 U uu",
    "aa": "a a1 aa A",
    "E": "e e1 E E1 ax ee ae @",
    "O": "o o1 O O1 oo",
}
_CYRILLIC = {
    **_LATIN,
    "PP": "p pp b bb m mm",
    "FF": "f ff v vv",
    "DD": "t tt d dd",
    "kk": "k kk g gg h hh",
    "CH": "ch sh sch zh",
    "SS": "s ss z zz c",
    "nn": "n nn l ll",
    "RR": "r rr",
    "I": "i ii y yy j ae",
    "U": "u uu ur",
    "aa": "a aa",
    "E": "e ee ay",
    "O": "o oo",
}
"""ay and ae are the reduced vowels behind hard and soft consonants."""
_FINNISH = {**_LATIN, "U": "u y w", "O": "o 7", "aa": "a @", "E": "e", "I": "i j"}
_CZECH = {**_LATIN, "CH": "c~ s~ z~ r~ r~*", "SS": "s z c dz", "kk": "k g ch n*", "nn": "n l n~", "DD": "t d t~ d~"}


def _by_name(table: dict[str, str]) -> dict[str, Shapes]:
    return {name: tuple(shapes.split()) for shapes, names in table.items() for name in names.split()}


NAMED = {name: _by_name(table) for name, table in
         {"radio": _RADIO, "latin": _LATIN, "russian": _CYRILLIC, "finnish": _FINNISH,
          "czech": _CZECH}.items()}  # fmt: skip
SILENT = {"", "pau", "#", "sil", "brth", "_", "_:", "h#", "ssil"}


def shapes_of_name(phone_set: str, name: str) -> Shapes | None:
    """The visemes of a phone by its name in a voice's phone set ("radio", "latin", "russian", "finnish", "czech").

    phone_set: as above; name: in it.
    """
    if name in SILENT:
        return ("sil",)
    table = NAMED[phone_set]
    plain = name.rstrip(":")
    return table.get(plain) or table.get(plain.lower()) or (() if plain in ("h", "hh", "hv") else None)


_VOICELESS = tuple("p t k f s ʃ x h θ ç c q χ ħ ɕ ʂ hh th sh ch".split())
_VOICED_NAMES = ("dh", "jh", "zh")


def is_voiced(name: str) -> bool:
    """Whether vocal cords swing in a phone, by its name in IPA or in the English voices' phone set."""
    plain = MARKS.sub("", name)
    return plain not in SILENT and (plain in _VOICED_NAMES or not plain.startswith(_VOICELESS))
