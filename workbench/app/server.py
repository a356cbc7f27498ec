"""Serves the page by Voila, and the notebooks by JupyterLab: the settings, and nothing of the page itself."""

import errno
import ipaddress
import os
import socket
import subprocess
import sys
from pathlib import Path

from workbench.errors import InputError, checked_number

HERE = Path(__file__).parent
TEMPLATE_FOLDER = HERE / "voila_template"
LAB_CONFIG_FOLDER = HERE / "lab_config"
NOTEBOOK = "workbench.ipynb"
HERE_ALONE = "127.0.0.1"
POOL_SIZE = 2
IDLE_SECONDS, CULL_INTERVAL = 900, 60
LABEXTENSIONS = ("@jupyter-widgets/jupyterlab-manager", "@voila-dashboards/widgets-manager8", "anywidget")


def notebook_path() -> Path:
    """Path of the notebook that is the page: in the package, or in the project folder beside it."""
    for folder in (HERE, HERE.parents[1] / "notebooks"):
        if (folder / NOTEBOOK).exists():
            return folder / NOTEBOOK
    raise InputError(
        f"{NOTEBOOK} must be in the package or in the notebooks folder, it is in neither; install again."
    )


def free_port(port: int, ip: str = HERE_ALONE) -> int:
    """Return the port if it is free, or any free one for 0; a busy port is refused."""
    port = int(checked_number("port", port, at_least=0, at_most=65535))
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((ip, port))
        except OSError as error:
            if error.errno == errno.EADDRNOTAVAIL:
                raise InputError(
                    f"address must be one of this machine, {ip} is not; 127.0.0.1 always is."
                ) from None
            raise InputError(
                f"port must be free, {port} is in use; give another, or 0 for any free one."
            ) from None
        return int(probe.getsockname()[1])


def voila_arguments(
    port: int, open_browser: bool, pool_size: int = POOL_SIZE, address: str = HERE_ALONE
) -> list[str]:
    """Arguments of Voila for the page at a port that is free.

    Warm kernels wait for readers; a kernel is ended when its page has been closed
    for 15 minutes, never under an open page; the reader can change neither
    template nor theme, and sees no source.
    """
    path = notebook_path()
    pool = {
        path.name: {"pool_size": pool_size, "kernel_env_variables": {"OMP_NUM_THREADS": "1"}},
        "default": {"pool_size": 0},
    }
    settings: dict[str, object] = {
        "Voila.port": port,
        "Voila.ip": address,
        "Voila.port_retries": 0,
        "Voila.open_browser": open_browser,
        "VoilaConfiguration.template": "workbench",
        "VoilaConfiguration.preheat_kernel": pool_size > 0,
        "VoilaConfiguration.default_pool_size": pool_size,
        "VoilaConfiguration.strip_sources": True,
        "VoilaConfiguration.show_tracebacks": False,
        "VoilaConfiguration.allow_template_override": "NO",
        "VoilaConfiguration.allow_theme_override": "NO",
        "VoilaConfiguration.extension_allowlist": list(LABEXTENSIONS),
        "VoilaKernelManager.fill_delay": 0,
        "VoilaKernelManager.kernel_pools_config": pool,
        "MappingKernelManager.cull_idle_timeout": IDLE_SECONDS,
        "MappingKernelManager.cull_interval": CULL_INTERVAL,
        "MappingKernelManager.cull_connected": False,
        "VoilaExecutor.timeout": 120,
    }
    return [str(path), *(f"--{name}={value}" for name, value in settings.items())]


def environment() -> dict[str, str]:
    """Environment in which Jupyter finds the template of the page, also from a clone."""
    return {
        **os.environ,
        "JUPYTER_PATH": _with_folder("JUPYTER_PATH", TEMPLATE_FOLDER),
        "OMP_NUM_THREADS": os.environ.get("OMP_NUM_THREADS", "1"),
        "PYDEVD_DISABLE_FILE_VALIDATION": "1",
    }


def lab_environment() -> dict[str, str]:
    """Environment in which JupyterLab, for this process alone, neither asks about news nor looks for them."""
    return {**environment(), "JUPYTER_CONFIG_PATH": _with_folder("JUPYTER_CONFIG_PATH", LAB_CONFIG_FOLDER)}


def _with_folder(variable: str, folder: Path) -> str:
    """Return a list of folders of the environment with one before them."""
    known = [part for part in os.environ.get(variable, "").split(os.pathsep) if part]
    return os.pathsep.join([str(folder), *known])


def checked_address(address: str) -> str:
    """Return an IP address at which this machine can listen."""
    try:
        return str(ipaddress.IPv4Address(address))
    except ValueError:
        raise InputError(
            f"address must be an IPv4 address, got {address!r}; 127.0.0.1 serves this machine alone, 0.0.0.0 "
            "every network it is in."
        ) from None


def run_app(port: int = 8866, open_browser: bool = True, address: str = HERE_ALONE) -> None:
    """Serve the page until interrupted, to this machine alone or, at address 0.0.0.0, to its networks."""
    address = checked_address(address)
    _run(["-m", "voila", *voila_arguments(free_port(port, address), open_browser, address=address)])


def lab_arguments(port: int, open_browser: bool, folder: Path | None = None) -> list[str]:
    """Arguments of JupyterLab for a folder of notebooks: no news, no look for updates."""
    settings: dict[str, object] = {
        "ServerApp.port": port,
        "ServerApp.port_retries": 0,
        "ServerApp.ip": HERE_ALONE,
        "ServerApp.root_dir": folder or notebook_path().parent,
        "ServerApp.open_browser": open_browser,
        "LabApp.news_url": None,
        "LabApp.check_for_updates_class": "jupyterlab.NeverCheckForUpdate",
    }
    return [f"--{name}={value}" for name, value in settings.items()]


def run_lab(port: int = 8888, open_browser: bool = True) -> None:
    """Serve the notebooks by JupyterLab until interrupted."""
    _run(["-m", "jupyterlab", *lab_arguments(free_port(port), open_browser)], lab_environment())


def _run(arguments: list[str], variables: dict[str, str] | None = None) -> None:
    """Run a server in the foreground."""
    try:
        code = subprocess.run(
            [sys.executable, *arguments], env=variables or environment(), check=False
        ).returncode
    except KeyboardInterrupt:
        return
    if code not in (0, -2, 130):
        raise SystemExit(code)
