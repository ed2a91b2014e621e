#include "core/molecule/selection_expression.hpp"

#include <algorithm>
#include <charconv>

#include "core/molecule/letter_case.hpp"

namespace alphascope {
namespace {

constexpr int kDeepestNesting = 200;  // each takes three frames of the parser, some 2 kB of stack

bool same_word(std::string_view a, std::string_view b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
           return lower_case(x) == lower_case(y);
         });
}

// * matches any characters, ? matches one.
bool glob(std::string_view pattern, std::string_view text) {
  std::size_t p = 0, t = 0, star = std::string_view::npos, from = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      from = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p, ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++from;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

struct Token {
  enum class Kind : std::uint8_t { end, word, quoted, open, close, comma, op_and, op_or, op_not };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t column = 1;
};

std::vector<Token> tokens_of(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t i = 0;
  const auto add = [&](Token::Kind kind, std::size_t length) {
    tokens.push_back({kind, text.substr(i, length), i + 1});
    i += length;
  };
  while (i < text.size()) {
    const char c = text[i];
    const bool twice = i + 1 < text.size() && text[i + 1] == c;
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++i;
    } else if (c == '(') {
      add(Token::Kind::open, 1);
    } else if (c == ')') {
      add(Token::Kind::close, 1);
    } else if (c == ',') {
      add(Token::Kind::comma, 1);
    } else if (c == '!') {
      add(Token::Kind::op_not, 1);
    } else if (c == '&') {
      add(Token::Kind::op_and, twice ? 2 : 1);
    } else if (c == '|') {
      add(Token::Kind::op_or, twice ? 2 : 1);
    } else if (c == '"') {
      const std::size_t end = text.find('"', i + 1);
      if (end == std::string_view::npos) throw SelectionError(i + 1, "this \" has no closing \"");
      tokens.push_back({Token::Kind::quoted, text.substr(i + 1, end - i - 1), i + 1});
      i = end + 1;
    } else {
      const std::size_t end = std::min(text.find_first_of(" \t\n\r(),!&|\"", i), text.size());
      const std::string_view word = text.substr(i, end - i);
      add(same_word(word, "and")   ? Token::Kind::op_and
          : same_word(word, "or")  ? Token::Kind::op_or
          : same_word(word, "not") ? Token::Kind::op_not
                                   : Token::Kind::word,
          end - i);
    }
  }
  tokens.push_back({Token::Kind::end, "", text.size() + 1});
  return tokens;
}

}  // namespace

// Recursive descent (or, and, not, primary) that writes the program; only parentheses and "not" are
// recursive.
class SelectionParser {
 public:
  using Kind = SelectionExpression::Kind;
  using Node = SelectionExpression::Node;

  explicit SelectionParser(std::string_view text) : tokens_(tokens_of(text)) {}

  std::vector<Node> parse() {
    if (peek().kind == Token::Kind::end) {
      nodes_.push_back({});
      return std::move(nodes_);
    }
    parse_or();
    if (peek().kind != Token::Kind::end) {
      fail(peek(),
           peek().kind == Token::Kind::close
               ? "this ) has no opening ("
               : "expected \"and\", \"or\" or the end before \"" + std::string(peek().text) + "\"");
    }
    return std::move(nodes_);
  }

 private:
  const Token& peek() const { return tokens_[at_]; }
  const Token& next() { return tokens_[at_ < tokens_.size() - 1 ? at_++ : at_]; }

  // A chain of one operator: each side but the last is followed by a jump to the end.
  void parse_chain(Token::Kind op, Kind jump, void (SelectionParser::*side)()) {
    std::vector<std::size_t> jumps;
    (this->*side)();
    while (peek().kind == op) {
      next();
      jumps.push_back(nodes_.size());
      add_node(jump);
      (this->*side)();
    }
    for (const std::size_t j : jumps) nodes_[j].target = nodes_.size();
  }
  void parse_or() {
    parse_chain(Token::Kind::op_or, Kind::jump_if_true, &SelectionParser::parse_and);
  }
  void parse_and() {
    parse_chain(Token::Kind::op_and, Kind::jump_if_false, &SelectionParser::parse_not);
  }

