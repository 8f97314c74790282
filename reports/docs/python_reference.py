#!/usr/bin/env python3
"""python_reference.py: prints the page of the Python package that PYTHONPATH holds, name by name, from its texts and types alone.

A text is a sentence, rows "argument  what" for every argument, "Gives ..", what is raised, and an example. Exit 1, with a line on
stderr for each name whose text lacks a part.
"""
import ast
import dataclasses
import enum
import inspect
import re
import sys
import textwrap
from pathlib import Path

ROW = re.compile(r"^(\w+(?:, \w+)*) {2,}(\S.*)$")
FIELD = re.compile(r"(?m)^    (\w+)(?:: (.+?))?(?: = (.+?))?(?:  #: (.+))?$")
SENTENCE = re.compile(r"(?<=[^.][.]) +(?=[A-Z`])")
NOT_SHOWN = {"__init__", "__eq__", "__hash__", "__repr__", "__str__"}
# A name that a module of the package gives to a type.
ALIAS = re.compile(r"(?m)^(\w+) = ((?:NDArray|tuple|dict|str \|).*)$")
ALIASES = {}


class Text:
    """A docstring, taken apart."""

    def __init__(self, doc):
        paragraphs = [part for part in inspect.cleandoc(doc or "").split("\n\n") if part.strip()]
        if paragraphs and re.match(r"\w+\(", paragraphs[0]):
            del paragraphs[0]  # the signature that the module writes for itself
        self.rows, self.codes, self.example, prose = [], [], "", []
        for part in paragraphs:
            if part.lstrip().startswith(">>>"):
                self.example += textwrap.dedent(part) + "\n"
            elif part.startswith("    "):
                self.codes.append(textwrap.dedent(part))
            elif all(ROW.match(line) or line.startswith("  ") for line in part.split("\n")):
                self.rows += rows_of(part)
            else:
                prose += SENTENCE.split(" ".join(part.split()))
        self.summary = prose[0] if prose and paragraphs[0].startswith(prose[0].split()[0]) else ""
        self.gives = [sentence for sentence in prose[1:] if sentence.startswith("Gives ")]
        self.errors = [sentence for sentence in prose[1:] if "Error" in sentence and sentence not in self.gives]
        self.rest = [sentence for sentence in prose[1:] if sentence not in self.gives + self.errors]

    def arguments(self):
        return {name for names, _ in self.rows for name in names.split(", ")}


def rows_of(part):
    rows = []
    for line in part.split("\n"):
        if found := ROW.match(line):
            rows.append([found[1], found[2]])
        else:
            rows[-1][1] += " " + line.strip()
    return rows


def markdown(words):
    """As Doxygen reads it, which would take a name with () for one of C++."""
    return re.sub(r"``(\w+)\(\)``", r"`\1`", words).replace("``", "`").replace("|", "\\|")


