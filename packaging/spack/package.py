# Copyright: MIT, as sigmasweep.
from spack.package import *


class Sigmasweep(CMakePackage):
    """MPI-parallel parameter sweeps of granular collisions, into one HDF5 table that is the same to the bit for any
    number of ranks."""

    license("MIT")
    version("0.1.0")  # of a checkout: spack dev-build sigmasweep@0.1.0

    variant("python", default=False, description="Build the Python package")

    depends_on("cmake@3.24:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("mpi")
    depends_on("hdf5+mpi@1.10:")
    depends_on("boost@1.74:+mpi+serialization")
    depends_on("eigen@3.4:")
    depends_on("tomlplusplus")
    depends_on("muparser")
    depends_on("fmt@9:")
    depends_on("cli11")
    depends_on("nlohmann-json")
    depends_on("xxhash")
    depends_on("fontconfig")
    depends_on("gnuplot", type="run")
    depends_on("python@3.10:", when="+python", type=("build", "run"))
    depends_on("py-pybind11", when="+python", type="build")
    depends_on("py-numpy", when="+python", type=("build", "run"))
    depends_on("py-h5py", when="+python", type="run")

    conflicts("%gcc@:11", msg="C++20 of g++ 12 is needed")
    requires("target=x86_64_v3:", msg="AVX2 and FMA are needed")

    def cmake_args(self):
        return [
            self.define("SIGMASWEEP_TESTS", False),
            self.define("SIGMASWEEP_BENCH", False),
            self.define_from_variant("SIGMASWEEP_PYTHON", "python"),
        ]
