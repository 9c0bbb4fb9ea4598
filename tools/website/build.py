"""Builds the documentation site into build/site: `python -m tools.website.build`."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tools.website.html_links import resources
from tools.website.pages import ROOT
from tools.website.pages import main as write_pages


def main() -> int:
    """Builds; a link that leads nowhere, or an address of another host that a page would load, fails."""
    write_pages()
    command = [sys.executable, "-m", "mkdocs", "build", "--quiet", "--strict", "--clean"]
    built = subprocess.run(command, cwd=ROOT, env={**os.environ, "NO_MKDOCS_2_WARNING": "1"}, check=False)
    if built.returncode:
        return built.returncode
    site = ROOT / "build" / "site"
    loaded = [f"{page.relative_to(site)}: {url}" for page in site.rglob("*.html") for url in loaded_from_hosts(page)]
    print("\n".join(loaded) or f"{site.relative_to(ROOT)}/index.html: {len([*site.rglob('*.html')])} pages")
    return 1 if loaded else 0


def loaded_from_hosts(page: Path) -> list[str]:
    """What a page would fetch from another host: scripts, styles, pictures; not what links lead to."""
    return [url for url in resources(page.read_text(encoding="utf-8")) if url.startswith(("http:", "https:", "//"))]


if __name__ == "__main__":
    sys.exit(main())