def table(head, rows):
    lines = [f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
    return lines + [f"| {' | '.join(row)} |" for row in rows] + [""]


def spelled(kind):
    """A type without the package's own short names for types."""
    return re.sub(r"\b\w+\b", lambda word: ALIASES.get(word[0], word[0]), kind)


def parameters(signature):
    return [name for name in signature.parameters if name not in ("self", "cls")]


def written(name, signature):
    """The call on one line, or an argument a line where that is too long."""
    parts, is_named = [], False
    for parameter in signature.parameters.values():
        if parameter.name in ("self", "cls"):
            continue
        if parameter.kind is parameter.KEYWORD_ONLY and not is_named:
            parts.append("*")
            is_named = True
        kind = f": {spelled(parameter.annotation)}" if parameter.annotation is not parameter.empty else ""
        default = f" = {parameter.default!r}" if parameter.default is not parameter.empty else ""
        parts.append(f"{parameter.name}{kind}{default}")
    end = f" -> {spelled(signature.return_annotation)}" if signature.return_annotation is not signature.empty else ""
    line = f"{name}({', '.join(parts)}){end}"
    return line if len(line) <= 96 else f"{name}(\n" + "".join(f"    {part},\n" for part in parts) + f"){end}"


class Package:
    """The names of a module, and what of it has no types of its own: plumb._native, whose types stand in a file beside it."""

    def __init__(self, module, types):
        self.module, self.names = module, [name for name in module.__all__ if not name.startswith("_")]
        self.types = {node.name: node for node in ast.parse(types).body if isinstance(node, ast.ClassDef)}

    def native(self, name):
        """{member: its type} and {function: its signature} of a class of plumb._native."""
        functions = {node.name: node for node in self.types[name].body}
        is_property = lambda node: bool(node.decorator_list)
        members = {key: ast.unparse(node.returns) for key, node in functions.items() if is_property(node)}
        calls = {key: f"({ast.unparse(node.args)}) -> {ast.unparse(node.returns)}" for key, node in functions.items() if not is_property(node)}
        return members, calls

    def linked(self, kind):
        """A type, with links to the package's own."""
        name = f"`{spelled(kind)}`"
        own = [word for word in re.findall(r"\w+", kind) if word in self.names]
        links = ", ".join(f'@ref python_{word} "{word}"' for word in own)
        return links if kind in own else f"{name} ({links})" if own else name


def function_lines(package, name, function, level="##"):
    signature, text = inspect.signature(function), Text(function.__doc__)
    label = name.replace(".", "_")
    lines = [f"{level} plumb.{name} {{#python_{label}}}", "", "```python", written(name, signature), "```", "", markdown(text.summary), ""]
    if text.rows:
        lines += table(("argument", "what"), [(f"`{names}`", markdown(what)) for names, what in text.rows])
    if text.rest:
        lines += [markdown(" ".join(text.rest)), ""]
    gives = " ".join(sentence.removeprefix("Gives ") for sentence in text.gives)
    lines += [f"**Gives** {package.linked(signature.return_annotation)}{': ' + markdown(gives) if gives else '.'}", ""]
    if text.errors:
        lines += [f"**Raises.** {markdown(' '.join(text.errors))}", ""]
    return lines + example_lines(text)


def example_lines(text):
    if not text.example:
        return []
    return ['<div class="caption">Example, run by the test <code>python/package</code></div>', "", "```python", *text.example.rstrip().split("\n"), "```", ""]


def fields_of(package, name, kind):
    """[name, type or value, text] of what an object of the class holds."""
    if name in package.types:
        return [[key, declared, getattr(kind, key).__doc__ or ""] for key, declared in package.native(name)[0].items()]
    body = re.sub(r'""".*?"""', "", inspect.getsource(kind), count=1, flags=re.S).split("\n    def ")[0]
    rows = dict(Text(kind.__doc__).rows)
    known = {*getattr(kind, "__dataclass_fields__", ()), *getattr(kind, "_fields", ()), *getattr(kind, "__members__", ())}
    return [[row[1], row[2] or row[3] or "", row[4] or rows.get(row[1], "")] for row in FIELD.finditer(body) if row[1] in known]


def methods_of(package, name, kind):
    """{name: function} of a class in Python."""
    if name in package.types or issubclass(kind, enum.Enum):
        return {}
    own = {key: getattr(kind, key) for key in vars(kind) if key == "__getitem__" or not key.startswith("_")}
    return {key: value for key, value in own.items() if inspect.isroutine(value)}


def native_call(name, arguments):
    return ["```python", name + arguments.replace("(self, ", "(").replace(" -> None", ""), "```", ""]


def class_lines(package, name, kind):
    text, lines = Text(kind.__doc__), [f"## plumb.{name} {{#python_{name}}}", ""]
    calls = package.native(name)[1] if name in package.types else {}
    if "__init__" in calls:
        lines += native_call(name, calls["__init__"])
    elif dataclasses.is_dataclass(kind) and "__init__" in vars(kind) and text.rows:
        lines += ["```python", written(name, inspect.signature(kind.__init__)).replace(" -> None", ""), "```", ""]
    lines += [markdown(" ".join([text.summary, *text.rest])), ""]
    for code in text.codes:
        lines += ["```text", code, "```", ""]
    fields = fields_of(package, name, kind)
    if fields:
        arguments = dict(text.rows)
        head = ("field", "value" if issubclass(kind, enum.Enum) else "type", "what")
        lines += table(head, [(f"`{key}`", f"`{markdown(spelled(declared))}`", markdown(arguments.get(key, what))) for key, declared, what in fields])
    if text.errors:
        lines += [f"**Raises.** {markdown(' '.join(text.errors))}", ""]
    lines += example_lines(text)
    for key in sorted(calls.keys() - NOT_SHOWN):
        said = inspect.cleandoc(getattr(kind, key).__doc__).split("\n\n")[-1]
        lines += [f"### plumb.{name}.{key} {{#python_{name}_{key}}}", "", *native_call(f"{name}.{key}", calls[key]), markdown(said), ""]
    for key, method in methods_of(package, name, kind).items():
        lines += function_lines(package, f"{name}.{key}", method, "###")
    return lines


def missing_of_function(name, function, is_method=False):
    text = Text(function.__doc__)
    mentioned = set(re.findall(r"``(\w+)``", function.__doc__ or "")) if is_method else set()
    if not text.summary:
        yield f"{name}: has no text"
    for argument in parameters(inspect.signature(function)):
        if argument not in text.arguments() | mentioned:
            yield f"{name}: does not say what {argument} is"
    if is_method:
        return
    if parameters(inspect.signature(function)) and not text.errors and "Error" not in text.summary:
        yield f"{name}: does not say what it raises"
    if inspect.signature(function).return_annotation in ("Json", "dict[str, Any]") and not text.gives:
        yield f"{name}: does not say what it gives"
    if not text.example:
        yield f"{name}: has no example"


def missing_of_class(package, name, kind):
    if not Text(kind.__doc__).summary:
        yield f"{name}: has no text"
    for field, _, what in fields_of(package, name, kind):
        if not what:
            yield f"{name}.{field}: has no text"
    for key, method in methods_of(package, name, kind).items():
        yield from missing_of_function(f"{name}.{key}", method, is_method=True)


def missing(package):
    """A line for each part that a public name's text lacks."""
    for name in package.names:
        thing = getattr(package.module, name)
        yield from missing_of_class(package, name, thing) if inspect.isclass(thing) else missing_of_function(name, thing)


def groups(package):
    """As the module's own text lists them; what it does not list comes last."""
    listed = [(found[1], re.findall(r"\w+", found[2])) for found in re.finditer(r"(?m)^(\S.*?) {3,}(.+)$", package.module.__doc__ or "")]
    listed = [(head.strip(), [name for name in names if name in package.names]) for head, names in listed]
    shown = {name for _, names in listed for name in names}
    return [group for group in listed if group[1]] + [("What they hold and give", [name for name in package.names if name not in shown])]


def page(package):
    lines = ["# Python, name by name {#pythonreference}", "", "[TOC]", ""]
    lines += ["What `help(plumb.NAME)` says, on one page. @ref python has whole programs. `import plumb` stands before every example.", ""]
    lines += [markdown(inspect.cleandoc(package.module.__doc__ or "").split("\n\n")[-1]), ""]
    for head, names in groups(package):
        lines += [f"# {head.rstrip(':')} {{#python_{re.sub(chr(92) + 'W', '_', head.lower())}}}", ""]
        for name in names:
            thing = getattr(package.module, name)
            lines += class_lines(package, name, thing) if inspect.isclass(thing) else function_lines(package, name, thing)
    return "\n".join(lines)


def main():
    import plumb

    folder = Path(plumb.__file__).parent
    for module in folder.glob("*.py"):
        ALIASES.update(ALIAS.findall(module.read_text()))
    package = Package(plumb, "".join((folder / name).read_text() for name in ("_native.pyi", "_shapes.pyi")))
    print(page(package))
    lacking = list(missing(package))
    print(*lacking, sep="\n", end="\n" if lacking else "", file=sys.stderr)
    sys.exit(1 if lacking else 0)


if __name__ == "__main__":
    main()
