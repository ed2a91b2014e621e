// SPDX-License-Identifier: GPL-3.0-or-later
// A recursive descent parser (or, and, not, primary) that writes the program of a selection. Only
// parentheses and words before a selection are recursive.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/selection_expression.hpp"
#include "core/selection/selection_program.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

using Test = SelectionTest;

// Each level takes three frames of the parser, about 2 kB of stack.
constexpr int kDeepestNesting = 200;
constexpr double kLargestZone = 1000;  // Å
constexpr double kMicro = 1e6;         // units per Å: six decimals, as the finest lattice

bool same_word(std::string_view a, std::string_view b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
           return lower_case(x) == lower_case(y);
         });
}

struct Token {
  enum class Kind : std::uint8_t {
    end,
    word,
    quoted,
    open,
    close,
    comma,
    compare,
    op_and,
    op_or,
    op_not
  };
  Kind kind = Kind::end;
  std::string_view text;
  std::size_t column = 1;
};

class Tokens {
 public:
  explicit Tokens(std::string_view text) : text_(text) {}

  std::vector<Token> all() {
    while (at_ < text_.size()) read_one();
    tokens_.push_back({Token::Kind::end, "", text_.size() + 1});
    return std::move(tokens_);
  }

 private:
  void add(Token::Kind kind, std::size_t length) {
    tokens_.push_back({kind, text_.substr(at_, length), at_ + 1});
    at_ += length;
  }

