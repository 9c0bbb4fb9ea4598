"""What a program trusts over https; handshakes are tested where certificates are made."""

from pathlib import Path

import pytest

from omote.client.trust import authority_path, https_folder, trusted_context


def test_the_authority_of_a_user_lies_in_a_folder_of_its_own() -> None:
    assert authority_path().parent == https_folder()


def test_what_is_no_certificate_is_named(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.pem"
    wrong.write_text("no certificate")
    with pytest.raises(OSError, match=r"wrong.pem is no certificate to trust \(it holds none\); give what"):
        trusted_context(wrong)
    with pytest.raises(OSError, match=r"missing\.pem is no certificate to trust"):
        trusted_context(tmp_path / "missing.pem")
