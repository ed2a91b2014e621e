// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses among alternative locations: groups atoms into residues, even where numbers repeat, then
// keeps one location of each atom.
#include "core/molecule/altlocs.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <unordered_set>

namespace alphascope {
namespace {

// A fall of residue numbers by more than this means that they begin anew: at 0 or 1, after 9999 or
// 99999.
constexpr std::int32_t kWrapped = 5000;
// The number of residues of one number to which an atom is compared. A file that numbers all its
// waters 1 has very many.
constexpr std::size_t kResiduesLookedAt = 8;

// An atom that shares its residue number with an atom that has a letter.
struct Candidate {
  std::size_t atom;
  std::uint32_t round;  // number of times that residue numbers began anew before it
};

auto number_tuple(const Atom& a, std::uint32_t round) {
  return std::tuple(a.chain, a.segment, round, a.residue_number, a.insertion_code);
}

std::uint64_t number_hash(const Atom& a) {
  std::uint64_t key = static_cast<std::uint32_t>(a.residue_number);
  key = (key << 32) ^ (std::uint64_t{a.chain} << 8) ^ static_cast<unsigned char>(a.insertion_code);
  return key;
}

// The order of locations: higher occupancy, then lower B factor, then the earlier letter. The least
// is the best.
auto rank(double occupancy, double b_factor, char letter) {
  return std::tuple(-occupancy, b_factor, letter);
}

struct LetterMean {
  double occupancy = 0, b_factor = 0;
  std::size_t count = 0;
  NameId residue_name = 0;
};

using Atoms = std::vector<Atom>;
using Indices = std::vector<std::size_t>;

// The best letter of a residue. If `confidences`, B factors are ignored, because pLDDT values do
// not tell locations apart.
char best_letter(const Atoms& atoms, const Indices& residue, bool confidences,
                 NameId& residue_name) {
  std::map<char, LetterMean> letters;
  for (const std::size_t i : residue) {
    if (atoms[i].altloc == ' ') continue;
    LetterMean& mean = letters[atoms[i].altloc];
    mean.occupancy += atoms[i].occupancy;
    if (!confidences) mean.b_factor += atoms[i].b_factor;
    ++mean.count;
    mean.residue_name = atoms[i].residue_name;
  }
  const auto score = [](const auto& entry) {
    const double n = static_cast<double>(entry.second.count);
    return rank(entry.second.occupancy / n, entry.second.b_factor / n, entry.first);
  };
  const auto best =
      std::min_element(letters.begin(), letters.end(),
                       [&](const auto& a, const auto& b) { return score(a) < score(b); });
  residue_name = best->second.residue_name;
  return best->first;
}

// Marks those atoms of one residue that give way to another location.
void choose_in_residue(const Atoms& atoms, Indices residue, std::size_t begin, bool confidences,
                       std::vector<bool>& minor) {
  NameId chosen_type = 0;
  const char chosen = best_letter(atoms, residue, confidences, chosen_type);
  std::stable_sort(residue.begin(), residue.end(),
                   [&](std::size_t a, std::size_t b) { return atoms[a].name < atoms[b].name; });
  for (std::size_t first = 0, last; first < residue.size(); first = last) {
    last = first;
    std::size_t kept = residue[first];
    const auto score = [&](std::size_t i) {
      const Atom& a = atoms[i];
      return std::tuple(a.altloc != chosen,
                        rank(a.occupancy, confidences ? 0 : a.b_factor, a.altloc));
    };
    bool varies = false;
    for (; last < residue.size() && atoms[residue[last]].name == atoms[residue[first]].name;
         ++last) {
      varies |= atoms[residue[last]].altloc != ' ';
      if (score(residue[last]) < score(kept)) kept = residue[last];
    }
    if (!varies) continue;
    for (std::size_t k = first; k < last; ++k) {
      const Atom& a = atoms[residue[k]];
      const bool other_type = a.altloc != ' ' && a.residue_name != chosen_type;
      minor[residue[k] - begin] = residue[k] != kept || other_type;
    }
  }
}

// The atoms of one residue, with sets that decide whether another atom belongs to it.
struct Residue {
  Indices atoms;
  std::unordered_set<std::uint64_t> locations;  // name and letter
  std::unordered_set<NameId> names, single;  // names of all atoms; names of atoms without a letter
  std::map<char, NameId> types;              // residue name of each letter

  static std::uint64_t location(const Atom& a) {
    return (std::uint64_t{a.name} << 8) | static_cast<unsigned char>(a.altloc);
  }
  void add(const Atoms& all, std::size_t i) {
    const Atom& a = all[i];
    atoms.push_back(i);
    locations.insert(location(a));
    names.insert(a.name);
    if (a.altloc == ' ') {
      single.insert(a.name);
    } else {
      types.emplace(a.altloc, a.residue_name);
    }
  }
  bool has_location(const Atom& a) const { return locations.contains(location(a)); }

