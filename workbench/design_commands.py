"""Commands that list designs and show one, and how every command prints."""

import json
import sys
from typing import Any

from workbench import designs, tables
from workbench.command_inputs import DesignArgument, JsonOption


def print_json(values: dict[str, Any]) -> None:
    """Print one JSON object."""
    print(json.dumps(values, allow_nan=False))


def print_warnings(sentences: list[str]) -> None:
    """Print warnings on standard error."""
    for sentence in sentences:
        print(f"warning: {sentence}", file=sys.stderr)


def list_designs(as_json: JsonOption = False) -> None:
    """List the designs of the library."""
    listed = [{"name": name, "title": designs.named_design(name).title} for name in designs.names()]
    if as_json:
        print_json({"designs": listed})
    else:
        width = max(len(entry["name"]) for entry in listed)
        for entry in listed:
            print(f"{entry['name']:<{width}}  {entry['title']}")


def show(design: DesignArgument, as_json: JsonOption = False) -> None:
    """Print particulars, hydrostatics and provenance of a design."""
    values = tables.particulars(designs.design(design))
    if as_json:
        print_json(values)
    else:
        print(tables.particulars_text(values))
        print_warnings(values["warnings"])
