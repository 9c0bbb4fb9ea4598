"""Letters to visemes: English, German, what no rule knows."""

import pytest

from omote.perform.speech.english_spelling import WORDS as ENGLISH
from omote.perform.speech.german_spelling import WORDS as GERMAN
from omote.perform.speech.spelling import Language, check_language, sounds_of, words_in
from omote.perform.speech.visemes import VISEMES


def _shapes(word: str, language: Language = "en") -> str:
    return " ".join(sound.viseme for sound in sounds_of(word, language))


@pytest.mark.parametrize(
    ("word", "shapes"),
    [
        ("make", "PP E I kk"), ("five", "FF aa I FF"), ("night", "nn aa I DD"), ("phone", "FF O U nn"),
        ("through", "TH RR U"), ("knife", "nn aa I FF"), ("bubble", "PP aa PP nn"), ("nation", "nn E I CH O nn"),
        ("speech", "SS PP I CH"), ("the", "TH aa"), ("queen", "kk U I nn"), ("Hello", "E nn O U"),
        ("comb", "kk O PP"), ("stopped", "SS DD O PP DD"), ("I'm", "aa I PP"), ("42", "FF O RR DD U"),
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


@pytest.mark.parametrize("words", [ENGLISH, GERMAN])
def test_every_known_word_has_visemes(words: dict[str, str]) -> None:
    assert all(set(shapes.split()) <= set(VISEMES) for shapes in words.values())


def test_a_sound_knows_its_letters() -> None:
    for word in ("thought", "hello", "7up", "bubble's"):
        sounds = sounds_of(word, "en")
        places = [(sound.first, sound.last) for sound in sounds]
        assert places == sorted(places)
        assert all(0 <= first <= last <= len(word) for first, last in places)


def test_what_no_rule_knows_is_silent_and_nothing_is_too_long() -> None:
    assert sounds_of("日本", "en") == ()
    assert sounds_of("٣", "en") == ()
    assert len(sounds_of("a" * 1000, "en")) <= 120


def test_words_stand_where_they_are_in_the_text() -> None:
    assert words_in("Oh, it's - 3 o'clock!") == [(0, "Oh"), (4, "it's"), (11, "3"), (13, "o'clock")]


def test_rejects_a_language_without_rules() -> None:
    with pytest.raises(ValueError, match="language 'fr'"):
        check_language("fr")
