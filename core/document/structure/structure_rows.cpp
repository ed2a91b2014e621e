// SPDX-License-Identifier: GPL-3.0-or-later
// Finds residues and sorts them into branches.
#include "core/document/structure/structure_rows.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <string_view>
#include <utility>

#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/molecule/atom_type.hpp"
#include "core/molecule/molecule.hpp"
#include "core/secondary/secondary_once.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

constexpr std::pair<std::string_view, char> kLetters[] = {
    {"ALA", 'A'}, {"ARG", 'R'}, {"ASN", 'N'}, {"ASP", 'D'}, {"CYS", 'C'}, {"GLN", 'Q'},
    {"GLU", 'E'}, {"GLY", 'G'}, {"HIS", 'H'}, {"ILE", 'I'}, {"LEU", 'L'}, {"LYS", 'K'},
    {"MET", 'M'}, {"MSE", 'M'}, {"PHE", 'F'}, {"PRO", 'P'}, {"SEC", 'U'}, {"SER", 'S'},
    {"THR", 'T'}, {"TRP", 'W'}, {"TYR", 'Y'}, {"VAL", 'V'}};

char letter_of(std::string_view residue) {
  const std::string_view standard = standard_amino_acid(residue);
  const std::string_view name = standard.empty() ? residue : standard;
  const auto at = std::find_if(std::begin(kLetters), std::end(kLetters),
                               [&](const auto& l) { return l.first == name; });
  if (at != std::end(kLetters)) return at->second;
  const char base = nucleotide_base(residue);
  return base != 0 ? base : 'X';
}

// The place of a kind's branches in the tree.
int rank_of(ResidueKind kind) {
  switch (kind) {
    case ResidueKind::polymer:
      return 0;
    case ResidueKind::ligand:
      return 1;
    case ResidueKind::ion:
      return 2;
    case ResidueKind::water:
      return 3;
    case ResidueKind::dummy:
      break;
  }
  return 4;
}

struct Found {
  ResidueRow row;
  std::size_t branch = 0;
};

class RowMaker {
 public:
  explicit RowMaker(const Molecule& molecule) : molecule_(molecule) {
    for (NameId id = 0; id < molecule.names.size(); ++id) {
      letters_.push_back(letter_of(molecule.text(id)));
    }
    of_chain_.assign(molecule.names.size(), kNone);
    of_kind_.fill(kNone);
  }

  void add(std::size_t begin, std::size_t end, const RunContext& context) {
    constexpr std::size_t kAtOnce = 1 << 16;
    const auto& atoms = molecule_.atoms;
    for (std::size_t i = begin; i < end;) {
      if (i / kAtOnce != checked_) {
        checked_ = i / kAtOnce;
        context.cancel.throw_if_cancelled();
      }
      std::size_t last = i + 1;
      while (last < end && same_residue_number(atoms[i], atoms[last]) &&
             atoms[i].residue_name == atoms[last].residue_name &&
             atoms[i].kind == atoms[last].kind) {
        ++last;
      }
      ResidueRow row{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(last)};
      if (atoms[i].kind == ResidueKind::polymer) row.letter = letters_[atoms[i].residue_name];
      found_.push_back({row, branch_of(atoms[i])});
      i = last;
    }
  }

