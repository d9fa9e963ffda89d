#!/usr/bin/env bash
# Installs the named Debian or Ubuntu packages that are missing, and says so. Where it may not
# install, it says what to ask for.
#
#   scripts/install_packages.sh PACKAGE...
set -euo pipefail

missing=()
for package in "$@"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' ||
    missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    as_root=(sudo)
  else
    printf 'hfdem needs packages that are not installed, and this user may not install them.\n' >&2
    printf 'Please run, or ask an administrator to run:\n\n  sudo apt-get install %s\n\n' \
      "${missing[*]}" >&2
    exit 1
  fi
fi

printf 'Installing: %s\n' "${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" apt-get install -y -qq "${missing[@]}" >/dev/null
