"""Content-addressed store of results that take seconds to compute, as netCDF files.

The key is a hash of everything the result depends on, so nothing in the store is
ever out of date. Files are written under a temporary name and then renamed;
a file that cannot be read counts as a miss. Complex numbers, which netCDF lacks,
are split into real and imaginary parts here and nowhere else.
"""

import hashlib
import json
import os
import warnings
from collections.abc import Callable, Mapping
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np
import platformdirs
import xarray as xr

from workbench.errors import InputError
from workbench.whole_files import written_whole

_PART = "complex_part"


def content_key(stage: str, version: int, **inputs) -> str:
    """Return the key of a result: a hash of the stage, its version and its inputs.

    Parameters
    ----------
    stage, version : name of the stage, and a number raised by any change that moves its numbers.
    **inputs : JSON-able values; NaN is refused.
    """
    text = json.dumps([stage, version, inputs], sort_keys=True, allow_nan=False, default=_plain)
    return hashlib.sha256(text.encode()).hexdigest()[:20]


def _plain(value):
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{type(value).__name__} cannot be part of a key")


def cache_folder() -> Path:
    """Folder of the store: $WORKBENCH_CACHE_DIR, or the user's cache folder."""
    chosen = os.environ.get("WORKBENCH_CACHE_DIR")
    return Path(chosen) if chosen else Path(platformdirs.user_cache_dir("workbench"))


def with_split_complex(dataset: xr.Dataset) -> xr.Dataset:
    """Return the Dataset with complex variables as real ones with a last dimension of two."""
    split = dataset.copy()
    for name, variable in dataset.data_vars.items():
        if np.iscomplexobj(variable):
            parts = np.stack([variable.values.real, variable.values.imag], axis=-1)
            split[name] = ((*variable.dims, _PART), parts, variable.attrs)
    return split


def with_joined_complex(dataset: xr.Dataset) -> xr.Dataset:
    """Return the Dataset that `with_split_complex` was given."""
    whole = dataset.copy()
    for name, variable in dataset.data_vars.items():
        if _PART in variable.dims:
            parts = variable.values.astype(np.float64)
            whole[name] = (variable.dims[:-1], parts[..., 0] + 1j * parts[..., 1], variable.attrs)
    return whole


def save_dataset(dataset: xr.Dataset, path: Path, *, single_precision: bool = False) -> None:
    """Write a Dataset to a netCDF file: under a temporary name, then renamed.

    Parameters
    ----------
    single_precision : store complex variables as pairs of 32-bit numbers.

    Raises
    ------
    InputError if the folder cannot be written to.
    """
    split = with_split_complex(dataset)
    encoding = {}
    for name, variable in split.data_vars.items():
        if variable.dtype.kind == "f":
            encoding[name] = {"zlib": True, "complevel": 4}
            if single_precision and _PART in variable.dims:
                encoding[name]["dtype"] = "float32"
    path = Path(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with written_whole(path) as temporary:
            split.to_netcdf(temporary, encoding=encoding, engine="netcdf4")
    except OSError as error:
        raise InputError(
            f"Folder {path.parent} must be writable, got: {error.strerror or error}; choose another folder."
        ) from error


def load_dataset(path: Path) -> xr.Dataset:
    """Read a Dataset written by `save_dataset` into memory."""
    with xr.open_dataset(path, engine="netcdf4") as stored:
        return with_joined_complex(stored.load())


def _shipped(key: str) -> xr.Dataset | None:
    """Return the result that comes with the package, if it has this one."""
    resource = files("workbench") / "data" / "hydrodynamics" / f"{key}.nc"
    if not resource.is_file():
        return None
    with as_file(resource) as path:
        return load_dataset(path)


def cached(key: str, compute: Callable[[], xr.Dataset], attrs: Mapping | None = None) -> xr.Dataset:
    """Return the result of this key: shipped, stored, or computed and stored.

    Parameters
    ----------
    key : from `content_key`; compute : makes the result.
    attrs : further attributes to keep with a computed result.

    Notes
    -----
    An unwritable store costs a warning, not the result.
    """
    shipped = _shipped(key)
    if shipped is not None:
        return shipped
    path = cache_folder() / f"{key}.nc"
    if path.is_file():
        try:
            return load_dataset(path)
        except (OSError, ValueError, KeyError, RuntimeError) as error:
            warnings.warn(
                f"Stored result {path.name} cannot be read and is computed anew: {error}", stacklevel=2
            )
    result = compute().assign_attrs(cache_key=key, **dict(attrs or {}))
    try:
        save_dataset(result, path)
    except InputError as error:
        warnings.warn(f"The result is not kept for later: {error}", stacklevel=2)
    return result