  void read_one() {
    const char c = text_[at_];
    const char after = at_ + 1 < text_.size() ? text_[at_ + 1] : ' ';
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at_;
    } else if (c == '(') {
      add(Token::Kind::open, 1);
    } else if (c == ')') {
      add(Token::Kind::close, 1);
    } else if (c == ',') {
      add(Token::Kind::comma, 1);
    } else if (c == '<' || c == '>' || c == '=') {
      add(Token::Kind::compare, after == '=' ? 2 : 1);
    } else if (c == '!') {
      add(Token::Kind::op_not, 1);
    } else if (c == '&') {
      add(Token::Kind::op_and, after == c ? 2 : 1);
    } else if (c == '|') {
      add(Token::Kind::op_or, after == c ? 2 : 1);
    } else if (c == '"') {
      const std::size_t end = text_.find('"', at_ + 1);
      if (end == std::string_view::npos) throw SelectionError(at_ + 1, "this \" has no closing \"");
      tokens_.push_back({Token::Kind::quoted, text_.substr(at_ + 1, end - at_ - 1), at_ + 1});
      at_ = end + 1;
    } else {
      read_word();
    }
  }

  void read_word() {
    const std::size_t end = std::min(text_.find_first_of(" \t\n\r(),!&|\"<>=", at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    add(same_word(word, "and")   ? Token::Kind::op_and
        : same_word(word, "or")  ? Token::Kind::op_or
        : same_word(word, "not") ? Token::Kind::op_not
                                 : Token::Kind::word,
        word.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

struct Word {
  std::string_view word;
  Test test;
  std::string_view operand = {};  // description of what must follow; empty: nothing
};

constexpr Word kWords[] = {{"all", Test::all},
                           {"none", Test::none},
                           {"chain", Test::chain, "a chain name"},
                           {"resi", Test::residue, "a residue number or range"},
                           {"residue", Test::residue, "a residue number, range or name"},
                           {"resn", Test::residue, "a residue name"},
                           {"name", Test::atom_name, "an atom name"},
                           {"element", Test::element, "an element"},
                           {"altloc", Test::altloc, "a letter"},
                           {"index", Test::index, "the number of an atom in the file, from 1"},
                           {"copy", Test::copy, "the number of a copy in the assembly, from 1"},
                           {"b", Test::b_factor, "a number"},
                           {"occupancy", Test::occupancy, "a number"},
                           {"polymer", Test::polymer},
                           {"protein", Test::protein},
                           {"nucleic", Test::nucleic},
                           {"backbone", Test::backbone},
                           {"sidechain", Test::sidechain},
                           {"water", Test::water},
                           {"waters", Test::water},
                           {"solvent", Test::water},
                           {"ligand", Test::ligand},
                           {"ligands", Test::ligand},
                           {"ion", Test::ion},
                           {"ions", Test::ion},
                           {"hydrogen", Test::hydrogen},
                           {"hydrogens", Test::hydrogen},
                           {"hetero", Test::hetero},
                           {"hetatm", Test::hetero},
                           {"selected", Test::selected},
                           {"hidden", Test::hidden},
                           {"within", Test::within, "a distance in Å"},
                           {"byres", Test::by_residue, "a selection"},
                           {"bychain", Test::by_chain, "a selection"}};

class SelectionParser {
 public:
  explicit SelectionParser(std::string_view text) : tokens_(Tokens(text).all()) {}

  SelectionProgram parse() {
    if (peek().kind == Token::Kind::end) return {SelectionNode{}};
    parse_or();
    if (peek().kind != Token::Kind::end) fail(peek(), why_no_more());
    return std::move(nodes_);
  }

 private:
  const Token& peek() const { return tokens_[at_]; }
  const Token& next() { return tokens_[at_ < tokens_.size() - 1 ? at_++ : at_]; }
  bool next_is(std::string_view word) const {
    return peek().kind == Token::Kind::word && same_word(peek().text, word);
  }

  std::string why_no_more() const {
    if (peek().kind == Token::Kind::close) return "this ) has no opening (";
    std::string text =
        "expected \"and\", \"or\" or the end before \"" + std::string(peek().text) + "\"";
    if (next_is("within")) text += "; write X and within 5 of Y";
    if (next_is("around")) text += "; write within 5 of X";
    return text;
  }

  // Parses a chain of one operator. Each side but the last is followed by a jump to the end.
  void parse_chain(Token::Kind op, Test jump, void (SelectionParser::*side)()) {
    std::vector<std::size_t> jumps;
    (this->*side)();
    while (peek().kind == op) {
      next();
      jumps.push_back(nodes_.size());
      nodes_.push_back({.test = jump});
      (this->*side)();
    }
    for (const std::size_t j : jumps) nodes_[j].target = nodes_.size();
  }
  void parse_or() {
    parse_chain(Token::Kind::op_or, Test::jump_if_true, &SelectionParser::parse_and);
  }
  void parse_and() {
    parse_chain(Token::Kind::op_and, Test::jump_if_false, &SelectionParser::parse_not);
  }

  void parse_not() {
    if (++depth_ > kDeepestNesting) {
      fail(peek(), "more than " + std::to_string(kDeepestNesting) +
                       " parentheses, \"not\" or \"within\" are nested here; use fewer");
    }
    if (peek().kind == Token::Kind::op_not) {
      next();
      parse_not();
      nodes_.push_back({.test = Test::negation});
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
    const Token token = next();
    if (token.kind == Token::Kind::end)
      fail(token, "the expression ends where a selection is expected");
    const Word* word = std::find_if(std::begin(kWords), std::end(kWords), [&](const Word& entry) {
      return token.kind == Token::Kind::word && same_word(entry.word, token.text);
    });
    if (word == std::end(kWords)) {
      fail(token, "\"" + std::string(token.text) +
                      "\" is not a selection; use chain, resi, resn, name, element, altloc, index, "
                      "copy, b, occupancy, protein, nucleic, polymer, backbone, sidechain, water, "
                      "ligand, ion, hydrogen, hetero, selected, hidden, all, none, within 5 of, "
                      "byres or bychain");
    }
    SelectionNode node{.test = word->test, .column = token.column};
    switch (word->test) {
      case Test::within:
        node.microangstrom = parse_zone(token);
        node.inner = parse_inner();
        break;
      case Test::by_residue:
      case Test::by_chain:
        node.inner = parse_inner();
        break;
      case Test::b_factor:
      case Test::occupancy:
        parse_comparison(node, token);
        break;
      default:
        if (!word->operand.empty()) parse_operands(node, token, word->operand);
    }
    nodes_.push_back(std::move(node));
  }

  std::shared_ptr<const SelectionProgram> parse_inner() {
    SelectionProgram outer = std::exchange(nodes_, {});
    parse_not();
    return std::make_shared<const SelectionProgram>(std::exchange(nodes_, std::move(outer)));
  }

  // Parses "5 of"; returns the distance in 10^-6 Å.
  std::int64_t parse_zone(const Token& word) {
    const Token token = next();
    double angstrom = 0;
    if (!read_number(token, angstrom) || !(angstrom >= 0 && angstrom <= kLargestZone)) {
      fail(token, "expected a distance from 0 to 1000 Å after \"" + std::string(word.text) +
                      "\", such as within 5 of resn HEM");
    }
    if (next_is("Å") || next_is("A")) next();
    if (!next_is("of")) fail(peek(), "expected \"of\", as in within 5 of resn HEM");
    next();
    const double micro = std::round(angstrom * kMicro);
    if (micro / kMicro != angstrom) fail(token, "a distance can have at most six decimals");
    return static_cast<std::int64_t>(micro);
  }

  void parse_comparison(SelectionNode& node, const Token& word) {
    const Token op = next();
    if (op.kind != Token::Kind::compare) {
      fail(op, "expected <, <=, =, >= or > after \"" + std::string(word.text) + "\", as in b > 40");
    }
    node.comparison = op.text == "<"    ? NumberTest::less
                      : op.text == "<=" ? NumberTest::at_most
                      : op.text == ">"  ? NumberTest::greater
                      : op.text == ">=" ? NumberTest::at_least
                                        : NumberTest::equal;
    const Token token = next();
    double number = 0;
    if (!read_number(token, number)) fail(token, "expected a number, as in b > 40");
    node.number = static_cast<float>(number);
  }

  static bool read_number(const Token& token, double& number) {
    const char* const end = token.text.data() + token.text.size();
    const auto read = std::from_chars(token.text.data(), end, number);
    return token.kind == Token::Kind::word && read.ec == std::errc() && read.ptr == end &&
           std::isfinite(number);
  }

  void parse_operands(SelectionNode& node, const Token& word, std::string_view expected) {
    for (;;) {
      const Token token = next();
      if (token.kind != Token::Kind::word && token.kind != Token::Kind::quoted) {
        fail(token,
             "expected " + std::string(expected) + " after \"" + std::string(word.text) + "\"");
      }
      add_operand(node, word, token);
      if (peek().kind != Token::Kind::comma) return;
      next();
    }
  }

  static void add_operand(SelectionNode& node, const Token& word, const Token& token) {
    if (node.test == Test::index || node.test == Test::copy) {
      const auto range = range_in(token.text);
      if (!range || range->first < 1 || range->insertion_code != ' ') {
        fail(token, "\"" + std::string(token.text) +
                        "\" is not a number from 1 on, or a range such as 10-20");
      }
      add_range(node, *range, token);
    } else if (node.test == Test::residue && !same_word(word.text, "resn")) {
      const auto range = range_in(token.text);
      if (range) return add_range(node, *range, token);
      if (same_word(word.text, "residue")) return node.names.push_back(std::string(token.text));
      fail(token, "\"" + std::string(token.text) +
                      "\" is not a residue number such as 7, 12A, 10-20 or -5--1");
    } else if (node.test == Test::element) {
      const Element element = element_from_symbol(token.text);
      if (element == kUnknownElement && token.text != "X") {
        fail(token, "\"" + std::string(token.text) + "\" is not an element");
      }
      node.elements.push_back(element);
    } else {
      node.names.emplace_back(token.text);
    }
  }

  static void add_range(SelectionNode& node, const SelectionNode::Range& range,
                        const Token& token) {
    if (range.last < range.first) {
      fail(token, "the range \"" + std::string(token.text) + "\" runs backwards");
    }
    node.ranges.push_back(range);
  }

  // Parses "7", "-3", "10-20", "-5--1" or "12A".
  static std::optional<SelectionNode::Range> range_in(std::string_view text) {
    const char* p = text.data();
    const char* const end = p + text.size();
    SelectionNode::Range range{0, 0, ' '};
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
    return good ? std::optional(range) : std::nullopt;
  }

  [[noreturn]] static void fail(const Token& token, const std::string& reason) {
    throw SelectionError(token.column, reason);
  }

  std::vector<Token> tokens_;
  SelectionProgram nodes_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

SelectionProgram parse_selection(std::string_view text) {
  return SelectionParser(text).parse();
}

}  // namespace alphascope
