// SPDX-License-Identifier: GPL-3.0-or-later
// Groups atoms into residues, and counts what their names and elements show.
#include "core/read/residues/residue_table.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/atom_groups.hpp"

namespace alphascope {
namespace {

constexpr Element kCarbon = 6, kOxygen = 8;
// Limit of atoms that are searched for one with the same name.
constexpr std::size_t kLongestSearched = 512;

BackboneAtom backbone_atom(std::string_view name) {
  static constexpr std::pair<std::string_view, BackboneAtom> kAtoms[] = {
      {"N", BackboneAtom::n},    {"CA", BackboneAtom::ca},  {"C", BackboneAtom::c},
      {"P", BackboneAtom::p},    {"O3'", BackboneAtom::o3}, {"O3*", BackboneAtom::o3},
      {"O5'", BackboneAtom::o5}, {"O5*", BackboneAtom::o5}, {"C1'", BackboneAtom::c1},
      {"C1*", BackboneAtom::c1}, {"C3'", BackboneAtom::c3}, {"C3*", BackboneAtom::c3},
      {"C4'", BackboneAtom::c4}, {"C4*", BackboneAtom::c4}, {"CB", BackboneAtom::cb}};
  for (const auto& [text, atom] : kAtoms) {
    if (text == name) return atom;
  }
  return BackboneAtom::other;
}

// True for lone pairs, dummy masses and charges in water models of three to six points.
bool water_site(std::string_view name) {
  constexpr std::string_view kFirst = "MLEVQ";
  return !name.empty() && (kFirst.find(name[0]) != std::string_view::npos || name == "OM" ||
                           name == "IW" || name.starts_with("DO"));
}

// True for the oxygen of a water in a file without elements.
bool is_water_oxygen(std::string_view name) {
  return name == "O" || name == "OW" || name == "OH2" || name == "OH";
}

void add_index(std::array<std::uint32_t, 2>& list, std::uint32_t atom) {
  if (list[0] == kNoIndex) {
    list[0] = atom;
  } else if (list[1] == kNoIndex) {
    list[1] = atom;
  }
}

// Adds the atoms of one model to its residues.
class TableMaker {
 public:
  TableMaker(const Molecule& molecule, const ResidueRecords& records, AtomRoles& roles)
      : molecule_(molecule), records_(records), roles_(roles) {}

  ResidueTable make(const ModelRange& model) {
    std::size_t run = 0;
    for (std::size_t i = model.begin; i < model.end; ++i) {
      if (molecule_.atoms[i].residue_name == 0 && molecule_.atoms[i].residue_number == 0) continue;
      const std::vector<ResidueRecords::Run>& runs = records_.runs();
      while (run + 1 < runs.size() && runs[run + 1].begin <= i) ++run;
      const ResidueRecord record =
          runs.empty() || runs[run].begin > i ? ResidueRecord{} : runs[run].record;
      const Atom& atom = molecule_.atoms[i];
      if (!continues(i, model, record)) begin_piece(i, record);
      table_.pieces.back().end = i + 1;
      count(table_.residues[table_.pieces.back().residue], atom, static_cast<std::uint32_t>(i));
    }
    for (ResidueFacts& facts : table_.residues) finish(facts);
    return std::move(table_);
  }

 private:
  bool continues(std::size_t i, const ModelRange& model, const ResidueRecord& record) const {
    if (i == model.begin || table_.pieces.empty() || table_.pieces.back().end != i) return false;
    const Atom &atom = molecule_.atoms[i], &before = molecule_.atoms[i - 1];
    const ResiduePiece& piece = table_.pieces.back();
    if (!same_residue(before, atom) ||
        table_.residues[piece.residue].record.section != record.section) {
      return false;
    }
    // Waters and ions can share one residue number. Each repeated first atom begins a new piece.
    const Atom& first = molecule_.atoms[piece.begin];
    const bool again = first.name == atom.name && first.altloc == atom.altloc &&
                       (atom.kind == ResidueKind::water || atom.kind == ResidueKind::ion);
    return !again;
  }

  void begin_piece(std::size_t i, const ResidueRecord& record) {
    const Atom& atom = molecule_.atoms[i];
    std::uint32_t residue = static_cast<std::uint32_t>(table_.residues.size());
    if (atom.altloc != ' ') {
      const Key key{atom.chain,          atom.segment,      atom.residue_number,
                    atom.insertion_code, atom.residue_name, record.section};
      const auto [known, added] = parted_.try_emplace(key, residue);
      if (!added && !has(known->second, atom)) {
        residue = known->second;
      } else {
        known->second = residue;
      }
    }
    if (residue == table_.residues.size()) {
      ResidueFacts facts;
      facts.first = static_cast<std::uint32_t>(i);
      facts.record = record;
      facts.family = roles_.family(atom.residue_name);
      table_.residues.push_back(facts);
    }
    table_.pieces.push_back({i, i + 1, residue});
  }

