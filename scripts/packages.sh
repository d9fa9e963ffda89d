# Debian's names of what hfdem is built with; sourced by the other scripts.
programs="g++ cmake ninja-build libcli11-dev libtomlplusplus-dev nlohmann-json3-dev libnanoflann-dev \
libboost-dev libeigen3-dev"
tests="$programs doctest-dev libbenchmark-dev python3 python3-vtk9 doxygen"
