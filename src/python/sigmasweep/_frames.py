"""Rows as pandas data frames."""


def to_pandas(rows, units=None):
    """A structured array as a pandas.DataFrame. Enumerations become categories. `units` are kept in `attrs["units"]`."""
    import pandas

    flat = rows.reshape(-1)
    columns = {}
    for name in flat.dtype.names:
        enumeration = (flat.dtype[name].metadata or {}).get("enum")
        if enumeration:
            names = sorted(enumeration, key=enumeration.get)
            columns[name] = pandas.Categorical.from_codes(flat[name].astype(int), names)
        else:
            columns[name] = flat[name]
    frame = pandas.DataFrame(columns)
    if units:
        frame.attrs["units"] = units
    return frame