  void parse_not() {
    if (++depth_ > kDeepestNesting) {
      fail(peek(), "more than " + std::to_string(kDeepestNesting) +
                       " parentheses or \"not\" are nested here; use fewer");
    }
    if (peek().kind == Token::Kind::op_not) {
      next();
      parse_not();
      add_node(Kind::negation);
    } else if (peek().kind == Token::Kind::open) {
      const Token open = next();
      parse_or();
      if (peek().kind != Token::Kind::close) fail(open, "this ( has no closing )");
      next();
    } else {
      parse_primary();
    }
    --depth_;
  }

  void parse_primary() {
    static constexpr struct {
      std::string_view word;
      Kind kind;
      std::string_view operand;  // what must follow; empty = nothing
    } kWords[] = {{"all", Kind::all, ""},
                  {"none", Kind::none, ""},
                  {"chain", Kind::chain, "a chain name"},
                  {"resi", Kind::residue_number, "a residue number or range"},
                  {"residue", Kind::residue_number, "a residue number or range"},
                  {"resn", Kind::residue_name, "a residue name"},
                  {"name", Kind::atom_name, "an atom name"},
                  {"element", Kind::element, "an element"},
                  {"altloc", Kind::altloc, "a letter"},
                  {"polymer", Kind::polymer, ""},
                  {"water", Kind::water, ""},
                  {"waters", Kind::water, ""},
                  {"ligand", Kind::ligand, ""},
                  {"ion", Kind::ion, ""},
                  {"hydrogen", Kind::hydrogen, ""},
                  {"hetero", Kind::hetero, ""}};
    const Token token = next();
    if (token.kind == Token::Kind::end)
      fail(token, "the expression ends where a selection is expected");
    const auto* word = std::find_if(std::begin(kWords), std::end(kWords), [&](const auto& entry) {
      return token.kind == Token::Kind::word && same_word(entry.word, token.text);
    });
    if (word == std::end(kWords)) {
      fail(token, "\"" + std::string(token.text) +
                      "\" is not a selection; use chain, resi, resn, name, element, altloc, "
                      "polymer, water, ligand, ion, hydrogen, hetero, all or none");
    }
    Node node;
    node.kind = word->kind;
    if (!word->operand.empty()) parse_operands(node, token, word->operand);
    nodes_.push_back(std::move(node));
  }

  void parse_operands(Node& node, const Token& word, std::string_view expected) {
    for (;;) {
      const Token token = next();
      if (token.kind != Token::Kind::word && token.kind != Token::Kind::quoted) {
        fail(token,
             "expected " + std::string(expected) + " after \"" + std::string(word.text) + "\"");
      }
      if (node.kind == Kind::residue_number) {
        node.ranges.push_back(parse_range(token));
      } else if (node.kind == Kind::element) {
        const Element element = element_from_symbol(token.text);
        if (element == kUnknownElement && token.text != "X") {
          fail(token, "\"" + std::string(token.text) + "\" is not an element");
        }
        node.elements.push_back(element);
      } else {
        node.names.emplace_back(token.text);
      }
      if (peek().kind != Token::Kind::comma) return;
      next();
    }
  }

  // "7", "-3", "10-20", "-5--1", "12A".
  SelectionExpression::ResidueRange parse_range(const Token& token) const {
    const char* p = token.text.data();
    const char* const end = p + token.text.size();
    SelectionExpression::ResidueRange range{0, 0, ' '};
    const auto first = std::from_chars(p, end, range.first);
    bool good = first.ec == std::errc();
    range.last = range.first;
    p = first.ptr;
    if (good && p != end && *p == '-') {
      const auto last = std::from_chars(p + 1, end, range.last);
      good = last.ec == std::errc() && last.ptr == end;
    } else if (good && p != end) {
      range.insertion_code = *p;
      good = p + 1 == end;
    }
    if (!good)
      fail(token, "\"" + std::string(token.text) +
                      "\" is not a residue number such as 7, 12A, 10-20 or -5--1");
    if (range.last < range.first)
      fail(token, "the range \"" + std::string(token.text) + "\" runs backwards");
    return range;
  }

