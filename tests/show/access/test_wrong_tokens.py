"""Guessing is slow; nobody else waits for it."""

from omote.show.access.wrong_tokens import MOST_SENDERS, TRIES_AT_ONCE, TRIES_PER_SECOND, WrongTokens


def guess(wrong: WrongTokens, host: str, tries: int, now: float = 0.0) -> None:
    for number in range(tries):
        wrong.note(host, f"guess {now} {number}", now)


def test_who_guesses_is_heard_slowly_and_others_at_once() -> None:
    wrong = WrongTokens()
    guess(wrong, "10.0.0.7", int(TRIES_AT_ONCE))
    assert not wrong.is_blocked("10.0.0.7", 0.0)
    guess(wrong, "10.0.0.7", 1, 0.1)
    assert wrong.is_blocked("10.0.0.7", 0.2)
    assert not wrong.is_blocked("10.0.0.8", 0.2)
    assert not wrong.is_blocked("10.0.0.7", 0.2 + 1.0 / TRIES_PER_SECOND)


def test_the_same_again_is_no_guess() -> None:
    wrong = WrongTokens()
    for _ in range(1000):
        wrong.note("10.0.0.7", "old", 0.0)
    assert not wrong.is_blocked("10.0.0.7", 0.0)


def test_a_network_of_ipv6_is_one_sender() -> None:
    wrong = WrongTokens()
    for number in range(20):
        wrong.note(f"2001:db8::{number:x}", f"guess {number}", 0.0)
    assert wrong.is_blocked("2001:db8::ffff", 0.0)
    assert not wrong.is_blocked("2001:db8:0:1::1", 0.0)


def test_a_flood_of_senders_takes_no_memory() -> None:
    wrong = WrongTokens()
    for number in range(MOST_SENDERS + 50):
        wrong.note(f"10.0.{number >> 8}.{number & 255}", "a", 0.0)
    assert len(wrong._senders) == MOST_SENDERS
