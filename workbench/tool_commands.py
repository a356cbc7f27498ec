"""Commands that serve: verification, app, notebooks, and what is prepared once."""

import json
from pathlib import Path
from typing import Annotated

import typer

from workbench.command_inputs import JsonOption


def verify(
    features: Annotated[
        bool, typer.Option("--features", help="The table of features and its evidence.")
    ] = False,
    slow: Annotated[bool, typer.Option("--slow", help="Also the cases that take minutes.")] = False,
    as_json: JsonOption = False,
) -> None:
    """Print the verification cases: published value, computed value, difference, tolerance."""
    from workbench.verification import report

    passed, values = report.features() if features else report.cases(slow=slow)
    if as_json:
        print(json.dumps(values, allow_nan=False))
    else:
        print(report.text(values))
    if not passed:
        raise SystemExit(1)


def open_app(
    port: Annotated[int, typer.Option(help="Port; 0 takes a free one.")] = 8866,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open a browser.")] = True,
    address: Annotated[
        str, typer.Option(help="Address to listen at; 0.0.0.0 also serves other machines.")
    ] = "127.0.0.1",
) -> None:
    """Open the app in a browser."""
    from workbench.app import server

    server.run_app(port=port, open_browser=browser, address=address)


def open_lab(
    port: Annotated[int, typer.Option(help="Port; 0 takes a free one.")] = 8888,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open a browser.")] = True,
) -> None:
    """Open the notebooks in JupyterLab."""
    from workbench.app import server

    server.run_lab(port=port, open_browser=browser)


def prepare() -> None:
    """Do what is done once per machine: tabulate the Green function of the panel method (some 20 s)."""
    from workbench.hydrodynamics.potential_flow import prepared_green_function

    prepared_green_function()
    print("The panel method is ready.")


def precompute(
    names: Annotated[list[str], typer.Argument(help="Library designs.")],
    out: Annotated[
        Path | None, typer.Option("--out", help="Folder; the one shipped with the package if left out.")
    ] = None,
) -> None:
    """Compute the hydrodynamics of library designs, as shipped with the package."""
    from workbench import shipped

    for path in shipped.written_hydrodynamics(names, out):
        print(path)


COMMANDS = (verify, open_app, open_lab, prepare, precompute)
