"""Microphones at a session: a source of the layer lips; a smile survives, silence shows what lies below."""

import msgspec
import numpy as np
import pytest

import omote
from omote.inputs.microphone.microphone_input import MOST_MICROPHONES, MOST_WAITING, MicrophoneInput
from omote.inputs.microphone.microphone_messages import Begin, Measured, Rejected, Sentence, Sound, Speak, ToMicrophone
from omote.inputs.microphone.sound_features import BANDS, HOP, SAMPLE_RATE
from omote.model.cast import Cast
from omote.show.objects.state import State
from omote.show.session import ShowSession
from tests.inputs.microphone.test_speaker_profile import sentence
from tests.inputs.microphone.voices import Sound as Samples
from tests.inputs.microphone.voices import pause, pcm, vowel

TICK = 1.0 / 60.0


class Stage:
    """A session with one character, microphones, and a clock."""

    def __init__(self, cast: Cast) -> None:
        self.session = ShowSession(cast)
        self.now = 0.0
        self.microphones = MicrophoneInput(lambda: self.session)
        self.told: list[ToMicrophone] = []
        self.states: list[State] = []

    def say(self, who: str, message: msgspec.Struct) -> list[ToMicrophone]:
        answers = self.microphones.hear(who, msgspec.msgpack.encode(message), self.now)
        self.told += answers
        return answers

    def speak(self, who: str, sound: Samples) -> State:
        """Ticks while this sound comes, 10 ms at a time."""
        sent = 0
        for tick in range(1, round(len(sound) / SAMPLE_RATE / TICK) + 1):
            while (sent + 1) * HOP <= tick * TICK * SAMPLE_RATE:
                self.say(who, Sound(pcm(sound[sent * HOP : (sent + 1) * HOP]), 1000.0 * self.now))
                sent += 1
            self.tick()
        return self.states[-1]

    def tick(self, seconds: float = TICK) -> State:
        for _ in range(round(seconds / TICK)):
            self.told += [rejected for _, rejected in self.microphones.play(self.now)]
            self.now += TICK
            self.states.append(self.session.tick(self.now))
        return self.states[-1]

    def jaw(self) -> float:
        return self.states[-1].characters["one"].channels.get("jawOpen", 0.0)


@pytest.fixture
def stage() -> Stage:
    return Stage(omote.load_cast())


def test_a_vowel_opens_the_mouth_and_a_pause_shuts_it(stage: Stage) -> None:
    stage.say("page", Begin("Anna"))
    stage.speak("page", pause(0.5))
    assert stage.jaw() < 0.01
    stage.speak("page", vowel(0.3))
    assert stage.jaw() > 0.1
    state = stage.speak("page", pause(1.5))
    assert stage.jaw() < 0.01
    assert state.characters["one"].layers["lips"].source == "Anna"
    assert not stage.told


def test_silence_shows_the_smile_below_and_speech_keeps_part_of_it(stage: Stage) -> None:
    stage.session.scene["one"].call_expression("smile", seconds=0.0)
    stage.say("page", Begin("Anna"))
    silent = stage.speak("page", pause(0.5)).characters["one"]
    assert silent.expressions["smile"] == 1.0
    assert "mouth" not in silent.regions
    speaking = stage.speak("page", vowel(0.4)).characters["one"]
    assert speaking.regions["mouth"]["smile"] == pytest.approx(0.3, abs=0.02)
    after = stage.speak("page", pause(2.0)).characters["one"]
    assert after.regions.get("mouth", after.expressions)["smile"] == pytest.approx(1.0)


def test_nothing_jumps_between_ticks(stage: Stage) -> None:
    stage.say("page", Begin("Anna"))
    for _ in range(3):
        stage.speak("page", np.concatenate([pause(0.3), vowel(0.3)]))
    way = [state.characters["one"].channels.get("jawOpen", 0.0) for state in stage.states]
    assert max(way) > 0.1
    assert np.abs(np.diff(way)).max() < 0.5 * max(way)


def test_a_microphone_that_is_cut_off_comes_to_rest_and_comes_back(stage: Stage) -> None:
    stage.say("page", Begin("Anna"))
    stage.speak("page", np.concatenate([pause(0.3), vowel(0.4)]))
    stage.tick(2.0)
    assert stage.jaw() < 0.01
    assert [source.found for source in stage.session.sources.states({})] == [False]
    stage.speak("page", vowel(0.3))
    assert stage.jaw() > 0.1, "its first word is whole"


