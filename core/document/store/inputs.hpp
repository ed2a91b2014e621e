// What derived results are made of, and keys that say of which.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/ball_set.hpp"

namespace alphascope {

template <class T>
struct Definition;
struct MeasuredUnion;
enum class FlowTies;
enum class OutsideRule;

struct Inputs {
  std::shared_ptr<const BallSet> balls;  // with the solvent radius; null: no molecule
  std::uint64_t balls_key = 0;           // another number for other balls; 0: none
  double solvent_radius_angstrom = 0;    // theirs
  // The atoms that they are, and their radii without the solvent radius; null: not known.
  std::shared_ptr<const BallReferences> atoms;
  std::uint64_t body_key = 0;    // another number for other atoms, not for another solvent radius
  std::uint64_t frames_key = 0;  // of them in every model (key_of_frames()); 0: there is one model
  // Of the complex on screen, and that itself; null: none. Not a number and null for results whose
  // key is not of alpha.
  Alpha alpha_angstrom2;
  std::shared_ptr<const AlphaComplex> complex;
  bool split_networks = false;  // CavityChoices'
  // How cavities are found; zero is CASTp's way, and the window's.
  FlowTies flow_ties{};
  OutsideRule outside_rule{};
  int triangulation_threads = 1;  // of CGAL; they change the time alone
  // Its areas and volumes where something has measured it already; null: nobody has.
  std::shared_ptr<const MeasuredUnion> measures = {};

  // A result that the one which is being made is made of (AnyDefinition::made_of): ready, not null.
  template <class T>
  const T& of(const Definition<T>& definition) const {
    return *share(definition);
  }
  // The same, to be kept.
  template <class T>
  std::shared_ptr<const T> share(const Definition<T>& definition) const {
    return std::static_pointer_cast<const T>(find(definition.id));
  }

  // By id; the store fills it in.
  std::vector<std::pair<std::string_view, std::shared_ptr<const void>>> made = {};

 private:
  const std::shared_ptr<const void>& find(std::string_view id) const;
};

// Of what a result is made of: equal keys, equal results.
struct Key {
  std::uint64_t balls = 0;  // Inputs::balls_key; 0: the inputs do not suffice
  std::uint64_t alpha = 0;  // another number for another alpha; 0: it does not matter
  std::uint64_t more = 0;   // of what the definition takes beside the inputs

  explicit operator bool() const { return balls != 0; }
  friend bool operator==(const Key&, const Key&) = default;

  std::uint64_t number() const;  // another one for another key, but for one chance in 2^64
};

Key key_of_balls(const Inputs& inputs);
Key key_of_balls_and_alpha(const Inputs& inputs);
Key key_of_complex(const Inputs& inputs);  // of Inputs::complex, whole or tetrahedra only
// Of what is made of both.
Key joined(const Key& a, const Key& b);

}  // namespace alphascope
