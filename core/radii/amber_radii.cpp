// SPDX-License-Identifier: GPL-3.0-or-later
// AMBER's radii of atoms. The values are R*, in 10^-3 Å, of the types in parm94 (W. D. Cornell et
// al., J. Am. Chem. Soc. 117 (1995) 5179). parm99 (J. Wang, P. Cieplak, P. A. Kollman, J. Comput.
// Chem. 21 (2000) 1049) and ff14SB keep them. AMBER's residue libraries (all_amino94,
// all_aminont94, all_aminoct94, all_nucleic94) give the type of each atom.
//
// Ions are those of parm99: Li, Na, Mg, K, Ca, Rb, Cs from J. Åqvist, J. Phys. Chem. 94 (1990)
// 8021; chloride (type IM) from D. E. Smith, L. X. Dang, J. Chem. Phys. 100 (1994) 3757. parm99 has
// no other halide ions; they are guessed like any missing value.
#include "core/radii/amber_radii.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "core/geometry/alpha.hpp"
#include "core/molecule/atom_type.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"

namespace alphascope {
namespace {

enum Hydrogen : std::int16_t {
  kH = 600,  // on N; HS on S has the same value
  // On O. AMBER has 0 for it and for HW of water, which would give no ball.
  kHO = 600,
  kHC = 1487,  // on aliphatic C
  kH1 = 1387,  // on aliphatic C with one electron-withdrawing neighbour
  kH2 = 1287,  // with two such neighbours
  kHP = 1100,  // next to a charged group
  kHA = 1459,  // on aromatic C
  kH4 = 1409,  // on aromatic C with one electron-withdrawing neighbour
  kH5 = 1359,  // with two such neighbours
};
// O2 has the value of O.
enum Oxygen : std::int16_t { kO = 1661, kOS = 1684, kOH = 1721, kOW = 1768 };

struct HydrogenRule {
  std::string_view residue, prefix;  // `residue` "*": any; `prefix`: of the atom's name
  Hydrogen type;
};

// Rules for hydrogens of side chains and of both ends. The first rule that fits decides. A hydrogen
// on a side-chain carbon without a rule is HC.
constexpr HydrogenRule kHydrogenRules[] = {
    {"ARG", "HD", kH1},  {"ARG", "HE", kH},   {"ARG", "HH", kH},   {"ASN", "HD2", kH},
    {"ASP", "HD", kHO},  {"CYS", "HB", kH1},  {"CYS", "HG", kH},   {"GLN", "HE2", kH},
    {"GLU", "HE", kHO},  {"HIS", "HD1", kH},  {"HIS", "HD2", kH4}, {"HIS", "HE1", kH5},
    {"HIS", "HE2", kH},  {"HYP", "HD1", kHO}, {"HYP", "HD2", kH1}, {"HYP", "HG", kH1},
    {"LYS", "HE", kHP},  {"LYS", "HZ", kH},   {"MET", "HE", kH1},  {"MET", "HG", kH1},
    {"PHE", "HD", kHA},  {"PHE", "HE", kHA},  {"PHE", "HZ", kHA},  {"PRO", "HD", kH1},
    {"SER", "HB", kH1},  {"SER", "HG", kHO},  {"THR", "HB", kH1},  {"THR", "HG1", kHO},
    {"TRP", "HD1", kH4}, {"TRP", "HE1", kH},  {"TRP", "HE3", kHA}, {"TRP", "HH2", kHA},
    {"TRP", "HZ", kHA},  {"TYR", "HD", kHA},  {"TYR", "HE", kHA},  {"TYR", "HH", kHO},
    {"*", "HA", kH1},    {"*", "HXT", kHO},   {"*", "HO", kHO}};

// Rules for hydrogens of bases; the atom's whole name must fit.
constexpr HydrogenRule kBaseRules[] = {
    {"A", "H2", kH5},   {"A", "H8", kH5},   {"A", "H61", kH},  {"A", "H62", kH},
    {"C", "H5", kHA},   {"C", "H6", kH4},   {"C", "H41", kH},  {"C", "H42", kH},
    {"G", "H1", kH},    {"G", "H8", kH5},   {"G", "H21", kH},  {"G", "H22", kH},
    {"I", "H1", kH},    {"I", "H2", kH5},   {"I", "H8", kH5},  {"T", "H3", kH},
    {"T", "H6", kH4},   {"T", "H71", kHC},  {"T", "H72", kHC}, {"T", "H73", kHC},
    {"T", "H51", kHC},  {"T", "H52", kHC},  {"T", "H53", kHC}, {"T", "H5M1", kHC},
    {"T", "H5M2", kHC}, {"T", "H5M3", kHC}, {"U", "H3", kH},   {"U", "H5", kHA},
    {"U", "H6", kH4}};

constexpr struct {
  Element element;
  int milliangstrom;
} kElements[] = {{3, 1137},  {6, 1908},  {7, 1824},  {9, 1750},  {11, 1868}, {12, 793},
                 {15, 2100}, {16, 2000}, {17, 1948}, {19, 2658}, {20, 1713}, {30, 1100},
                 {35, 2220}, {37, 2956}, {53, 2350}, {55, 3395}};
constexpr int kChlorideIon = 2470;

// An atom's name in one spelling: digit at the end, primes instead of stars, H instead of D. So
// "1H5*" becomes "H5'1".
class Canonical {
 public:
  explicit Canonical(std::string_view name) {
    std::size_t digits = 0;
    while (digits < name.size() && name[digits] >= '0' && name[digits] <= '9') ++digits;
    text_ = std::string(name.substr(digits)) + std::string(name.substr(0, digits));
    std::replace(text_.begin(), text_.end(), '*', '\'');
    if (text_.starts_with('D')) text_[0] = 'H';
  }
  operator std::string_view() const { return text_; }

