// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences on the steps of the tuple engine, and on steps that every engine has.
#include "core/document/explain/steps_text.hpp"

#include <iterator>

#include "core/document/explain/step_words.hpp"
#include "core/geometry/shortest_number.hpp"
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
      case StepKind::left_out:
        return {"Left out", "takes no part", left_out()};
      case StepKind::grid:
        return {"Grid", things(all(id::kCells), "cell"), grid()};
      case StepKind::cube:
        return {"Kernel I: neighbours", things(all(id::kNeighbours), "neighbour"), cube()};
      case StepKind::pairs:
        return {"Kernel I: pairs", left_of(step_), pairs()};
      case StepKind::triples:
        return {"Kernel I: triples", left_of(step_), larger("third", "pair", "triple")};
      case StepKind::tuples:
        return {"Kernel I: 4-tuples", left_of(step_), larger("fourth", "triple", "4-tuple")};
      case StepKind::alpha:
        return {"Kernel I: alpha optimisation", left_of(step_), alpha()};
      case StepKind::places:
        return {"Prefix sum", things(step_.count(id::kKept).here, "place"), places()};
      case StepKind::filter:
        return {"Kernel II",
                grouped(all(id::kValid)) + " valid, " + grouped(all(id::kBand)) + " open",
                filter()};
      case StepKind::exact:
        return {"Kernel III",
                grouped(all(id::kValid)) + " of " + grouped(all(id::kTested)) + " valid", exact()};
      case StepKind::faces:
        return {"Pairs and triples",
                grouped(all(id::kEdges)) + " and " + grouped(all(id::kTriangles)) + " valid",
                faces()};
      case StepKind::too_many:
        return {"Stopped", "too many tuples", too_many()};
      default:
        break;
    }
    return {"Result", things(all(id::kTetrahedra), "tetrahedron", "tetrahedra"), result()};
  }

 private:
  std::uint64_t all(std::string_view what) const { return step_.count(what).all; }
  std::string the_ball() const {
    return "ball " + std::to_string(steps_.ball) + " (" + name_(steps_.ball) + ")";
  }
  std::string made_here(std::string_view what) const {
    return alphascope::made_here(step_.count(what));
  }

  std::string left_out() const {
    const std::string others =
        " The grid holds " + things(all(id::kBalls), "ball") + " without it.";
    if (steps_.left_out == LeftOutReason::hidden) {
      return "Another ball has the same centre as " + the_ball() +
             ", and is larger or comes first. So this one has no place of its own in space and is "
             "left out." +
             others;
    }
    return "At alpha = " +
           shortest_number(steps_.lattice.alpha_angstrom2(steps_.alpha_on_lattice)) + " Å², " +
           the_ball() + " has shrunk to nothing: r² + α is negative. It is left out." + others;
  }

  std::string grid() const {
    const RealPoint size = step_.boxes[0].high_angstrom - step_.boxes[0].low_angstrom;
    const std::uint64_t others = all(id::kInCell) - 1;
    return "Space is cut into cells, so that the neighbours of a ball can be found without looking "
           "at all balls. Here " +
           things(all(id::kCells), "cell") + " of " + short_number(size.x) + " × " +
           short_number(size.y) + " × " + short_number(size.z) + " Å " +
           (all(id::kCells) == 1 ? "holds " : "hold ") + things(all(id::kBalls), "ball") +
           ". In the cell of " + the_ball() + " there " + is_or_are(others) + " " +
           (others == 0 ? "no other ball" : things(others, "other ball")) +
           ". Balls are sorted by cell; this one comes as number " + grouped(all(id::kPlace) + 1) +
           ".";
  }

  std::string cube() const {
    const std::uint64_t found = all(id::kNeighbours);
    return "With alpha, balls grow to √(r² + α). All balls that can then meet this one have their "
           "centres in a cube around it. It reaches " +
           short_number(step_.length_angstrom) +
           " Å to each side: the grown radius of this ball plus the largest of all. The cube lies "
           "in " +
           things(all(id::kCellsSearched), "cell") + " with " +
           things(all(id::kBallsTested), "other ball") + "; " + grouped(found) + " of them " +
           is_or_are(found) + " in the cube. These are the neighbours.";
  }

  std::string pairs() const {
    const std::uint64_t dropped = all(id::kDropped), kept = all(id::kKept);
    std::string text =
        step_.off
            ? "The edge optimisation is off: all " + things(kept, "pair") +
                  " of this ball and a neighbour are kept, although some of these balls do not "
                  "meet."
            : "In a simplex of the complex every two grown balls meet. Of " +
                  things(all(id::kMade), "neighbour") + ", " + grouped(dropped) + " do" +
                  (dropped == 1 ? "es" : "") +
                  " not meet this ball, even when all have grown. The edge optimisation drops "
                  "them. " +
                  things(kept, "pair") + " " + is_or_are(kept) + " left.";
    const StepCount& count = step_.count(id::kKept);
    if (count.here == count.all) return text;
    return text +
           " Each tuple is made once, at the one of its balls that comes first in the grid. "
           "For " +
           things(count.here, "pair") + " that is this ball.";
  }

  std::string larger(const std::string& nth, const std::string& base,
                     const std::string& tuple) const {
    const std::uint64_t made = all(id::kMade), dropped = all(id::kDropped), kept = all(id::kKept);
    std::string text = "A " + nth + " ball joins each " + base + ": " + things(made, tuple) + ". ";
    if (step_.off) {
      return text + "The edge optimisation is off, so all are kept" + made_here(id::kKept) + ".";
    }
    text += "In " + grouped(dropped) +
            " of them it does not meet all the others. The edge "
            "optimisation drops these. ";
    return text + things(kept, tuple) + " " + is_or_are(kept) + " left" + made_here(id::kKept) +
           ".";
  }

  std::string alpha() const {
    const std::uint64_t dropped = all(id::kDropped), kept = all(id::kKept);
    const std::string onward = things(kept, "4-tuple") + (kept == 1 ? " goes" : " go") +
                               " on to kernel II" + made_here(id::kKept) + ".";
    if (step_.off) return "The alpha optimisation is off. " + onward;
    return "There is one point with the same power distance from all four balls, the orthocentre. "
           "That power distance is ρ. A tetrahedron needs ρ ≤ α. The alpha optimisation drops " +
           things(dropped, "4-tuple") + " with ρ > α, as far as single precision is certain. " +
           onward;
  }

  std::string places() const {
    std::string text =
        "A GPU works on many balls at a time, so each must know where to write its 4-tuples. The "
        "thesis reserves room for as many as there could be, here " +
        grouped(all(id::kReserved)) +
        ". Alphascope first counts how many each triple makes. The sum of the counts before a "
        "triple is its place.";
    if (step_.count(id::kKept).here == 0) return text + " This ball itself makes none.";
    for (const StepPlace& place : step_.places) {
      text += " Balls " + std::to_string(place.triple[0]) + ", " + std::to_string(place.triple[1]) +
              ", " + std::to_string(place.triple[2]) + ": ";
      text += place.tuples == 0   ? "none."
              : place.tuples == 1 ? "1, place " + grouped(place.place) + "."
                                  : grouped(place.tuples) + ", places " + grouped(place.place) +
                                        " to " + grouped(place.place + place.tuples - 1) + ".";
    }
    return text + " And so on: " + things(step_.count(id::kKept).here, "place") + " in all.";
  }

  std::string conflicts() const {
    const std::uint64_t conflict = all(id::kConflict), above = all(id::kAboveAlpha);
    std::string text =
        grouped(conflict) + " of them " + has_or_have(conflict) + " another ball in conflict";
    if (above > 0) text += ", and " + grouped(above) + " " + has_or_have(above) + " ρ > α";
    return text + ". ";
  }
  std::string who_removes() const {
    if (step_.removers.empty()) return "";
    const StepConflict& most = step_.removers.front();
    return " Ball " + std::to_string(most.ball) + " (" + name_(most.ball) + ") ends most, " +
           grouped(most.simplices) + ".";
  }

  std::string filter() const {
    const std::uint64_t tested = all(id::kTested), valid = all(id::kValid), band = all(id::kBand);
    if (tested == 0) return "There is no 4-tuple to test.";
    std::string text =
        "Four balls make a tetrahedron of the triangulation if no other ball is in conflict: none "
        "has less power distance at the orthocentre than they have. Single precision decides, "
        "where its error bound allows. Tested: " +
        things(tested, "4-tuple") + made_here(id::kTested) + ". " + conflicts() + grouped(valid) +
        " " + is_or_are(valid) + " valid.";
    if (band > 0) {
      text += " " + grouped(band) + (band == 1 ? " is" : " are") +
              " too near to a tie to say: they are in the band, and go on to kernel III.";
    } else {
      text += " None is too near to a tie to say.";
    }
    return text + who_removes();
  }

  std::string exact() const {
    const std::uint64_t tested = all(id::kTested), valid = all(id::kValid), flat = all(id::kFlat);
    if (tested == 0) return "No 4-tuple is in the band, so kernel III has nothing to do.";
    std::string text =
        "Integers decide the tuples that kernel II leaves open, and the perturbation decides "
        "ties. Tested: " +
        things(tested, "4-tuple") + made_here(id::kTested) + ". " + conflicts();
    if (flat > 0) {
      text += grouped(flat) + " " + has_or_have(flat) +
              " four centres in one plane, so no orthocentre. ";
    }
    return text + grouped(valid) + " " + is_or_are(valid) + " valid." + who_removes();
  }

  std::string faces() const {
    const std::uint64_t band = all(id::kLowerBand);
    return "The thesis stops at tetrahedra. Alphascope tests the ball itself, its pairs and its "
           "triples in the same way: " +
           things(all(id::kTested), "test") + ", " + grouped(band) + " of them also in integers. " +
           things(all(id::kVertices), "vertex", "vertices") + ", " +
           things(all(id::kEdges), "edge") + " and " + things(all(id::kTriangles), "triangle") +
           " have no ball in conflict and ρ ≤ α.";
  }

  std::string too_many() const {
    return "The steps end here: there are more than " + grouped(kMostTuplesOfBall) +
           " 4-tuples of this ball to look at, and could be " + grouped(all(id::kMade)) +
           ". Choose a smaller alpha" +
           (steps_.options.edge_optimisation ? "." : ", or switch the edge optimisation on.");
  }

  std::string result() const {
    const std::uint64_t attached = all(id::kAttached);
    if (all(id::kVertices) == 0) {
      return "Nothing of this ball is valid: no place in space is nearer to it, by power distance, "
             "than to all others. It is in no simplex of the alpha complex.";
    }
    std::string text = "With what is valid, all its faces are in the complex. So " + the_ball() +
                       " is a vertex of the alpha complex, and part of " +
                       things(all(id::kEdges), "edge") + ", " +
                       things(all(id::kTriangles), "triangle") + " and " +
                       things(all(id::kTetrahedra), "tetrahedron", "tetrahedra") + ". ";
    if (attached == 0) return text + "All of them are valid by themselves.";
    return text + grouped(attached) +
           (attached == 1 ? " of these is not valid by itself, only a face of a larger one."
                          : " of these are not valid by themselves, only faces of larger ones.");
  }

  const BallSteps& steps_;
  const Step& step_;
  const BallName& name_;
};

}  // namespace

StepText step_text(const BallSteps& steps, const Step& step, const BallName& name) {
  const bool common = step.kind == StepKind::left_out || step.kind == StepKind::grid ||
                      step.kind == StepKind::result;
  if (steps.engine == StepsEngine::dual_edges && !common) {
    return dual_edge_step_text(steps, step, name);
  }
  return Writer(steps, step, name).text();
}

const char* steps_engine_id(StepsEngine engine) {
  return engine == StepsEngine::tuples ? "tuples" : "dual_edges";
}

const char* step_id(StepKind kind) {
  static constexpr const char* kIds[] = {
      "left_out",  "grid",     "cube",  "pairs",  "triples",      "tuples",   "alpha",
      "places",    "filter",   "exact", "faces",  "neighbours",   "discs",    "edges",
      "triangles", "clipping", "ends",  "vertex", "beyond_range", "too_many", "result"};
  static_assert(std::size(kIds) == static_cast<std::size_t>(StepKind::result) + 1);
  return kIds[static_cast<std::size_t>(kind)];
}

}  // namespace alphascope
