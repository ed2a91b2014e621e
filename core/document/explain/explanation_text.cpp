// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the sentences of an explanation: whether the simplex is there, why, and which arithmetic
// decided.
#include "core/document/explain/explanation_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/document/explain/dimension_words.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/point_text.hpp"
#include "core/geometry/shortest_number.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/text/short_number.hpp"

namespace alphascope {
namespace {

using Balls = std::vector<BallIndex>;

std::string square(double angstrom2) {
  return short_number(angstrom2) + " Å²";
}
std::string place(const RealPoint& p) {
  return "(" + point_text(p) + ") Å";
}

std::string ball_text(BallIndex ball, const BallName& name) {
  return "ball " + std::to_string(ball) + " (" + name(ball) + ")";
}

const char* class_meaning(SimplexClass simplex_class) {
  switch (simplex_class) {
    case SimplexClass::singular:
      return "no larger simplex of the complex contains it";
    case SimplexClass::regular:
      return "it is on the boundary of something larger in the complex";
    case SimplexClass::interior:
      break;
  }
  return "everything around it is filled";
}

const char* arithmetic_name(Arithmetic by) {
  switch (by) {
    case Arithmetic::single_filter:
      return "single precision";
    case Arithmetic::double_filter:
      return "double precision";
    case Arithmetic::integers:
      return "integers";
    case Arithmetic::perturbation:
      break;
  }
  return "the perturbation";
}
std::string step_text(const ArithmeticStep& step, bool first) {
  std::string text = first ? "First, " : " Then ";
  text += arithmetic_name(step.by);
  if (step.by == Arithmetic::perturbation) {
    return text +
           " decides: as if every weight were smaller by a different, infinitely small amount, "
           "the ball counts as " +
           (step.sign < 0 ? "inside." : "outside.");
  }
  if (step.has_number && std::isfinite(step.error_angstrom2)) {
    text += step.error_angstrom2 > 0 ? ": " + square(step.value_angstrom2) + ", wrong by at most " +
                                           square(step.error_angstrom2)
                                     : ": " + square(step.value_angstrom2) + ", exactly compared";
  }
  if (step.sign != 0) return text + ". This decides.";
  return text + (step.by == Arithmetic::integers ? ". It is a tie." : ". This leaves it open.");
}
std::string steps_text(const std::vector<ArithmeticStep>& steps) {
  std::string text;
  for (const ArithmeticStep& step : steps) text += step_text(step, text.empty());
  return text;
}

class Sentences {
 public:
  Sentences(const Explanation& e, const BallName& name) : e_(e), name_(name) {}

  std::vector<ExplanationLine> all() {
    add("Simplex", "This is the " + simplex_text(e_.simplex, name_) + "." + dimension());
    e_.absence == AbsenceReason::none ? answer() : absence();
    orthosphere();
    margin();
    if (e_.absence == AbsenceReason::none) {
      value();
      classes();
    }
    others();
    arithmetic();
    return std::move(lines_);
  }

 private:
  bool in_space() const { return e_.dimension == 3; }
  std::string largest_kind() const {
    return simplex_kind_name(static_cast<std::size_t>(e_.dimension) + 1);
  }
  std::string dimension() const {
    switch (e_.dimension) {
      case 2:
        return " All centres are in one plane, where triangles are the largest simplices and edges "
               "of one triangle are the boundary.";
      case 1:
        return " All centres are on one line, where edges are the largest simplices and vertices "
               "of one edge are the boundary.";
      case 0:
        return " All centres are at one point, where a vertex is the largest simplex.";
      default:
        return "";
    }
  }
  void add(const char* heading, std::string text, Balls about = {}) {
    lines_.push_back({heading, std::move(text), std::move(about)});
  }
  std::string the() const { return std::string("this ") + simplex_kind_name(e_.simplex.size()); }
  std::string ball(BallIndex b) const { return ball_text(b, name_); }

  // Shows all digits if the rounded value would look equal to alpha.
  std::string value_beside(const Alpha& alpha) const {
    const std::string value = square(e_.appears.angstrom2);
    return value == square(alpha) ? shortest_number(e_.appears.angstrom2) + " Å²" : value;
  }

