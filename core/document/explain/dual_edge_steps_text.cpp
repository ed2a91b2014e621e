// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences on the steps of the dual-edge engine. Steps that every engine has are in
// steps_text.cpp.
#include "core/document/explain/step_words.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text/short_number.hpp"

namespace alphascope {
namespace {

namespace id = step_count;

class Writer {
 public:
  Writer(const BallSteps& steps, const Step& step, const BallName& name)
      : steps_(steps), step_(step), name_(name) {}

  StepText text() const {
    switch (step_.kind) {
      case StepKind::neighbours:
        return {"Kernel I: neighbours", things(all(id::kNeighbours), "neighbour"), neighbours()};
      case StepKind::discs:
        return {"Kernel I: covered discs", left_of(step_), discs()};
      case StepKind::edges:
        return {"Edges",
                grouped(all(id::kValid)) + " valid, " + grouped(all(id::kConflict)) + " attached",
                edges()};
      case StepKind::triangles:
        return {"Triangles", left_of(step_), triangles()};
      case StepKind::clipping:
        return {"Kernel II: dual edges",
                grouped(all(id::kLeft)) + " left, " + grouped(all(id::kBand)) + " open",
                clipping()};
      case StepKind::exact:
        return {"Kernel III",
                grouped(all(id::kLeft)) + " of " + grouped(all(id::kTested)) + " left", exact()};
      case StepKind::ends:
        return {"Triangles and tetrahedra",
                grouped(all(id::kTriangles)) + " and " + grouped(all(id::kTetrahedra)), ends()};
      case StepKind::vertex:
        return {"Vertex", all(id::kValid) > 0 ? "valid" : "attached", vertex()};
      case StepKind::beyond_range:
        return {"Stopped", "alpha is too large", beyond_range()};
      default:
        return {"Stopped", "too many dual edges", too_many()};
    }
  }

 private:
  std::uint64_t all(std::string_view what) const { return step_.count(what).all; }
  std::string here(std::string_view what) const { return made_here(step_.count(what)); }
  std::string who(const std::string& does) const {
    if (step_.removers.empty()) return "";
    const StepConflict& most = step_.removers.front();
    return " Ball " + std::to_string(most.ball) + " (" + name_(most.ball) + ") " + does + ", " +
           grouped(most.simplices) + ".";
  }

  std::string neighbours() const {
    const std::uint64_t found = all(id::kNeighbours), cells = all(id::kCellsSearched),
                        later = step_.count(id::kNeighbours).here;
    return "With alpha, this ball grows to a radius of " + short_number(step_.length_angstrom) +
           " Å. Cells are so wide that all balls that can then meet it are in its cell and those "
           "around it, " +
           things(cells, "cell") + " with " + things(all(id::kBallsTested), "other ball") + "; " +
           grouped(found) + (found == 1 ? " of them meets" : " of them meet") +
           " it. These are its neighbours. No other ball takes part in what follows: within alpha, "
           "a ball that is farther away cuts nothing off. Neighbours are taken in the order of "
           "their numbers, and each simplex is made once, at its ball of the lowest number. " +
           things(later, "neighbour") + (later == 1 ? " comes" : " come") + " after this ball.";
  }

  std::string discs() const {
    const std::uint64_t made = all(id::kMade), dropped = all(id::kDropped), kept = all(id::kKept),
                        forgotten = all(id::kForgotten);
    if (step_.off) {
      return "The list is short, so the engine does not look for neighbours that can be left "
             "out. " +
             things(kept, "neighbour") + " " + is_or_are(kept) + " left.";
    }
    std::string text =
        "The plane on which this ball and a neighbour have the same power distance cuts a disc out "
        "of the grown ball. They are together in a simplex only if a part of the disc is not "
        "covered by other balls. The " +
        grouped(all(id::kNearest)) +
        " balls whose planes are nearest to the centre are tried as covers. Of " +
        things(made, "disc") + ", " + grouped(dropped) + " " + is_or_are(dropped) +
        " covered by one of them. " + grouped(kept) + " " + is_or_are(kept) + " left.";
    if (dropped == 0) return text;
    return text + (forgotten > 0
                       ? " The centre of this ball is within its power cell, so balls with covered "
                         "discs are not needed at all, and leave the list."
                       : " The centre of this ball may be outside its power cell, so balls with "
                         "covered discs stay in the list: they still cut.");
  }

  std::string edges() const {
    const std::uint64_t tested = all(id::kTested), attached = all(id::kConflict),
                        above = all(id::kAboveAlpha), valid = all(id::kValid),
                        integers = all(id::kIntegers);
    std::string text =
        "The edge to a neighbour has its orthocentre in the middle of the disc. Tested: " +
        things(tested, "edge") + here(id::kTested) + ". " + grouped(attached) + " " +
        has_or_have(attached) +
        " another ball in conflict: its power distance there is not larger. " +
        (attached == 1 ? "It is" : "They are") +
        " attached, and in the complex only as a face of a triangle. " + grouped(valid) + " " +
        has_or_have(valid) + " no ball in conflict and ρ ≤ α: valid.";
    if (above > 0) {
      text += " " + grouped(above) + " " + has_or_have(above) +
              " no ball in conflict and ρ > α, and " + (above == 1 ? "goes" : "go") +
              " no further.";
    }
    if (integers > 0) {
      text += " For " + things(integers, "edge") +
              ", double precision was too near to a tie, and integers decided.";
    }
    return text + who("attaches most");
  }

