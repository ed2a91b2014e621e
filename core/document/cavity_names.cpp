// See the header.
#include "core/document/cavity_names.hpp"

#include <algorithm>

#include "core/molecule/atom_address.hpp"
#include "core/molecule/atom_groups.hpp"
#include "core/molecule/grouped_number.hpp"

namespace alphascope {
namespace {

std::size_t atom_of(const BallReferences& references, BallIndex ball) {
  return references.prepared().atom_of_ball.at(ball);
}

// use(atom, ball, whether another residue begins) for each of these.
template <class Use>
void for_lining(const BallReferences& references, std::span<const BallIndex> lining,
                const Use& use) {
  const std::vector<Atom>& atoms = references.molecule().atoms;
  const Atom* last = nullptr;
  for (const BallIndex ball : lining) {
    const std::size_t index = atom_of(references, ball);
    use(index, ball, !last || !same_residue(*last, atoms[index]));
    last = &atoms[index];
  }
}

}  // namespace

std::string cavity_name(const BallReferences& references, const CavityTable& table,
                        std::size_t row) {
  return sink_name(references, table.sink(row));
}

std::string sink_name(const BallReferences& references, std::span<const BallIndex> sink) {
  std::string text;
  for (const BallIndex ball : sink) {
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
  return residues_of_lining(references, table.measure(row).lining);
}

std::vector<LiningResidue> residues_of_lining(const BallReferences& references,
                                              std::span<const BallIndex> lining) {
  std::vector<LiningResidue> residues;
  for_lining(references, lining, [&](std::size_t atom, BallIndex ball, bool next) {
    if (next) residues.push_back({residue_address(references.molecule(), atom), {}});
    residues.back().balls.push_back(ball);
  });
  return residues;
}

LiningCounts lining_counts(const BallReferences& references, const CavityTable& table,
                           std::size_t row) {
  const std::vector<Atom>& atoms = references.molecule().atoms;
  std::vector<NameId> chains;
  std::size_t residues = 0;
  for_lining(references, table.measure(row).lining, [&](std::size_t atom, BallIndex, bool next) {
    residues += next;
    const NameId chain = atoms[atom].chain;
    if (!next || std::find(chains.begin(), chains.end(), chain) != chains.end()) return;
    chains.push_back(chain);
  });
  return {residues, chains.size()};
}

std::string mouths_text(std::size_t mouths) {
  if (mouths < 2) return {};
  const std::string has = "It has " + grouped(mouths) + " mouths: ";
  if (mouths < Cavity::kMouthsOfNetwork) {
    return has + "it may be a pore. The page Channels says how wide it is.";
  }
  return has +
         "it is a network of gaps that are connected, rather than one hole. A larger solvent "
         "radius parts it.";
}

}  // namespace alphascope
