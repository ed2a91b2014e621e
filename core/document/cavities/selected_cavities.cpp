// SPDX-License-Identifier: GPL-3.0-or-later
// Collects shapes, lining and contents of the selected cavities.
#include "core/document/cavities/selected_cavities.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_identity.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/cavity_shape/cavity_shape.hpp"
#include "core/cavity_shape/filling_spheres.hpp"
#include "core/clearance/clearance.hpp"
#include "core/document/cavities/cavity_contents.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/drawn_parts.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

// Clearance of the balls without solvent radius. Only spheres need it, so it is made when first
// asked for.
using ClearanceOf = std::function<const Clearance&()>;

SelectedCavity draw(const CavityTable& table, std::size_t row, const DrawnCavityParts& parts,
                    const ClearanceOf& clearance) {
  SelectedCavity drawn;
  const CavityGround& ground = *table.ground;
  const Cavity& cavity = table.cavity(row);
  drawn.row = row;
  if (parts.surfaces) drawn.surface = cavity_surface(ground, table.found, table.order[row]);
  if (parts.rims) drawn.rims = mouth_rims(ground, cavity);
  if (parts.numbers) drawn.place_angstrom = deepest_place_angstrom(ground, cavity);
  if (parts.spheres) drawn.spheres = filling_spheres(ground, cavity, clearance());
  if (!parts.tetrahedra) return drawn;
  for (const std::uint32_t t : cavity.tetrahedra) {
    drawn.tetrahedra.push_back(ground.triangulation->tetrahedra[t]);
  }
  return drawn;
}

// Lists residues by chain; residues of one chain must follow each other, as in the file.
void list_residues(const BallReferences& atoms, const std::vector<BallIndex>& lining,
                   std::vector<ChainLining>& chains) {
  const Molecule& molecule = atoms.molecule();
  for (const LiningResidue& residue : residues_of_lining(atoms, lining)) {
    const std::size_t atom = atoms.prepared().atom_of_ball.at(residue.balls.front());
    const std::string_view chain = molecule.text(molecule.atoms[atom].chain);
    if (chains.empty() || chains.back().chain != chain) {
      chains.push_back({std::string(chain), {}, 0});
    }
    std::string& text = chains.back().residues;
    text += (text.empty() ? "" : ", ") + residue_within_chain(molecule, atom);
    ++chains.back().count;
  }
}

void add_held(const BallReferences& atoms, const CavityContents& contents, std::uint32_t cavity,
              std::vector<ContainedAtom>& held) {
  const std::vector<LeftOutAtom>& out = atoms.prepared().left_out;
  for (const std::uint32_t n : contents.of[cavity]) {
    const ContainedResidue& residue = contents.residues[n];
    auto at =
        std::lower_bound(out.begin(), out.end(), residue.atom,
                         [](const LeftOutAtom& a, std::uint32_t atom) { return a.atom < atom; });
    for (std::uint32_t k = 0; k < residue.atoms && at != out.end(); ++k, ++at) {
      held.push_back({at->atom, at->reason, false});
    }
  }
}

// Adds ligands and ions of the body that are among these balls, with all balls of their residues.
void add_lining_ligands(const BallReferences& references, const std::vector<BallIndex>& lining,
                        std::vector<ContainedAtom>& held) {
  const std::vector<Atom>& all = references.molecule().atoms;
  const std::vector<std::uint32_t>& atom_of = references.prepared().atom_of_ball;
  for (const BallIndex ball : lining) {
    const Atom& atom = all[atom_of[ball]];
    if (atom.kind != ResidueKind::ligand && atom.kind != ResidueKind::ion) continue;
    const DropReason kind = atom.kind == ResidueKind::ion ? DropReason::ion : DropReason::ligand;
    const auto same = [&](std::size_t b) { return same_residue(all[atom_of[b]], atom); };
    std::size_t first = ball, last = ball;
    while (first > 0 && same(first - 1)) --first;
    while (last + 1 < atom_of.size() && same(last + 1)) ++last;
    for (std::size_t b = first; b <= last; ++b) held.push_back({atom_of[b], kind, true});
  }
}

