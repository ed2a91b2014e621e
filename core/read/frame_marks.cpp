// SPDX-License-Identifier: GPL-3.0-or-later
// Finds repeated atoms behind END and TER records and makes models of them.
#include "core/read/frame_marks.hpp"

#include <algorithm>
#include <string>

#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

bool same_names(const Atom& a, const Atom& b) {
  return same_residue_number(a, b) && a.name == b.name && a.residue_name == b.residue_name &&
         a.altloc == b.altloc;
}

// True when the atoms from `begin` on repeat the first ones.
bool repeats(const std::vector<Atom>& atoms, std::size_t begin, std::size_t count, bool serials) {
  for (std::size_t k = 0; k < count; ++k) {
    const Atom& first = atoms[k];
    const Atom& again = atoms[begin + k];
    if (!same_names(first, again)) return false;
    if (serials && (first.serial != again.serial || first.serial == 0)) return false;
  }
  return true;
}

// First atoms of the frames that END records separate. Empty when the parts between them do not
// repeat the same atoms. The last frame may have been cut off.
std::vector<std::size_t> frames_behind(const std::vector<std::size_t>& ends,
                                       const std::vector<Atom>& atoms) {
  if (ends.empty() || ends.front() == atoms.size()) return {};
  const std::size_t size = ends.front();
  std::vector<std::size_t> begins{0};
  for (std::size_t k = 0; k < ends.size() && ends[k] < atoms.size(); ++k) {
    const std::size_t end = k + 1 < ends.size() ? ends[k + 1] : atoms.size();
    const bool last = end == atoms.size();
    const std::size_t count = end - ends[k];
    if (count > size || (count < size && !last)) return {};
    if (!repeats(atoms, ends[k], count, false)) return {};
    begins.push_back(ends[k]);
  }
  return begins;
}

// First atoms of frames that end with a TER. A frame may have several chains, each with a TER.
std::vector<std::size_t> frames_of_chains(const std::vector<std::size_t>& ters,
                                          const std::vector<Atom>& atoms) {
  for (const std::size_t size : ters) {
    if (size >= atoms.size()) break;
    if (!same_names(atoms[0], atoms[size]) || atoms.size() % size != 0) continue;
    std::vector<std::size_t> begins;
    for (std::size_t at = 0; at < atoms.size(); at += size) {
      const bool marked = at == 0 || std::binary_search(ters.begin(), ters.end(), at);
      if (!marked || !repeats(atoms, at, size, true)) break;
      begins.push_back(at);
    }
    if (begins.size() == atoms.size() / size) return begins;
  }
  return {};
}

}  // namespace

void FrameMarks::split(Molecule& molecule) const {
  if (!molecule.models.empty() || molecule.atoms.empty()) return;
  const char* record = "END";
  std::vector<std::size_t> begins = frames_behind(ends_, molecule.atoms);
  if (begins.empty()) {
    record = "TER";
    begins = frames_of_chains(ters_, molecule.atoms);
  }
  if (begins.size() < 2) return;
  for (std::size_t k = 0; k < begins.size(); ++k) {
    const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : molecule.atoms.size();
    molecule.models.push_back({static_cast<int>(k + 1), begins[k], end});
  }
  molecule.notes.push_back(
      "The file has no MODEL records, but the same atoms are repeated after each " +
      std::string(record) + ": it is read as " + grouped(begins.size()) + " models");
}

}  // namespace alphascope
