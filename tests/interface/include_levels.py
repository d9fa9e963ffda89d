"""Includes go downhill: a header includes only headers of lower levels and of its own folder.

usage: include_levels.py INCLUDE_DIRECTORY
"""
import pathlib
import re
import sys

# Folders, and the headers outside of them.
LEVELS = {
    "base": 0,
    "analytic": 1, "state": 1,
    "contact": 2, "aperture": 2, "fluid": 2, "leakoff": 2, "neighbours": 2,
    "pressure": 3, "mechanics": 3, "setup": 3,
    "simulator_params.hpp": 4, "assembly.hpp": 4, "simulator_observers.hpp": 4,
    "simulator_checks.hpp": 4, "simulator.hpp": 4,
    "measure": 5,
    "observe": 6,
    "hfdem.hpp": 7,
}
UMBRELLA = "hfdem.hpp"
LONGEST_CHAIN = 8  # includes, from the umbrella down


def read_includes(root):
    """Header -> the headers of hfdem that it includes, in terms of paths below `root`."""
    return {
        path.relative_to(root).as_posix():
            re.findall(r'^\s*#\s*include\s*(?:<hfdem/|")([^">]+)', path.read_text(), re.M)
        for path in sorted(root.rglob("*.hpp"))
    }


def folder(header):
    return header.rpartition("/")[0]


def level(header):
    return LEVELS[folder(header) or header]


def unknown(includes):
    for header, below in includes.items():
        if (folder(header) or header) not in LEVELS:
            yield f"{header} has no level: add its folder to LEVELS"
        for included in below:
            if included not in includes:
                yield f"{header} includes {included}, which is no header of hfdem"


def uphill(includes):
    for header, below in includes.items():
        for included in below:
            own_folder = folder(included) == folder(header) and level(included) == level(header)
            if level(included) >= level(header) and not own_folder:
                yield (f"{header} (level {level(header)}) includes {included} "
                       f"(level {level(included)})")


def longest_chain(includes, header, above=()):
    if header in above:
        sys.exit("a circle of includes: " + " -> ".join([*above, header]))
    chains = [longest_chain(includes, included, (*above, header)) for included in includes[header]]
    return [header, *max(chains, key=len, default=[])]


def reached(includes, header):
    return {header}.union(*(reached(includes, included) for included in includes[header]))


includes = read_includes(pathlib.Path(sys.argv[1]) / "hfdem")
complaints = list(unknown(includes))
if not complaints:
    chain = max((longest_chain(includes, header) for header in includes), key=len)
    print(f"{len(includes)} headers, longest chain:", " -> ".join(chain))
    complaints += uphill(includes)
    if len(chain) - 1 > LONGEST_CHAIN:
        complaints.append(f"the chain has {len(chain) - 1} includes, more than {LONGEST_CHAIN}")
    for header in sorted(set(includes) - reached(includes, UMBRELLA)):
        complaints.append(f"{UMBRELLA} does not reach {header}")
sys.exit("\n".join(complaints) or 0)
