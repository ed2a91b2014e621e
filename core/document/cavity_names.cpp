// See the header.
#include "core/document/cavity_names.hpp"

#include "core/molecule/atom_address.hpp"
#include "core/molecule/atom_groups.hpp"

namespace alphascope {
namespace {

std::size_t atom_of(const BallReferences& references, BallIndex ball) {
  return references.prepared().atom_of_ball.at(ball);
}

// use(atom, ball, whether another residue begins) for each atom that lines it.
template <class Use>
void for_lining(const BallReferences& references, const CavityTable& table, std::size_t row,
                const Use& use) {
  const std::vector<Atom>& atoms = references.molecule().atoms;
  const Atom* last = nullptr;
  for (const BallIndex ball : table.measure(row).lining) {
    const std::size_t index = atom_of(references, ball);
    use(index, ball, !last || !same_residue(*last, atoms[index]));
    last = &atoms[index];
  }
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
  std::vector<LiningResidue> residues;
  for_lining(references, table, row, [&](std::size_t atom, BallIndex ball, bool next) {
    if (next) residues.push_back({residue_address(references.molecule(), atom), {}});
    residues.back().balls.push_back(ball);
  });
  return residues;
}

std::size_t lining_residue_count(const BallReferences& references, const CavityTable& table,
                                 std::size_t row) {
  std::size_t count = 0;
  for_lining(references, table, row, [&](std::size_t, BallIndex, bool next) { count += next; });
  return count;
}

}  // namespace alphascope