  // True when the residue has this atom already; the atom then belongs to another residue of the
  // same number. Also true when more than kLongestSearched atoms would have to be searched.
  bool has(std::uint32_t residue, const Atom& atom) const {
    std::size_t searched = 0;
    for (std::size_t k = table_.pieces.size(); k-- > 0 && searched < kLongestSearched;) {
      const ResiduePiece& piece = table_.pieces[k];
      for (std::size_t i = piece.begin; i < piece.end && searched < kLongestSearched; ++i) {
        ++searched;
        const Atom& other = molecule_.atoms[i];
        if (piece.residue == residue && other.name == atom.name && other.altloc == atom.altloc) {
          return true;
        }
      }
      if (piece.begin == table_.residues[residue].first) return false;
    }
    return searched >= kLongestSearched;
  }

  void count(ResidueFacts& facts, const Atom& atom, std::uint32_t index) const {
    facts.hetero = facts.hetero && atom.hetero;
    if (atom.kind == ResidueKind::dummy) {
      ++facts.dummies;
      return;
    }
    facts.water_name |= atom.kind == ResidueKind::water;
    // Only the first letter of alternative locations counts.
    if (facts.letter == ' ') facts.letter = atom.altloc;
    if (atom.altloc != ' ' && atom.altloc != facts.letter) {
      add_ends(facts, atom, index);
      return;
    }
    ++facts.atoms;
    if (roles_.is_water_site(molecule_, atom)) {
      ++facts.sites;
      return;
    }
    facts.oxygens += atom.element == kOxygen &&
                     (!atom.element_guessed || is_water_oxygen(molecule_.text(atom.name)));
    facts.hydrogens += atom.element == kHydrogen;
    facts.metals += is_metal(atom.element) && !atom.element_guessed;
    facts.unknown += atom.element == kUnknownElement;
    facts.ions += atom.kind == ResidueKind::ion;
    add_ends(facts, atom, index);
  }

  void add_ends(ResidueFacts& facts, const Atom& atom, std::uint32_t index) const {
    const BackboneAtom role = roles_.backbone(atom.name);
    if (role == BackboneAtom::other) return;
    // "CA" of calcium is no backbone atom.
    if (role == BackboneAtom::ca && atom.element != kCarbon && atom.element != kUnknownElement) {
      return;
    }
    facts.has |= static_cast<std::uint16_t>(1u << static_cast<unsigned>(role));
    switch (role) {
      case BackboneAtom::n:
        return add_index(facts.n, index);
      case BackboneAtom::ca:
        return add_index(facts.ca, index);
      case BackboneAtom::c:
        return add_index(facts.c, index);
      case BackboneAtom::p:
        return add_index(facts.p, index);
      case BackboneAtom::o3:
        return add_index(facts.o3, index);
      default:
        return;
    }
  }

  void finish(ResidueFacts& facts) const {
    const std::string_view name = molecule_.text(molecule_.atoms[facts.first].residue_name);
    const bool by_name = facts.family == ResidueFamily::biopolymer;
    // "UNK" is an unknown amino acid, but many programs use it for any ligand.
    const bool unknown = name == "UNK" && !facts.holds(BackboneAtom::ca) &&
                         !facts.holds(BackboneAtom::cb) && !facts.holds(BackboneAtom::n);
    const bool shape = facts.amino_shape() || facts.nucleic_shape();
    facts.chain_like = (by_name && !unknown) || shape || facts.only_ca();
  }

  using Key = std::tuple<NameId, std::uint16_t, std::int32_t, char, NameId, std::uint32_t>;
  const Molecule& molecule_;
  const ResidueRecords& records_;
  AtomRoles& roles_;
  ResidueTable table_;
  std::map<Key, std::uint32_t> parted_;  // residues with alternative locations
};

}  // namespace

AtomRoles::AtomRoles(const Molecule& molecule) : names_(molecule.names) {
  families_.resize(names_.size());
  for (NameId id = 0; id < names_.size(); ++id) {
    const std::string_view name = names_.text(id);
    backbone_.push_back(backbone_atom(name));
    water_site_.push_back(water_site(name));
  }
}

ResidueFamily AtomRoles::family(NameId residue_name) {
  std::optional<ResidueFamily>& family = families_[residue_name];
  if (!family) family = residue_family(names_.text(residue_name));
  return *family;
}

ResidueTable make_residue_table(const Molecule& molecule, const ModelRange& model,
                                const ResidueRecords& records, AtomRoles& roles) {
  return TableMaker(molecule, records, roles).make(model);
}

}  // namespace alphascope
