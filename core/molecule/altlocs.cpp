#include "core/molecule/altlocs.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <unordered_set>

namespace alphascope {
namespace {

// Residue numbers begin anew, at 0 or 1 after 9999 or 99999, where one falls by more than this.
constexpr std::int32_t kWrapped = 5000;
// Of those with one number; a file that numbers all its waters 1 has very many.
constexpr std::size_t kResiduesLookedAt = 8;

// An atom whose residue number some lettered atom has too.
struct Candidate {
  std::size_t atom;
  std::uint32_t round;  // how often the residue numbers have begun anew before it
};

auto number_tuple(const Atom& a, std::uint32_t round) {
  return std::tuple(a.chain, a.segment, round, a.residue_number, a.insertion_code);
}

std::uint64_t number_hash(const Atom& a) {
  std::uint64_t key = static_cast<std::uint32_t>(a.residue_number);
  key = (key << 32) ^ (std::uint64_t{a.chain} << 8) ^ static_cast<unsigned char>(a.insertion_code);
  return key;
}

// Smaller is better.
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

// confidences: what stands for B factors says nothing of locations.
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

// Marks what gives way among the atoms of one residue.
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

// Atoms that are of one residue, and what decides whether another is.
struct Residue {
  Indices atoms;
  std::unordered_set<std::uint64_t> locations;  // name and letter
  std::unordered_set<NameId> names, single;     // of all atoms; of those without a letter
  std::map<char, NameId> types;                 // the residue name that a letter stands for

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

  // Whether an atom that stands elsewhere may be one more of this residue. If its name is here
  // under the same letter, or one of the two has no letter, or its letter is another type's, then
  // it is of another residue with the same number.
  bool may_have(const Atom& a) const {
    if (has_location(a)) return false;
    if (a.altloc == ' ') return !names.contains(a.name);
    const auto type = types.find(a.altloc);
    return !single.contains(a.name) && (type == types.end() || type->second == a.residue_name);
  }
};

// Atoms that stand together in the file.
struct Block {
  Indices atoms;
  bool lettered = true;  // all of them
};

// Names of residues of one number of which there are several, of one atom each: some location
// comes twice, and no other name.
std::unordered_set<NameId> single_atoms(const Atoms& atoms,
                                        std::span<const Candidate> same_number) {
  std::map<NameId, std::pair<NameId, bool>> found;  // atom's name; whether it is the only one
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
                         // Of ions that all have one number, one without a letter is no
                         // location of the one with a letter beside it.
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

// The atoms of one chain, segment, number and insertion code as the residues that they form. Most
// often that is one, but a file with more residues than numbers uses them again. Alternative
// locations may stand apart, behind the chain say; then every atom there has its letter.
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

// The candidates of a model, those of one residue number together and in the order of the file.
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
