// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of residues with their names and colours.
#include "core/molecule/residue_class.hpp"

#include <string_view>
#include <utility>

#include "core/molecule/atom_type.hpp"
#include "core/molecule/rgb8.hpp"

namespace alphascope {
namespace {

struct Info {
  const char* name;
  Rgb8 colour;
};

const Info& info(ResidueClass kind) {
  static constexpr Info kInfos[kResidueClasses] = {{"small non-polar", {230, 159, 0}},
                                                   {"hydrophobic", {0, 158, 115}},
                                                   {"polar", {204, 121, 167}},
                                                   {"negative", {213, 94, 0}},
                                                   {"positive", {0, 114, 178}},
                                                   {"nucleotide", {86, 180, 233}},
                                                   {"other residue", {148, 148, 148}},
                                                   {"ligand", {190, 170, 50}},
                                                   {"ion", {118, 92, 168}},
                                                   {"water", {150, 190, 200}},
                                                   {"dummy", {110, 116, 124}}};
  return kInfos[static_cast<std::size_t>(kind)];
}

ResidueClass amino_acid_kind(std::string_view name) {
  static constexpr std::pair<std::string_view, ResidueClass> kClasses[] = {
      {"GLY ALA SER THR", ResidueClass::small_nonpolar},
      {"CYS SEC VAL ILE LEU PRO PHE TYR MET MSE TRP", ResidueClass::hydrophobic},
      {"ASN GLN HIS", ResidueClass::polar},
      {"ASP GLU", ResidueClass::negative},
      {"LYS ARG", ResidueClass::positive}};
  for (const auto& [names, kind] : kClasses) {
    if (names.find(name) != std::string_view::npos) return kind;
  }
  return ResidueClass::other;
}

}  // namespace

ResidueClass residue_class(const Molecule& molecule, const Atom& atom) {
  switch (atom.kind) {
    case ResidueKind::water:
      return ResidueClass::water;
    case ResidueKind::ligand:
      return ResidueClass::ligand;
    case ResidueKind::ion:
      return ResidueClass::ion;
    case ResidueKind::dummy:
      return ResidueClass::dummy;
    case ResidueKind::polymer:
      break;
  }
  const std::string_view name = molecule.text(atom.residue_name);
  const std::string_view amino_acid = standard_amino_acid(name);
  if (!amino_acid.empty()) return amino_acid_kind(amino_acid);
  return nucleotide_base(name) != 0 ? ResidueClass::nucleotide : ResidueClass::other;
}

const char* residue_class_name(ResidueClass kind) {
  return info(kind).name;
}

Rgb8 residue_class_colour(ResidueClass kind) {
  return info(kind).colour;
}

}  // namespace alphascope
