// SPDX-License-Identifier: GPL-3.0-or-later
// Results of earlier requests for a set of balls, which later requests can use. The caller of an
// engine owns them; an engine keeps none.
#pragma once

#include <memory>
#include <utility>

namespace alphascope {

class Filtration;
struct AlphaComplex;
struct BallSet;
struct Triangulation;

// Results for the set as a whole, which serve every alpha. Each part may be null.
struct ResultsForAllAlphas {
  std::shared_ptr<const BallSet> balls;
  std::shared_ptr<const Triangulation> triangulation;
  // Filtration of all simplices of `balls`, made from their triangulation. The complex at any alpha
  // is a threshold of it.
  std::shared_ptr<const Filtration> filtration;

  explicit operator bool() const { return triangulation || filtration; }
  // Takes the other's parts; both are of the same balls.
  void add(const ResultsForAllAlphas& other) {
    if (other.triangulation) triangulation = other.triangulation;
    if (other.filtration) filtration = other.filtration;
  }
  // Drops a part if the other holds the very same object.
  void drop(const ResultsForAllAlphas& other) {
    if (triangulation == other.triangulation) triangulation = nullptr;
    if (filtration == other.filtration) filtration = nullptr;
  }
};

struct KnownResults : ResultsForAllAlphas {
  // A whole complex, set if the engine has asked for it. The complex at any smaller alpha is a
  // threshold of it.
  std::shared_ptr<const AlphaComplex> complex;
  std::shared_ptr<const Filtration> below;  // made from such a complex
  bool wants_complex = false;  // true: the engine wants its latest answer back as `complex`

  // Hands over the answer, if the engine has asked for it.
  void share(std::shared_ptr<const AlphaComplex> answer) {
    if (std::exchange(wants_complex, false)) complex = std::move(answer);
  }
  void forget_complex() {
    complex = nullptr;
    below = nullptr;
  }
};

}  // namespace alphascope
