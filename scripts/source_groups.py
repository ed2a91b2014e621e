# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups sources that scripts/check_sources compiles one after another as one text.

Most of the time goes into headers of ours, which neighbours share. A group must not hide what a source
compiled alone would show: a name from a header that it does not include, or a private name of another
source. So a source follows others only if none of its words is such a name. Words that the source
declares itself, or finds in headers that it includes, are no such names. The same holds for the header
that it includes first, which would have to compile alone.
"""
import collections
import re

INCLUDE = re.compile(r'^ *# *include ["<](.+)[">]', re.M)
NOISE = re.compile(r'^ *# *include[^\n]*|//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"'
                   r"|\b'(?=\d)|'(?:\\.|[^'\\\n])+'", re.S | re.M)
WORD = re.compile(r"[A-Za-z_]\w*")
# A word that a type, * or & stands before, and a sign that ends a declaration behind it.
DECLARED = re.compile(r"(?:\b(?!(?:return|throw|else|case|new|not|and|or|in)\b)\w+|[>&*\]])\s+[&*]*([A-Za-z_]\w*)"
                      r"\s*(?=[=;,(){}\[:])")
BINDING = re.compile(r"auto&{0,2} \[([^\]]*)\]")
# Names outside classes and functions, which clang-format puts at the start of a line.
OUTSIDE = re.compile(r"^[A-Za-z][^\n(={]*?[ *&]([A-Za-z_]\w*) ?[({=;\[]|"
                     r"^(?:template ?<[^\n]*> )?(?:struct|class|enum class|enum|union|using|namespace|concept) (\w+)",
                     re.M)
ALIAS = re.compile(r"^namespace (\w+) = .*;$", re.M)
# Such a source changes the meaning of text behind it.
STANDS_ALONE = re.compile(r"^ *# *(?:define|undef)\b|^using namespace\b", re.M)
KEYWORDS = set("""alignas alignof alphascope and auto bool break case catch char class concept const consteval
    constexpr continue decltype default delete do double else enum explicit extern false float for friend goto if
    inline int long mutable namespace new noexcept not nullptr operator or private protected public requires return
    short signed size_t sizeof static static_assert static_cast std struct switch template this thread_local throw
    true try typename union unsigned using virtual void while""".split())
# Members of the standard library's classes have the names of many members of ours. A group that they
# prevent would only cost time.
STANDARD = re.compile(r"\bstd(?:::[A-Za-z_]\w*)+|(?:\.|->)\s*(?:append|at|back|begin|c_str|clear|contains|count|data"
                      r"|emplace_back|empty|end|erase|find|first|front|get|insert|join|key|length|list|load|lock|max|min"
                      r"|push_back|reserve|reset|resize|second|size|store|str|substr|value|wait|what)\b")
OF_OTHERS = re.compile(r"(?:\.|->|\bstd::)\s*[A-Za-z_]\w*")
LARGEST = 16


def outside_parentheses(text):
    kept, depth = [], 0
    for piece in re.split(r"([()])", text):
        depth += (piece == "(") - (piece == ")")
        kept.append(piece if depth == 0 else " ")
    return "".join(kept)


class File:
    """What the text of a source or header says about names."""

    def __init__(self, text):
        code = NOISE.sub(" ", text)
        self.includes = INCLUDE.findall(text)
        self.words = set(WORD.findall(STANDARD.sub(" ", code))) - KEYWORDS
        self.declared = set(DECLARED.findall(code)).union(*(WORD.findall(b) for b in BINDING.findall(code)))
        self.gives = set(WORD.findall(OF_OTHERS.sub(" ", outside_parentheses(code)))) - KEYWORDS
        self.outside = {name for pair in OUTSIDE.findall(code) for name in pair} - {"", "alphascope", "std"}
        self.aliases = set(ALIAS.findall(code))
        self.stands_alone = bool(STANDS_ALONE.search(code))


class Files:
    """Names of files by path, with the files that they include."""

    def __init__(self, texts):
        self.files = {name: File(text) for name, text in texts.items()}
        self.closures = {}
        self.unknowns = {}

    def closure(self, name):
        """Returns all that a file includes, but not the standard library's headers (check_includes)."""
        if name not in self.closures:
            self.closures[name] = set()
            found = set()
            for included in self.files[name].includes:
                if included in self.files:
                    found |= {included} | self.closure(included)
                elif "." in included or "/" in included:
                    found.add(included)
            self.closures[name] = found
        return self.closures[name]

    def gives(self, names):
        return set().union(*(self.files[name].gives for name in names if name in self.files))

    def unknown(self, name):
        """Returns the words of a file that are neither its own nor in headers that it includes."""
        if name not in self.unknowns:
            this = self.files[name]
            self.unknowns[name] = this.words - this.declared - this.outside - self.gives(self.closure(name))
            if name.endswith(".hpp"):
                self.unknowns[name] -= this.gives
        return self.unknowns[name]

    def first_headers(self, name):
        """Returns the header that a file includes first, the one that this includes first, and so on."""
        found = []
        while self.files[name].includes and (name := self.files[name].includes[0]) in self.files:
            found.append(name)
        return found


class Group:
    def __init__(self):
        self.members, self.seen, self.outside, self.aliases = [], set(), set(), set()

    def may_have(self, name, files):
        this, closure = files.files[name], files.closure(name)
        hidden = self.seen - closure
        if self.outside & this.words or (self.aliases - this.aliases) & this.words:
            return False
        if any(header not in files.files for header in hidden):
            return False  # a header of another library, whose names are not known
        hidden_names = files.gives(hidden)
        if hidden_names & (files.unknown(name) | this.outside) or self.outside & files.gives(closure - self.seen):
            return False
        return not any(files.gives(self.seen - files.closure(first) - {first}) & files.unknown(first)
                       for first in files.first_headers(name))

    def add(self, name, files):
        this = files.files[name]
        self.members.append(name)
        self.seen |= files.closure(name)
        if name.endswith(".hpp"):
            self.seen.add(name)
        else:
            self.outside |= this.outside - this.aliases
            self.aliases |= this.aliases


def groups(commands, texts):
    """Returns lists of names. All names of a list have the same command. Each may follow those before it."""
    files = Files(texts)
    by_command = collections.defaultdict(list)
    for name, words in commands.items():
        by_command[tuple(words)].append(name)
    done = []
    for names in by_command.values():
        found = []
        # Sources with few headers come first, since these hide little from those behind them.
        for name in sorted(names, key=lambda name: (name.rpartition("/")[0], len(files.closure(name)), name)):
            best, most = None, 0
            for group in [] if files.files[name].stands_alone else found:
                shared = len(group.seen & files.closure(name)) - 0.3 * len(group.seen - files.closure(name))
                if shared >= most and len(group.members) < LARGEST and group.may_have(name, files):
                    best, most = group, shared
            if best is None:
                best = Group()
                (done if files.files[name].stands_alone else found).append(best)
            best.add(name, files)
        done += found
    return [group.members for group in done]
