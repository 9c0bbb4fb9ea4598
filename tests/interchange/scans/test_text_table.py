"""Numbers of texts: every line and word is found, whatever ends and parts them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.scans.text_table import TextTable, parse_numbers

words = st.text("v1.5-#", min_size=1, max_size=4)


@given(
    st.lists(st.lists(words, max_size=4), max_size=8),
    st.sampled_from(["\n", "\r\n", "\r"]),
    st.sampled_from([" ", "\t "]),
)
def test_lines_and_words_are_those_of_python(lines: list[list[str]], end: str, gap: str) -> None:
    table = TextTable(end.join(gap + gap.join(line) for line in lines).encode())
    kept = [line for line in lines if line]
    assert table.words.tolist() == [len(line) for line in kept]
    assert [table.line(at).split() for at in range(len(table))] == kept
    assert table.lines_of(b"v").tolist() == [at for at, line in enumerate(kept) if line[0] == "v"]
    chosen = np.arange(0, len(kept), 2)
    assert table.join(chosen).decode().split() == [word for line in kept[::2] for word in line]


def test_numbers_are_those_of_python_and_the_first_other_word_is_named() -> None:
    text = b"1 -2.5 3e-4\n\t7.25e+2 .5 5. 1e999 nan"
    np.testing.assert_array_equal(parse_numbers(text, "it"), [float(word) for word in text.split()])
    with pytest.raises(ValueError, match="it has 'six', which is no number"):
        parse_numbers(b"1 2 six 7 eight", "it")
    np.testing.assert_array_equal(parse_numbers(b"1,5 -2,25 3", "it"), [1.5, -2.25, 3.0])
    with pytest.raises(ValueError, match=r"it has '1\.234,5', which is no number"):
        parse_numbers(b"7 1.234,5 8", "it")
