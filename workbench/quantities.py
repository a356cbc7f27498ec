"""The one table of names: what each quantity is called, its unit and its symbol; and the maker of result Datasets.

Every variable and coordinate of every result carries ``units``, ``long_name``
and ``symbol`` from this table. A name that is not here cannot enter a result.
"""

from collections.abc import Iterable, Mapping

import xarray as xr

from workbench import __version__
from workbench.quantity_tables import impact, records, ships
from workbench.quantity_tables.quantity import Quantity

TABLE: dict[str, Quantity] = {**ships.TABLE, **records.TABLE, **impact.TABLE}


def attributes(name: str) -> dict[str, str]:
    """Return the ``units``, ``long_name`` and ``symbol`` of a quantity; KeyError if it is not in the table."""
    return dict(TABLE[name]._asdict())


def labelled(dataset: xr.Dataset) -> xr.Dataset:
    """Return the Dataset with the attributes of this table on every variable and coordinate."""
    labelled_dataset = dataset.copy()
    for name in list(labelled_dataset.variables):
        labelled_dataset[name].attrs.update(attributes(str(name)))
    return labelled_dataset


def dataset(
    coords: Mapping | None = None,
    *,
    method: str = "",
    warnings: Iterable[str] = (),
    attrs: Mapping | None = None,
    **variables,
) -> xr.Dataset:
    """Make a result Dataset.

    Parameters
    ----------
    coords : as for `xarray.Dataset`.
    method : name of the method that made the result.
    warnings : sentences about limits of validity; kept in the attribute ``warnings``, a line each.
    attrs : further attributes (inputs, versions).
    **variables : as for `xarray.Dataset`, by names of the table.

    Notes
    -----
    The attribute ``version`` is the version of this package.
    """
    made = labelled(xr.Dataset(dict(variables), coords=dict(coords or {})))
    made.attrs = {"method": method, "version": __version__, **dict(attrs or {})}
    made.attrs["warnings"] = joined_warnings(warnings)
    return made


def joined_warnings(sentences: Iterable[str]) -> str:
    """Return sentences as the attribute ``warnings`` keeps them: a line each, each once, none empty."""
    return "\n".join(dict.fromkeys(sentence for sentence in sentences if sentence))


def warnings_of(*datasets: xr.Dataset) -> tuple[str, ...]:
    """Return the warnings of the Datasets, in order, each once."""
    lines = (line for one in datasets for line in str(one.attrs.get("warnings", "")).split("\n"))
    return tuple(dict.fromkeys(line for line in lines if line))


def axis_label(variable: xr.DataArray) -> str:
    """Return 'name symbol [unit]' for an axis."""
    attrs = variable.attrs
    words = f"{attrs.get('long_name', variable.name)} {attrs.get('symbol', '')}".strip()
    unit = attrs.get("units", "1")
    return words if unit == "1" else f"{words} [{unit}]"
