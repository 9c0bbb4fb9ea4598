"""The two pages without scripts."""

from http import HTTPStatus

from omote.server.access.token_page import ask_for_token, leave_address


def test_what_is_said_and_where_to_go_is_shown_as_text() -> None:
    asked = ask_for_token("no <script>alert(1)</script>.", HTTPStatus.UNAUTHORIZED)
    left = leave_address('/console?layout="><script>')
    for page in (asked, left):
        assert "<script" not in (page.text or "")
        assert "script-src" not in page.headers["Content-Security-Policy"]
        assert page.headers["Content-Security-Policy"].startswith("default-src 'none'")
        assert page.headers["Cache-Control"] == "no-store"
    assert (asked.status, left.status) == (401, 200)


def test_what_else_an_address_says_is_kept() -> None:
    asked = ask_for_token("no.", HTTPStatus.UNAUTHORIZED, [("tile", "0,0"), ('"><script>', '"><script>')])
    assert '<input type="hidden" name="tile" value="0,0">' in (asked.text or "")
    assert "<script" not in (asked.text or "")
