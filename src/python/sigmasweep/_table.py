"""open(): tables that 'sigmasweep run' wrote, by h5py."""

import os
import tomllib
from functools import cached_property

import numpy as np

from sigmasweep import _core
from sigmasweep._frames import to_pandas


def open(path):
    """Opens a table of 'sigmasweep run' and reads what is asked for.

    Raises FileNotFoundError where there is none, or where its sweep is not complete, and ValueError for another file.
    """
    return Table(path)


class Table:
    """A table: `results` and `timings` (NumPy, a row a tuple), `answers`, `means` and `curves` (None where the sweep
    has none), `title`, `spec` (its text), `units` (a dict by column), `attrs`."""

    def __init__(self, path):
        import h5py

        if not os.path.exists(path):
            begun = os.path.exists(f"{path}.journal")
            why = "the sweep is not complete: 'sigmasweep export' has its rows so far" if begun else "there is no table"
            raise FileNotFoundError(f"{path}: {why}")
        self.path = os.fspath(path)
        try:
            file = h5py.File(self.path)
        except OSError as error:
            raise ValueError(f"{path} is no HDF5 file: {error}") from None
        with file:
            self.attrs = dict(file.attrs)
            if self.attrs.get("format") != "sigmasweep-table":
                raise ValueError(f"{path} is no table of sigmasweep")
            self._data = {name: file[name][()] for name in ("results", "timings", "answers", "means", "curves") if name in file}
            self.units = {key[5:]: value for name in self._data for key, value in file[name].attrs.items() if key.startswith("unit:")}
            for name in ("title", "spec"):
                setattr(self, name, self.attrs[name] if name in self.attrs else file[name].asstr()[()])

    results = property(lambda self: self._data["results"])
    timings = property(lambda self: self._data["timings"])
    answers = property(lambda self: self._data.get("answers"))
    means = property(lambda self: self._data.get("means"))
    curves = property(lambda self: self._data.get("curves"))

    def pandas(self):
        """The results as a pandas.DataFrame: enumerations as categories, units in `attrs["units"]`."""
        return to_pandas(self.results, self.units)

    @cached_property
    def _dimensions(self):
        """(name, axes, size) of each dimension of the grid: an axis, or axes that advance together; None where `where`
        chose tuples, or the table is a slice."""
        spec = tomllib.loads(self.spec)["sweep"]
        if "where" in spec or "slice_count" in self.attrs:
            return None
        names, sizes = _core.axes_of(self.spec)
        zipped = {name: tuple(group) for group in spec.get("zip", []) for name in group}
        dimensions = {}
        for name, size in zip(names, sizes):
            group = zipped.get(name, (name,))
            dimensions.setdefault("-".join(group), (group, int(size)))
        return [(name, axes, size) for name, (axes, size) in dimensions.items()]

    def xarray(self):
        """The results as an xarray.Dataset. Axes are dimensions with coordinates; of axes that advance together the
        dimension is named after all of them. A sweep with `where` has the dimension `row`. Units are attributes.
        As sel() has an argument `method` of its own, write `sel({"method": "ed"})`."""
        import xarray

        frame = self.pandas()
        dimensions = self._dimensions or [("row", (), len(frame))]
        names = [name for name, _, _ in dimensions]
        shape = [size for _, _, size in dimensions]
        values = {}
        for column in frame:
            data = np.asarray(frame[column]).reshape(shape)
            kept = [axis for axis, (_, axes, _) in enumerate(dimensions) if column in axes]
            if kept:  # an axis: its values along its dimension
                data = data[tuple(slice(None) if axis in kept else 0 for axis in range(len(shape)))]
                values[column] = ([names[axis] for axis in kept], data)
            else:
                values[column] = (names, data)
        axes = {axis for _, group, _ in dimensions for axis in group}
        dataset = xarray.Dataset(
            {name: value for name, value in values.items() if name not in axes},
            coords={name: value for name, value in values.items() if name in axes},
            attrs={"title": self.title},
        )
        for name in dataset.variables:
            if self.units.get(name, "1") != "1":
                dataset[name].attrs["units"] = self.units[name]
        return dataset

    def __repr__(self):
        return f"<sigmasweep.Table {self.path!r}: {len(self.results)} rows, {self.title!r}>"
