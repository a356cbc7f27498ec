"""One random sea for all tests of records."""

import numpy as np
import pytest
from random_seas import sines


@pytest.fixture(scope="session")
def sea():
    return sines()


@pytest.fixture(scope="session")
def time():
    return np.arange(0, 3600, 0.25)
