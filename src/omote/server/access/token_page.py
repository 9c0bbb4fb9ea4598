"""The page that asks for a token, and the one that takes a token out of the address bar."""

from __future__ import annotations

import html
from collections.abc import Iterable
from http import HTTPStatus

from aiohttp import web

_STYLE = (
    "body{margin:0;min-height:100vh;display:grid;place-items:center;background:#08090a;color:#d8dce0;"
    "font:16px/1.5 system-ui,sans-serif}main{max-width:30rem;padding:2rem}h1{font-size:1.2rem;margin:0 0 .5rem}"
    "input,button{font:inherit;padding:.6rem .8rem;border:1px solid #4a5058;border-radius:.3rem;background:#15181b;"
    "color:inherit}form{display:flex;gap:.5rem;margin:1.2rem 0}input{flex:1;min-width:0}button{background:#2c5d8f;"
    "cursor:pointer}small{color:#9aa2aa}code{color:#d8dce0}"
)
_PHONE_STYLE = (
    "h2{font-size:1.05rem;margin:0}section{margin:1.2rem 0;padding:.8rem 1rem;border:1px solid #4a5058;"
    "border-radius:.4rem}section p{margin:.3rem 0}label{display:block;margin:.5rem 0;color:#9aa2aa}"
    "label input{display:block;width:100%;box-sizing:border-box;font:600 1.3rem ui-monospace,monospace;color:#d8dce0;"
    "user-select:all;-webkit-user-select:all}a{color:#8fc0f0}small{display:block;margin:.8rem 0}"
)
_HEAD = (
    '<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Omote</title>'
    '<meta name="viewport" content="width=device-width, initial-scale=1"><link rel="icon" href="data:,">'
)
_POLICY = (
    "default-src 'none'; style-src 'unsafe-inline'; img-src data:; form-action 'self'; base-uri 'none'; "
    "frame-ancestors 'self'"
)


def ask_for_token(sentence: str, status: HTTPStatus, query: Iterable[tuple[str, str]] = ()) -> web.Response:
    """The page that says why somebody is not let in, and takes a token; query: what else its address is to keep.

    sentence: why; status: of the response.
    """
    kept = "".join(
        f'<input type="hidden" name="{html.escape(name)}" value="{html.escape(value)}">' for name, value in query
    )
    said = html.escape(sentence[:1].upper() + sentence[1:])
    return _page(
        f"{_HEAD}<style>{_STYLE}</style></head><body><main><h1>This show asks for a token</h1><p>{said}</p>"
        f'<form>{kept}<input name="token" aria-label="Token" placeholder="Token, or the whole address" '
        'autocomplete="off" autocapitalize="off" '
        'spellcheck="false" autofocus required><button>Enter</button></form>'
        "<small>Whoever runs the show has it: the terminal of <code>omote show</code> prints an address and a picture "
        "that a phone reads, and the console shows both under <i>People</i>.</small></main></body></html>",
        status,
    )


def leave_address(address: str, status: HTTPStatus = HTTPStatus.OK) -> web.Response:
    """A page that goes on to an address without a token: a page of our own, so that the browser sends the cookie along,
    which after a redirect from elsewhere it would not.

    address: where it leads; status: of the response.
    """
    goal = html.escape(address, quote=True)
    return _page(
        f'{_HEAD}<meta http-equiv="refresh" content="0;url={goal}"><style>{_STYLE}</style></head>'
        f'<body><main><a href="{goal}" style="color:inherit">Go on</a></main></body></html>',
        status,
    )


def show_page(body: str, status: HTTPStatus) -> web.Response:
    """A small page of the same kind, which a phone reads; body: what stands in it (HTML). status: of the response."""
    return _page(f"{_HEAD}<style>{_STYLE}{_PHONE_STYLE}</style></head><body><main>{body}</main></body></html>", status)


def _page(text: str, status: HTTPStatus) -> web.Response:
    headers = {"Content-Security-Policy": _POLICY, "Cache-Control": "no-store"}
    return web.Response(text=text, content_type="text/html", status=status, headers=headers)
