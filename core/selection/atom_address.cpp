// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes addresses of atoms. An address is turned into a selection expression, so that
// names, numbers and ranges mean the same in both.
#include "core/selection/atom_address.hpp"

#include <algorithm>
#include <charconv>
#include <vector>

#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/selection_expression.hpp"

namespace alphascope {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kHow =
    "write CHAIN:RESIDUE:ATOM, such as A:HIS 87:NE2, A: for chain A or :87 for residue 87 of every "
    "chain";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool is_residue_number(std::string_view text) {
  try {
    SelectionExpression::parse("resi " + quoted_name(text));
    return true;
  } catch (const SelectionError&) {
    return false;
  }
}

bool means_any(std::string_view part) {
  return part.empty() || part == "*";
}

bool has_addresses(std::string_view text) {
  if (text.find(':') != std::string_view::npos) return true;
  const std::vector<std::string_view> parts = split(text, ',');
  return std::any_of(parts.begin(), parts.end(),
                     [](std::string_view part) { return trimmed(part).starts_with('#'); });
}

// One address: an atom's number in the file, or an expression.
struct Address {
  std::size_t number = 0;  // counted from 1; 0: use the expression
  SelectionExpression expression;
};

class AddressReader {
 public:
  // `column`: where the address begins in the whole text, from 1.
  AddressReader(std::string_view text, std::size_t column) : text_(text), column_(column) {}

  Address read() {
    const std::string_view address = trimmed(text_);
    if (address.empty()) fail("there is no address here; " + std::string(kHow));
    if (address.front() == '#') return {read_number(address.substr(1)), {}};
    const std::vector<std::string_view> parts = split(address, ':');
    if (parts.size() < 2) fail("\"" + std::string(address) + "\" has no colon; " + kHow.data());
    if (parts.size() > 4) {
      fail("\"" + std::string(address) +
           "\" has more than four parts, which are chain, residue, atom and alternative location");
    }
    add("chain", trimmed(parts[0]));
    add_residue(trimmed(parts[1]));
    if (parts.size() > 2) add("name", trimmed(parts[2]));
    if (parts.size() > 3) add("altloc", trimmed(parts[3]));
    return {0, SelectionExpression::parse(expression_.empty() ? "all" : expression_)};
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw SelectionError(column_, reason); }

  std::size_t read_number(std::string_view digits) const {
    std::size_t number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size() || number == 0) {
      fail("\"#" + std::string(digits) + "\" is not an atom of a file; atoms are counted from #1");
    }
    return number;
  }

  void add(std::string_view word, std::string_view name) {
    if (means_any(name)) return;
    add_test(std::string(word) + " " + quoted_name(name));
  }
  void add_test(const std::string& test) {
    expression_ += (expression_.empty() ? "" : " and ") + test;
  }

  // "HIS 87", "87", "10-20" or "HIS".
  void add_residue(std::string_view residue) {
    if (means_any(residue)) return;
    const std::size_t blank = residue.find_last_of(kBlanks);
    const std::string_view last =
        blank == std::string_view::npos ? residue : residue.substr(blank + 1);
    const bool number = is_residue_number(last);
    if (number) add_test("resi " + quoted_name(last));
    if (!number && blank != std::string_view::npos) {
      fail("\"" + std::string(last) + "\" is not a residue number such as 7, 12A, 10-20 or -5--1");
    }
    const std::string_view name =
        !number ? residue
                : trimmed(blank == std::string_view::npos ? "" : residue.substr(0, blank));
    add("resn", name);
  }

  std::string_view text_;
  std::size_t column_;
  std::string expression_;
};

bool is_in_residue(const Atom& atom) {
  return atom.residue_name != 0 || atom.residue_number != 0;
}

bool is_nameless(const Atom& atom) {
  return !is_in_residue(atom) && atom.chain == 0;
}

}  // namespace

std::string quoted_name(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    if (c == '"') c = '?';
  }
  return '"' + text + '"';
}

std::string residue_within_chain(const Molecule& molecule, std::size_t index) {
  const Atom& atom = molecule.atoms[index];
  if (is_nameless(atom)) {
    return "#" + std::to_string(atom_source(molecule, index).deposited + 1);
  }
  if (!is_in_residue(atom)) return {};
  std::string text(molecule.text(atom.residue_name));
  text += (atom.residue_name == 0 ? "" : " ") + std::to_string(atom.residue_number);
  if (atom.insertion_code != ' ') text += atom.insertion_code;
  return text;
}

std::string residue_address(const Molecule& molecule, std::size_t index) {
  const Atom& atom = molecule.atoms[index];
  const std::string residue = residue_within_chain(molecule, index);
  return is_nameless(atom) ? residue : std::string(molecule.text(atom.chain)) + ":" + residue;
}

std::string atom_address(const Molecule& molecule, std::size_t index) {
  const Atom& atom = molecule.atoms[index];
  std::string text = residue_address(molecule, index);
  if (is_nameless(atom)) return text;
  text += ":" + std::string(molecule.text(atom.name));
  if (atom.altloc != ' ') text += std::string(":") + atom.altloc;
  return text;
}

std::function<bool(std::size_t)> atoms_named(const Molecule& molecule, std::string_view text,
                                             const PictureAtoms& picture) {
  if (!has_addresses(text)) {
    const auto bound = SelectionExpression::parse(text).bind(molecule, picture);
    return [&molecule, bound](std::size_t atom) { return bound(molecule.atoms[atom]); };
  }
  std::vector<std::size_t> numbers;
  std::vector<SelectionExpression::Bound> tests;
  for (const std::string_view part : split(text, ',')) {
    const auto column = static_cast<std::size_t>(part.data() - text.data()) + 1;
    const Address address = AddressReader(part, column).read();
    if (address.number > 0) {
      numbers.push_back(address.number - 1);
    } else {
      tests.push_back(address.expression.bind(molecule));
    }
  }
  return [&molecule, numbers, tests](std::size_t atom) {
    const auto holds = [&](const SelectionExpression::Bound& test) {
      return test(molecule.atoms[atom]);
    };
    if (std::any_of(tests.begin(), tests.end(), holds)) return true;
    if (numbers.empty()) return false;
    const std::size_t deposited = atom_source(molecule, atom).deposited;
    return std::find(numbers.begin(), numbers.end(), deposited) != numbers.end();
  };
}

std::optional<SelectionError> fault_of_address(std::string_view text) {
  if (!has_addresses(text)) return fault_of_selection(text);
  try {
    for (const std::string_view part : split(text, ',')) {
      AddressReader(part, static_cast<std::size_t>(part.data() - text.data()) + 1).read();
    }
    return std::nullopt;
  } catch (const SelectionError& error) {
    return error;
  }
}

}  // namespace alphascope