  StructureRows take(const SecondaryModel& secondary) {
    StructureRows rows;
    std::vector<std::uint32_t> order(found_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<std::size_t> rank(branches_.size());
    std::iota(rank.begin(), rank.end(), std::size_t{0});
    std::stable_sort(rank.begin(), rank.end(), [&](std::size_t a, std::size_t b) {
      return rank_of(branches_[a].kind) < rank_of(branches_[b].kind);
    });
    std::vector<std::size_t> place(branches_.size());
    for (std::size_t i = 0; i < rank.size(); ++i) place[rank[i]] = i;
    const bool sorted = std::is_sorted(
        found_.begin(), found_.end(),
        [&](const Found& a, const Found& b) { return place[a.branch] < place[b.branch]; });
    if (!sorted) {
      std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return place[found_[a].branch] < place[found_[b].branch];
      });
      rows.by_atom.resize(order.size());
      for (std::uint32_t i = 0; i < order.size(); ++i) rows.by_atom[order[i]] = i;
    }
    for (const std::size_t branch : rank) rows.branches.push_back(branches_[branch]);
    rows.residues.reserve(order.size());
    for (const std::uint32_t i : order) {
      ResidueBranch& branch = rows.branches[place[found_[i].branch]];
      if (branch.end == 0) branch.begin = rows.residues.size();
      rows.residues.push_back(found_[i].row);
      branch.end = rows.residues.size();
    }
    for (std::size_t r = 0; r < secondary.residues.size(); ++r) {
      const auto row = rows.row_of(secondary.residues[r].ca);
      if (row) rows.residues[*row].secondary = secondary.kinds[r];
    }
    return rows;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t branch_of(const Atom& atom) {
    std::size_t& known = atom.kind == ResidueKind::polymer
                             ? of_chain_[atom.chain]
                             : of_kind_.at(static_cast<std::size_t>(atom.kind));
    if (known != kNone) return known;
    known = branches_.size();
    branches_.push_back({title(atom), atom.kind, 0, 0});
    return known;
  }

  std::string title(const Atom& atom) const {
    switch (atom.kind) {
      case ResidueKind::ligand:
        return "Ligands";
      case ResidueKind::ion:
        return "Ions";
      case ResidueKind::water:
        return "Waters";
      case ResidueKind::dummy:
        return "Dummies";
      case ResidueKind::polymer:
        break;
    }
    const std::string name(molecule_.text(atom.chain));
    return name.empty() ? "Chain without a name" : "Chain " + name;
  }

  const Molecule& molecule_;
  std::vector<char> letters_;           // by NameId
  std::vector<std::size_t> of_chain_;   // by NameId
  std::array<std::size_t, 8> of_kind_;  // by ResidueKind
  std::vector<ResidueBranch> branches_;
  std::vector<Found> found_;
  std::size_t checked_ = 0;
};

}  // namespace

std::optional<std::size_t> StructureRows::row_of(std::uint32_t atom) const {
  const auto row_at = [this](std::size_t i) {
    return by_atom.empty() ? i : std::size_t{by_atom[i]};
  };
  std::size_t low = 0, high = residues.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    residues[row_at(middle)].end <= atom ? low = middle + 1 : high = middle;
  }
  if (low == residues.size() || residues[row_at(low)].first > atom) return std::nullopt;
  return row_at(low);
}

StructureRows make_structure_rows(const Molecule& molecule, const ModelRange& models,
                                  const SecondaryModel& secondary, const RunContext& context) {
  RowMaker maker(molecule);
  maker.add(models.begin, models.end, context);
  context.cancel.throw_if_cancelled();
  return maker.take(secondary);
}

std::string residue_title(const Molecule& molecule, const ResidueRow& row) {
  const Atom& atom = molecule.atoms[row.first];
  std::string text(molecule.text(atom.residue_name));
  text += (text.empty() ? "" : " ") + std::to_string(atom.residue_number);
  if (atom.insertion_code != ' ') text += atom.insertion_code;
  // Polymers stand below their chains.
  if (atom.kind == ResidueKind::polymer || molecule.text(atom.chain).empty()) return text;
  return text + ", chain " + std::string(molecule.text(atom.chain));
}

const Definition<StructureRows>& structure_rows() {
  static const Definition<StructureRows> definition{
      {.id = "structure_rows",
       .title = "Tree of residues",
       .key =
           [](const Inputs& in) {
             return Key{in.atoms ? in.body_key : 0, 0, 0};
           },
       .memory =
           [](const Inputs& in) {
             const std::uint64_t atoms = in.atoms ? in.atoms->molecule().atoms.size() : 0;
             return MemoryNeed{atoms * sizeof(ResidueRow), 3 * atoms * sizeof(ResidueRow)};
           },
       .lane = Lane::interactive},
      [](const Inputs& in, const RunContext& context) {
        const Molecule& molecule = in.atoms->molecule();
        const ModelRange models = models_of_balls(molecule, in.atoms->prepared());
        const auto secondary = in.atoms->secondary().of(molecule, models, context);
        return std::make_shared<const StructureRows>(
            make_structure_rows(molecule, models, *secondary, context));
      }};
  return definition;
}

}  // namespace alphascope
