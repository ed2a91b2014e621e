// What earlier requests have found out about a set of balls, so that the next one need not. An
// engine keeps none of it; who asks the engine owns it.
#pragma once

#include <memory>
#include <utility>

#include "core/complex/alpha_complex.hpp"

namespace alphascope {

class Filtration;
struct Triangulation;

// Made of the set as a whole, for every alpha. Each part may be null.
struct OfAllBalls {
  std::shared_ptr<const BallSet> balls;
  std::shared_ptr<const Triangulation> triangulation;
  // Of `balls` itself, and made of their triangulation: every alpha is a threshold of it.
  std::shared_ptr<const Filtration> filtration;

  explicit operator bool() const { return triangulation || filtration; }
  // Takes over what another has of the same balls.
  void add(const OfAllBalls& other) {
    if (other.triangulation) triangulation = other.triangulation;
    if (other.filtration) filtration = other.filtration;
  }
  // Lets go of the very objects that another has.
  void drop(const OfAllBalls& other) {
    if (triangulation == other.triangulation) triangulation = nullptr;
    if (filtration == other.filtration) filtration = nullptr;
  }
};

struct KnownOfBalls : OfAllBalls {
  // A whole complex, if the engine has asked for it: smaller alphas are thresholds of it, too.
  std::shared_ptr<const AlphaComplex> complex;
  std::shared_ptr<const Filtration> below;  // made of such a complex
  bool wants_complex = false;               // the engine asks for the answer that it has just given

  // The answer, when it can be shared.
  void share(std::shared_ptr<const AlphaComplex> answer) {
    if (std::exchange(wants_complex, false)) complex = std::move(answer);
  }
  void forget_complex() {
    complex = nullptr;
    below = nullptr;
  }
};

}  // namespace alphascope
