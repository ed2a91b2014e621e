// See the header.
#include "core/document/cavity_names.hpp"

#include "core/molecule/atom_address.hpp"

namespace alphascope {
namespace {

std::size_t atom_of(const BallReferences& references, BallIndex ball) {
  return references.prepared().atom_of_ball.at(ball);
}

// Atoms without any names are residues of their own.
bool same_residue(const Atom& a, const Atom& b) {
  const bool named = a.residue_name != 0 || a.residue_number != 0;
  return named && same_residue_number(a, b) && a.residue_name == b.residue_name;
}

}  // namespace

std::string cavity_name(const BallReferences& references, const CavityTable& table,
                        std::size_t row) {
  std::string text;
  for (const BallIndex ball : table.sink(row)) {
    text +=
        (text.empty() ? "" : " ") + atom_address(references.molecule(), atom_of(references, ball));
  }
  return text;
}

SimplexRef cavity_sink(const BallReferences& references, const CavityTable& table,
                       std::size_t row) {
  return std::get<SimplexRef>(references.reference(table.sink(row)));
}

std::vector<LiningResidue> lining_residues(const BallReferences& references,
                                           const CavityTable& table, std::size_t row) {
  const Molecule& molecule = references.molecule();
  std::vector<LiningResidue> residues;
  const Atom* last = nullptr;
  for (const BallIndex ball : table.measure(row).lining) {
    const std::size_t index = atom_of(references, ball);
    const Atom& atom = molecule.atoms[index];
    if (!last || !same_residue(*last, atom)) {
      residues.push_back({residue_address(molecule, index), {}});
    }
    residues.back().balls.push_back(ball);
    last = &atom;
  }
  return residues;
}

}  // namespace alphascope
