# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: test_languages.py SOURCE. Every function of raygauge/raygauge_c.h is called, by tests with good and with bad input: from C, and
through the packages of Octave and Julia. Each ccall of Julia's has the types of the header; it runs only where Julia is."""
import pathlib
import re
import sys

from test_abi import declared

source = pathlib.Path(sys.argv[1])
# Julia's types for those of C. A handle is Ptr{Cvoid}; so are pointers to functions, and `data`.
NUMBERS = {"int32_t": {"Int32"}, "int64_t": {"Int64"}, "uint32_t": {"UInt32"}, "double": {"Cdouble"}, "rg_error": {"Int32"},
           "rg_support_mapping": {"Ptr{Cvoid}"}, "rg_stop": {"Ptr{Cvoid}"}}
STRUCTURES = {"rg_pair": "CPair", "rg_answer": "CAnswer", "rg_link": "CLink", "rg_verdict": "CVerdict",
              "rg_checker_options": "CCheckerOptions", "rg_batch_answers": "CBatchAnswers"}


def text_of(*patterns):
    return "\n".join(path.read_text(encoding="utf-8") for pattern in patterns for path in sorted(source.glob(pattern)))


def julia_types(c_type):
    """What may stand in a ccall for a parameter of this type."""
    words = c_type.replace("const", " ").split()
    base, stars = words[0].rstrip("*"), c_type.count("*")
    if stars == 0:
        return NUMBERS[base]
    if base == "char":
        return {"Cstring"}
    if base == "void":
        return {"Ptr{Cvoid}"}
    if base in STRUCTURES:
        return {f"Ref{{{STRUCTURES[base]}}}", f"Ptr{{{STRUCTURES[base]}}}"}
    inner = NUMBERS.get(base, {"Handle"})
    if base not in NUMBERS:
        stars -= 1  # a handle is a pointer
    return inner if stars == 0 else {f"{kind}{{{name}}}" for kind in ("Ref", "Ptr") for name in inner}


def split_arguments(text):
    """The parts between commas outside brackets, up to the bracket that ends the list."""
    parts, depth, part = [], 0, ""
    for letter in text:
        if letter in ")]}" and depth == 0:
            break
        depth += (letter in "([{") - (letter in ")]}")
        if letter == "," and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += letter
    return [part for part in [*parts, part.strip()] if part]


lines = list(declared((source / "include/raygauge/raygauge_c.h").read_text(encoding="utf-8")))
signatures = {}
for line in lines:
    match = re.match(r"(?!typedef|constant)(.*?)\b(rg_\w+)\((.*)\)$", line)
    if match:
        parameters = [] if match.group(3) == "void" else [re.sub(r"\w+$", "", word).strip() for word in match.group(3).split(",")]
        signatures[match.group(2)] = (match.group(1).strip(), parameters)
wrong = []

# C: OK(...), or within an expression; REFUSED(...), or compared with an error. What cannot fail takes a null pointer, or any number.
tests = text_of("tests/c/*.c")
for name, (returned, parameters) in signatures.items():
    refused = re.search(rf"(REFUSED\(|!= RG_OK[^;]*|CHECK\()\s*{name}\(", tests) if returned == "rg_error" else True
    if not re.search(rf"(?<!REFUSED\(){name}\(", tests) or not refused:
        wrong.append(f"C: no good or no bad input of {name}")
    if name.endswith("_free") and f"{name}(NULL)" not in tests:
        wrong.append(f"C: no {name}(NULL)")

# Octave: the compiled file calls every function; the test calls every function of the package, every kind of set, every option.
octave, test = text_of("bindings/octave/src/*.c"), (source / "tests/octave/test_octave.m").read_text(encoding="utf-8").splitlines()
wrong += [f"Octave: nothing calls {name}" for name in signatures if not re.search(rf"\b{name}\(", octave)]
public = re.findall(r"\brg_\w+", (source / "bindings/octave/INDEX").read_text(encoding="utf-8"))
names = {f"{name} (" for name in public} | {f"'{name}'" for name in re.findall(r'^    \{"(\w+)", (?:-?\d|HAS_)', octave, re.M)}
cannot_fail = {"rg_version (", "rg_set ("}  # a set is checked when it is first asked
balls = {"'ball'": "ball ("}                # as the test names it
for name in sorted(names):
    good = [line for line in test if (name in line or balls.get(name, name) in line) and not line.lstrip().startswith("refused")]
    bad = [line for line in test if (name in line or balls.get(name, name) in line) and line.lstrip().startswith("refused")]
    if not good or not (bad or name in cannot_fail):
        wrong.append(f"Octave: no {'bad' if good else 'good'} input of {name}")

# Julia: every function is called, with the header's types and as many arguments; the test calls what is exported.
julia = text_of("bindings/julia/src/*.jl")
calls = re.findall(r"ccall\(\(:(rg_\w+), library\),\s*(.*?),\s*\(([^)]*)\)(.*)", julia.replace("\n", " ").replace("ccall", "\nccall"))
wrong += [f"Julia: nothing calls {name}" for name in signatures if name not in {call[0] for call in calls}]
for name, returned, types, rest in calls:
    c_returned, parameters = signatures[name]
    expected = {"Cvoid"} if c_returned == "void" else julia_types(c_returned)
    given = split_arguments(types)
    if returned not in expected or len(given) != len(parameters) or len(split_arguments(rest.lstrip(", "))) != len(parameters):
        wrong.append(f"Julia: ccall of {name} returns {returned}, has types {given} for {parameters}, arguments {split_arguments(rest.lstrip(', '))}")
        continue
    wrong += [f"Julia: {name}: {kind} for {parameter}" for kind, parameter in zip(given, parameters) if kind not in julia_types(parameter)]
for c_name, name in STRUCTURES.items():  # members in their order, by name
    body = next(re.search(r"\{(.*)\}", line).group(1) for line in lines if line.startswith(f"typedef struct {c_name} {{"))
    members = re.findall(r"(\w+)(?:\[\d+\])?(?=[,;])", body)
    fields = re.findall(r"^    (\w+)::", re.search(rf"struct {name}\n(.*?)\nend", julia, re.S).group(1), re.M)
    if members != fields:
        wrong.append(f"Julia: {name} has {fields}, {c_name} {members}")
runtests = (source / "bindings/julia/test/runtests.jl").read_text(encoding="utf-8").splitlines()
exported = re.findall(r"[\w!]+", " ".join(re.findall(r"^export ((?:.*,\n)*.*)$", julia, re.M)))
cannot_fail = {"ConvexSet", "RaygaugeError", "clear!", "center", "forget!", "ignore_joined!"}
for name in exported:
    use = re.compile(rf"(?<!\w){re.escape(name)}(?![\w!])")
    good = [line for line in runtests if use.search(line) and "refused(" not in line]
    bad = [line for line in runtests if use.search(line) and "refused(" in line]
    if not (good or name == "ConvexSet") or not (bad or name in cannot_fail):
        wrong.append(f"Julia: no {'bad' if good else 'good'} input of {name}")

print("\n".join(wrong) or f"{len(signatures)} functions, from C, Octave and Julia ({len(calls)} ccalls)")
sys.exit(1 if wrong else 0)