  std::string triangles() const {
    const std::uint64_t made = all(id::kMade), dropped = all(id::kDropped), kept = all(id::kKept);
    std::string text = "Three balls are a candidate triangle if every two of them meet: " +
                       things(made, "triangle") + ". ";
    if (dropped > 0) {
      text += grouped(dropped) + " of them " + has_or_have(dropped) +
              " an edge that is not in the complex. ";
    }
    return text + things(kept, "triangle") + " " + is_or_are(kept) + " left" + here(id::kKept) +
           ", each with its dual edge.";
  }

  std::string clipping() const {
    const std::uint64_t tested = all(id::kTested), outside = all(id::kOutside),
                        gone = all(id::kConflict), left = all(id::kLeft), band = all(id::kBand);
    if (tested == 0) return "There is no dual edge to clip.";
    std::string text =
        "The points that have the same power distance from three balls lie on a line. The dual "
        "edge is the part of it where no other ball has less; only what is within alpha, in the "
        "grown ball, matters. Clipped: " +
        things(tested, "dual edge") + here(id::kTested) + ". ";
    if (outside > 0) {
      text += grouped(outside) + " " + has_or_have(outside) +
              " no point within alpha, or three centres in line. ";
    }
    text += "Each ball that meets all three cuts, ";
    text += steps_.find(StepKind::discs)->off ? "in the order of their numbers. "
                                              : "those with the nearest planes first. ";
    text += cuts() + grouped(gone) + " " + has_or_have(gone) + " nothing left, " + grouped(left) +
            " " + has_or_have(left) + " two ends. ";
    text += band > 0 ? grouped(band) + (band == 1 ? " is" : " are") +
                           " too near to a tie for double precision, and " +
                           (band == 1 ? "goes" : "go") + " on to kernel III."
                     : "None is too near to a tie for double precision.";
    return text + who("takes the rest of most");
  }
  std::string cuts() const {
    return "Of " + things(all(id::kHeld), "comparison") + " with a ball, " +
           grouped(all(id::kFar)) + " were too far away to cut the rest, and " +
           grouped(all(id::kMoved)) + " moved an end. ";
  }

  std::string exact() const {
    const std::uint64_t tested = all(id::kTested), gone = all(id::kConflict), flat = all(id::kFlat),
                        left = all(id::kLeft);
    if (tested == 0) return "Nothing was left open, so kernel III has nothing to do.";
    std::string text =
        "Integers clip again what double precision leaves open, and the perturbation decides "
        "ties. Clipped: " +
        things(tested, "dual edge") + here(id::kTested) + ". " + grouped(gone) + " " +
        has_or_have(gone) + " nothing left";
    if (flat > 0) text += ", " + grouped(flat) + " " + has_or_have(flat) + " three centres in line";
    return text + ", " + grouped(left) + " " + has_or_have(left) + " two ends." +
           who("takes the rest of most");
  }

  std::string ends() const {
    const std::uint64_t tested = all(id::kTested), above = all(id::kAboveAlpha),
                        in = all(id::kTriangles), attached = all(id::kAttached),
                        tetrahedra = all(id::kTetrahedra);
    if (tested == 0) return "No dual edge is left, so there are no triangles and no tetrahedra.";
    return "A fourth ball ends a dual edge at the orthocentre of a tetrahedron, which is in "
           "the complex if ρ ≤ α. A triangle's own orthocentre is the point of the line that "
           "is "
           "nearest to the centres; the triangle is attached if that is beyond an end. Of " +
           things(tested, "dual edge") + ", " + grouped(in) +
           (in == 1 ? " shows a triangle" : " show triangles") + " of the complex" +
           here(id::kTriangles) + ": " + grouped(in - attached) + " with ρ ≤ α by themselves, " +
           grouped(attached) + " attached to a tetrahedron. " + grouped(above) + " " +
           is_or_are(above) + " above alpha. The ends show " +
           things(tetrahedra, "tetrahedron", "tetrahedra") + " of the complex" +
           here(id::kTetrahedra) + ".";
  }

  std::string vertex() const {
    return all(id::kValid) > 0
               ? "No neighbour has less power distance at the centre of this ball than the ball "
                 "has itself. So the vertex is valid."
               : "At the centre of this ball, a neighbour has no more power distance than the ball "
                 "has itself. So the vertex is attached: it is in the complex if one of its edges "
                 "is.";
  }

  std::string beyond_range() const {
    return "The steps end here: at so large an alpha, numbers leave the range of this engine's "
           "arithmetic, and it makes a triangulation of all balls instead. Choose a smaller "
           "alpha.";
  }
  std::string too_many() const {
    return "The steps end here: this ball has " + things(all(id::kNeighbours), "neighbour") +
           ", and more than " + grouped(kMostDualEdgesOfBall) +
           " dual edges to look at. Choose a smaller alpha.";
  }

  const BallSteps& steps_;
  const Step& step_;
  const BallName& name_;
};

}  // namespace

StepText dual_edge_step_text(const BallSteps& steps, const Step& step, const BallName& name) {
  return Writer(steps, step, name).text();
}

}  // namespace alphascope