  void answer() {
    if (!e_.at_alpha) {
      return add("Answer", "It is in the alpha complex from alpha = " +
                               square(e_.appears.angstrom2) + " on.");
    }
    const AtAlpha& at = *e_.at_alpha;
    const Alpha given = e_.lattice.alpha_angstrom2(at.alpha_on_lattice);
    const std::string alpha = shortest_number(given) + " Å²";
    const std::string value = value_beside(given);
    if (!at.in_complex) {
      return add("Answer", "It is not in the alpha complex at alpha = " + alpha +
                               ". Its alpha value, " + value + ", is larger.");
    }
    add("Answer", "It is in the alpha complex at alpha = " + alpha + ". Its alpha value, " + value +
                      ", is not larger. It is " + simplex_class_name(at.simplex_class) + ": " +
                      class_meaning(at.simplex_class) + ".");
  }

  void absence() {
    std::string text = "It is in no alpha complex, however large alpha is. ";
    text += "The alpha complex takes its simplices from the regular triangulation, and " + the() +
            " is not in that. ";
    Balls about = e_.culprits;
    switch (e_.absence) {
      case AbsenceReason::hidden:
        text += hidden();
        break;
      case AbsenceReason::dependent:
        text += dependent();
        break;
      case AbsenceReason::face:
        text += "The " + simplex_text(e_.absent_face, name_) +
                " is not in it, so nothing that contains it is.";
        about = e_.absent_face;
        break;
      case AbsenceReason::cut_away:
        text += cut_away();
        break;
      case AbsenceReason::none:
        break;
    }
    add("Answer", text, about);
  }
  std::string hidden() const {
    std::string text = "Its " + ball(e_.absent_face[0]) + " is hidden. ";
    if (e_.culprits.empty()) return text;
    const std::string other = ball(e_.culprits[0]);
    return text + "There is no point " + where_text(e_.dimension) +
           " where it has the least power distance. At its centre " + other +
           " has less or the same.";
  }
  std::string dependent() const {
    const std::size_t n = e_.simplex.size();
    return n == 4   ? "Its four centres lie in one plane."
           : n == 3 ? "Its three centres lie on one line."
                    : "Its two centres are the same point.";
  }
  std::string cut_away() const {
    std::string text =
        "To be in the complex, its balls need a common point where no other ball has less power "
        "distance. ";
    text += e_.culprits.size() == 2 ? "There is none: " + ball(e_.culprits[0]) + " and " +
                                          ball(e_.culprits[1]) + " cut off all of these points."
            : e_.culprits.size() == 1
                ? "There is none: " + ball(e_.culprits[0]) +
                      (e_.simplex.size() == 4 ? " has less, or as much and wins the tie."
                                              : " has less, and others take the rest.")
                : "There is none.";
    return text;
  }

  void orthosphere() {
    if (!e_.orthosphere) {
      return add("Orthosphere", "There is none: its centres lie " +
                                    std::string(e_.simplex.size() == 4   ? "in one plane"
                                                : e_.simplex.size() == 3 ? "on one line"
                                                                         : "at one point") +
                                    ".");
    }
    const auto& sphere = *e_.orthosphere;
    std::string text =
        "The power distance of a point from a ball is the square of its distance from the centre "
        "minus the square of the radius. ";
    text += e_.simplex.size() == 1
                ? "For one ball it is least at the centre, "
                : "The point of least power distance that is the same for all its balls is the "
                  "orthocentre, ";
    text += place(sphere.centre_angstrom) +
            ". Its power distance there is ρ = " + square(sphere.rho_angstrom2) + ". ";
    text +=
        sphere.rho_sign > 0 ? "So the orthosphere has the radius √ρ = " +
                                  short_number(std::sqrt(sphere.rho_angstrom2)) + " Å."
        : sphere.rho_sign < 0
            ? "As ρ is negative, the orthosphere is imaginary: its centre is inside all of these "
              "balls, and there is no sphere to draw."
            : "So the orthosphere is a point.";
    if (e_.dimension == 2 && sphere.rho_sign > 0) {
      text += " The plane meets it in the orthocircle, which has the same centre and the same ρ.";
    }
    add("Orthosphere", text);
  }

