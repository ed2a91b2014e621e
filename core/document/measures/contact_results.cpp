// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the edges between chains.
#include "core/document/measures/contact_results.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/complex/alpha_complex.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/molecule/molecule.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

// The number of each ball's chain, in the order in which chains appear, and their names.
struct Chains {
  std::vector<std::size_t> of_ball;
  std::vector<std::string> names;
};

Chains chains_of(const BallReferences& atoms, std::size_t balls) {
  const Molecule& molecule = atoms.molecule();
  Chains chains;
  std::map<std::string_view, std::size_t> numbers;
  for (std::size_t ball = 0; ball < balls; ++ball) {
    const Atom& atom = molecule.atoms[atoms.prepared().atom_of_ball[ball]];
    const std::string_view name = molecule.text(atom.chain);
    const auto [at, added] = numbers.try_emplace(name, chains.names.size());
    if (added) chains.names.emplace_back(name);
    chains.of_ball.push_back(at->second);
  }
  return chains;
}

void sort_and_join(std::vector<BallIndex>& balls) {
  std::sort(balls.begin(), balls.end());
  balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
}

ChainContacts find_contacts(const Inputs& in, const RunContext& context) {
  const Chains chains = chains_of(*in.atoms, in.balls->size());
  std::map<std::pair<std::size_t, std::size_t>, ChainContact> found;
  for (std::size_t e = 0; e < in.complex->edges.size(); ++e) {
    if (e % 65536 == 0) context.cancel.throw_if_cancelled();
    auto [a, b] = in.complex->edges.simplices[e];
    if (chains.of_ball[a] == chains.of_ball[b]) continue;
    if (chains.of_ball[a] > chains.of_ball[b]) std::swap(a, b);
    ChainContact& pair = found[{chains.of_ball[a], chains.of_ball[b]}];
    ++pair.edges;
    pair.of_first.push_back(a);
    pair.of_second.push_back(b);
  }
  ChainContacts contacts;
  for (auto& [numbers, pair] : found) {
    pair.first = chains.names[numbers.first];
    pair.second = chains.names[numbers.second];
    sort_and_join(pair.of_first);
    sort_and_join(pair.of_second);
    contacts.pairs.push_back(std::move(pair));
  }
  std::stable_sort(contacts.pairs.begin(), contacts.pairs.end(),
                   [](const ChainContact& a, const ChainContact& b) { return a.edges > b.edges; });
  return contacts;
}

}  // namespace

const Definition<ChainContacts>& chain_contacts() {
  static const Definition<ChainContacts> definition{
      {.id = "contacts",
       .title = "Contacts between chains",
       .key =
           [](const Inputs& in) {
             const bool enough = in.atoms && in.complex && !in.complex->tetrahedra_only;
             return enough ? key_of_complex(in) : Key();
           },
       // Two balls for each edge between chains, of at most all edges.
       .memory =
           [](const Inputs& in) {
             return MemoryNeed{16 * in.complex->edges.size(), 16 * in.complex->edges.size()};
           },
       .lane = Lane::interactive},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const ChainContacts>(find_contacts(in, context));
      }};
  return definition;
}

}  // namespace alphascope
