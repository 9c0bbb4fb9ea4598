"""Other scripts in Latin letters: kana as they sound, vowels that nobody writes, a letter for a letter."""

import pytest

from omote.perform.speech.romanization import is_latin, is_mark, romanize


@pytest.mark.parametrize(
    ("word", "latin"),
    [
        ("きゃく", "kyaku"), ("しゃ", "sha"), ("ちょ", "cho"), ("がっこう", "gakou"),
        ("スーパー", "suupaa"), ("ティ", "ti"),
        ("パーティー", "paatii"), ("日本語", "ribenyu"), ("Щука", "shchuka"), ("ψυχή", "psychi"), ("안녕", "annyeong"),
        ("שלום", "salavam"), ("सत्य", "saty"), ("สวัสดี", "swasadi"), ("ქართული", "kartuli"),
    ],
)  # fmt: skip
def test_words_are_written_as_they_sound(word: str, latin: str) -> None:
    assert "".join(romanize(word)) == latin


def test_each_letter_has_its_own_place() -> None:
    for word in ("きゃく", "नमस्ते", "مرحبا", "한국어"):
        assert len(romanize(word)) == len(word)


def test_latin_letters_and_marks_are_known() -> None:
    assert all(is_latin(each) for each in "aÄøł\uff21")
    assert not any(is_latin(each) for each in "жあא")
    assert is_mark("\u0301")
    assert is_mark("ि")
    assert not is_mark("a")
