// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings of objects (DrawnObject) as flat arrays. Pure C++, may run in a worker; no VTK.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/bonds/bonds.hpp"
#include "core/document/reference/appearance.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "core/run/cancel_token.hpp"
#include "core/secondary/nucleotides.hpp"
#include "core/secondary/secondary.hpp"
#include "ui/scene/mesh/complex_mesh.hpp"
#include "ui/scene/objects/cartoon_mesh.hpp"
#include "ui/scene/objects/pictured_object.hpp"
#include "ui/scene/picture/painting.hpp"

namespace alphascope {

// Facts about the molecule that objects are drawn from.
struct ObjectFacts {
  ModelRange atoms;  // the models whose atoms are balls
  std::shared_ptr<const SecondaryModel> secondary;
  std::vector<Nucleotide> nucleotides;
  std::vector<Bond> bonds;
};
// Takes some 0.1 µs an atom. Throws Cancelled.
std::shared_ptr<const ObjectFacts> find_object_facts(const PicturedMolecule& molecule,
                                                     const RunContext& context = {});

// Rods with round ends; each half has its atom's colour.
struct StickMesh {
  std::shared_ptr<const BallGeometry> places;  // of the ends; null: there are no sticks
  EdgeCells rods;
  float radius = 0;                          // Å
  std::vector<std::uint32_t> atom_of_place;  // indices in Molecule::atoms
};

struct ObjectMesh {
  CartoonMesh cartoon;
  StickMesh sticks;
  std::shared_ptr<const BallGeometry> spheres;  // null: none
  std::vector<Rgb8> sphere_colours;
  std::vector<std::uint32_t> atom_of_sphere;
  CellSoup dots;  // points of some pixels; `source` holds their atoms
  bool empty() const {
    return cartoon.triangles() == 0 && !sticks.places && !spheres && dots.points() == 0;
  }
};

// The facts about one molecule, found when they are first needed. Several threads may ask at once.
class FactsOnce {
 public:
  // Throws Cancelled.
  std::shared_ptr<const ObjectFacts> of(const PicturedMolecule& molecule,
                                        const RunContext& context = {});

 private:
  std::timed_mutex finding_;
  std::shared_ptr<const PreparedBalls> prepared_;  // of the molecule of facts_
  std::shared_ptr<const ObjectFacts> facts_;
};

// Hidden atoms are left out, as are alternative locations that give way to others; colours that the
// user chose for atoms win. Without balls the result is empty. Works on the caller's threads.
// Throws SelectionError and Cancelled.
ObjectMesh build_object(const PicturedMolecule& molecule, const ObjectFacts& facts,
                        const DrawnObject& object, const Appearance& appearance,
                        const CancelToken& cancel = {});
// The same for these atoms, whatever the object's expression says.
ObjectMesh build_object(const PicturedMolecule& molecule, const ObjectFacts& facts,
                        const DrawnObject& object, const std::vector<std::uint32_t>& atoms,
                        const Appearance& appearance, const CancelToken& cancel = {});

// The objects that are shown. Throws as build_object() does.
PicturedObjects build_objects(const PicturedMolecule& molecule, FactsOnce& facts,
                              const DrawnObjects& objects, const Appearance& appearance,
                              const RunContext& context = {});

// Bytes of an object's arrays, those of VTK and OpenGL included.
std::uint64_t object_bytes(const ObjectMesh& mesh);

}  // namespace alphascope
