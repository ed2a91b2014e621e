// SPDX-License-Identifier: GPL-3.0-or-later
// Expands assemblies and parses their operator expressions.
#include "core/molecule/assembly.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>

#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/molecule.hpp"
#include "core/text/printable.hpp"

namespace alphascope {
namespace {

constexpr std::uint64_t kMostCopies = 1'000'000;
// Bytes of an Atom, and of a ball's centre, radius, atom index and entry in the search for
// coincident centres.
constexpr std::uint64_t kBytesPerAtom = sizeof(Atom) + sizeof(LatticePoint) + 4 + 4 + 5;

using Rows = std::array<std::array<double, 4>, 3>;

Rows product(const Rows& a, const Rows& b) {
  Rows c{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + (j == 3 ? a[i][3] : 0);
    }
  }
  return c;
}

std::uint64_t copies_of(const AssemblyGenerator& generator) {
  std::uint64_t copies = generator.factors.empty() ? 0 : 1;
  for (const auto& factor : generator.factors) copies *= factor.size();
  return copies;
}

// The k-th product of operators, where the last factor changes fastest.
Rows operator_at(const Assemblies& assemblies, const AssemblyGenerator& generator,
                 std::uint64_t k) {
  Rows result{};
  bool first = true;
  for (auto factor = generator.factors.rbegin(); factor != generator.factors.rend(); ++factor) {
    const Rows& rows = assemblies.operators[(*factor)[k % factor->size()]].rows;
    result = first ? rows : product(rows, result);
    first = false;
    k /= factor->size();
  }
  return result;
}

bool is_identity(const Rows& rows) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (rows[i][j] != (i == j ? 1.0 : 0.0)) return false;
    }
  }
  return true;
}

// Indices of the atoms of a model that belong to a generator's chains.
std::vector<std::size_t> atoms_of(const Molecule& molecule, const AssemblyGenerator& generator,
                                  const ModelRange& model) {
  std::vector<bool> wanted(molecule.names.size(), false);
  for (const std::string& chain : generator.chains) {
    const NameId id = molecule.names.find(chain);
    if (id != 0 || chain.empty()) wanted[id] = true;
  }
  std::vector<std::size_t> atoms;
  for (std::size_t i = model.begin; i < model.end; ++i) {
    if (wanted[molecule.atoms[i].label_chain]) atoms.push_back(i);
  }
  return atoms;
}

std::uint64_t count_atoms(const Molecule& molecule, const Assembly& assembly) {
  std::uint64_t atoms = 0;
  for (const AssemblyGenerator& generator : assembly.generators) {
    for (const ModelRange& model : molecule.models) {
      atoms += copies_of(generator) * atoms_of(molecule, generator, model).size();
    }
  }
  return atoms;
}

class Expansion {
 public:
  Expansion(const Molecule& source, const Assembly& assembly, const RunContext& context)
      : source_(source), assembly_(assembly), context_(context) {}

  Molecule run() {
    const std::uint64_t atoms = count_atoms(source_, assembly_);
    if (atoms == 0) {
      throw std::invalid_argument("assembly " + assembly_.id +
                                  " has no atoms: its chains are not in the file");
    }
    if (atoms > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument("assembly " + assembly_.id + " has " + std::to_string(atoms) +
                                  " atoms, more than an index can count");
    }
    copy_all_but_atoms();
    result_.atoms.reserve(atoms);
    total_ = static_cast<double>(atoms);
    for (const ModelRange& model : source_.models) {
      const std::size_t begin = result_.atoms.size();
      copies_of_chain_.clear();
      for (const AssemblyGenerator& generator : assembly_.generators)
        add_generator(generator, model);
      if (result_.atoms.size() > begin) {
        result_.models.push_back({model.number, begin, result_.atoms.size()});
      }
    }
    if (!renamed_.empty()) {
      result_.notes.push_back(
          "The file itself has chains that are named like copies, so copies of "
          "this assembly have names such as " +
          renamed_);
    }
    result_.rounding_angstrom =
        std::max(source_.rounding_angstrom, source_.lattice.angstrom(largest_rounding_));
    return std::move(result_);
  }

