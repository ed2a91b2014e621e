#include "core/molecule/atom_groups.hpp"

#include "core/molecule/atom_address.hpp"

namespace alphascope {
namespace {

constexpr std::uint32_t kNew = 0xffffffff;

}  // namespace

bool same_residue(const Atom& a, const Atom& b) {
  const bool named = a.residue_name != 0 || a.residue_number != 0;
  return named && same_residue_number(a, b) && a.residue_name == b.residue_name;
}

AtomGroups atom_groups(const Molecule& molecule, std::span<const std::uint32_t> atom_of_ball,
                       AtomGrouping by) {
  AtomGroups groups;
  groups.of_ball.reserve(atom_of_ball.size());
  std::vector<std::uint32_t> of_chain(molecule.names.size(), kNew);
  const Atom* last = nullptr;
  for (const std::uint32_t index : atom_of_ball) {
    const Atom& atom = molecule.atoms[index];
    const auto next = static_cast<std::uint32_t>(groups.first.size());
    std::uint32_t group = next;
    if (by == AtomGrouping::residue && last && same_residue(*last, atom)) group = next - 1;
    if (by == AtomGrouping::chain) {
      std::uint32_t& known = of_chain[atom.chain];
      if (known == kNew) known = next;
      group = known;
    }
    if (group == next) groups.first.push_back(index);
    groups.of_ball.push_back(group);
    last = &atom;
  }
  return groups;
}

std::string group_name(const Molecule& molecule, std::size_t atom, AtomGrouping by) {
  if (by == AtomGrouping::atom) return atom_address(molecule, atom);
  if (by == AtomGrouping::residue) return residue_address(molecule, atom);
  return std::string(molecule.text(molecule.atoms[atom].chain));
}

}  // namespace alphascope
