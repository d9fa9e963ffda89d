#!/usr/bin/env bash
# From a clean clone to the paper's verification model and its carbon dioxide in intact rock: installs
# what is missing, builds, runs. Takes a folder for the results; out if none is given.
#
#   scripts/demo.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."
out=${1:-out}

. scripts/packages.sh
# shellcheck disable=SC2086  # a list of words
scripts/install_packages.sh $programs

echo "Building (about a minute) ..."
cmake --preset release -DHFDEM_TESTS=OFF -DHFDEM_BENCHMARKS=OFF >build.log 2>&1 &&
  cmake --build --preset release --target kgd intact >>build.log 2>&1 || {
  cat build.log >&2
  exit 1
}
rm build.log

echo "A crack driven by uniform pressure through 10,000 bonded discs (some seconds) ..."
build/release/examples/kgd --out "$out/kgd" --toughness examples/data/toughness.toml
echo "Carbon dioxide in rock, 17,511 discs of random size and place (half a minute) ..."
build/release/examples/intact --case 2-S1 --out "$out/intact" --threads "$(nproc)"
echo "As addresses: file://$(realpath "$out")/kgd/report.html"
echo "              file://$(realpath "$out")/intact/report.html"
echo "All other programs: cmake --build --preset release"