  void add_node(Kind kind) {
    nodes_.emplace_back();
    nodes_.back().kind = kind;
  }

  [[noreturn]] static void fail(const Token& token, const std::string& reason) {
    throw SelectionError(token.column, reason);
  }

  std::vector<Token> tokens_;
  std::vector<Node> nodes_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

struct SelectionExpression::Bound::Node {
  Kind kind;
  std::vector<bool> names;  // by NameId
  std::vector<ResidueRange> ranges;
  std::vector<bool> elements;
  std::vector<char> letters;
  std::size_t target;

  bool holds(const Atom& atom) const;  // of a test
};

SelectionExpression SelectionExpression::parse(std::string_view text) {
  SelectionExpression expression;
  expression.nodes_ = SelectionParser(text).parse();
  return expression;
}

SelectionExpression::Bound SelectionExpression::bind(const Molecule& molecule) const {
  std::vector<Bound::Node> nodes;
  for (const Node& node : nodes_) {
    Bound::Node b{node.kind, {}, node.ranges, {}, {}, node.target};
    if (node.kind == Kind::altloc) {
      for (const std::string& name : node.names) b.letters.push_back(name.empty() ? ' ' : name[0]);
    } else if (!node.names.empty()) {
      b.names.resize(molecule.names.size());
      for (NameId id = 0; id < b.names.size(); ++id) {
        b.names[id] = std::any_of(
            node.names.begin(), node.names.end(),
            [&](const std::string& pattern) { return glob(pattern, molecule.text(id)); });
      }
    }
    if (!node.elements.empty()) {
      b.elements.resize(256);
      for (const Element element : node.elements) b.elements[element] = true;
    }
    nodes.push_back(std::move(b));
  }
  Bound bound;
  bound.nodes_ = std::make_shared<const std::vector<Bound::Node>>(std::move(nodes));
  return bound;
}

bool SelectionExpression::Bound::operator()(const Atom& atom) const {
  bool value = true;
  for (std::size_t at = 0; at < nodes_->size();) {
    const Node& node = (*nodes_)[at++];
    if (node.kind == Kind::negation) {
      value = !value;
    } else if (node.kind == Kind::jump_if_false || node.kind == Kind::jump_if_true) {
      if (value == (node.kind == Kind::jump_if_true)) at = node.target;
    } else {
      value = node.holds(atom);
    }
  }
  return value;
}

bool SelectionExpression::Bound::Node::holds(const Atom& atom) const {
  switch (kind) {
    case Kind::all:
      return true;
    case Kind::none:
      return false;
    case Kind::chain:
      return names[atom.chain];
    case Kind::residue_name:
      return names[atom.residue_name];
    case Kind::atom_name:
      return names[atom.name];
    case Kind::element:
      return elements[atom.element];
    case Kind::altloc:
      return std::find(letters.begin(), letters.end(), atom.altloc) != letters.end();
    case Kind::polymer:
      return atom.kind == AtomKind::polymer;
    case Kind::water:
      return atom.kind == AtomKind::water;
    case Kind::ligand:
      return atom.kind == AtomKind::ligand;
    case Kind::ion:
      return atom.kind == AtomKind::ion;
    case Kind::hydrogen:
      return atom.element == kHydrogen;
    case Kind::hetero:
      return atom.hetero;
    case Kind::residue_number:
    case Kind::negation:
    case Kind::jump_if_false:
    case Kind::jump_if_true:
      break;
  }
  return std::any_of(ranges.begin(), ranges.end(), [&](const ResidueRange& range) {
    return atom.residue_number >= range.first && atom.residue_number <= range.last &&
           (range.insertion_code == ' ' || range.insertion_code == atom.insertion_code);
  });
}

std::optional<SelectionError> fault_of_selection(std::string_view text) {
  try {
    SelectionExpression::parse(text);
    return std::nullopt;
  } catch (const SelectionError& error) {
    return error;
  }
}

}  // namespace alphascope
