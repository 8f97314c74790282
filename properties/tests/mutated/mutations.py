"""A file edited badly: one to three edits that know its form (JSON, JSON lines, lines of words, bytes), the same for a seed.

`mutated(draw, data, form)` gives bytes. A JSON tree is edited as text would be, so that it may say what no tree can: a member twice,
a number that JSON has not, a letter that UTF-8 has not.
"""

import gzip
import json
import struct

NUMBERS = (
    *("NaN", "nan", "Infinity", "-Infinity", "1e999", "-1e999", "1e308", "1.7976931348623157e308", "-1", "0", "-0.0", "0.5"),
    *("5e-324", "1e-320", "18446744073709551615", "18446744073709551616", "9223372036854775808", "-9223372036854775809"),
    *("9007199254740993", "2147483648", "-2147483649", "1e", "01", "+1", ".5", "1.", "0x10", "1e99999999999", "1" * 5000),
)
STRINGS = (
    *('"x"', '""', '"\\u0000"', '"\\ud800"', '"a\\nb"', '"\\r\\u001b[31m"', '"%s%n"', '"../../x"', '"1.5"', '"nan"', '"é"'),
    *("'x'", '"' + "y" * 100000 + '"', '"\udcff"', '"x', "\\", "\\u0041"),
)
OTHERS = ("null", "true", "false", "[]", "{}", "[1]", "[null]", '{"x": 1}', "[[[]]]", "[" * 1000, '{"a":' * 100, "/**/1", "", ",")
KEYS = ('""', '"x"', '"x_"', '"a.b"', '"a\\nb"', '"\\u001b[2J"', '"[0]"', '"-1"', '"1e9"', '"' + "k" * 5000 + '"', '"\udcfe"', "x")
WORDS = (*NUMBERS, "x", "-", "ITEM:", "ITEM: ATOMS", "\0", "\x1b[31m", "é", "\udcff", "id", "pp", "1;2", "z" * 10000)
CELLS = (0, 1, 2, 255, 2**31, 2**32, 2**53 + 1, 2**62, 2**63 - 1, 2**63, 2**64 - 1, 2**64 - 8, 0x7FF0 << 48, 0x7FF8 << 48)


class Raw(str):
    """JSON text that need not be JSON."""


class Members(list):
    """Of an object: [key's text, value], any number of times."""


def tree_of(text):
    return json.loads(text, object_pairs_hook=lambda pairs: Members([Raw(json.dumps(key)), value] for key, value in pairs))


def text_of(tree):
    if isinstance(tree, Raw):
        return str(tree)
    if isinstance(tree, Members):
        return "{" + ", ".join(f"{key}: {text_of(value)}" for key, value in tree) + "}"
    if isinstance(tree, list):
        return "[" + ", ".join(map(text_of, tree)) + "]"
    return json.dumps(tree)


def places_of(tree):
    """(list or pair, index) of every value below the root."""
    for index, entry in enumerate(tree):
        holder, at = (entry, 1) if isinstance(tree, Members) else (tree, index)
        yield holder, at, tree, index
        if isinstance(holder[at], list):
            yield from places_of(holder[at])


def edit_tree(draw, tree):
    """The tree, with one place of it changed; shallow places as often as the many deep ones."""
    places = list(places_of(tree)) if isinstance(tree, list) else []
    if not places or draw.random() < 0.03:
        return Raw(draw.choice((*OTHERS, *NUMBERS[:4], *STRINGS[:3])))
    if draw.random() < 0.4:
        kinds = {}
        for place in places:
            kinds.setdefault((text_of(place[0][0]) if isinstance(place[2], Members) else "[]"), []).append(place)
        places = kinds[draw.choice(sorted(kinds))]
    holder, at, above, index = draw.choice(places)
    edit = draw.choice(("number", "string", "other", "delete", "twice", "key", "unknown", "swap"))
    if edit in ("number", "string", "other"):
        holder[at] = Raw(draw.choice({"number": NUMBERS, "string": STRINGS, "other": OTHERS}[edit]))
    elif edit == "delete":
        del above[index]
    elif edit == "twice":
        above.insert(index, list(above[index]) if isinstance(above, Members) else above[index])
    elif edit == "swap":
        other, there, _, _ = draw.choice(places)
        holder[at] = Raw(text_of(other[there]))
    elif isinstance(above, Members):
        above[index] = [Raw(draw.choice(KEYS)), holder[at]] if edit == "key" else above[index]
        above.insert(index + (edit == "unknown"), [Raw(draw.choice(KEYS)), holder[at]]) if edit == "unknown" else None
    else:
        above.insert(index, Raw(draw.choice(OTHERS)))
    return tree


