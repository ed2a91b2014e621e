// SPDX-License-Identifier: GPL-3.0-or-later
// Groups residues by name and decision, and finds expressions that name each group.
#include "core/selection/residue_groups.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

// The atom as the file's evidence decides it, without treatments.
const Atom& as_in_file(const Molecule& deposited, const Molecule& molecule, std::size_t atom) {
  if (molecule.atoms[atom].why != ResidueReason::by_hand) return molecule.atoms[atom];
  return deposited.atoms[atom_source(molecule, atom).deposited];
}

// Returns whether an atom continues the run of a residue, as in list_residues(): same residue, kind
// and reason.
bool goes_on(const Atom& last, const Atom& atom) {
  return last.kind == atom.kind && last.why == atom.why && same_residue(last, atom);
}

// Returns whether an address can name the atom's residue without naming its whole chain.
bool has_address(const Atom& atom) {
  return atom.residue_name != 0 || atom.residue_number != 0 || atom.chain == 0;
}

class Grouping {
 public:
  Grouping(const Molecule& deposited, const Molecule& molecule,
           const std::vector<std::string>& treatments, const TreatedAtoms& treated)
      : deposited_(deposited),
        molecule_(molecule),
        treatments_(treatments),
        treated_(treated),
        residues_of_name_(molecule.names.size()) {}

  void add(std::size_t atom, bool begins) {
    if (begins) begin_residue(atom);
    ++groups_[place_].group.atoms;
    if (molecule_.atoms[atom].why != ResidueReason::by_hand) return;
    std::vector<bool>& by = groups_[place_].by;
    by.resize(treated_.size());
    for (std::size_t t = 0; t < treated_.size(); ++t) by[t] = by[t] || treated_[t][atom];
  }

  ResidueGroups take() {
    ResidueGroups result;
    for (const Found& found : groups_) {
      if (found.group.why != ResidueReason::virtual_site) of_name_[found.name].push_back(&found);
    }
    for (Found& found : groups_) name(found);
    for (Found& found : groups_) {
      const ResidueGroup& group = found.group;
      if (group.why != ResidueReason::virtual_site) {
        result.kinds[static_cast<std::size_t>(group.kind)] += group.residues;
      }
      if (is_guess(group.why)) result.guessed += group.residues;
      if (group.why == ResidueReason::by_hand) result.by_hand += group.residues;
      result.of.push_back(std::move(found.group));
    }
    return result;
  }

 private:
  struct Found {
    ResidueGroup group;
    NameId name = 0;
    std::vector<std::size_t> first;  // first atoms of residues, of at most kMostAddresses + 1
    std::vector<bool> by;            // for each treatment whether it applies to the group
  };

  void begin_residue(std::size_t index) {
    const Atom& atom = molecule_.atoms[index];
    const Atom& file = as_in_file(deposited_, molecule_, index);
    std::uint64_t key = atom.residue_name;
    for (const auto part : {static_cast<unsigned>(atom.kind), static_cast<unsigned>(atom.why),
                            static_cast<unsigned>(file.kind), static_cast<unsigned>(file.why)}) {
      key = key << 8 | part;
    }
    // The key has 32 bits of the name and 32 of these four values.
    const auto [known, is_new] = places_.try_emplace(key, groups_.size());
    place_ = known->second;
    if (is_new) {
      Found found;
      found.name = atom.residue_name;
      found.group.name = molecule_.text(atom.residue_name);
      found.group.kind = atom.kind;
      found.group.why = atom.why;
      found.group.file_kind = file.kind;
      found.group.file_why = file.why;
      groups_.push_back(std::move(found));
    }
    Found& found = groups_[place_];
    ++found.group.residues;
    if (found.first.size() <= kMostAddresses) found.first.push_back(index);
    if (atom.why != ResidueReason::virtual_site) ++residues_of_name_[atom.residue_name];
  }

  void name(Found& found) const {
    ResidueGroup& group = found.group;
    for (std::size_t t = 0; t < found.by.size(); ++t) {
      if (found.by[t]) group.treated.push_back(treatments_[t]);
    }
    if (group.why == ResidueReason::virtual_site) return;
    if (found.name != 0 && group.residues == residues_of_name_[found.name]) {
      group.called = {group.name};
      return;
    }
    if (group.residues > kMostAddresses) {
      const std::string expression = all_but_others(found);
      if (!expression.empty()) group.called = {expression};
      return;
    }
    std::vector<std::string> called;
    for (const std::size_t atom : found.first) {
      if (!has_address(molecule_.atoms[atom])) return;
      std::string address = residue_address(molecule_, atom);
      // Atoms of two types at one place alternate, so an address may repeat.
      if (std::find(called.begin(), called.end(), address) == called.end()) {
        called.push_back(std::move(address));
      }
    }
    group.called = std::move(called);
  }

