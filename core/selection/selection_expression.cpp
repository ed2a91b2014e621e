// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program of a selection expression over a molecule's atoms. Words that depend on more
// than one atom (zones, whole residues, kinds of polymers) are computed for all atoms beforehand.
#include "core/selection/selection_expression.hpp"

#include <algorithm>

#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/selection_masks.hpp"
#include "core/selection/selection_program.hpp"

namespace alphascope {
namespace {

using Test = SelectionTest;

// In patterns * matches any characters and ? matches one.
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

bool holds(NumberTest comparison, float value, float number) {
  switch (comparison) {
    case NumberTest::less:
      return value < number;
    case NumberTest::at_most:
      return value <= number;
    case NumberTest::equal:
      return value == number;
    case NumberTest::at_least:
      return value >= number;
    case NumberTest::greater:
      break;
  }
  return value > number;
}

bool in_ranges(const std::vector<SelectionNode::Range>& ranges, std::int64_t number, char code) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const SelectionNode::Range& range) {
    return number >= range.first && number <= range.last &&
           (range.insertion_code == ' ' || range.insertion_code == code);
  });
}

// The first word of a program that needs a picture, or null.
const SelectionNode* picture_word(const SelectionProgram& program) {
  for (const SelectionNode& node : program) {
    if (node.test == Test::selected || node.test == Test::hidden) return &node;
    if (!node.inner) continue;
    if (const SelectionNode* inner = picture_word(*node.inner)) return inner;
  }
  return nullptr;
}

SelectionError no_picture(const SelectionNode& node) {
  return {node.column,
          "\"selected\" and \"hidden\" have a meaning in the picture only; name the "
          "atoms here"};
}

}  // namespace

struct SelectionExpression::Bound::Node {
  SelectionNode of;
  std::vector<bool> names = {};     // by NameId
  std::vector<bool> elements = {};  // by Element
  std::vector<bool> atoms = {};     // for tests that are computed beforehand

  bool holds(const Molecule& molecule, const Atom& atom) const;  // evaluates a test
};

// Binds a program to a molecule. The recursion is as deep as that of the parser.
struct SelectionExpression::Binder {
  const Molecule& molecule;
  const PictureAtoms& picture;

  Bound bind(const Program& program) const {
    std::vector<Bound::Node> nodes;
    for (const SelectionNode& node : program) nodes.push_back(bind_node(node));
    Bound bound;
    bound.nodes_ = std::make_shared<const std::vector<Bound::Node>>(std::move(nodes));
    bound.molecule_ = &molecule;
    return bound;
  }

  Bound::Node bind_node(const SelectionNode& node) const {
    Bound::Node b{.of = node};
    if (!node.names.empty() && node.test != Test::altloc) {
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
    b.atoms = atoms_of(node);
    return b;
  }

  std::vector<bool> atoms_of(const SelectionNode& node) const {
    switch (node.test) {
      case Test::protein:
      case Test::nucleic:
      case Test::backbone:
      case Test::sidechain:
        return atoms_of_polymers(molecule, node.test);
      case Test::selected:
      case Test::hidden: {
        const auto* atoms = node.test == Test::selected ? picture.selected : picture.hidden;
        if (atoms == nullptr) throw no_picture(node);
        return *atoms;
      }
      case Test::within:
        return atoms_within(molecule, atoms_where(*node.inner), node.microangstrom);
      case Test::by_residue:
        return whole_residues(molecule, atoms_where(*node.inner));
      case Test::by_chain:
        return whole_chains(molecule, atoms_where(*node.inner));
      default:
        return {};
    }
  }

  std::vector<bool> atoms_where(const Program& program) const {
    const Bound bound = bind(program);
    std::vector<bool> atoms(molecule.atoms.size());
    for (std::size_t i = 0; i < atoms.size(); ++i) atoms[i] = bound(molecule.atoms[i]);
    return atoms;
  }
};

SelectionExpression SelectionExpression::parse(std::string_view text) {
  SelectionExpression expression;
  expression.program_ = std::make_shared<const Program>(parse_selection(text));
  return expression;
}

SelectionExpression::Bound SelectionExpression::bind(const Molecule& molecule,
                                                     const PictureAtoms& picture) const {
  return Binder{molecule, picture}.bind(program_ ? *program_ : Program{SelectionNode{}});
}

bool SelectionExpression::Bound::operator()(const Atom& atom) const {
  bool value = true;
  for (std::size_t at = 0; at < nodes_->size();) {
    const Node& node = (*nodes_)[at++];
    if (node.of.test == Test::negation) {
      value = !value;
    } else if (node.of.test == Test::jump_if_false || node.of.test == Test::jump_if_true) {
      if (value == (node.of.test == Test::jump_if_true)) at = node.of.target;
    } else {
      value = node.holds(*molecule_, atom);
    }
  }
  return value;
}

bool SelectionExpression::Bound::Node::holds(const Molecule& molecule, const Atom& atom) const {
  const auto place = [&] { return static_cast<std::size_t>(&atom - molecule.atoms.data()); };
  switch (of.test) {
    case Test::all:
      return true;
    case Test::none:
      return false;
    case Test::chain:
      return names[atom.chain];
    case Test::residue:
      return (!names.empty() && names[atom.residue_name]) ||
             in_ranges(of.ranges, atom.residue_number, atom.insertion_code);
    case Test::atom_name:
      return names[atom.name];
    case Test::element:
      return elements[atom.element];
    case Test::altloc:
      return std::any_of(of.names.begin(), of.names.end(), [&](const std::string& name) {
        return atom.altloc == (name.empty() ? ' ' : name[0]);
      });
    case Test::index:
      return in_ranges(
          of.ranges, static_cast<std::int64_t>(atom_source(molecule, place()).deposited) + 1, ' ');
    case Test::copy:
      return in_ranges(of.ranges,
                       static_cast<std::int64_t>(atom_source(molecule, place()).copy) + 1, ' ');
    case Test::b_factor:
      return atom.has_b_factor && alphascope::holds(of.comparison, atom.b_factor, of.number);
    case Test::occupancy:
      return alphascope::holds(of.comparison, atom.occupancy, of.number);
    case Test::polymer:
      return atom.kind == ResidueKind::polymer;
    case Test::water:
      return atom.kind == ResidueKind::water;
    case Test::ligand:
      return atom.kind == ResidueKind::ligand;
    case Test::ion:
      return atom.kind == ResidueKind::ion;
    case Test::hydrogen:
      return atom.element == kHydrogen;
    case Test::hetero:
      return atom.hetero;
    default:
      return atoms[place()];
  }
}

std::optional<SelectionError> fault_of_selection(std::string_view text) {
  try {
    const SelectionProgram program = parse_selection(text);
    const SelectionNode* word = picture_word(program);
    return word ? std::optional(no_picture(*word)) : std::nullopt;
  } catch (const SelectionError& error) {
    return error;
  }
}

}  // namespace alphascope
