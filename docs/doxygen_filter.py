"""What Doxygen reads in place of a file.

A parameter is described once, in its table of fields, and coordinates are declared together on one
line; Doxygen wants a description at every member. And a document's links become references to pages,
headings and headers; those to other files become plain words.

    python3 docs/doxygen_filter.py FILE
"""

import pathlib
import re
import sys

TABLE = re.compile(r"struct \w+(?: : [\w:]+)? \{((?:(?!\bstruct\b).)*?)(static constexpr auto fields\(\) \{.*?\n *\}\n)",
                   re.S)
FIELD = re.compile(r'Field\{\s*"\w+",\s*&[\w:]+::(\w+),\s*"([^"]*)",\s*([^"]*?),\s*((?:"[^"]*"\s*)+)\}',
                   re.S)
START = r"(?: = [^,;{}]+|\{[^{}]*\})?"
DECLARATION = re.compile(rf"^( *)((?:inline constexpr )?[\w:]+(?:<.*>)?) (\w+{START}(?:,\s+\w+{START})*);"
                         r"(?: *///< (.*))?$", re.M)
ABBREVIATION = re.compile(r"\b(Figs?|Eqs?|e\.g|[A-Z])\. ")
HEADING = re.compile(r"^#(?:#+ (.*)| .*)$", re.M)
LINK = re.compile(r"(?<!!)\[([^\]]+)\]\((?!\w+:)([^)\s#]+)(?:#([^)\s]+))?\)")
FENCED = re.compile(r"(^```.*?^```$)", re.M | re.S)
CODE = re.compile(r"`([^`]+)`")
NAMED_RANGES = {"any_number": "", "positive": "greater than 0", "non_negative": "at least 0"}


def range_in_words(text, table):
    """`positive`, `Range{0, 1, true}`, or a name that the table gives to `{.low = 2, .high = 9}`."""
    if text in NAMED_RANGES:
        return NAMED_RANGES[text]
    braces = re.search(r"\b%s\{(.*?)\}" % text if text.isidentifier() else r"Range\{(.*)\}",
                       table if text.isidentifier() else text)
    if not braces:
        return text
    ends = {}
    for name, value in zip(("low", "high", "open_low", "open_high"), braces.group(1).split(",")):
        named = re.match(r"\s*\.(\w+) = (.*)", value)
        ends[named.group(1) if named else name] = (named.group(2) if named else value).strip()
    words = []
    if "low" in ends:
        words.append(("greater than " if ends.get("open_low") == "true" else "at least ") + ends["low"])
    if "high" in ends:
        words.append(("less than " if ends.get("open_high") == "true" else "at most ") + ends["high"])
    return " and ".join(words)


def meanings(table):
    """The description of every member that a table of fields names."""
    found = {}
    for member, unit, allowed, text in FIELD.findall(table):
        meaning = "".join(re.findall(r'"([^"]*)"', text))
        parts = [meaning, unit, range_in_words(" ".join(allowed.split()), table)]
        found[member] = "; ".join(part for part in parts if part)
    return found


def no_full_stop(words):
    """Marks the dots of abbreviations, so that they end no summary."""
    return ABBREVIATION.sub(r"\1.\\ ", words)


def describe(declarations, described):
    """Every member on its own, with the table's description and the comment at the line's end."""

    def line(match):
        indent, kind, names, comment = match.groups()
        members = []
        for one in re.findall(rf"\w+{START}", names):
            words = "; ".join(filter(None, [described.get(re.match(r"\w+", one).group()), comment]))
            if not words:
                return match.group()
            members.append(f"{kind} {one}; /**< {no_full_stop(words)} */")
        return indent + " ".join(members)

    return DECLARATION.sub(line, declarations)


def top(comment):
    """The comment at the top of a file: its indented lines, formulas, stay lines."""
    lines = [line[len("/// "):] for line in comment.splitlines()]
    formula = [line.startswith("  ") for line in lines] + [False]
    for k in range(1, len(lines)):
        if formula[k] and not formula[k - 1]:
            lines[k - 1] += " @verbatim"
        elif formula[k - 1] and not formula[k]:
            lines[k] = "@endverbatim " + lines[k]
    return "/** " + "\n".join(lines) + (" @endverbatim" if formula[len(lines) - 1] else "") + " */\n"


def header(text):
    text = re.sub(r"^ */// ?(?! ).*$", lambda line: no_full_stop(line.group()), text, flags=re.M)
    text = re.sub(r"\A(///.*\n)+", lambda comment: top(comment.group()), text)

    def with_table(match):
        declarations, table = match.groups()
        return (match.group()[:match.start(1) - match.start()] +
                describe(declarations, meanings(table)) +
                "/** The table of these fields. */ " + table)

    return describe(TABLE.sub(with_table, text), {})


def label(page, heading):
    """The label of a heading (its link's fragment), or of a page if there is none."""
    words = re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")
    name = page.parent.name if page.stem == "README" else page.stem
    return "-".join(filter(None, [name, words]))


def link(match):
    words, target, heading = match.groups()
    if target.endswith(".hpp") and "include/" in target:
        return f'@ref {target.split("include/")[1]} "{words}"'
    if target.endswith(".md"):
        return f'@ref {label(pathlib.Path(target), heading or "")} "{words}"'
    return words


def prose(text):
    text = CODE.sub(r"``\1``", text)  # to Doxygen, ` and ' are a pair of quotation marks
    text = HEADING.sub(lambda line: f"{line[0]} {{#{label(file, line[1] or '')}}}", text)
    return LINK.sub(link, text)


def document(text):
    parts = FENCED.split(text)
    return "".join(part if part.startswith("```") else prose(part) for part in parts)


file = pathlib.Path(sys.argv[1])
sys.stdout.write((header if file.suffix == ".hpp" else document)(file.read_text()))