def edit_json(draw, data):
    try:
        tree = tree_of(data.decode())
    except (ValueError, RecursionError):  # an earlier edit
        return edit_bytes(draw, data)
    return text_of(edit_tree(draw, tree)).encode("utf-8", "surrogateescape")


def edit_lines(draw, data, edit_one):
    """A line of them edited, gone, twice, in another's place."""
    lines = data.split(b"\n")
    at = draw.randrange(max(1, len(lines) - (lines[-1] == b"")))
    edit = draw.choice(("edit",) * 6 + ("delete", "twice", "swap", "blank"))
    if edit == "edit":
        lines[at] = edit_one(draw, lines[at])
    elif edit == "delete":
        del lines[at]
    elif edit == "twice":
        lines.insert(at, lines[at])
    elif edit == "blank":
        lines.insert(at, b" ")
    else:
        other = draw.randrange(len(lines))
        lines[at], lines[other] = lines[other], lines[at]
    return b"\n".join(lines)


def edit_words(draw, line):
    words = line.split(b" ")
    at = draw.randrange(len(words))
    edit = draw.choice(("replace", "replace", "delete", "twice", "swap"))
    if edit == "replace":
        words[at] = draw.choice(WORDS).encode("utf-8", "surrogateescape")
    elif edit == "delete":
        del words[at]
    elif edit == "twice":
        words.insert(at, words[at])
    else:
        other = draw.randrange(len(words))
        words[at], words[other] = words[other], words[at]
    return b" ".join(words)


def edit_cells(draw, data):
    """Eight bytes of them."""
    at = draw.randrange(max(1, len(data) - 8))
    cell = struct.pack("<Q", draw.choice((*CELLS, draw.randrange(64))))
    return data[:at] + cell + data[at + 8 :]


def edit_bytes(draw, data):
    one, other = sorted((draw.randrange(len(data) + 1), draw.randrange(len(data) + 1)))
    other = min(other, one + draw.choice((1, 8, 100)))
    noise = bytes(draw.randrange(256) for _ in range(draw.choice((1, 3, 40))))
    return draw.choice(
        (
            lambda: data[:one],
            lambda: data[:one] + data[other:],
            lambda: data[:other] + data[one:],
            lambda: data[:one] + noise + data[one:],
            lambda: data[:one] + noise + data[one + len(noise) :],
            lambda: data[:one] + bytes(other - one) + data[other:],
            lambda: data[:one] + bytes([data[one] ^ 1 << draw.randrange(8)]) + data[one + 1 :] if one < len(data) else data + noise,
        )
    )()


def edit_whole(draw, data):
    return draw.choice(
        (
            lambda: b"",
            lambda: b"\n \n",
            lambda: b"\xef\xbb\xbf" + data,
            lambda: b"\xff\xfe" + data.decode("latin1").encode("utf-16-le"),
            lambda: gzip.compress(data, mtime=0),
            lambda: bytes(draw.randrange(256) for _ in range(200)),
            lambda: b"[" * 100000,
            lambda: b'{"a":' * 100000,
            lambda: b"[" * 60 + data + b"]" * 60,
            lambda: data + data,
            lambda: data + b"x",
            lambda: data.replace(b"\n", b"\r\n"),
            lambda: data.replace(b"\n", b"\r"),
            lambda: data.replace(b" ", b"\xa0"),
            lambda: b"[" + data + b"]",
            lambda: b"\x7fELF" + data,
        )
    )()


FORMS = {
    "json": edit_json,
    "lines": lambda draw, data: edit_lines(draw, data, edit_json),
    "words": lambda draw, data: edit_lines(draw, data, edit_words),
    "cells": edit_cells,
}


def mutated(draw, data, form):
    """Seven of ten times by form, else as bytes or as a whole; a second and a third edit are rarer."""
    edits = 1 + (draw.random() < 0.2) + (draw.random() < 0.1)
    for _ in range(edits):
        chance = draw.random()
        edit = FORMS[form] if chance < 0.7 else edit_bytes if chance < 0.9 else edit_whole
        data = edit(draw, data)
    return data