  // An expression for all residues of the name but those of other groups, such as "resn "HOH" and
  // not (chain "A" and resi 143)". Empty if there are too many others.
  std::string all_but_others(const Found& found) const {
    const std::size_t others = residues_of_name_[found.name] - found.group.residues;
    if (found.name == 0 || others > kMostAddresses) return {};
    std::string text;
    for (const Found* other : of_name_.at(found.name)) {
      if (other == &found) continue;
      for (const std::size_t index : other->first) {
        const Atom& atom = molecule_.atoms[index];
        text += text.empty() ? "(" : " or (";
        if (atom.chain != 0) text += "chain " + quoted_name(molecule_.text(atom.chain)) + " and ";
        std::string number = std::to_string(atom.residue_number);
        if (atom.insertion_code != ' ') number += atom.insertion_code;
        text += "resi " + (atom.residue_number < 0 ? quoted_name(number) : number) + ")";
      }
    }
    if (others > 1) text = "(" + text + ")";
    return "resn " + quoted_name(found.group.name) + " and not " + text;
  }

  const Molecule& deposited_;
  const Molecule& molecule_;
  const std::vector<std::string>& treatments_;
  const TreatedAtoms& treated_;
  // Numbers of residues that treatments can change, by name id.
  std::vector<std::size_t> residues_of_name_;
  std::vector<Found> groups_;
  // Groups by name; filled when all are known.
  std::unordered_map<NameId, std::vector<const Found*>> of_name_;
  std::unordered_map<std::uint64_t, std::size_t> places_;
  std::size_t place_ = 0;  // index of the current residue's group
};

// The rank of a group in the list; low ranks come first.
int rank(const ResidueGroup& group) {
  if (is_guess(group.file_why)) return -1;
  constexpr ResidueKind kOrder[] = {ResidueKind::ligand, ResidueKind::ion, ResidueKind::dummy,
                                    ResidueKind::water, ResidueKind::polymer};
  return static_cast<int>(std::find(std::begin(kOrder), std::end(kOrder), group.file_kind) -
                          std::begin(kOrder));
}

void sort_and_number(std::vector<ResidueGroup>& groups) {
  const auto key = [](const ResidueGroup& g) {
    return std::tuple(rank(g), std::string_view(g.name), g.file_kind, g.file_why, g.kind, g.why);
  };
  std::sort(groups.begin(), groups.end(),
            [&](const ResidueGroup& a, const ResidueGroup& b) { return key(a) < key(b); });
  std::unordered_map<std::string_view, std::size_t> seen;
  for (ResidueGroup& group : groups) group.nth = ++seen[group.name];
}

}  // namespace

ResidueGroups residue_groups(const Molecule& deposited, const Molecule& molecule, std::size_t begin,
                             std::size_t end, const std::vector<std::string>& treatments,
                             const TreatedAtoms& treated) {
  Grouping grouping(deposited, molecule, treatments, treated);
  for (std::size_t i = begin; i < end; ++i) {
    grouping.add(i, i == begin || !goes_on(molecule.atoms[i - 1], molecule.atoms[i]));
  }
  ResidueGroups groups = grouping.take();
  const bool known = std::any_of(groups.of.begin(), groups.of.end(), [](const ResidueGroup& group) {
    return group.why != ResidueReason::none;
  });
  if (!known) return {};
  sort_and_number(groups.of);
  return groups;
}

std::string decisions_text(const ResidueGroups& groups) {
  std::string text;
  const auto add = [&text](std::size_t count, const char* what) {
    if (count > 0) text += (text.empty() ? "" : ", ") + grouped(count) + " " + what;
  };
  add(groups.guessed, "guessed");
  add(groups.by_hand, "set by hand");
  return text.empty() ? kinds_text(groups.kinds) : text;
}

std::string why_text(const ResidueGroup& group) {
  const std::string reason = reason_text(group.why);
  if (group.why != ResidueReason::by_hand) return reason;
  const std::string file_reason = reason_text(group.file_why);
  return reason + "; otherwise " + kind_name(group.file_kind) +
         (file_reason.empty() ? "" : " (" + file_reason + ")");
}

std::string selection_text(const ResidueGroup& group) {
  if (group.called.empty()) return {};
  if (group.called.front() == group.name) return "resn " + quoted_name(group.name);
  return std::accumulate(
      std::next(group.called.begin()), group.called.end(), group.called.front(),
      [](const std::string& text, const std::string& address) { return text + "," + address; });
}

void set_group_kind(std::vector<std::string>& treatments, const ResidueGroup& group,
                    ResidueKind kind) {
  for (const std::string& residues : group.called) set_treatment(treatments, {residues, kind});
}

void remove_treatments(std::vector<std::string>& treatments, const ResidueGroup& group) {
  std::erase_if(treatments, [&](const std::string& text) {
    return std::find(group.treated.begin(), group.treated.end(), text) != group.treated.end();
  });
}

}  // namespace alphascope
