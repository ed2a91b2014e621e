// SPDX-License-Identifier: GPL-3.0-or-later
// Lists residues for people, alone or in groups.
#include "core/selection/residue_list.hpp"

#include <map>
#include <tuple>

#include "core/selection/atom_groups.hpp"

namespace alphascope {
namespace {

// The largest number of residues of one name and reason in a chain that are listed one by one.
constexpr std::size_t kToldOneByOne = 12;

std::string number_text(const Atom& atom) {
  std::string text = std::to_string(atom.residue_number);
  if (atom.insertion_code != ' ') text += atom.insertion_code;
  return text;
}

struct Run {
  std::size_t first = 0, last = 0, atoms = 0;
};

std::vector<Run> runs_of(const Molecule& molecule, std::size_t begin, std::size_t end) {
  std::vector<Run> runs;
  for (std::size_t i = begin; i < end; ++i) {
    const Atom& atom = molecule.atoms[i];
    const bool same = !runs.empty() && same_residue(molecule.atoms[runs.back().last], atom) &&
                      molecule.atoms[runs.back().last].kind == atom.kind &&
                      molecule.atoms[runs.back().last].why == atom.why;
    if (!same) runs.push_back({i, i, 0});
    runs.back().last = i;
    ++runs.back().atoms;
  }
  return runs;
}

using Key = std::tuple<NameId, ResidueKind, ResidueReason, NameId>;

// Polymers, and waters, of a chain share one entry whatever their names.
Key key_of(const Atom& atom) {
  const bool together = atom.kind == ResidueKind::polymer || atom.kind == ResidueKind::water;
  return {atom.chain, atom.kind, atom.why, together && !is_guess(atom.why) ? 0 : atom.residue_name};
}

}  // namespace

std::vector<ListedResidues> list_residues(const Molecule& molecule, std::size_t begin,
                                          std::size_t end, ResidueListing listing) {
  const std::vector<Run> runs = runs_of(molecule, begin, end);
  std::map<Key, std::size_t> counts;
  if (listing == ResidueListing::grouped) {
    for (const Run& run : runs) ++counts[key_of(molecule.atoms[run.first])];
  }
  const auto is_grouped = [&](const Atom& atom) {
    if (listing == ResidueListing::each) return false;
    const bool body = atom.kind == ResidueKind::polymer || atom.kind == ResidueKind::water;
    return (body && !is_guess(atom.why)) || counts[key_of(atom)] > kToldOneByOne;
  };
  std::vector<ListedResidues> list;
  std::vector<std::size_t> last;  // for each entry an atom of its last residue
  std::map<Key, std::size_t> places;
  for (const Run& run : runs) {
    const Atom& atom = molecule.atoms[run.first];
    const std::string name(molecule.text(atom.residue_name));
    std::size_t place = list.size();
    if (is_grouped(atom)) place = places.try_emplace(key_of(atom), place).first->second;
    if (place == list.size()) {
      list.push_back({std::string(molecule.text(atom.chain)), name, number_text(atom), atom.kind,
                      atom.why, 0, 0, run.first});
      last.push_back(run.first);
    }
    ListedResidues& entry = list[place];
    if (entry.name != name) entry.name.clear();
    last[place] = run.first;
    ++entry.residues;
    entry.atoms += run.atoms;
  }
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (list[k].residues > 1) list[k].number += "-" + number_text(molecule.atoms[last[k]]);
  }
  return list;
}

}  // namespace alphascope
