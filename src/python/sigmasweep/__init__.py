"""Collisions of granular columns and lattices with a wall, Luding et al., Phys. Rev. E 50, 4113 (1994).

    import numpy as np, sigmasweep as ss
    r = ss.simulate(N=10, epsilon=0.9, v0=1.0, tc=1e-5, sigma=np.geomspace(1e-4, 1e2, 301))
    r["eps_eff"], r["eps_eff_error"]        # numpy arrays
    t = ss.open("beads.h5")                 # a table that 'sigmasweep run' wrote
    t.results, t.pandas(), t.xarray()

Units are SI. 'sigmasweep help fields' lists parameters and results.
"""

from sigmasweep import _core
from sigmasweep._frames import to_pandas
from sigmasweep._simulate import simulate
from sigmasweep._table import Table, open

__version__ = _core.version
__all__ = ["Table", "open", "simulate", "to_pandas"]
