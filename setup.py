"""The Python package as a wheel: the CMake build of python/ and of the program, and what they install. See pyproject.toml."""
import pathlib
import re

from skbuild import setup

root = pathlib.Path(__file__).resolve().parent
setup(
    name="ar3d",
    version=re.search(r"project\(ar3d VERSION (\S+)", (root / "CMakeLists.txt").read_text())[1],
    description="Proved 3D drawings of low-degree graphs with optimal angular resolution",
    license="MIT",
    packages=["ar3d"],
    package_dir={"": "python"},
    python_requires=">=3.9",
    entry_points={"console_scripts": ["ar3d = ar3d:run_program"]},
    install_requires=["numpy"],
    extras_require={"results": ["h5py", "pandas"], "plot": ["matplotlib"]},
    cmake_languages=("CXX",),
    cmake_args=["-DCMAKE_BUILD_TYPE=Release", "-DAR3D_TESTS=OFF", "-DAR3D_PYTHON=ON", "-DAR3D_PYTHON_FOLDER=."],
    cmake_install_dir="python",
    cmake_install_target="ar3d_wheel",
)
