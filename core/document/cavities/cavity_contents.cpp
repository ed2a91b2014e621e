// SPDX-License-Identifier: GPL-3.0-or-later
// Assigns left-out atoms to cavities, residue by residue.
#include "core/document/cavities/cavity_contents.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity_identity/cavity_of_points.hpp"
#include "core/complex/face_class.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/engine/known_results.hpp"
#include "core/predicates/orthosphere.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/selection/atom_address.hpp"
#include "core/selection/atom_groups.hpp"
#include "core/selection/ball_options.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/text/grouped_number.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

std::vector<std::uint32_t> cavities_of_left_out(const BallReferences& atoms,
                                                const CavityTable& table,
                                                const CancelToken& cancel) {
  const Molecule& molecule = atoms.molecule();
  std::vector<LatticePlace> places;
  for (const LeftOutAtom& out : atoms.prepared().left_out) {
    places.push_back(place_on(table.ground->balls->lattice, molecule.atoms[out.atom].position,
                              molecule.lattice));
  }
  return cavities_at(table, places, cancel);
}

// Calls use(begin, end) for the left-out atoms of each residue; hydrogens of the body are skipped.
// Files that run out of numbers give many waters the same one. So a new residue begins where the
// first atom's name comes again.
template <class Use>
void for_residues(const BallReferences& atoms, const Use& use) {
  const std::vector<LeftOutAtom>& out = atoms.prepared().left_out;
  const std::vector<Atom>& all = atoms.molecule().atoms;
  for (std::size_t begin = 0, end = 0; begin < out.size(); begin = end) {
    const Atom& first = all[out[begin].atom];
    for (end = begin + 1; end < out.size() && out[end].reason == out[begin].reason; ++end) {
      const Atom& atom = all[out[end].atom];
      const bool again = atom.name == first.name && atom.altloc == first.altloc;
      if (again || !same_residue(first, atom)) break;
    }
    if (out[begin].reason != DropReason::hydrogen) use(begin, end);
  }
}

ContainedResidue held_residue(const LeftOutAtom* begin, const LeftOutAtom* end,
                              const std::uint32_t* cavities,
                              const std::vector<std::size_t>& row_of) {
  ContainedResidue residue{begin->atom, begin->reason, Cavities::kNone,
                           static_cast<std::uint32_t>(end - begin), 0};
  std::map<std::size_t, std::uint32_t> count;  // keys are rows, which begin with the largest volume
  for (std::size_t n = 0; n < residue.atoms; ++n) {
    if (cavities[n] == Cavities::kNone) continue;
    ++count[row_of[cavities[n]]];
  }
  for (std::size_t n = 0; n < residue.atoms; ++n) {
    if (cavities[n] == Cavities::kNone) continue;
    const auto rank = [&](std::uint32_t cavity) {
      const std::size_t row = row_of[cavity];
      return std::tuple(count.at(row), ~row);
    };
    if (residue.cavity == Cavities::kNone || rank(cavities[n]) > rank(residue.cavity)) {
      residue.cavity = cavities[n];
    }
  }
  if (residue.cavity != Cavities::kNone) residue.inside = count.at(row_of[residue.cavity]);
  return residue;
}

int place_of_kind(DropReason kind) {
  return kind == DropReason::ligand ? 0 : kind == DropReason::ion ? 1 : 2;
}

}  // namespace

CavityContents find_contents(const BallReferences& atoms, const CavityTable& table,
                             const CancelToken& cancel) {
  CavityContents contents;
  contents.of.resize(table.found.cavities.size());
  const std::vector<std::uint32_t> cavities = cavities_of_left_out(atoms, table, cancel);
  std::vector<std::size_t> row_of(table.size());
  for (std::size_t row = 0; row < table.size(); ++row) row_of[table.order[row]] = row;
  const LeftOutAtom* out = atoms.prepared().left_out.data();
  for_residues(atoms, [&](std::size_t begin, std::size_t end) {
    contents.residues.push_back(
        held_residue(out + begin, out + end, cavities.data() + begin, row_of));
  });
  const auto kind = [&](std::uint32_t n) { return place_of_kind(contents.residues[n].kind); };
  for (std::uint32_t n = 0; n < contents.residues.size(); ++n) {
    const std::uint32_t cavity = contents.residues[n].cavity;
    if (cavity != Cavities::kNone) contents.of[cavity].push_back(n);
  }
  for (std::vector<std::uint32_t>& list : contents.of) {
    std::stable_sort(list.begin(), list.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return kind(a) < kind(b); });
  }
  return contents;
}

std::string contents_text(const Molecule& molecule, const CavityContents& contents,
                          std::uint32_t cavity, std::size_t most) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  std::size_t named = 0, others = 0, waters = 0;
  for (const std::uint32_t n : contents.of[cavity]) {
    const ContainedResidue& residue = contents.residues[n];
    if (residue.kind == DropReason::water) {
      ++waters;
    } else if (named == most) {
      ++others;
    } else {
      ++named;
      std::string name = residue_address(molecule, residue.atom);
      if (residue.inside < residue.atoms) {
        name += " (" + grouped(residue.inside) + " of " + grouped(residue.atoms) + " atoms)";
      }
      add(name);
    }
  }
  if (others > 0) add(grouped(others) + " more");
  if (waters > 0) add(grouped(waters) + (waters == 1 ? " water" : " waters"));
  return text;
}

const Definition<CavityContents>& cavity_contents() {
  static const Definition<CavityContents> definition{
      {.id = "cavities.contents",
       .title = "Contents of cavities",
       .made_of = {&cavity_table()},
       .key = [](const Inputs& in) { return in.atoms ? key_of_balls_and_alpha(in) : Key{}; },
       .memory =
           [](const Inputs& in) {
             constexpr std::uint64_t kBytesPerAtom = 48;  // a place, a residue, its index
             const std::uint64_t bytes =
                 kBytesPerAtom * in.atoms->prepared().left_out.size() +
                 in.of(cavity_table()).size() * sizeof(std::vector<std::uint32_t>) + 100'000;
             return MemoryNeed{bytes, bytes};
           },
       .lane = Lane::interactive},
      [](const Inputs& in, const RunContext& context) {
        return std::make_shared<const CavityContents>(
            find_contents(*in.atoms, in.of(cavity_table()), context.cancel));
      }};
  return definition;
}

}  // namespace alphascope
