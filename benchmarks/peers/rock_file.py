"""hfdem's specimen files for the other codes."""

import pathlib


def read(path):
    """The numbers of the header by name, and x, y and radius of every disc, m."""
    header, discs = {}, []
    for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
        words = line.split("#")[0].split()
        if len(words) == 3 and words[0] != "hfdem":
            discs.append([float(word) for word in words])
        elif len(words) == 2:
            header[words[0]] = float(words[1])
    return header, discs
