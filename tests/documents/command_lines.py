"""Command lines of edvo within blocks of shell or YAML, and within code spans of a text."""

import re
import shlex

import documents

PREFIXES = {"do", "then", "else", "if", "while", "!", "time", "-", "run:", "/usr/bin/time", "-v", "{"}
ASSIGNMENT = re.compile(r"^(\w+)=(.*)$", re.DOTALL)
QUOTED = "\1"  # before the name of a variable within quotation marks
PROGRAM = re.compile(r"^(?:[\w./-]*/)?edvo$")


def commands(text):
    """The arguments of each call of edvo. Variables that the block sets, loops included, are put in; N is a number."""
    text = re.sub(r"<<'?(\w+)'?.*?\n\1\n", "\n", text, flags=re.DOTALL)  # files that are written
    text = re.sub(r"\\\n", " ", text)
    text = re.sub(r"\n\s+(?=--)", " ", text)  # folded lines of YAML
    text = re.sub(r"\$\((?!edvo)[^()]*\)", "OUTPUT", text)  # what another command prints
    text = re.sub(r'"\$(\w+)"', QUOTED + r"\1", text)
    text = re.sub(r"(?<=[ =])N(?=[\s])", "1", text)
    found, variables = [], {}
    for line in text.split("\n"):
        try:
            lexer = shlex.shlex(line, posix=True, punctuation_chars=True)
            lexer.whitespace_split = True
            tokens = list(lexer)
        except ValueError:  # a quotation over several lines, which is a program of another language
            continue
        for words in simple_commands(tokens):
            arguments = edvo_arguments(words, variables)
            if arguments is not None:
                found.append(arguments)
    return found


def simple_commands(tokens):
    words, is_file = [], False
    for token in tokens:
        if token and all(c in "();<>|&" for c in token):
            yield words
            words, is_file = [], token[0] in "<>"
        elif is_file:
            is_file = False
        else:
            words.append(token)
    yield words


def edvo_arguments(words, variables):
    if words[:1] == ["for"] and words[2:3] == ["in"] and len(words) > 3:
        variables[words[1]] = words[3]
        return None
    words = [part for word in words for part in expanded(word, variables)]
    while words and (words[0] in PREFIXES or ASSIGNMENT.match(words[0])):
        assignment = ASSIGNMENT.match(words.pop(0))
        if assignment:
            variables[assignment[1]] = assignment[2]
    return words[1:] if words and PROGRAM.match(words[0]) else None


def expanded(word, variables):
    if word.startswith(QUOTED):
        return [variables.get(word[1:], word[1:])]
    if word.startswith("$") and word[1:] in variables:
        return shlex.split(variables[word[1:]])
    return [re.sub(r"\$(\w+)", lambda name: variables.get(name[1], name[0]), word)]


def options_of_commands(manual):
    """{command: its options}, of `edvo manual --format markdown`; "path check" is a command beside "path"."""
    options = {}
    for section in re.split(r"^## edvo ", manual, flags=re.MULTILINE)[1:]:
        name = section.split("\n", 1)[0]
        options[name] = set(re.findall(r"^\| `(--[\w.-]+)`", section, flags=re.MULTILINE))
    return options


def unknown_in_spans(text, options):
    """(line, what is wrong) of code spans that begin with edvo."""
    for number, line in enumerate(documents.split_code(text)[0], 1):
        for span in re.findall(r"`(edvo [a-z][^`]*)`", line):
            words = span.split("|")[0].split()[1:]
            name = next((" ".join(words[:n]) for n in (2, 1) if " ".join(words[:n]) in options), None)
            if name is None:
                if words[0] != "help":
                    yield number, f"`{span}`: edvo has no command {words[0]}"
                continue
            for option in re.findall(r"(?<![\w-])(--[a-z][\w.-]*)", span):
                if option not in options[name] and option != "--version":
                    yield number, f"`{span}`: edvo {name} has no option {option}"
