"""Reads a results file of ar3d (results/SCHEMA.md) into pandas.

    import ar3d_results
    runs = ar3d_results.read("r.h5")

Texts are str, integers pandas' Int64 or UInt64, and what is missing (-1 among integers, NaN among numbers) is
NA: a mean leaves it out. Needs h5py and pandas; reads files of version 3.
"""
import sys

import h5py
import pandas


def read(path, table="runs"):
    """The table as a DataFrame: "runs", "instances", "algorithms" or "environments"."""
    with h5py.File(path, "r") as file:
        records = file[table][:]
    columns = {}
    for name in records.dtype.names:
        values = pandas.Series(records[name])
        kind = records.dtype[name].kind
        if kind == "S":
            values = values.str.decode("ascii").astype("string")
        elif kind == "i":
            values = values.astype("Int64")
            if not name.endswith(("_constant_x", "_constant_y", "_constant_z")):  # may be -1
                values = values.mask(values == -1)
        elif kind == "u":
            values = values.astype("UInt64")
        columns[name] = values
    return pandas.DataFrame(columns)


if __name__ == "__main__":
    print(read(sys.argv[1], *sys.argv[2:3]).to_string())