  void margin() {
    if (!e_.orthosphere) return;
    if (e_.nearest.empty()) return add("Other balls", "There is no other ball.");
    const BallMargin& one = e_.nearest.front();
    const std::string power = ball(one.ball) + " has the power distance " +
                              square(one.power_angstrom2) + " at the orthocentre";
    std::string text = "Of all other balls, " + power + ", the least. ";
    if (one.sign == 0) {
      text += "This is exactly ρ: a tie, with the margin 0 Å².";
    } else {
      text += "Minus ρ, this is the margin " + square(one.margin_angstrom2) + ". ";
      text += one.sign < 0 ? "A negative margin means that the ball is inside the orthosphere."
                           : "A positive margin means that the ball is outside the orthosphere.";
    }
    add("Nearest ball", text, {one.ball});
  }

  void value() {
    if (!e_.attached) {
      return add("Alpha value",
                 "No ball is inside its orthosphere, so it is unattached. Its alpha "
                 "value is its own ρ, " +
                     square(e_.appears.angstrom2) + ".");
    }
    add("Alpha value",
        "A ball is inside its orthosphere, so it is attached: it does not appear by itself, but "
        "together with a larger simplex. The first is the " +
            simplex_text(e_.appears.from, name_) + ". The ρ of that is its alpha value, " +
            square(e_.appears.angstrom2) + ".",
        e_.appears.from);
  }

  void classes() {
    std::string text = "It appears at alpha = " + square(e_.appears.angstrom2) + ". ";
    if (e_.largest) {
      if (!in_space()) text += "Nothing " + std::string(where_text(e_.dimension)) + " is larger: ";
      return add("With alpha", text + (in_space() ? "A " : "this ") + largest_kind() +
                                   " is interior from then on.");
    }
    if (!e_.regular) {
      return add("With alpha", text + "It stays singular for ever: nothing larger contains it.");
    }
    if (e_.regular->from == e_.appears.from) {
      text += "It is never singular, for it comes with a larger simplex. ";
    } else {
      text +=
          "It is singular until it becomes regular at alpha = " + square(e_.regular->angstrom2) +
          ", with the " + simplex_text(e_.regular->from, name_) + ". ";
    }
    add("With alpha", text, e_.regular->from);
    if (!e_.interior) {
      return add("Interior",
                 "It never becomes interior, because it is on the hull of all balls: no "
                 "tetrahedron can fill its outer side.");
    }
    add("Interior",
        "It becomes interior at alpha = " + square(e_.interior->angstrom2) + ", when the last " +
            largest_kind() + " around it appears, the " + simplex_text(e_.interior->from, name_) +
            ".",
        e_.interior->from);
  }

  void others() {
    for (std::size_t n = 1; n < e_.nearest.size(); ++n) {
      const BallMargin& one = e_.nearest[n];
      add(n == 1 ? "Next balls" : "",
          ball(one.ball) + ": power distance " + square(one.power_angstrom2) + ", margin " +
              square(one.margin_angstrom2) +
              (one.sign < 0   ? ", inside."
               : one.sign > 0 ? ", outside."
                              : ", a tie."),
          {one.ball});
    }
  }

  void arithmetic() {
    if (!e_.nearest.empty()) {
      add("Arithmetic", "How the margin of " + ball(e_.nearest.front().ball) +
                            " was compared with 0. " + steps_text(e_.nearest.front().steps));
    }
    if (e_.at_alpha) {
      add(e_.nearest.empty() ? "Arithmetic" : "",
          "How ρ − α was compared with 0. " + steps_text(e_.at_alpha->steps));
    }
  }

  const Explanation& e_;
  const BallName& name_;
  std::vector<ExplanationLine> lines_;
};

}  // namespace

const char* simplex_class_name(SimplexClass simplex_class) {
  switch (simplex_class) {
    case SimplexClass::singular:
      return "singular";
    case SimplexClass::regular:
      return "regular";
    case SimplexClass::interior:
      break;
  }
  return "interior";
}

std::string simplex_text(const Balls& simplex, const BallName& name) {
  if (simplex.size() == 1) return "vertex of " + ball_text(simplex[0], name);
  std::string text = std::string(simplex_kind_name(simplex.size())) + " of balls ";
  for (std::size_t n = 0; n < simplex.size(); ++n) {
    text += n == 0 ? "" : n + 1 == simplex.size() ? " and " : ", ";
    text += std::to_string(simplex[n]) + " (" + name(simplex[n]) + ")";
  }
  return text;
}

std::vector<ExplanationLine> explanation_lines(const Explanation& e, const BallName& name) {
  return Sentences(e, name).all();
}

}  // namespace alphascope
