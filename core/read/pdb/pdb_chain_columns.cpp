// SPDX-License-Identifier: GPL-3.0-or-later
// Decides from all lines of a PDB file whether column 21 belongs to residue names or to chains.
#include "core/read/pdb/pdb_chain_columns.hpp"

#include <algorithm>
#include <iterator>

#include "core/read/pdb/pdb_records.hpp"
#include "core/read/residues/atom_names.hpp"
#include "core/text_files/line_reader.hpp"

namespace alphascope {
namespace {

// Names of four letters that begin with a standard residue's name. CHARMM and GROMOS use them for
// protonation states and chain ends.
constexpr std::string_view kVariants[] = {"ASPP", "GLUP", "HISA", "HISB", "HISH", "HIS1", "HIS2",
                                          "LYSH", "LYSN", "ARGN", "ASPH", "GLUH", "CYSH", "CYS1",
                                          "CYS2", "CYSD", "TYRO", "HISD", "HISE", "HISP", "CYSX"};

bool is_standard(std::string_view residue) {
  const ResidueFamily family = residue_family(residue);
  return family != ResidueFamily::unknown && family != ResidueFamily::ligand;
}

// True for names of four letters that are known as a whole: TIP3, SWM4.
bool is_known_whole(std::string_view name) {
  constexpr std::string_view kNames[] = {"SWM4", "SWM6", "TIP3", "TIP4", "TIP5",
                                         "POPC", "POPE", "DPPC", "CHL1"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames) ||
         residue_family(name) != ResidueFamily::unknown;
}

bool is_variant(std::string_view name) {
  return std::find(std::begin(kVariants), std::end(kVariants), name) != std::end(kVariants);
}

}  // namespace

void PdbChainColumns::look_at_file() {
  looked_ = true;
  LineReader lines(text_);
  std::string_view line;
  std::string last;  // columns 18-22; neighbouring lines have the same
  while (lines.next(line)) {
    const PdbLineKind kind = kind_of_pdb_line(line);
    if (kind.what != PdbLine::atom && kind.what != PdbLine::nearly_atom) continue;
    line.remove_prefix(kind.skip);
    const std::string_view both = columns(line, 18, 22);
    if (both.size() < 5 || is_blank(both[3]) || both == last) continue;
    last = both;
    const std::string_view name = trimmed(both.substr(0, 4));
    if (is_blank(both[4])) {
      four_letters_ = true;
      continue;
    }
    const std::string_view three = trimmed(both.substr(0, 3));
    if (is_known_whole(name) && name.size() == 4) {
      four_letters_ = true;
    } else if (is_standard(three)) {
      chains_[std::string(both.substr(3, 2))].insert(std::string(name));
    }
  }
  // A chain whose only name is a variant such as "ASPP" means chain A, not an aspartate of chain
  // PA.
  std::erase_if(chains_, [&](const auto& chain) {
    const bool variant = chain.second.size() == 1 && is_variant(*chain.second.begin());
    four_letters_ = four_letters_ || variant;
    return variant;
  });
}

std::string_view PdbChainColumns::chain_of(std::string_view line) {
  const std::string_view both = columns(line, 21, 22);
  const bool two = both.size() == 2 && !is_blank(both[0]) && !is_blank(both[1]) && is_chain(line);
  return two ? both : trimmed(columns(line, 22, 22));
}

bool PdbChainColumns::is_chain(std::string_view line) {
  if (!looked_) look_at_file();
  const std::string_view name = trimmed(columns(line, 18, 21));
  if (name.size() == 4 && is_known_whole(name)) return false;
  if (chains_.find(columns(line, 21, 22)) != chains_.end()) return true;
  return !chains_.empty() && !four_letters_ && !is_variant(name);
}

}  // namespace alphascope