  // Returns whether an atom elsewhere in the file may belong to this residue. It belongs to another
  // residue of the same number in three cases. (1) Its name is here under the same letter. (2) Its
  // name is here, and one of the two atoms has no letter. (3) Its letter stands for another residue
  // name.
  bool may_have(const Atom& a) const {
    if (has_location(a)) return false;
    if (a.altloc == ' ') return !names.contains(a.name);
    const auto type = types.find(a.altloc);
    return !single.contains(a.name) && (type == types.end() || type->second == a.residue_name);
  }
};

// Consecutive atoms of one residue in the file.
struct Block {
  Indices atoms;
  bool lettered = true;  // whether all of them have a letter
};

// Residue names of several one-atom residues with the same number. For such a name a location
// occurs twice, and there is no second atom name.
std::unordered_set<NameId> single_atoms(const Atoms& atoms,
                                        std::span<const Candidate> same_number) {
  std::map<NameId, std::pair<NameId, bool>> found;  // atom name; whether it is the only one
  std::unordered_set<std::uint64_t> locations;
  std::unordered_set<NameId> several;
  for (const Candidate& c : same_number) {
    const Atom& a = atoms[c.atom];
    const auto [at, is_new] = found.try_emplace(a.residue_name, a.name, true);
    if (at->second.first != a.name) at->second.second = false;
    const std::uint64_t location = (std::uint64_t{a.residue_name} << 40) ^ Residue::location(a);
    if (!locations.insert(location).second) several.insert(a.residue_name);
  }
  std::erase_if(several, [&](NameId residue) { return !found[residue].second; });
  return several;
}

std::vector<Block> blocks_of(const Atoms& atoms, std::span<const Candidate> same_number) {
  std::vector<Block> blocks;
  const std::unordered_set<NameId> single = single_atoms(atoms, same_number);
  Residue last;
  for (const auto& [i, round] : same_number) {
    const bool goes_on = !blocks.empty() && last.atoms.back() + 1 == i &&
                         atoms[last.atoms.back()].residue_name == atoms[i].residue_name &&
                         !last.has_location(atoms[i]) &&
                         // If ions all have one number, one without a letter is no location of the
                         // lettered one beside it.
                         (!single.contains(atoms[i].residue_name) || last.may_have(atoms[i]));
    if (!goes_on) {
      blocks.emplace_back();
      last = {};
    }
    last.add(atoms, i);
    blocks.back().atoms.push_back(i);
    blocks.back().lettered = blocks.back().lettered && atoms[i].altloc != ' ';
  }
  return blocks;
}

// Groups the atoms of one chain, segment, number and insertion code into residues. Mostly there is
// one residue. There are several in a file that has more residues than numbers. A file may list
// alternative locations apart from the rest of the residue, for example after the chain. Then every
// atom there has its letter.
std::vector<Residue> residues_of(const Atoms& atoms, std::span<const Candidate> same_number) {
  std::vector<Residue> residues;
  for (const Block& block : blocks_of(atoms, same_number)) {
    Residue* home = nullptr;
    const std::size_t looked_at = std::min(residues.size(), kResiduesLookedAt);
    for (std::size_t back = 1; home == nullptr && back <= looked_at; ++back) {
      Residue& residue = residues[residues.size() - back];
      const bool next_to_it = residue.atoms.back() + 1 == block.atoms.front();
      if (!next_to_it && !block.lettered) continue;
      const bool fits = std::all_of(block.atoms.begin(), block.atoms.end(),
                                    [&](std::size_t i) { return residue.may_have(atoms[i]); });
      if (fits) home = &residue;
    }
    if (home == nullptr) home = &residues.emplace_back();
    for (const std::size_t i : block.atoms) home->add(atoms, i);
  }
  return residues;
}

// All candidates of a model. Those of one residue number are together, in the order of the file.
std::vector<Candidate> find_candidates(const Atoms& atoms, std::size_t begin, std::size_t end) {
  std::unordered_set<std::uint64_t> numbers;
  for (std::size_t i = begin; i < end; ++i) {
    if (atoms[i].altloc != ' ') numbers.insert(number_hash(atoms[i]));
  }
  std::vector<Candidate> candidates;
  if (numbers.empty()) return candidates;
  std::uint32_t round = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Atom& atom = atoms[i];
    if (i > begin && atom.chain == atoms[i - 1].chain && atom.segment == atoms[i - 1].segment &&
        atom.residue_number < atoms[i - 1].residue_number - kWrapped) {
      ++round;
    }
    if (numbers.contains(number_hash(atom))) candidates.push_back({i, round});
  }
  std::stable_sort(
      candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
        return number_tuple(atoms[a.atom], a.round) < number_tuple(atoms[b.atom], b.round);
      });
  return candidates;
}

}  // namespace

std::vector<bool> minor_altlocs(const Molecule& molecule, std::size_t begin, std::size_t end,
                                const std::function<bool(const Atom&)>& compete) {
  const Atoms& atoms = molecule.atoms;
  std::vector<bool> minor(end - begin, false);
  const std::vector<Candidate> candidates = find_candidates(atoms, begin, end);
  for (auto first = candidates.begin(); first != candidates.end();) {
    const auto last = std::find_if(first, candidates.end(), [&](const Candidate& c) {
      return c.round != first->round || !same_residue_number(atoms[c.atom], atoms[first->atom]);
    });
    for (Residue& residue : residues_of(atoms, {first, last})) {
      if (compete) std::erase_if(residue.atoms, [&](std::size_t i) { return !compete(atoms[i]); });
      const bool varies = std::any_of(residue.atoms.begin(), residue.atoms.end(),
                                      [&](std::size_t i) { return atoms[i].altloc != ' '; });
      if (varies) {
        choose_in_residue(atoms, std::move(residue.atoms), begin, molecule.has_confidences, minor);
      }
    }
    first = last;
  }
  return minor;
}

}  // namespace alphascope
