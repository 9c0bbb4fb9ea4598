"""Certificates that a browser would take: made on the spot, or the operator's own."""

import datetime
import ipaddress
import ssl
from pathlib import Path

import pytest
from cryptography import x509
from cryptography.hazmat.primitives.serialization import (
    BestAvailableEncryption,
    Encoding,
    PrivateFormat,
    load_pem_private_key,
)

from omote.server.access.certificates import (
    AUTHORITY_DAYS,
    CertificateFiles,
    load_context,
    make_certificate,
    make_usual_certificate,
)

NOW = datetime.datetime(2026, 11, 23, tzinfo=datetime.UTC)
NAMES = ("theatre", "theatre.local", "localhost", "127.0.0.1", "192.168.1.7", "::1")


def handshake(files: CertificateFiles, name: str) -> bool:
    """Whether a client that trusts the authority shakes hands with the server under a name; no socket is opened."""
    client_context = ssl.create_default_context(cafile=str(files.authority))
    to_server = ssl.MemoryBIO()
    to_client = ssl.MemoryBIO()
    server = load_context(files).wrap_bio(to_server, to_client, server_side=True)
    client = client_context.wrap_bio(to_client, to_server, server_hostname=name)
    done = set[ssl.SSLObject]()
    while len(done) < 2:
        for end in (client, server):
            try:
                end.do_handshake()
                done.add(end)
            except ssl.SSLWantReadError:
                pass
    return True


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> CertificateFiles:
    now = datetime.datetime.now(datetime.UTC)  # the handshake's own clock
    return make_certificate(NAMES, now=now, folder=tmp_path_factory.mktemp("https") / "made")


@pytest.mark.parametrize("name", NAMES)
def test_who_trusts_the_authority_takes_every_name_of_this_machine(files: CertificateFiles, name: str) -> None:
    assert handshake(files, name)


@pytest.mark.parametrize("name", ["bank.example", "192.168.1.8"])
def test_no_other_name_is_taken(files: CertificateFiles, name: str) -> None:
    with pytest.raises(ssl.SSLCertVerificationError):
        handshake(files, name)


def test_the_authority_signs_for_this_machine_alone(tmp_path: Path) -> None:
    """Whoever steals its key deceives nobody about other sites."""
    now = datetime.datetime.now(datetime.UTC)
    made = make_certificate(NAMES, now=now, folder=tmp_path)
    stolen = make_certificate(("bank.example", *NAMES), now=now, folder=tmp_path)
    assert stolen == made  # the same authority
    with pytest.raises(ssl.SSLCertVerificationError, match="permitted subtree violation"):
        handshake(stolen, "bank.example")


def test_only_their_owner_reads_keys_and_the_authority_stays(tmp_path: Path) -> None:
    folder = tmp_path / "https"
    first = make_certificate(NAMES, now=NOW, folder=folder)
    assert first.authority is not None
    before = first.authority.read_bytes(), first.certificate.read_bytes()
    make_certificate(NAMES, now=NOW, folder=folder)
    assert first.authority.read_bytes() == before[0]
    assert first.certificate.read_bytes() != before[1]
    assert folder.stat().st_mode & 0o777 == 0o700
    assert {path.stat().st_mode & 0o777 for path in folder.iterdir()} == {0o600}
    make_certificate(NAMES, now=NOW + datetime.timedelta(days=AUTHORITY_DAYS - 30), folder=folder)
    assert first.authority.read_bytes() != before[0]


def test_what_is_made_says_what_tablets_ask_for(files: CertificateFiles) -> None:
    certificate = x509.load_pem_x509_certificate(files.certificate.read_bytes())
    alternatives = certificate.extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    assert ipaddress.ip_address("192.168.1.7") in alternatives.get_values_for_type(x509.IPAddress)
    assert (certificate.not_valid_after_utc - certificate.not_valid_before_utc).days <= 398


def test_files_of_no_use_are_said(tmp_path: Path, files: CertificateFiles) -> None:
    with pytest.raises(OSError, match=r"gone\.pem cannot be read .* see --certificate"):
        load_context(CertificateFiles(tmp_path / "gone.pem", files.key))
    (tmp_path / "text.pem").write_text("hello")
    other = make_certificate(NAMES, now=NOW, folder=tmp_path / "other")
    key = load_pem_private_key(other.key.read_bytes(), None)
    locked = key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, BestAvailableEncryption(b"secret"))
    (tmp_path / "locked.pem").write_bytes(locked)
    wrong = {
        (tmp_path / "text.pem", files.key): r"text\.pem has no certificate in it",
        (files.key, files.certificate): r"key\.pem has no certificate in it",
        (files.certificate, files.certificate): r"certificate\.pem has no key in it",
        (files.certificate, tmp_path / "locked.pem"): r"locked\.pem asks for a password",
        (files.certificate, other.key): r"key\.pem is not the key of .*certificate\.pem",
    }
    for pair, why in wrong.items():
        with pytest.raises(ValueError, match=why) as said:
            load_context(CertificateFiles(*pair))
        assert "SSL" not in str(said.value)


def test_without_the_package_or_a_folder_it_says_what_to_do(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="no certificate can be made in"):
        make_certificate(NAMES, now=NOW, folder=tmp_path / "file" / "https")
    monkeypatch.setitem(__import__("sys").modules, "cryptography", None)
    with pytest.raises(OSError, match=r"pip install \"omote\[https\]\""):
        make_certificate(NAMES, now=NOW, folder=tmp_path)


def test_the_usual_one_lies_in_the_folder_of_this_user(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    assert make_usual_certificate("0.0.0.0").certificate == tmp_path / "omote" / "https" / "certificate.pem"