 private:
  void copy_all_but_atoms() {
    result_.source = source_.source;
    result_.format = source_.format;
    result_.title = source_.title;
    result_.lattice = source_.lattice;
    result_.has_file_radii = source_.has_file_radii;
    result_.has_confidences = source_.has_confidences;
    result_.names = source_.names;
    result_.notes = source_.notes;
    result_.sha256 = source_.sha256;
    result_.assembly_id = assembly_.id;
    result_.assemblies = source_.assemblies;
    result_.stated_secondary = source_.stated_secondary;
    result_.stated_bonds = source_.stated_bonds;
    result_.unresolved_bonds = source_.unresolved_bonds;
  }

  void add_generator(const AssemblyGenerator& generator, const ModelRange& model) {
    const std::vector<std::size_t> atoms = atoms_of(source_, generator, model);
    const std::uint64_t copies = copies_of(generator);
    const std::size_t begin = result_.atoms.size();
    for (std::uint64_t k = 0; k < copies; ++k) {
      context_.cancel.throw_if_cancelled();
      context_.report("expanding assembly", static_cast<double>(result_.atoms.size()) / total_);
      add_copy(atoms, operator_at(source_.assemblies, generator, k));
    }
    if (result_.atoms.size() > begin) {
      const auto index = static_cast<std::size_t>(&generator - assembly_.generators.data());
      result_.copied.push_back({begin, static_cast<std::size_t>(copies), atoms, index});
    }
  }

  void add_copy(const std::vector<std::size_t>& atoms, Rows rows) {
    const bool identity = is_identity(rows);
    for (auto& row : rows) row[3] *= source_.lattice.units_per_angstrom();
    new_names_.clear();
    for (const std::size_t i : atoms) {
      Atom atom = source_.atoms[i];
      if (!identity) atom.position = moved(atom.position, rows);
      atom.chain = name_of_copy(atom.chain, atom.label_chain);
      result_.atoms.push_back(atom);
    }
  }

  LatticePoint moved(const LatticePoint& p, const Rows& rows) {
    std::int32_t out[3];
    for (int i = 0; i < 3; ++i) {
      const double exact = rows[i][0] * p.x + rows[i][1] * p.y + rows[i][2] * p.z + rows[i][3];
      const double rounded = std::round(exact);
      if (!(std::fabs(rounded) <= kMaxLatticeCoordinate)) {
        throw std::invalid_argument(
            "assembly " + assembly_.id + " reaches beyond the lattice of this file (" +
            std::to_string(static_cast<long>(source_.lattice.angstrom(kMaxLatticeCoordinate))) +
            " Å)");
      }
      largest_rounding_ = std::max(largest_rounding_, std::fabs(exact - rounded));
      out[i] = static_cast<std::int32_t>(rounded);
    }
    return {out[0], out[1], out[2]};
  }

  // The name of a chain's copy. Copies are counted for each pair of author chain and asymmetric
  // unit. So the waters of chain A, which are another asymmetric unit, get the same copy names as
  // the polymer of A.
  NameId name_of_copy(NameId chain, NameId label_chain) {
    const std::uint64_t key = (std::uint64_t{chain} << 32) | label_chain;
    const auto known = new_names_.find(key);
    if (known != new_names_.end()) return known->second;
    const std::uint32_t copy = ++copies_of_chain_[key];
    NameId name = chain;
    if (copy > 1) {
      const std::string base(source_.text(chain)), number = std::to_string(copy);
      std::string separator = "-";
      // A file that was expanded before has such names itself. Then copies are called "A_2" or
      // "A__2".
      while (is_chain(base + separator + number)) {
        separator = separator == "-" ? "_" : separator + "_";
      }
      if (separator != "-") renamed_ = printable(base + separator + number);
      name = result_.names.intern(base + separator + number);
    }
    new_names_.emplace(key, name);
    return name;
  }

  // Returns whether the file itself has a chain of this name.
  bool is_chain(const std::string& name) {
    if (chains_.empty()) {
      chains_.assign(source_.names.size(), false);
      for (const Atom& atom : source_.atoms) chains_[atom.chain] = true;
    }
    const NameId id = source_.names.find(name);
    return id != 0 && chains_[id];
  }

