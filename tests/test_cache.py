import warnings

import numpy as np
import pytest
import xarray as xr

from workbench import cache, quantities
from workbench.errors import InputError


def example(value: complex = 1 + 2j) -> xr.Dataset:
    return quantities.dataset(
        {"omega": [0.5, 1.0]},
        method="test",
        motion_rao=("omega", np.array([value, 3.0 - 1j])),
        wavenumber=("omega", [1.0, 2.0]),
    )


@pytest.fixture(autouse=True)
def own_store(tmp_path, monkeypatch):
    monkeypatch.setenv("WORKBENCH_CACHE_DIR", str(tmp_path / "store"))


def test_stored_result_equals_a_fresh_one():
    computed = []

    def compute():
        computed.append(1)
        return example()

    fresh = cache.cached("abc", compute)
    stored = cache.cached("abc", compute)
    assert len(computed) == 1
    xr.testing.assert_identical(fresh, stored)
    assert stored.motion_rao.attrs["units"] == "m/m, rad/m"


def test_corrupt_file_is_a_miss_with_a_warning():
    cache.cached("abc", example)
    (cache.cache_folder() / "abc.nc").write_bytes(b"not netCDF")
    with pytest.warns(UserWarning, match="computed anew"):
        again = cache.cached("abc", lambda: example(9j))
    assert again.motion_rao.values[0] == 9j


def test_unwritable_folder_is_refused_in_a_sentence(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    with pytest.raises(InputError, match="must be writable"):
        cache.save_dataset(example(), blocked / "x.nc")


def test_unwritable_store_costs_a_warning_only(tmp_path, monkeypatch):
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setenv("WORKBENCH_CACHE_DIR", str(blocked))
    with pytest.warns(UserWarning, match="not kept"):
        assert cache.cached("abc", example).motion_rao.values[0] == 1 + 2j


def test_key_depends_on_every_input_and_refuses_nan():
    key = cache.content_key("stage", 1, a=1.0, b=[1, 2])
    assert key == cache.content_key("stage", 1, b=[1, 2], a=1.0)
    assert key == cache.content_key("stage", 1, a=np.float64(1.0), b=np.array([1, 2]))
    assert (
        len(
            {
                key,
                cache.content_key("stage", 2, a=1.0, b=[1, 2]),
                cache.content_key("stage", 1, a=1.1, b=[1, 2]),
            }
        )
        == 3
    )
    with pytest.raises(ValueError, match="JSON"):
        cache.content_key("stage", 1, a=float("nan"))


def test_nothing_half_written_is_left(tmp_path, monkeypatch):
    def broken(self, *args, **kwargs):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(xr.Dataset, "to_netcdf", broken)
    with pytest.raises(InputError, match="No space left"):
        cache.save_dataset(example(), tmp_path / "x.nc")
    assert list(tmp_path.glob("*.nc")) == []
    assert [path for path in tmp_path.iterdir() if path.is_file()] == []


def test_single_precision_keeps_six_digits(tmp_path):
    cache.save_dataset(example(1.23456789 + 2j), tmp_path / "x.nc", single_precision=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        back = cache.load_dataset(tmp_path / "x.nc")
    assert back.motion_rao.values[0] == pytest.approx(1.23456789 + 2j, rel=1e-6)
    assert back.wavenumber.values[1] == 2.0
