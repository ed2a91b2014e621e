// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the radii sets, and the look-up of an atom's radius.
#include "core/radii/radii_set.hpp"

#include <algorithm>

#include "core/molecule/atom_type.hpp"
#include "core/molecule/element_table.hpp"
#include "core/molecule/molecule.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/radii/fallback_radii.hpp"
#include "core/text/letter_case.hpp"

namespace alphascope {
namespace {

constexpr ElementEntry kAlvarezEntries[] = {
    {1, 1200},  {2, 1430},  {3, 2120},  {4, 1980},  {5, 1910},  {6, 1770},  {7, 1660},  {8, 1500},
    {9, 1460},  {10, 1580}, {11, 2500}, {12, 2510}, {13, 2250}, {14, 2190}, {15, 1900}, {16, 1890},
    {17, 1820}, {18, 1830}, {19, 2730}, {20, 2620}, {21, 2580}, {22, 2460}, {23, 2420}, {24, 2450},
    {25, 2450}, {26, 2440}, {27, 2400}, {28, 2400}, {29, 2380}, {30, 2390}, {31, 2320}, {32, 2290},
    {33, 1880}, {34, 1820}, {35, 1860}, {36, 2250}, {37, 3210}, {38, 2840}, {39, 2750}, {40, 2520},
    {41, 2560}, {42, 2450}, {43, 2440}, {44, 2460}, {45, 2440}, {46, 2150}, {47, 2530}, {48, 2490},
    {49, 2430}, {50, 2420}, {51, 2470}, {52, 1990}, {53, 2040}, {54, 2060}, {55, 3480}, {56, 3030},
    {57, 2980}, {58, 2880}, {59, 2920}, {60, 2950}, {62, 2900}, {63, 2870}, {64, 2830}, {65, 2790},
    {66, 2870}, {67, 2810}, {68, 2830}, {69, 2790}, {70, 2800}, {71, 2740}, {72, 2630}, {73, 2530},
    {74, 2570}, {75, 2490}, {76, 2480}, {77, 2410}, {78, 2290}, {79, 2320}, {80, 2450}, {81, 2470},
    {82, 2600}, {83, 2540}, {89, 2800}, {90, 2930}, {91, 2880}, {92, 2710}, {93, 2820}, {94, 2810},
    {95, 2830}, {96, 3050}, {97, 3400}, {98, 3050}, {99, 2700}};
constexpr ElementTable kAlvarez = make_element_table(kAlvarezEntries);

// RasMol's table is in units of 1/250 Å: 387, 350, 337, 452.
constexpr ElementEntry kRasmolEntries[] = {{1, 1100}, {6, 1548},  {7, 1400},
                                           {8, 1348}, {15, 1880}, {16, 1808}};
constexpr ElementTable kRasmol = make_element_table(kRasmolEntries);

constexpr RadiiSetInfo kSets[] = {
    {RadiiSet::automatic, "auto", "automatic", "", false},
    {RadiiSet::file, "file", "from the file", "the radii written in the file itself", false},
    {RadiiSet::bondi, "bondi", "Bondi",
     "A. Bondi, van der Waals volumes and radii, J. Phys. Chem. 68 (1964) 441-451", false},
    {RadiiSet::protor, "protor", "ProtOr",
     "J. Tsai, R. Taylor, C. Chothia, M. Gerstein, The packing density in proteins, J. Mol. Biol. "
     "290 (1999) 253-266; nucleic acids as in FreeSASA",
     true},
    {RadiiSet::castp, "castp", "CASTp",
     "ProtOr, with 1.40 Å for the oxygens of carboxyl groups: the radii behind the output of CASTp "
     "(W. Tian et al., CASTp 3.0, Nucleic Acids Res. 46 (2018) W363-W367) for 1HIV",
     true},
    {RadiiSet::alvarez, "alvarez", "Alvarez",
     "S. Alvarez, A cartography of the van der Waals territories, Dalton Trans. 42 (2013) "
     "8617-8636",
     false},
    {RadiiSet::amber, "amber", "AMBER",
     "W. D. Cornell et al., J. Am. Chem. Soc. 117 (1995) 5179-5197, and parm99: J. Wang, P. "
     "Cieplak, "
     "P. A. Kollman, J. Comput. Chem. 21 (2000) 1049-1074; R* to 0.001 Å; hydrogens of hydroxyls "
     "and waters, 0 in AMBER, as 0.6 Å",
     false},
    {RadiiSet::naccess, "naccess", "NACCESS",
     "C. Chothia, The nature of the accessible and buried surfaces in proteins, J. Mol. Biol. 105 "
     "(1976) 1-12, as used by NACCESS (S. Hubbard, J. Thornton, 1993)",
     true},
    {RadiiSet::rasmol, "rasmol", "RasMol",
     "R. Sayle, E. J. Milner-White, RasMol, Trends Biochem. Sci. 20 (1995) 374-376", false},
    {RadiiSet::user, "user", "user table", "a table of the user", false},
};

// 10^-3 Å; 0: the set does not have this type.
int protor(AtomType type) {
  switch (type) {
    case AtomType::aliphatic_carbon:
    case AtomType::nucleic_sugar_carbon:
    case AtomType::nucleic_methyl_carbon:
      return 1880;
    case AtomType::trigonal_carbon:
    case AtomType::nucleic_base_carbon:
      return 1610;
    case AtomType::aromatic_ch_carbon:
    case AtomType::nucleic_base_ch_carbon:
      return 1760;
    case AtomType::amide_nitrogen:
    case AtomType::amine_nitrogen:
    case AtomType::nucleic_nitrogen:
      return 1640;
    case AtomType::carbonyl_oxygen:
      return 1420;
    case AtomType::hydroxyl_oxygen:
      return 1460;
    case AtomType::sulphur:
      return 1770;
    case AtomType::selenium:
      return 1900;
    case AtomType::phosphorus:
      return 1800;
    case AtomType::none:
      break;
  }
  return 0;
}

int naccess(AtomType type) {
  switch (type) {
    case AtomType::aliphatic_carbon:
      return 1870;
    case AtomType::trigonal_carbon:
    case AtomType::aromatic_ch_carbon:
      return 1760;
    case AtomType::nucleic_sugar_carbon:
    case AtomType::nucleic_base_carbon:
    case AtomType::nucleic_base_ch_carbon:
    case AtomType::nucleic_methyl_carbon:
      return 1800;
    case AtomType::amide_nitrogen:
      return 1650;
    case AtomType::amine_nitrogen:
      return 1500;
    case AtomType::nucleic_nitrogen:
      return 1600;
    case AtomType::carbonyl_oxygen:
    case AtomType::hydroxyl_oxygen:
      return 1400;
    case AtomType::sulphur:
      return 1850;
    case AtomType::selenium:
      return 1800;
    case AtomType::phosphorus:
      return 1900;
    case AtomType::none:
      break;
  }
  return 0;
}

// The set's typical value for an element, for atoms without a type in the set, such as those of
// ligands. 10^-3 Å; 0: none.
int typical(RadiiSet set, Element element) {
  const bool naccess_set = set == RadiiSet::naccess;
  switch (element) {
    case 6:
      return naccess_set ? naccess(AtomType::trigonal_carbon)
                         : protor(AtomType::aromatic_ch_carbon);
    case 7:
      return naccess_set ? naccess(AtomType::amide_nitrogen) : protor(AtomType::amide_nitrogen);
    case 8:
      return naccess_set ? naccess(AtomType::hydroxyl_oxygen) : protor(AtomType::hydroxyl_oxygen);
    case 15:
      return naccess_set ? naccess(AtomType::phosphorus) : protor(AtomType::phosphorus);
    case 16:
      return naccess_set ? naccess(AtomType::sulphur) : protor(AtomType::sulphur);
    case 34:
      return naccess_set ? naccess(AtomType::selenium) : protor(AtomType::selenium);
    default:
      return 0;
  }
}

AssignedRadius of_set(int milliangstrom) {
  return {milliangstrom * 1000, false, {}};
}

AssignedRadius by_element(const ElementTable& table, RadiiSet set, const Atom& atom) {
  const bool known = atom.element <= kHeaviestElement && table[atom.element] > 0;
  return known ? of_set(table[atom.element]) : fallback_radius(set, atom.element, atom.kind);
}

// CASTp's value, 10^-3 Å; its other radii are ProtOr's.
constexpr int kCarboxylateOxygen = 1400;

AssignedRadius by_type(RadiiSet set, AtomType type, const Atom& atom) {
  const int typed = set == RadiiSet::naccess ? naccess(type) : protor(type);
  if (typed > 0) return of_set(typed);
  const int middle = typical(set, atom.element);
  if (middle > 0) return {middle * 1000, true, kTypicalValueSource};
  return fallback_radius(set, atom.element, atom.kind);
}

AssignedRadius by_user(const UserRadii& table, std::string_view residue, std::string_view name,
                       const Atom& atom) {
  for (const std::string_view where : {residue, std::string_view("*")}) {
    const auto found = table.by_atom.find(std::string(where) + ' ' + std::string(name));
    if (found != table.by_atom.end()) return {found->second, false, {}};
  }
  const auto found = table.by_element.find(atom.element);
  if (found != table.by_element.end()) return {found->second, false, {}};
  return fallback_radius(RadiiSet::user, atom.element, atom.kind);
}

}  // namespace

std::span<const RadiiSetInfo> all_radii_sets() {
  return kSets;
}

const RadiiSetInfo& radii_set_info(RadiiSet set) {
  return kSets[static_cast<std::size_t>(set)];
}

bool find_radii_set(std::string_view id, RadiiSet& set) {
  const auto same = [id = lower_case(id)](const RadiiSetInfo& info) { return info.id == id; };
  const auto* found = std::find_if(std::begin(kSets), std::end(kSets), same);
  if (found == std::end(kSets)) return false;
  set = found->set;
  return true;
}

RadiiLookup::RadiiLookup(const Molecule& molecule, RadiiSet set,
                         std::shared_ptr<const UserRadii> user)
    : molecule_(molecule), set_(set), user_(std::move(user)) {}

std::size_t RadiiLookup::Hash::operator()(const Key& key) const {
  const std::uint64_t names = (std::uint64_t{key.residue} << 32) ^ key.name;
  const std::uint64_t rest = (std::uint64_t{key.form} << 16) ^ (std::uint64_t{key.element} << 8) ^
                             static_cast<std::uint64_t>(key.kind);
  return (names * 0x9E3779B97F4A7C15u) ^ (rest * 0xC2B2AE3D27D4EB4Fu);
}

AssignedRadius RadiiLookup::radius(std::size_t index) {
  const Atom& atom = molecule_.atoms[index];
  const AmberForm form = set_ == RadiiSet::amber ? form_around(index) : AmberForm{0};
  const auto [entry, inserted] =
      known_.try_emplace({atom.residue_name, atom.name, atom.element, atom.kind, form});
  if (inserted) entry->second = find(atom, form);
  return entry->second;
}

// The form of the atom's residue. The atoms of a residue are consecutive in the file.
AmberForm RadiiLookup::form_around(std::size_t index) {
  if (index >= residue_begin_ && index < residue_end_) return residue_form_;
  const std::vector<Atom>& atoms = molecule_.atoms;
  const auto same = [&](const Atom& a) {
    return same_residue_number(a, atoms[index]) && a.residue_name == atoms[index].residue_name;
  };
  residue_begin_ = index;
  residue_end_ = index + 1;
  while (residue_begin_ > 0 && same(atoms[residue_begin_ - 1])) --residue_begin_;
  while (residue_end_ < atoms.size() && same(atoms[residue_end_])) ++residue_end_;
  AmberFormFinder finder(molecule_.text(atoms[index].residue_name));
  for (std::size_t i = residue_begin_; i < residue_end_; ++i) {
    finder.add(molecule_.text(atoms[i].name));
  }
  residue_form_ = finder.form();
  return residue_form_;
}

AssignedRadius RadiiLookup::find(const Atom& atom, AmberForm form) const {
  const std::string_view residue = molecule_.text(atom.residue_name);
  const std::string_view name = molecule_.text(atom.name);
  switch (set_) {
    case RadiiSet::alvarez:
      return by_element(kAlvarez, set_, atom);
    case RadiiSet::rasmol:
      return by_element(kRasmol, set_, atom);
    case RadiiSet::user:
      return by_user(*user_, residue, name, atom);
    case RadiiSet::protor:
    case RadiiSet::castp:
    case RadiiSet::naccess: {
      const bool typed = atom.element != kHydrogen && atom.kind != ResidueKind::ligand;
      if (set_ == RadiiSet::castp && typed && is_carboxylate_oxygen(residue, name)) {
        return of_set(kCarboxylateOxygen);
      }
      return by_type(set_, typed ? atom_type(residue, name) : AtomType::none, atom);
    }
    case RadiiSet::amber: {
      const AmberRadius amber = amber_radius(residue, name, form, atom.element, atom.kind);
      if (amber.milliangstrom == 0) return fallback_radius(set_, atom.element, atom.kind);
      if (amber.typed) return of_set(amber.milliangstrom);
      return {amber.milliangstrom * 1000, true, kTypicalValueSource};
    }
    default: {
      const int radius = bondi_milliangstrom(atom.element);
      return radius > 0 ? of_set(radius) : fallback_radius(set_, atom.element, atom.kind);
    }
  }
}

}  // namespace alphascope
