"""Guessing is slow; nobody else waits for it."""

from omote.show.access.wrong_tokens import FREE_TRIES, LONGEST_WAIT, MOST_SENDERS, WrongTokens


def guess(wrong: WrongTokens, host: str, tries: int, now: float = 0.0) -> list[float]:
    """How long each of some wrong tokens has to wait."""
    return [wrong.note(host, f"guess {now} {number}", now) for number in range(tries)]


def test_who_guesses_waits_ever_longer_and_others_do_not() -> None:
    wrong = WrongTokens()
    assert guess(wrong, "10.0.0.7", FREE_TRIES) == [0.0] * FREE_TRIES
    waits = guess(wrong, "10.0.0.7", 12)
    assert waits == sorted(waits)
    assert waits[:3] == [1.0, 2.0, 4.0]
    assert waits[-1] == LONGEST_WAIT
    assert guess(wrong, "10.0.0.8", 1) == [0.0]


def test_who_is_quiet_for_a_while_may_err_again() -> None:
    wrong = WrongTokens()
    guess(wrong, "10.0.0.7", 500)
    (wait,) = guess(wrong, "10.0.0.7", 1, 0.5 * LONGEST_WAIT)
    assert wait > 0.0
    assert guess(wrong, "10.0.0.7", 1, 3.0 * LONGEST_WAIT) == [0.0]


def test_the_same_again_is_no_guess() -> None:
    wrong = WrongTokens()
    assert {wrong.note("10.0.0.7", "old", 0.0) for _ in range(1000)} == {0.0}


def test_a_network_of_ipv6_is_one_sender() -> None:
    wrong = WrongTokens()
    for number in range(20):
        wrong.note(f"2001:db8::{number:x}", f"guess {number}", 0.0)
    assert wrong.note("2001:db8::ffff", "one more", 0.0) > 0.0
    assert wrong.note("2001:db8:0:1::1", "a first one", 0.0) == 0.0


def test_a_flood_of_senders_takes_no_memory() -> None:
    wrong = WrongTokens()
    for number in range(MOST_SENDERS + 50):
        wrong.note(f"10.0.{number >> 8}.{number & 255}", "a", 0.0)
    assert len(wrong._senders) == MOST_SENDERS
