"""simulate(): tuples from NumPy arrays."""

import os

import numpy as np

from sigmasweep import _core

_PARAMETERS = {name: (kind, names) for name, kind, _, _, names in _core.parameters()}


def dtype_of(columns):
    """The NumPy dtype of rows with these columns. Enumerations are bytes, with their names in the dtype's metadata as
    h5py has them (h5py.check_enum_dtype)."""

    def of(kind, names):
        if not names or kind == "?":
            return np.dtype(kind)
        return np.dtype(kind, metadata={"enum": {name: number for number, name in enumerate(names)}})

    return np.dtype([(name, of(kind, names)) for name, kind, _, _, names in columns])


def _numbers(name, value):
    """The values of a parameter as an array of numbers; enumerators by their numbers."""
    if name not in _PARAMETERS:
        raise ValueError(f"'{name}' is no parameter; there are: {', '.join(_PARAMETERS)}")
    kind, names = _PARAMETERS[name]
    array = np.asarray(value)
    if names:
        given = np.char.lower(array.astype(str)) if array.dtype == bool else array.astype(str)
        numbers = np.full(array.shape, -1, dtype=np.int64)
        for number, known in enumerate(names):
            numbers[given == known] = number
        if (numbers < 0).any():
            raise ValueError(f"{name} = {given[numbers < 0].flat[0]!r}: must be one of {', '.join(names)}")
        return numbers
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name} must be a number or an array of numbers, not {array.dtype}")
    if kind == "i8":
        whole = array.astype(np.int64)
        if (whole != array).any():
            raise ValueError(f"{name} must be whole")
        return whole
    return array.astype(np.float64)


def simulate(*, threads=None, **parameters):
    broadcast = {name: _numbers(name, value) for name, value in parameters.items()}
    shape = np.broadcast_shapes(*(array.shape for array in broadcast.values()))
    count = int(np.prod(shape, dtype=np.int64))
    if threads is None:
        threads = len(os.sched_getaffinity(0))
    if threads < 1:
        raise ValueError("threads must be at least 1")
    if count == 0:
        raise ValueError("there are no tuples: a parameter is an empty array")
    flat = {
        name: np.ascontiguousarray(array.reshape(1) if array.size == 1 else np.broadcast_to(array, shape).reshape(-1))
        for name, array in broadcast.items()
    }
    columns, rows = _core.simulate(flat, count, min(threads, count))
    return rows.view(dtype_of(columns)).reshape(shape)


simulate.__doc__ = """Computes tuples, each a collision or a run on a plate.

Parameters are keyword arguments: numbers, names of enumerators, or arrays of them, which are broadcast. Units are SI.
`threads`: number of threads; default: one a core.

Returns a structured array of the broadcast shape, with the members of a table's /results: parameters, results,
and `status` (0: ok; otherwise the results are NaN). Results are those of 'sigmasweep run', to the bit.

Raises ValueError with the program's message for parameters that are missing, unused or not allowed.

""" + "\n".join(
    f"{name} : {'one of ' + ', '.join(names) if names else {'f8': 'float', 'i8': 'int'}.get(kind, kind)}\n    {meaning}"
    for name, kind, _, meaning, names in _core.parameters()
)