def test_a_page_that_goes_lets_its_layer_go(stage: Stage) -> None:
    stage.say("page", Begin("Anna"))
    stage.speak("page", vowel(0.3))
    stage.microphones.leave("page")
    stage.tick(3.0)
    assert (len(stage.microphones), stage.session.sources.states({})) == (0, [])
    assert stage.jaw() < 0.01
    stage.microphones.leave("page")


def test_a_page_that_is_loaded_anew_keeps_its_name(stage: Stage) -> None:
    stage.say("page", Begin("Anna"))
    stage.speak("page", vowel(0.3))
    stage.microphones.leave("page")
    stage.say("again", Begin("Anna"))
    stage.speak("again", pause(0.1))
    assert [source.name for source in stage.session.sources.states({})] == ["Anna"]


def test_a_second_microphone_has_another_name_and_waits_to_be_routed(stage: Stage) -> None:
    for who in ("page", "other"):
        stage.say(who, Begin("Anna"))
        stage.speak(who, pause(0.1))
    sources = {source.name: source.characters for source in stage.session.sources.states({})}
    assert sources == {"Anna": ["one"], "Anna 2": []}
    stage.say("page", Speak(""))
    stage.say("other", Speak("one"))
    stage.tick()
    assert {source.name: source.characters for source in stage.session.sources.states({})} == {
        "Anna": [],
        "Anna 2": ["one"],
    }
    assert not stage.told


def test_what_cannot_be_is_rejected_in_words(stage: Stage) -> None:
    for message in (Sound(b"\0\0"), Sentence("start"), Speak("one")):
        (answer,) = stage.say("page", message)
        assert isinstance(answer, Rejected)
        assert "no name yet" in answer.reason
    stage.say("page", Begin("Anna"))
    answers = [
        *stage.say("page", Speak("nobody")),
        *stage.say("page", Sentence("finish")),
        *stage.say("page", Begin("x", [0.0])),
        *stage.microphones.hear("page", b"hello", 0.0),
    ]
    reasons = [answer.reason for answer in answers if isinstance(answer, Rejected)]
    for reason, said in zip(reasons, ("nobody", "no sentence", "24", "nothing that"), strict=True):
        assert said in reason
    assert stage.microphones.rejected == 3 + len(reasons) - 1


def test_microphones_are_bounded(stage: Stage) -> None:
    for number in range(MOST_MICROPHONES):
        assert stage.say(f"page {number}", Begin("Anna")) == []
    (answer,) = stage.say("one more", Begin("Anna"))
    assert isinstance(answer, Rejected)
    assert "open already" in answer.reason


def test_a_backlog_is_cut(stage: Stage) -> None:
    """A mouth that is late is worse than one that misses a sound."""
    stage.say("page", Begin("Anna"))
    for _ in range(100):
        stage.say("page", Sound(pcm(vowel(0.1))))
    waiting = stage.microphones._open["page"].waiting
    assert sum(len(each.samples) for each in waiting) <= 2 * MOST_WAITING * SAMPLE_RATE


def test_one_sentence_measures_the_speaker_who_can_be_forgotten(stage: Stage) -> None:
    stage.say("page", Begin("Anna"))
    stage.say("page", Sentence("start"))
    stage.speak("page", pause(0.1))
    voice = stage.microphones.voice("page")
    assert voice is not None
    assert voice.calibrating
    stage.speak("page", sentence())
    (measured,) = stage.say("page", Sentence("finish"))
    assert isinstance(measured, Measured)
    assert len(measured.bands) == BANDS
    stage.say("page", Begin("Anna", measured.bands, measured.level))
    again = stage.microphones.voice("page")
    assert again is not None
    assert again.calibrated
    assert stage.say("page", Sentence("forget")) == [Measured([], 0.0)]
    forgotten = stage.microphones.voice("page")
    assert forgotten is not None
    assert not forgotten.calibrated


def test_the_page_is_told_what_is_heard(stage: Stage) -> None:
    assert stage.microphones.voice("page") is None
    stage.say("page", Begin("Anna"))
    stage.speak("page", np.concatenate([pause(0.3), vowel(0.3)])[: -SAMPLE_RATE // 20])
    voice = stage.microphones.voice("page")
    assert voice is not None
    assert voice.speaks > 0.5
    assert voice.viseme in {"aa", "E", "O"}
    assert -40.0 < voice.level < 0.0
    assert (voice.characters, voice.there) == (["one"], {"one": "One"})
