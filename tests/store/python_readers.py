"""What the documentation promises to Python users of a results file.

python_readers.py lines FILE.h5           600 sample rows, read in one line by pandas and by h5py, with warnings as errors
python_readers.py tools FILE.h5 TOOLS     4 of them, one without violations, by TOOLS/ar3d_results.py"""
import sys
import warnings

import numpy


def one_line_each(f):
    import h5py
    import pandas
    import tables
    warnings.simplefilter("error")
    a = pandas.read_hdf(f, "runs")
    b = pandas.DataFrame(h5py.File(f)["runs"][:])
    for t in (a, b):
        assert len(t) == 600, len(t)
        assert t.requested_n[7] == 13 and t.extent_z[0] == 2**61 and t.bends_7[599] == 8
        assert t.seed[0] == 2**64 - 1 and t.seed.dtype == numpy.uint64
        assert numpy.isnan(t.certify_s).all() and (t.peak_bytes == -1).all()
        assert abs(t.log2_volume[3] - 0.3) < 1e-15
    assert a.algorithm[1] == "grid" and b.algorithm[1] == b"grid", (a.algorithm[1], b.algorithm[1])
    assert list(a.columns) == list(b.columns)
    i = pandas.read_hdf(f, "instances")
    assert len(i) == 300 and list(i.requested_n) == list(range(10, 310))
    assert pandas.read_hdf(f, "environments").value[0] == "abacus"
    h = h5py.File(f)
    assert h["spec"][()].decode() == "# h\u00f6her\n[study]\n"
    assert h.attrs["format"].decode() == "ar3d-results" and h.attrs["format_version"] == 3
    assert h["runs"].attrs["wall_s.unit"].decode() == "s"
    tables.open_file(f).root.runs.attrs._f_list("all")


def by_the_tool(f, tools):
    sys.path.insert(0, tools)
    import ar3d_results
    runs = ar3d_results.read(f)
    assert runs.algorithm[1] == "grid" and isinstance(runs.algorithm[1], str)
    assert runs.violations.mean() == 0 and runs.violations.count() == 3
    assert runs.peak_bytes.isna().all() and runs.wall_s.isna().sum() == 0
    assert runs.seed[0] == 2**64 - 1
    assert len(ar3d_results.read(f, "instances")) == 2


{"lines": one_line_each, "tools": by_the_tool}[sys.argv[1]](*sys.argv[2:])
