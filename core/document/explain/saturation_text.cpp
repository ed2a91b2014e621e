// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the sentence.
#include "core/document/explain/saturation_text.hpp"

#include "core/geometry/alpha.hpp"
#include "core/rounds/thesis_rounds.hpp"
#include "core/text/grouped_number.hpp"
#include "core/text/short_number.hpp"

namespace alphascope {
namespace {

using State = BallSaturation::State;

std::string round_text(std::size_t round) {
  if (round == 0) return "after all of the thesis' rounds";
  return "the thesis' round " + std::to_string(round) +
         ", α = " + short_number(alpha_of_round(round)) + " Å²";
}

}  // namespace

std::string saturation_text(const BallSaturation& s) {
  switch (s.state) {
    case State::on_hull:
      return "On the hull: never saturated, as its cell has no end.";
    case State::hidden:
      return "Hidden: never saturated, as it has no cell.";
    case State::flat:
      return "Never saturated: all centres are in one plane, and there are no tetrahedra.";
    case State::saturates:
      break;
  }
  return "Saturated from α = " + short_number(s.angstrom2) + " Å² (" + round_text(s.round) +
         "): its star is final, " + counted(s.tetrahedra, "tetrahedron", "tetrahedra") + ".";
}

}  // namespace alphascope