  const Molecule& source_;
  const Assembly& assembly_;
  const RunContext& context_;
  Molecule result_;
  std::unordered_map<std::uint64_t, std::uint32_t> copies_of_chain_;
  std::unordered_map<std::uint64_t, NameId> new_names_;  // of the current copy
  std::vector<bool> chains_;  // for each name id: whether it is a chain of the file
  std::string renamed_;       // last name of a copy that needed another separator
  double largest_rounding_ = 0, total_ = 1;
};

}  // namespace

std::vector<AssemblyInfo> list_assemblies(const Molecule& molecule) {
  std::vector<AssemblyInfo> list;
  for (const Assembly& assembly : molecule.assemblies.list) {
    AssemblyInfo info{assembly.id, assembly.details, 0, count_atoms(molecule, assembly), 0};
    for (const AssemblyGenerator& generator : assembly.generators)
      info.copies += copies_of(generator);
    info.memory_bytes = info.atoms * kBytesPerAtom;
    list.push_back(std::move(info));
  }
  return list;
}

Molecule expand_assembly(const Molecule& molecule, std::string_view id, const RunContext& context) {
  std::string known;
  for (const Assembly& assembly : molecule.assemblies.list) {
    if (assembly.id == id) return Expansion(molecule, assembly, context).run();
    known += (known.empty() ? "" : ", ") + assembly.id;
  }
  for (const RefusedAssembly& refused : molecule.assemblies.refused) {
    if (!refused.id.empty() && refused.id != id) continue;
    throw std::invalid_argument("assembly " + std::string(id) +
                                " cannot be made: " + refused.reason);
  }
  throw std::invalid_argument(
      "there is no assembly " + std::string(id) + ": " +
      (known.empty() ? "the file describes none" : "the file has " + known));
}

bool parse_operator_expression(std::string_view text,
                               const std::vector<SymmetryOperator>& operators,
                               std::vector<std::vector<std::uint32_t>>& factors) {
  std::unordered_map<std::string_view, std::uint32_t> index;
  for (std::uint32_t i = 0; i < operators.size(); ++i) index.try_emplace(operators[i].id, i);
  const auto add = [&](std::string_view id, std::vector<std::uint32_t>& factor) {
    const auto found = index.find(id);
    if (found == index.end() || factor.size() >= kMostCopies) return false;
    factor.push_back(found->second);
    return true;
  };
  const auto add_range = [&](std::string_view item, std::vector<std::uint32_t>& factor) {
    const std::size_t dash = item.find('-', 1);
    if (dash == std::string_view::npos) return add(item, factor);
    std::uint32_t first = 0, last = 0;
    const auto a = std::from_chars(item.data(), item.data() + dash, first);
    const auto b = std::from_chars(item.data() + dash + 1, item.data() + item.size(), last);
    if (a.ptr != item.data() + dash || b.ptr != item.data() + item.size()) return false;
    for (std::uint64_t id = first; id <= last; ++id) {
      if (!add(std::to_string(id), factor)) return false;
    }
    return first <= last;
  };
  factors.clear();
  std::string cleaned;
  for (const char c : text) {
    if (c != ' ' && c != '\n' && c != '\r' && c != '\t') cleaned += c;
  }
  std::string_view rest = cleaned;
  std::uint64_t copies = 1;
  while (!rest.empty()) {
    const bool bracket = rest.front() == '(';
    if (bracket) rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find_first_of(bracket ? ")" : "("), rest.size());
    if (bracket && end == rest.size()) return false;
    std::string_view items = rest.substr(0, end);
    rest.remove_prefix(bracket ? end + 1 : end);
    std::vector<std::uint32_t> factor;
    while (!items.empty()) {
      const std::size_t comma = std::min(items.find(','), items.size());
      if (!add_range(items.substr(0, comma), factor)) return false;
      items.remove_prefix(std::min(comma + 1, items.size()));
    }
    if (factor.empty()) return false;
    copies *= factor.size();
    if (copies > kMostCopies) return false;
    factors.push_back(std::move(factor));
  }
  return !factors.empty();
}

}  // namespace alphascope
