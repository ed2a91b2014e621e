// See the header.
#include "core/document/cavity_names.hpp"

#include "core/molecule/atom_address.hpp"

namespace alphascope {

std::string CavityNames::name(const CavityTable& table, std::size_t row) const {
  std::string text;
  for (const BallIndex ball : table.sink(row)) {
    text += (text.empty() ? "" : " ") + atom_address(*molecule_, prepared_->atom_of_ball.at(ball));
  }
  return text;
}

std::vector<LiningResidue> CavityNames::lining(const CavityTable& table, std::size_t row) const {
  std::vector<LiningResidue> residues;
  const Atom* last = nullptr;
  for (const BallIndex ball : table.measure(row).lining) {
    const std::uint32_t index = prepared_->atom_of_ball.at(ball);
    const Atom& atom = molecule_->atoms[index];
    // Atoms without any names are residues of their own.
    const bool named = atom.residue_name != 0 || atom.residue_number != 0;
    const bool same = named && last && same_residue_number(*last, atom) &&
                      last->residue_name == atom.residue_name;
    if (!same) residues.push_back({residue_address(*molecule_, index), {}, {}});
    residues.back().atoms.push_back(index);
    residues.back().balls.push_back(ball);
    last = &atom;
  }
  return residues;
}

}  // namespace alphascope
