"""The committed bundles are those of the committed source."""

import hashlib
import json
from pathlib import Path

import workbench.scene

SCENE = Path(workbench.scene.__file__).parent
SOURCE = SCENE / "js"
STATIC = SCENE / "static"
LIMIT = 800_000


def digest(paths) -> str:
    together = hashlib.sha256()
    for path in paths:
        together.update(path.read_bytes())
    return together.hexdigest()


def test_bundles_match_their_source():
    hashes = json.loads((STATIC / "hashes.json").read_text())
    parts = [*sorted((SOURCE / "src").iterdir())]
    parts += [SOURCE / name for name in ("build.mjs", "package.json", "package-lock.json")]
    cure = "run: npm ci && npm run build in workbench/scene/js"
    assert hashes["source"] == digest(parts), cure
    for name in ("sea_view.js", "sea_view_standalone.js"):
        assert hashes[name] == digest([STATIC / name]), cure


def test_bundles_are_small():
    assert all((STATIC / name).stat().st_size < LIMIT for name in ("sea_view.js", "sea_view_standalone.js"))


def test_lock_file_names_no_registry():
    assert "resolved" not in (SOURCE / "package-lock.json").read_text()


def test_versions_are_pinned():
    package = json.loads((SOURCE / "package.json").read_text())
    assert package["dependencies"] == {"three": "0.187.0"}
    assert package["devDependencies"] == {"esbuild": "0.28.2"}
