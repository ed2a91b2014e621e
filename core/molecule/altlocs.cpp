#include "core/molecule/altlocs.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_set>

namespace alphascope {
namespace {

std::uint64_t residue_key(const Atom& a) {
  std::uint64_t key = static_cast<std::uint32_t>(a.residue_number);
  key = (key << 32) ^ (std::uint64_t{a.chain} << 8) ^ static_cast<unsigned char>(a.insertion_code);
  return key;
}

auto residue_tuple(const Atom& a) {
  return std::tuple(a.chain, a.residue_number, a.insertion_code);
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

char best_letter(const Atoms& atoms, const Indices& residue, NameId& residue_name) {
  std::map<char, LetterMean> letters;
  for (const std::size_t i : residue) {
    if (atoms[i].altloc == ' ') continue;
    LetterMean& mean = letters[atoms[i].altloc];
    mean.occupancy += atoms[i].occupancy;
    mean.b_factor += atoms[i].b_factor;
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
void choose_in_residue(const Atoms& atoms, Indices residue, std::size_t begin,
                       std::vector<bool>& minor) {
  NameId chosen_type = 0;
  const char chosen = best_letter(atoms, residue, chosen_type);
  std::stable_sort(residue.begin(), residue.end(),
                   [&](std::size_t a, std::size_t b) { return atoms[a].name < atoms[b].name; });
  for (std::size_t first = 0, last; first < residue.size(); first = last) {
    last = first;
    std::size_t kept = residue[first];
    const auto score = [&](std::size_t i) {
      const Atom& a = atoms[i];
      return std::tuple(a.altloc != chosen, rank(a.occupancy, a.b_factor, a.altloc));
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

}  // namespace

std::vector<bool> minor_altlocs(const Molecule& molecule, std::size_t begin, std::size_t end) {
  const Atoms& atoms = molecule.atoms;
  std::vector<bool> minor(end - begin, false);
  std::unordered_set<std::uint64_t> residues;
  for (std::size_t i = begin; i < end; ++i) {
    if (atoms[i].altloc != ' ') residues.insert(residue_key(atoms[i]));
  }
  if (residues.empty()) return minor;
  Indices candidates;
  for (std::size_t i = begin; i < end; ++i) {
    if (residues.contains(residue_key(atoms[i]))) candidates.push_back(i);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) {
    return residue_tuple(atoms[a]) < residue_tuple(atoms[b]);
  });
  for (auto first = candidates.begin(); first != candidates.end();) {
    auto last = first;
    bool varies = false;
    while (last != candidates.end() &&
           residue_tuple(atoms[*last]) == residue_tuple(atoms[*first])) {
      varies |= atoms[*last].altloc != ' ';
      ++last;
    }
    if (varies) choose_in_residue(atoms, Indices(first, last), begin, minor);
    first = last;
  }
  return minor;
}

}  // namespace alphascope
