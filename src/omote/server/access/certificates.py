"""Certificates for https: one of the operator's own, or one made on the spot under an authority of this user's own.

The authority is made once and may be installed on tablets; the certificate of this machine is made anew at each start,
for its addresses change. What the authority signs is valid for this machine's names, `.local` and bare addresses alone,
so a tablet that trusts it trusts it with nothing else.
"""

from __future__ import annotations

import contextlib
import datetime
import ipaddress
import ssl
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from omote.client.trust import https_folder
from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.show_addresses import certificate_names
from omote.server.persistence.private_file import write_private

if TYPE_CHECKING:
    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey

AUTHORITY_DAYS = 3650
CERTIFICATE_DAYS = 397
"""Browsers on tablets take no certificate of more than 398 days."""
RENEWED_DAYS = 400
"""An authority that ends sooner is made anew."""
MOST_BYTES = 2**20
NEEDS = (
    'a certificate is made with the package cryptography: pip install "omote[https]", or name --certificate and --key'
)


@dataclass(frozen=True)
class CertificateFiles:
    """Where a certificate, its key and, where it was made here, its authority lie."""

    certificate: Path
    key: Path
    authority: Path | None = None


def load_context(files: CertificateFiles) -> ssl.SSLContext:
    """What a server speaks https with; OSError or ValueError with a message where the files are of no use."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.minimum_version = ssl.TLSVersion.TLSv1_2
    contents = [_read_file(path) for path in (files.certificate, files.key)]
    try:
        context.load_cert_chain(files.certificate, files.key, password=_refuse_password)
    except (ssl.SSLError, ValueError) as error:
        raise ValueError(_explain_pair(files, *contents)) from error
    return context


def make_usual_certificate(host: str) -> CertificateFiles:
    """Makes a certificate for this machine, where a show listens on a host; OSError with a message."""
    return make_certificate(certificate_names(host), now=datetime.datetime.now(datetime.UTC))


def make_certificate(names: Sequence[str], *, now: datetime.datetime, folder: Path | None = None) -> CertificateFiles:
    """Makes a certificate for names and addresses of this machine; OSError with a message where that cannot be.

    now: with its zone; folder: where the files lie, that of this user where None.
    """
    folder = https_folder() if folder is None else folder
    try:
        import cryptography  # noqa: F401
    except ImportError as error:
        raise OSError(f"{NEEDS}.") from error
    try:
        folder.mkdir(parents=True, exist_ok=True)
        folder.chmod(0o700)
        files = CertificateFiles(folder / "certificate.pem", folder / "key.pem", folder / "authority.pem")
        _make_all(files, folder / "authority-key.pem", names, now)
    except (OSError, ValueError) as error:
        raise OSError(f"no certificate can be made in {folder} ({explain_error(error)}).") from error
    return files


def _read_file(path: Path) -> bytes:
    try:
        with path.open("rb") as file:
            return file.read(MOST_BYTES)
    except OSError as error:
        raise OSError(f"{path} cannot be read ({explain_error(error)}): see --certificate and --key.") from error


def _explain_pair(files: CertificateFiles, certificate: bytes, key: bytes) -> str:
    """Which of two files is wrong, as far as can be told by the headings of PEM (RFC 7468)."""
    if b"-----BEGIN CERTIFICATE-----" not in certificate:
        return f"{files.certificate} has no certificate in it: give a PEM file, the whole chain, to --certificate."
    if b"PRIVATE KEY-----" not in key:
        return f"{files.key} has no key in it: give the certificate's own key, a PEM file, to --key."
    if b"ENCRYPTED" in key:
        return f"{files.key} asks for a password: give --key a copy without one (openssl pkey -in ... -out ...)."
    return (
        f"{files.key} is not the key of {files.certificate}, or one of them is damaged: give both as they were made "
        "together."
    )


def _make_all(files: CertificateFiles, authority_key: Path, names: Sequence[str], now: datetime.datetime) -> None:
    from cryptography.hazmat.primitives.asymmetric import ec

    assert files.authority is not None
    pair = _read_authority(files.authority, authority_key, now)
    if pair is None:
        pair = _make_authority(names, now)
        write_private(authority_key, _key_bytes(pair[1]))
        write_private(files.authority, _pem(pair[0]))
    authority, signing = pair
    key = ec.generate_private_key(ec.SECP256R1())
    certificate = _sign(_describe_server(names, authority, signing, key, now), signing)
    write_private(files.key, _key_bytes(key))
    write_private(files.certificate, _pem(certificate) + _pem(authority))


def _read_authority(
    path: Path, key_path: Path, now: datetime.datetime
) -> tuple[x509.Certificate, EllipticCurvePrivateKey] | None:
    """The authority of before; None where there is none, it ends soon, or it cannot be read."""
    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric.ec import EllipticCurvePrivateKey
    from cryptography.hazmat.primitives.serialization import load_pem_private_key

    with contextlib.suppress(OSError, ValueError, TypeError):
        authority = x509.load_pem_x509_certificate(path.read_bytes())
        key = load_pem_private_key(key_path.read_bytes(), None)
        ends = authority.not_valid_after_utc - now
        if isinstance(key, EllipticCurvePrivateKey) and ends.days >= RENEWED_DAYS:
            return authority, key
    return None


def _make_authority(names: Sequence[str], now: datetime.datetime) -> tuple[x509.Certificate, EllipticCurvePrivateKey]:
    from cryptography import x509
    from cryptography.hazmat.primitives.asymmetric import ec

    key = ec.generate_private_key(ec.SECP256R1())
    title = _title(f"Omote on {_host_of(names)}"[:64])
    allowed: list[x509.GeneralName] = [x509.DNSName(name) for name in dict.fromkeys((*_host_names(names), "local"))]
    allowed += [x509.IPAddress(ipaddress.ip_network("0.0.0.0/0")), x509.IPAddress(ipaddress.ip_network("::/0"))]
    builder = _begin(title, title, key, now, AUTHORITY_DAYS)
    builder = builder.add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
    builder = builder.add_extension(_usage(signs=True), critical=True)
    builder = builder.add_extension(x509.NameConstraints(allowed, None), critical=True)
    identifier = x509.SubjectKeyIdentifier.from_public_key(key.public_key())
    return _sign(builder.add_extension(identifier, critical=False), key), key


def _describe_server(
    names: Sequence[str],
    authority: x509.Certificate,
    signing: EllipticCurvePrivateKey,
    key: EllipticCurvePrivateKey,
    now: datetime.datetime,
) -> x509.CertificateBuilder:
    from cryptography import x509
    from cryptography.x509.oid import ExtendedKeyUsageOID

    alternatives: list[x509.GeneralName] = [x509.DNSName(name) for name in _host_names(names)]
    alternatives += [x509.IPAddress(address) for address in map(_address, names) if address is not None]
    builder = _begin(_title(_host_of(names)[:64]), authority.subject, key, now, CERTIFICATE_DAYS)
    builder = builder.add_extension(x509.SubjectAlternativeName(alternatives), critical=False)
    builder = builder.add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
    builder = builder.add_extension(_usage(signs=False), critical=True)
    builder = builder.add_extension(x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH]), critical=False)
    issuer = x509.AuthorityKeyIdentifier.from_issuer_public_key(signing.public_key())
    return builder.add_extension(issuer, critical=False)


def _begin(
    subject: x509.Name, issuer: x509.Name, key: EllipticCurvePrivateKey, now: datetime.datetime, days: int
) -> x509.CertificateBuilder:
    from cryptography import x509

    builder = x509.CertificateBuilder().subject_name(subject).issuer_name(issuer).public_key(key.public_key())
    builder = builder.serial_number(x509.random_serial_number())
    yesterday = now - datetime.timedelta(days=1)  # a tablet's clock may be late
    return builder.not_valid_before(yesterday).not_valid_after(yesterday + datetime.timedelta(days=days))


def _sign(builder: x509.CertificateBuilder, key: EllipticCurvePrivateKey) -> x509.Certificate:
    from cryptography.hazmat.primitives import hashes

    return builder.sign(key, hashes.SHA256())


def _usage(*, signs: bool) -> x509.KeyUsage:
    from cryptography import x509

    return x509.KeyUsage(
        digital_signature=not signs,
        key_cert_sign=signs,
        crl_sign=signs,
        content_commitment=False,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        encipher_only=False,
        decipher_only=False,
    )


def _title(text: str) -> x509.Name:
    from cryptography import x509
    from cryptography.x509.oid import NameOID

    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, text)])


def _host_names(names: Sequence[str]) -> list[str]:
    return [name for name in names if _address(name) is None]


def _host_of(names: Sequence[str]) -> str:
    return next((name for name in _host_names(names) if name != "localhost"), "this machine")


def _address(name: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        return ipaddress.ip_address(name)
    except ValueError:
        return None


def _pem(certificate: x509.Certificate) -> bytes:
    from cryptography.hazmat.primitives.serialization import Encoding

    return certificate.public_bytes(Encoding.PEM)


def _key_bytes(key: EllipticCurvePrivateKey) -> bytes:
    from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat

    return key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption())


def _refuse_password() -> bytes:
    """No password: a server that takes over cannot ask for one."""
    return b""
