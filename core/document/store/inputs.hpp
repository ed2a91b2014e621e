// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of derived results, and keys that identify them.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry/alpha.hpp"

namespace alphascope {

template <class T>
struct Definition;
class BallReferences;
class TriangulationMaker;
enum class FlowTies;
enum class OutsideRule;
struct AlphaComplex;
struct BallSet;
struct Key;
struct MeasuredUnion;

struct Inputs {
  std::shared_ptr<const BallSet> balls;  // with the solvent radius; null: no molecule
  std::uint64_t balls_key = 0;           // differs between sets of balls; 0: none
  double solvent_radius_angstrom = 0;    // the one in `balls`
  // The atoms of `balls`, with their radii without the solvent radius. Null: not known.
  std::shared_ptr<const BallReferences> atoms;
  std::uint64_t body_key = 0;    // differs between sets of atoms; the same for every solvent radius
  std::uint64_t frames_key = 0;  // the balls of all models (key_of_frames()); 0: one model
  // The complex on screen and its alpha. NaN and null where there is none, and for results whose
  // key has no alpha.
  Alpha alpha_angstrom2;
  std::shared_ptr<const AlphaComplex> complex;
  bool split_networks = false;  // CavitySettings::split_networks
  // How cavities are found. Zero is CASTp's method, which the window uses.
  FlowTies flow_ties{};
  OutsideRule outside_rule{};
  // How triangulations are made; both affect the time only. Null: on the CPU.
  std::shared_ptr<TriangulationMaker> triangulation_maker = {};
  int triangulation_threads = 0;  // 0: all that the result has
  // Areas and volumes of `complex`, where they are measured already; else null.
  std::shared_ptr<const MeasuredUnion> measures = {};

  // A result in `made_of` of the definition that is being made (AnyDefinition::made_of). It is
  // ready and not null.
  template <class T>
  const T& of(const Definition<T>& definition) const {
    return *share(definition);
  }
  // The same, shared, for results that keep it.
  template <class T>
  std::shared_ptr<const T> share(const Definition<T>& definition) const {
    return std::static_pointer_cast<const T>(find(definition.id));
  }

  // By id. The store fills it in.
  std::vector<std::pair<std::string_view, std::shared_ptr<const void>>> made = {};

 private:
  const std::shared_ptr<const void>& find(std::string_view id) const;
};

Key key_of_balls(const Inputs& inputs);
Key key_of_balls_and_alpha(const Inputs& inputs);
Key key_of_complex(const Inputs& inputs);  // of Inputs::complex, whole or tetrahedra only
// The key of a result made from the inputs of both.
Key joined(const Key& a, const Key& b);

}  // namespace alphascope
