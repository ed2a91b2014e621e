// SPDX-License-Identifier: GPL-3.0-or-later
// Finds nucleotides by the names of their atoms.
#include "core/secondary/nucleotides.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/molecule/altlocs.hpp"
#include "core/molecule/atom_type.hpp"

namespace alphascope {
namespace {

// kC4 and kC1 are atoms of the sugar, and the roles after them atoms of the base.
enum Role : std::uint8_t {
  kP,
  kC4,
  kC1,
  kN1,
  kC2,
  kN3,
  kBaseC4,
  kC5,
  kC6,
  kN7,
  kC8,
  kN9,
  kRoles,
  kNoRole
};

// Along the outline.
constexpr std::array kPyrimidine{kN1, kC2, kN3, kBaseC4, kC5, kC6};
constexpr std::array kPurine{kN1, kC2, kN3, kBaseC4, kN9, kC8, kN7, kC5, kC6};

Role role_of(std::string_view name) {
  if (name == "P") return kP;
  if (name == "C4'" || name == "C4*") return kC4;
  if (name == "C1'" || name == "C1*") return kC1;
  if (name == "N1") return kN1;
  if (name == "C2") return kC2;
  if (name == "N3") return kN3;
  if (name == "C4") return kBaseC4;
  if (name == "C5") return kC5;
  if (name == "C6") return kC6;
  if (name == "N7") return kN7;
  if (name == "C8") return kC8;
  return name == "N9" ? kN9 : kNoRole;
}

class NucleotideFinder {
 public:
  NucleotideFinder(const Molecule& molecule, const ModelRange& model) : molecule_(molecule) {
    for (NameId id = 0; id < molecule.names.size(); ++id) {
      roles_.push_back(role_of(molecule.text(id)));
      named_.push_back(nucleotide_base(molecule.text(id)) != 0);
    }
    const auto begin = molecule.atoms.begin() + static_cast<std::ptrdiff_t>(model.begin);
    const auto end = molecule.atoms.begin() + static_cast<std::ptrdiff_t>(model.end);
    begin_ = model.begin;
    if (std::any_of(begin, end, [](const Atom& a) { return a.altloc != ' '; })) {
      minor_ = minor_altlocs(molecule, model.begin, model.end);
    }
  }

  void add(std::size_t i) {
    const Atom& atom = molecule_.atoms[i];
    if (atom.kind != ResidueKind::polymer || (!minor_.empty() && minor_[i - begin_])) return;
    const Role role = roles_[atom.name];
    const bool again = open_ && role < kRoles && found_[role] != kNoAtom;
    if (!open_ || again || !same_residue_number(molecule_.atoms[first_], atom)) {
      close();
      open_ = true;
      first_ = i;
      found_.fill(kNoAtom);
    }
    if (role < kRoles) found_[role] = static_cast<std::uint32_t>(i);
  }

  std::vector<Nucleotide> take() {
    close();
    for (std::size_t k = 1; k < list_.size(); ++k) {
      const Atom& a = molecule_.atoms[list_[k - 1].backbone];
      const Atom& b = molecule_.atoms[list_[k].backbone];
      const double step = length(position_angstrom(molecule_, list_[k - 1].backbone) -
                                 position_angstrom(molecule_, list_[k].backbone));
      list_[k - 1].bound_to_next =
          a.chain == b.chain && a.segment == b.segment && step <= kLongestNucleotideStep;
    }
    return std::move(list_);
  }

 private:
  void close() {
    if (!std::exchange(open_, false)) return;
    const bool named = named_[molecule_.atoms[first_].residue_name];
    if (found_[kC1] == kNoAtom && !(named && (found_[kC4] != kNoAtom || found_[kP] != kNoAtom))) {
      return;
    }
    Nucleotide n;
    for (const Role role : {kC4, kP, kC1}) {
      if (n.backbone == kNoAtom) n.backbone = found_[role];
    }
    n.sugar = found_[kC1];
    const bool purine = found_[kN9] != kNoAtom;
    n.base = found_[purine ? kN1 : kN3];
    purine ? set_outline(n, kPurine) : set_outline(n, kPyrimidine);
    list_.push_back(n);
  }

  template <std::size_t corners>
  void set_outline(Nucleotide& n, const std::array<Role, corners>& roles) const {
    for (std::size_t k = 0; k < corners; ++k) n.outline[k] = found_[roles[k]];
    const auto end = n.outline.begin() + corners;
    if (std::find(n.outline.begin(), end, kNoAtom) == end) n.corners = corners;
  }

  const Molecule& molecule_;
  std::vector<Role> roles_;  // by NameId
  std::vector<bool> named_;  // by NameId: the name is a nucleotide's
  std::vector<bool> minor_;  // empty: no atom has other locations
  std::size_t begin_ = 0;    // of the model
  std::vector<Nucleotide> list_;
  bool open_ = false;
  std::size_t first_ = 0;  // atom of the open residue
  std::array<std::uint32_t, kRoles> found_{};
};

}  // namespace

std::vector<Nucleotide> find_nucleotides(const Molecule& molecule, const ModelRange& model,
                                         const RunContext& context) {
  constexpr std::size_t kAtomsAtOnce = 1 << 16;
  NucleotideFinder finder(molecule, model);
  for (std::size_t i = model.begin; i < model.end; ++i) {
    if (i % kAtomsAtOnce == 0) context.cancel.throw_if_cancelled();
    finder.add(i);
  }
  return finder.take();
}

}  // namespace alphascope