 private:
  std::string text_;
};

template <std::size_t N>
bool one_of(const std::string_view (&list)[N], std::string_view name) {
  return std::find(std::begin(list), std::end(list), name) != std::end(list);
}

// The standard name of an amino acid. "SEC" and "MSE" have the types of the residues that they
// replace.
std::string_view amino_acid(std::string_view residue) {
  if (residue == "HYP") return residue;
  const std::string_view name = standard_amino_acid(residue);
  return name == "MSE" ? "MET" : name == "SEC" ? "CYS" : name;
}

constexpr std::string_view kOnNitrogen[] = {"H",   "HN",  "H1",  "H2",  "H3",  "HT1",
                                            "HT2", "HT3", "HN1", "HN2", "HN3", "HNT"};

constexpr std::string_view kBackbone[] = {"N", "CA", "C", "O"};

bool is_terminal_name(std::string_view residue, char end) {
  return residue.size() == 4 && residue[0] == end && !standard_amino_acid(residue).empty();
}

constexpr AmberRadius kUntypedHydrogen{kHC, false};

AmberRadius typed(int milliangstrom) {
  return {milliangstrom, true};
}

AmberRadius cap_hydrogen(std::string_view residue, std::string_view atom) {
  if (residue == "NH2" || residue == "NHE") return typed(kH);
  const bool lone = atom == "H";
  if (residue == "ACE") return lone ? kUntypedHydrogen : typed(kHC);
  return typed(lone || atom.starts_with("HN") ? kH : kH1);
}

AmberRadius amino_acid_hydrogen(std::string_view residue, std::string_view atom, AmberForm form) {
  if ((form & kAmberMethylamide) && atom.starts_with("HT")) return typed(kH1);
  if (one_of(kOnNitrogen, atom)) return typed(kH);
  const bool beside_nitrogen =
      atom.starts_with("HA") || (residue == "PRO" && atom.starts_with("HD"));
  if ((form & kAmberNTerminus) && beside_nitrogen) return typed(kHP);
  for (const HydrogenRule& rule : kHydrogenRules) {
    if ((rule.residue == "*" || rule.residue == residue) && atom.starts_with(rule.prefix)) {
      return typed(rule.type);
    }
  }
  // The letter tells the position along the side chain; Y is CHARMM's acetyl.
  const bool known = atom.size() > 1 && std::string_view("BGDEZHY").find(atom[1]) != atom.npos;
  return known ? typed(kHC) : kUntypedHydrogen;
}

AmberRadius nucleotide_hydrogen(char base, std::string_view atom, AmberForm form) {
  if (atom.starts_with("HO") || atom == "H5T" || atom == "H3T") return typed(kHO);
  if (atom == "H2'" && (form & kAmberCharmmRibose)) return typed(kHO);
  if (atom.size() > 2 && atom[2] == '\'') {
    switch (atom[1]) {
      case '1':
        return typed(kH2);
      case '2':
        return typed((form & kAmberRibose) ? kH1 : kHC);
      case '3':
      case '4':
      case '5':
        return typed(kH1);
      default:
        return kUntypedHydrogen;
    }
  }
  for (const HydrogenRule& rule : kBaseRules) {
    if (rule.residue[0] == base && rule.prefix == atom) return typed(rule.type);
  }
  return kUntypedHydrogen;
}

bool is_cap(std::string_view residue) {
  constexpr std::string_view kCaps[] = {"ACE", "NME", "NMA", "NH2", "NHE"};
  return one_of(kCaps, residue);
}

AmberRadius hydrogen(std::string_view residue, std::string_view atom, AmberForm form) {
  const Canonical name(atom);
  if (is_cap(residue)) return cap_hydrogen(residue, name);
  if (const std::string_view known = amino_acid(residue); !known.empty()) {
    if (is_terminal_name(residue, 'N')) form |= kAmberNTerminus;
    return amino_acid_hydrogen(known, name, form);
  }
  if (const char base = nucleotide_base(residue)) return nucleotide_hydrogen(base, name, form);
  // A modified residue: the atoms of its side chain have no types, but those that all amino acids
  // have do.
  const std::string_view n = name;
  const bool alpha = n.starts_with("HA") && n.size() <= 3;
  if ((form & kAmberPeptide) && (n == "H" || n == "HN" || alpha)) return typed(alpha ? kH1 : kH);
  return kUntypedHydrogen;
}

int amino_acid_oxygen(std::string_view residue, std::string_view atom, AmberForm form) {
  if (residue == "ASH" || residue == "GLH" || residue == "ASPP" || residue == "GLUP") {
    form |= kAmberHydroxylD2;
  }
  residue = amino_acid(residue);
  const bool first = atom == "OD1" || atom == "OE1", second = atom == "OD2" || atom == "OE2";
  const bool hydroxyl = (residue == "SER" && atom == "OG") || (residue == "THR" && atom == "OG1") ||
                        (residue == "TYR" && atom == "OH") || (residue == "HYP" && first) ||
                        ((form & kAmberHydroxylOxt) && atom == "OXT") ||
                        ((form & kAmberHydroxylD1) && first) ||
                        ((form & kAmberHydroxylD2) && second);
  return hydroxyl ? kOH : kO;
}

int nucleotide_oxygen(std::string_view residue, std::string_view atom, AmberForm form) {
  if (residue.size() > 1 && residue.back() == '5') form |= kAmberHydroxylO5;
  if (residue.size() > 1 && residue.back() == '3') form |= kAmberHydroxylO3;
  if (atom == "O2'" || atom == "O5T" || atom == "O3T") return kOH;
  if (atom == "O4'") return kOS;
  if (atom == "O5'") return (form & kAmberHydroxylO5) ? kOH : kOS;
  if (atom == "O3'") return (form & kAmberHydroxylO3) ? kOH : kOS;
  return kO;
}

AmberRadius oxygen(std::string_view residue, std::string_view atom, AmberForm form) {
  if (!amino_acid(residue).empty()) return typed(amino_acid_oxygen(residue, atom, form));
  if (nucleotide_base(residue)) return typed(nucleotide_oxygen(residue, Canonical(atom), form));
  const bool peptide = (form & kAmberPeptide) && (atom == "O" || atom == "OXT");
  return {kO, is_cap(residue) || peptide};
}

}  // namespace

AmberFormFinder::AmberFormFinder(std::string_view residue)
    : amino_acid_(amino_acid(residue)), base_(nucleotide_base(residue)) {}

void AmberFormFinder::add(std::string_view atom) {
  if (amino_acid_.empty() && base_ == 0) {
    for (std::size_t k = 0; k < std::size(kBackbone); ++k) {
      if (atom == kBackbone[k]) in_backbone_ |= 1u << k;
    }
    return;
  }
  const Canonical name(atom);
  const std::string_view n = name;
  if (base_ != 0) {
    if (n == "O2'") found_ |= kAmberRibose;
    if (n == "HO5'" || n == "H5T" || n == "HO'5") found_ |= kAmberHydroxylO5;
    if (n == "HO3'" || n == "H3T" || n == "HO'3") found_ |= kAmberHydroxylO3;
    second_on_c2_ |= n == "H2''";
    on_o2_ |= n == "HO2'" || n == "HO'2" || n == "HO2";
    return;
  }
  for (std::size_t k = 0; k < std::size(kOnNitrogen); ++k) {
    if (n == kOnNitrogen[k]) on_nitrogen_ |= 1u << k;
  }
  if (n == "CAT") found_ |= kAmberMethylamide;
  if (n == "HXT") found_ |= kAmberHydroxylOxt;
  if (amino_acid_ != "ASP" && amino_acid_ != "GLU") return;
  const char group = amino_acid_ == "ASP" ? 'D' : 'E';
  if (n.size() != 3 || n[0] != 'H' || n[1] != group) return;
  if (n[2] == '1') found_ |= kAmberHydroxylD1;
  if (n[2] == '2') found_ |= kAmberHydroxylD2;
}

AmberForm AmberFormFinder::form() const {
  AmberForm form = found_;
  if (std::popcount(in_backbone_) == std::size(kBackbone)) form |= kAmberPeptide;
  if ((form & kAmberRibose) && second_on_c2_ && !on_o2_) form |= kAmberCharmmRibose;
  const bool imino = amino_acid_ == "PRO" || amino_acid_ == "HYP";
  if (std::popcount(on_nitrogen_) >= (imino ? 2 : 3) && !(form & kAmberMethylamide))
    form |= kAmberNTerminus;
  return form;
}

AmberRadius amber_radius(std::string_view residue, std::string_view atom, AmberForm form,
                         Element element, ResidueKind kind) {
  if (kind == ResidueKind::water && element == kHydrogen) return typed(kHO);
  if (kind == ResidueKind::water && element == 8) return typed(kOW);
  if (kind == ResidueKind::ligand) {  // AMBER has no residue of this kind, whatever the name
    residue = {};
    form = 0;
  }
  if (element == kHydrogen) return hydrogen(residue, atom, form);
  if (element == 8) return oxygen(residue, atom, form);
  if (kind == ResidueKind::ion) {
    if (element == 17) return typed(kChlorideIon);
    if (element == 9 || element == 35 || element == 53) return {};
  }
  for (const auto& entry : kElements) {
    if (entry.element == element) return typed(entry.milliangstrom);
  }
  return {};
}

}  // namespace alphascope
