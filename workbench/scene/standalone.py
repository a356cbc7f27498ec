"""The animated 3-D view as one HTML file that needs neither kernel nor network."""

import base64
import html
import json
from pathlib import Path

import xarray as xr

from workbench.scene.packing import packed_scene

BUNDLE = Path(__file__).parent / "static" / "sea_view_standalone.js"

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>html, body {{ margin: 0; height: 100%; }} #sea-view {{ height: 100%; }}</style>
</head>
<body>
<main id="sea-view"></main>
<noscript>This page shows an animation and needs JavaScript.</noscript>
<script type="application/json" id="sea-view-scene">{facts}</script>
<script>{bundle}</script>
</body>
</html>
"""


def standalone_html(scene: xr.Dataset, title: str = "", field: str = "") -> str:
    """HTML text of a page that plays the scene, opened from a file, with no request at all.

    Parameters
    ----------
    scene : as made by `workbench.scene.description`.
    title : title of the page and of the view; the scene's own if empty.
    field : field first drawn on the deck; the first of the scene if empty.
    """
    blocks = packed_scene(scene)
    facts = dict(blocks.pop("scene"))
    facts["title"] = title or facts["title"]
    state = {
        "scene": facts,
        "field": field or (facts["fields"][0]["name"] if facts["fields"] else ""),
        "blocks": {name: base64.b64encode(block).decode("ascii") for name, block in blocks.items()},
    }
    # '<' inside a script element could end it
    return _PAGE.format(
        title=html.escape(facts["title"] or "Wet deck in waves"),
        facts=json.dumps(state).replace("<", "\\u003c"),
        bundle=BUNDLE.read_text(encoding="utf-8").replace("</script", "<\\/script"),
    )
