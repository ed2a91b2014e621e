// Hydrogens depend on what they are bound to. AMBER's types, R* in Å: H on N and HS on S 0.600,
// HC on aliphatic C 1.487, H1 on C beside one electron-withdrawing group 1.387, H2 beside two
// 1.287, HP beside a charged group 1.100, HA on aromatic C 1.459, H4 and H5 on aromatic C beside
// one and two such groups 1.409 and 1.359.
#include "core/molecule/amber_radii.hpp"

#include "core/molecule/atom_type.hpp"

namespace alphascope {
namespace {

struct HydrogenRule {
  std::string_view residue;  // "*" for any
  std::string_view prefix;   // of the atom name
  int milliangstrom;
};

// The first rule that fits decides; carbon-bound hydrogens without a rule are HC.
constexpr HydrogenRule kHydrogenRules[] = {
    {"GLN", "HE2", 600},  {"ASN", "HD2", 600},  {"ARG", "HE", 600},   {"ARG", "HH", 600},
    {"LYS", "HZ", 600},   {"HIS", "HD1", 600},  {"HIS", "HE2", 600},  {"HIS", "HE1", 1359},
    {"HIS", "HD2", 1409}, {"TRP", "HE1", 600},  {"TRP", "HD1", 1409}, {"TRP", "HE3", 1459},
    {"TRP", "HZ", 1459},  {"TRP", "HH2", 1459}, {"PHE", "HD", 1459},  {"PHE", "HE", 1459},
    {"PHE", "HZ", 1459},  {"TYR", "HD", 1459},  {"TYR", "HE", 1459},  {"TYR", "HH", 600},
    {"SER", "HG", 600},   {"SER", "HB", 1387},  {"THR", "HG1", 600},  {"THR", "HB", 1387},
    {"CYS", "HG", 600},   {"CYS", "HB", 1387},  {"MET", "HG", 1387},  {"MET", "HE", 1387},
    {"LYS", "HE", 1100},  {"ARG", "HD", 1387},  {"PRO", "HD", 1387},  {"*", "HA", 1387},
    {"*", "HO", 600}};

constexpr struct {
  Element element;
  int milliangstrom;
} kElements[] = {{3, 1137},  {6, 1908},  {7, 1824},  {8, 1661},  {9, 1750},  {11, 1868},
                 {12, 793},  {15, 2100}, {16, 2000}, {17, 1948}, {19, 2658}, {20, 1713},
                 {30, 1100}, {35, 2220}, {37, 2956}, {53, 2350}, {55, 3395}};

std::string_view standard_name(std::string_view residue) {
  if (residue == "HID" || residue == "HIE" || residue == "HIP" || residue == "HSD" ||
      residue == "HSE" || residue == "HSP") {
    return "HIS";
  }
  return residue == "CYX" || residue == "CYM" ? "CYS" : residue;
}

bool is_nucleic(std::string_view residue) {
  return atom_type(residue, "C1'") == AtomType::nucleic_sugar_carbon;
}

int nucleic_hydrogen(std::string_view atom) {
  if (atom.starts_with("HO") || atom.starts_with("H5T") || atom.starts_with("H3T")) return 600;
  if (atom.starts_with("H1'") || atom.starts_with("H1*")) return 1287;
  if (atom.find('\'') != atom.npos || atom.find('*') != atom.npos) {
    return atom.starts_with("H2") ? 1487 : 1387;
  }
  if (atom == "H8" || atom == "H2") return 1359;
  if (atom == "H6") return 1409;
  if (atom == "H5") return 1459;
  return atom.starts_with("H7") || atom.starts_with("H5") ? 1487 : 600;
}

int hydrogen(std::string_view residue, std::string_view atom) {
  // "1HB2" of old files is "HB21".
  while (!atom.empty() && atom[0] >= '0' && atom[0] <= '9') atom.remove_prefix(1);
  if (is_nucleic(residue)) return nucleic_hydrogen(atom);
  residue = standard_name(residue);
  if (atom == "H" || atom == "HN" || atom == "D" ||
      (atom.size() == 2 && atom[1] >= '1' && atom[1] <= '3')) {
    return 600;
  }
  for (const HydrogenRule& rule : kHydrogenRules) {
    if ((rule.residue == "*" || rule.residue == residue) && atom.starts_with(rule.prefix)) {
      return rule.milliangstrom;
    }
  }
  return 1487;
}

}  // namespace

int amber_radius_milliangstrom(std::string_view residue, std::string_view atom, Element element) {
  if (element == kHydrogen) return hydrogen(residue, atom);
  if (element == 8) {
    if (residue == "HOH" || residue == "WAT" || residue == "SOL") return 1768;
    const bool ether = atom == "O5'" || atom == "O3'" || atom == "O4'" || atom == "O5*" ||
                       atom == "O3*" || atom == "O4*";
    if (is_nucleic(residue) && ether) return 1684;
    const bool hydroxyl = (residue == "SER" && atom == "OG") ||
                          (residue == "THR" && atom == "OG1") ||
                          (residue == "TYR" && atom == "OH") || atom == "O2'" || atom == "O2*";
    if (hydroxyl) return 1721;
  }
  for (const auto& entry : kElements) {
    if (entry.element == element) return entry.milliangstrom;
  }
  return 0;
}

}  // namespace alphascope
