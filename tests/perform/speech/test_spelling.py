"""Letters to visemes: English, German, every other script, numbers and signs."""

import sys
import unicodedata

import pytest

from omote.perform.speech.number_words import Language
from omote.perform.speech.spelling import LANGUAGES, check_language, sounds_of, words_in


def _shapes(word: str, language: Language = "en") -> str:
    return " ".join(sound.viseme for sound in sounds_of(word, language))


@pytest.mark.parametrize(
    ("word", "shapes"),
    [
        ("make", "PP E I kk"), ("five", "FF aa I FF"), ("night", "nn aa I DD"), ("phone", "FF O U nn"),
        ("through", "TH RR U"), ("knife", "nn aa I FF"), ("bubble", "PP aa PP nn"), ("nation", "nn E I CH O nn"),
        ("speech", "SS PP I CH"), ("the", "TH aa"), ("queen", "kk U I nn"), ("Hello", "E nn O U"),
        ("comb", "kk O PP"), ("stopped", "SS DD O PP DD"), ("I'm", "aa I PP"), ("42", "FF O RR DD I DD U"),
        ("3.5", "TH RR I PP O I nn DD FF aa I FF"), ("%", "PP RR SS E nn DD"), ("naïve", "nn E I FF"),
        ("\uff28\uff49", "I"), ("Ø", "O"), ("²", "DD U"),
    ],
)  # fmt: skip
def test_english_words_are_spoken_as_they_sound(word: str, shapes: str) -> None:
    assert _shapes(word) == shapes


@pytest.mark.parametrize(
    ("word", "shapes"),
    [
        ("Straße", "CH DD kk aa SS E"), ("Pfeffer", "PP FF E FF aa"), ("Bäume", "PP O I PP E"), ("ich", "I I"),
        ("Puppe", "PP U PP E"), ("Wasser", "FF aa SS aa"), ("Zeit", "DD SS aa I DD"), ("schön", "CH O nn"),
        ("Bühne", "PP U nn E"), ("acht", "aa kk DD"), ("vier", "FF I aa"), ("2", "DD SS FF aa I"),
    ],
)  # fmt: skip
def test_german_words_are_spoken_as_they_sound(word: str, shapes: str) -> None:
    assert _shapes(word, "de") == shapes


@pytest.mark.parametrize("language", ["en", "de"])
def test_every_letter_of_the_alphabet_closes_lips_where_it_must(language: Language) -> None:
    for letter in "bmp":
        assert "PP" in _shapes(f"a{letter}a", language)
    for letter in "fv":
        assert "FF" in _shapes(f"a{letter}a", language)


def test_a_sound_knows_its_letters() -> None:
    for word in ("thought", "hello", "7up", "bubble's", "3.5", "1984", "नमस्ते", "きゃ", "日本"):
        sounds = sounds_of(word, "en")
        places = [(sound.first, sound.last) for sound in sounds]
        assert places == sorted(places)
        assert all(0 <= first <= last <= len(word) for first, last in places)


@pytest.mark.parametrize(
    ("word", "shapes"),
    [
        ("Привет", "PP RR I FF E DD"), ("Ελληνικά", "E nn I nn I kk aa"), ("日本", "RR I PP E nn"),
        ("こんにちは", "kk O nn I CH I aa"), ("ラーメン", "RR aa aa PP E nn"), ("한국어", "aa nn kk U kk O"),
        ("مرحبا", "PP aa RR aa aa PP aa"), ("नमस्ते", "nn aa PP aa SS DD E"), ("三", "SS aa nn"),
    ],
)  # fmt: skip
def test_words_of_other_scripts_are_spoken_by_their_romanization(word: str, shapes: str) -> None:
    assert _shapes(word).replace("aa aa", "aa") == shapes.replace("aa aa", "aa")
    assert _shapes(word, "de") == _shapes(word)


def test_every_letter_of_every_script_moves_the_mouth() -> None:
    codes = [*range(0x3100), *range(0x3100, sys.maxunicode, 101)]  # of ideographs and Hangul every hundredth
    letters = [chr(code) for code in codes if chr(code).isalpha()]
    for language in LANGUAGES:
        assert [letter for letter in letters if not set(_shapes(letter, language).split()) - {"sil"}] == []


def test_every_figure_of_every_script_moves_the_mouth() -> None:
    figures = [chr(code) for code in range(sys.maxunicode) if chr(code).isnumeric()]
    assert [figure for figure in figures if not _shapes(figure)] == []
    assert _shapes("٤٢") == _shapes("४२") == _shapes("42")


def test_pictures_and_points_are_silent() -> None:
    assert words_in("😀 ... 🐕‍🦺 ! — «» 。、 _ * ☎️") == []


def test_accents_are_read_alike_however_they_are_written() -> None:
    for word, language in [("über", "de"), ("schön", "de"), ("façade", "en"), ("Việt", "en")]:
        apart = unicodedata.normalize("NFD", word)
        assert len(apart) > len(word)
        assert [found for _, found in words_in(apart)] == [apart]
        assert _shapes(apart, language) == _shapes(unicodedata.normalize("NFC", word), language)  # type: ignore[arg-type]


@pytest.mark.parametrize("letter", ["a", "日", "ж", "7"])
def test_nothing_is_cut_off_a_long_word(letter: str) -> None:
    text = letter * 1000
    assert "".join(word for _, word in words_in(text)) == text
    once = len(sounds_of(letter, "en"))
    assert sum(len(sounds_of(word, "en")) for _, word in words_in(text)) == 1000 * once
    assert len(sounds_of(text, "en")) == 1000 * once


def test_words_stand_where_they_are_in_the_text() -> None:
    assert words_in("π is 3.14, 5% x") == [(0, "π"), (2, "is"), (5, "3.14"), (11, "5"), (12, "%"), (14, "x")]
    assert words_in("नमस्ते दुनिया") == [(0, "नमस्ते"), (7, "दुनिया")]
    assert words_in("Oh, it's - 3 o'clock!") == [(0, "Oh"), (4, "it's"), (11, "3"), (13, "o'clock")]


def test_rejects_a_language_without_rules() -> None:
    with pytest.raises(ValueError, match="language 'fr'"):
        check_language("fr")