std::vector<std::size_t> rows_of_sinks(const CavityTable& table, const CavitySinks& sinks) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.size() && rows.size() < sinks.size(); ++row) {
    if (std::binary_search(sinks.begin(), sinks.end(), table.sink(row))) rows.push_back(row);
  }
  return rows;
}

std::shared_ptr<const SelectedCavities> choose(const Inputs& in, const CavitySinks& sinks,
                                               const DrawnCavityParts& parts,
                                               const RunContext& context) {
  auto chosen = std::make_shared<SelectedCavities>();
  chosen->table = in.share(cavity_table());
  const CavityTable& table = *chosen->table;
  std::vector<BallIndex> lining;
  std::optional<Clearance> made;
  const auto clearance = [&]() -> const Clearance& {
    if (!made) made.emplace(*in.atoms->prepared().balls);
    return *made;
  };
  for (const std::size_t row : rows_of_sinks(table, sinks)) {
    context.cancel.throw_if_cancelled();
    chosen->of.push_back(draw(table, row, parts, clearance));
    const auto& own = table.measure(row).lining;
    lining.insert(lining.end(), own.begin(), own.end());
    add_held(*in.atoms, in.of(cavity_contents()), table.order[row], chosen->held);
  }
  std::sort(lining.begin(), lining.end());
  lining.erase(std::unique(lining.begin(), lining.end()), lining.end());
  list_residues(*in.atoms, lining, chosen->residues);
  add_lining_ligands(*in.atoms, lining, chosen->held);
  std::sort(chosen->held.begin(), chosen->held.end());
  chosen->held.erase(std::unique(chosen->held.begin(), chosen->held.end()), chosen->held.end());
  lining.resize(std::min(lining.size(), Selection::kMostItems));
  for (const BallIndex ball : lining) chosen->atoms.emplace_back(in.atoms->atom(ball));
  return chosen;
}

}  // namespace

SelectedRows rows_of_cavities(const CavityLines& lines, const RefSet& cavities) {
  const CavityTable& table = *lines.table;
  const CavityNumbers& numbers = *lines.numbers;
  CavitySinks sinks, merged;
  for (const Ref& ref : cavities.items()) {
    const auto balls = lines.atoms->balls(ref);
    if (!balls || balls->size() != 4) continue;
    const std::uint32_t number =
        numbers.number_of({(*balls)[0], (*balls)[1], (*balls)[2], (*balls)[3]});
    if (number == CavityMatch::kNone) continue;
    const std::uint32_t cavity = numbers.cavity_or_heir(number);
    if (cavity == CavityMatch::kNone) continue;
    const auto& sink =
        table.ground->triangulation->tetrahedra[table.found.cavities[cavity].deepest_sink];
    sinks.push_back(sink);
    if (numbers.cavity(number) == CavityMatch::kNone) merged.push_back(sink);
  }
  for (CavitySinks* each : {&sinks, &merged}) std::sort(each->begin(), each->end());
  return {rows_of_sinks(table, sinks), rows_of_sinks(table, merged)};
}

Definition<SelectedCavities> selected_cavities(const CavitySinks& sinks,
                                               const DrawnCavityParts& parts, std::uint64_t key) {
  return {{.id = "cavities.chosen",
           .title = "Drawings of cavities",
           .made_of = {&cavity_table(), &cavity_contents()},
           .key =
               [key](const Inputs& in) {
                 if (!in.atoms) return Key{};
                 Key all = key_of_balls_and_alpha(in);
                 all.more = key;
                 return all;
               },
           .memory =
               [](const Inputs& in) {
                 // Bytes for each tetrahedron: half of its triangles on the surface (12 bytes
                 // each), 16 for itself, 40 for spheres.
                 constexpr std::uint64_t kBytes = 90;
                 const std::uint64_t all =
                     kBytes * in.of(cavity_table()).ground->triangulation->tetrahedra.size();
                 return MemoryNeed{all, all};
               },
           .lane = Lane::interactive},
          [sinks, parts](const Inputs& in, const RunContext& context) {
            return choose(in, sinks, parts, context);
          }};
}

}  // namespace alphascope
