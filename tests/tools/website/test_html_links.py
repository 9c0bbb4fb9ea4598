"""What a page loads by itself is found; what people follow is not counted."""

from tools.website.html_links import resources


def test_scripts_styles_and_pictures_count_and_links_do_not() -> None:
    page = (
        '<link rel="stylesheet" href="a.css"><link rel="canonical" href="https://x/y">'
        '<script src="//cdn/z.js"></script>'
        '<a href="https://example.org">there</a><img src="b.png"><script>let x = "https://no";</script>'
    )
    assert resources(page) == ["a.css", "//cdn/z.js", "b.png"]
