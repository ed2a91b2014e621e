#include "core/io/atom_names.hpp"

#include <algorithm>
#include <gemmi/resinfo.hpp>  // for find_tabulated_residue

namespace alphascope {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Names of simulation packages that the PDB's own dictionary does not have.
constexpr std::string_view kWaters[] = {"WAT", "SOL",   "TIP", "TIP2", "TIP3", "TIP4",
                                        "TP3", "TIP3P", "SPC", "SPCE", "H2O",  "OH2"};
constexpr std::string_view kIons[] = {"SOD", "CLA", "POT", "CAL", "CES", "LIT", "RUB", "BAR",
                                      "CIO", "NA+", "CL-", "K+",  "MG+", "IOD", "CAD", "3CO",
                                      "3NI", "FE2", "CU1", "MN3", "ZN2", "NIO", "AU3", "4TI"};

constexpr std::string_view kBiopolymers[] = {"HID", "HIE", "HIP", "HSD", "HSE", "HSP", "CYX", "CYM",
                                             "ASH", "GLH", "LYN", "ARN", "ACE", "NME", "NMA", "ADE",
                                             "GUA", "CYT", "THY", "URA", "DA5", "DA3", "DC5", "DC3",
                                             "DG5", "DG3", "DT5", "DT3", "RA",  "RC",  "RG",  "RU",
                                             "A5",  "A3",  "C5",  "C3",  "G5",  "G3",  "U5",  "U3"};

template <std::size_t N>
bool contains(const std::string_view (&list)[N], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

bool is_ion_symbol(std::string_view name) {
  const Element z = element_from_symbol(name);
  const bool halide = z == 9 || z == 17 || z == 35 || z == 53;
  return is_metal(z) || halide;
}

}  // namespace

ResidueFamily residue_family(std::string_view name) {
  if (name == "DUM") return ResidueFamily::dummy;
  const gemmi::ResidueInfo& info = gemmi::find_tabulated_residue(std::string(name));
  if (info.is_water() || contains(kWaters, name)) return ResidueFamily::water;
  if (info.is_amino_acid() || info.is_nucleic_acid() || contains(kBiopolymers, name)) {
    return ResidueFamily::biopolymer;
  }
  if (contains(kIons, name) || is_ion_symbol(name)) return ResidueFamily::ion;
  return info.found() ? ResidueFamily::ligand : ResidueFamily::unknown;
}

ResidueFamily ResidueFamilies::of(NameId residue_name, const NameTable& names) {
  if (residue_name >= families_.size()) families_.resize(names.size());
  std::optional<ResidueFamily>& family = families_[residue_name];
  if (!family) family = residue_family(names.text(residue_name));
  return *family;
}

AtomKind atom_kind(ResidueFamily family, bool hetero) {
  switch (family) {
    case ResidueFamily::water:
      return AtomKind::water;
    case ResidueFamily::ion:
      return AtomKind::ion;
    case ResidueFamily::dummy:
      return AtomKind::dummy;
    case ResidueFamily::biopolymer:
      return AtomKind::polymer;
    case ResidueFamily::ligand:
      return AtomKind::ligand;
    case ResidueFamily::unknown:
      break;
  }
  return hetero ? AtomKind::ligand : AtomKind::polymer;
}

bool has_position_letter(std::string_view name) {
  constexpr std::string_view kFirst = "CHNOPS", kPosition = "ABGDEZHX";
  return name.size() > 1 && kFirst.find(name[0]) != std::string_view::npos &&
         kPosition.find(name[1]) != std::string_view::npos;
}

Element element_from_atom_name(std::string_view name, bool biopolymer) {
  while (!name.empty() && (is_digit(name.front()) || name.front() == '\'' || name.front() == '"')) {
    name.remove_prefix(1);
  }
  if (name.empty()) return kUnknownElement;
  std::size_t letters = 1;
  if (name.size() > 1 && !is_digit(name[1])) letters = 2;
  const Element two = letters == 2 ? element_from_symbol(name.substr(0, 2)) : kUnknownElement;
  const Element one = element_from_symbol(name.substr(0, 1));
  // Selenium is the one two-letter element of ordinary residues (MSE, SEC).
  if (biopolymer && one != kUnknownElement && name.substr(0, 2) != "SE") return one;
  return two != kUnknownElement ? two : one;
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string result(text.substr(0, kLongest));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = c == '\t' ? ' ' : '?';
  }
  if (text.size() > kLongest) {
    // Do not cut a UTF-8 character in half.
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80) {
      result.pop_back();
    }
    if (!result.empty() && static_cast<unsigned char>(result.back()) >= 0xC0) result.pop_back();
    result += "…";
  }
  return result;
}

}  // namespace alphascope
