// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of names for counts, boxes and marks of steps.
#include "core/document/explain/step_names.hpp"

#include <algorithm>
#include <utility>

#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

namespace id = step_count;

constexpr std::pair<std::string_view, const char*> kCounts[] = {
    {id::kBalls, "balls in the grid"},
    {id::kCells, "cells"},
    {id::kPlace, "balls before it"},
    {id::kInCell, "balls in its cell"},
    {id::kCellsSearched, "cells searched"},
    {id::kBallsTested, "balls looked at"},
    {id::kNeighbours, "neighbours"},
    {id::kMade, "made"},
    {id::kDropped, "dropped"},
    {id::kKept, "kept"},
    {id::kTested, "tested"},
    {id::kConflict, "in conflict"},
    {id::kAboveAlpha, "ρ > α"},
    {id::kFlat, "in one plane"},
    {id::kValid, "valid"},
    {id::kBand, "in the band"},
    {id::kLowerBand, "in the band"},
    {id::kReserved, "could be"},
    {id::kVertices, "vertices"},
    {id::kEdges, "edges"},
    {id::kTriangles, "triangles"},
    {id::kTetrahedra, "tetrahedra"},
    {id::kAttached, "attached"},
};

// Names of marks where "kept" and "dropped" would be unclear.
constexpr std::pair<std::pair<StepKind, StepMark>, const char*> kMarks[] = {
    {{StepKind::grid, StepMark::kept}, "in its cell"},
    {{StepKind::cube, StepMark::kept}, "in the cube"},
    {{StepKind::cube, StepMark::dropped}, "outside"},
    {{StepKind::filter, StepMark::kept}, "valid"},
    {{StepKind::filter, StepMark::dropped}, "not valid"},
    {{StepKind::filter, StepMark::undecided}, "in the band"},
    {{StepKind::exact, StepMark::kept}, "valid"},
    {{StepKind::exact, StepMark::dropped}, "not valid"},
    {{StepKind::faces, StepMark::kept}, "valid"},
    {{StepKind::result, StepMark::kept}, "in the complex"},
};

}  // namespace

std::string step_count_name(std::string_view count) {
  for (const auto& [known, name] : kCounts) {
    if (known == count) return name;
  }
  std::string name(count);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

const char* step_mark_name(StepKind kind, StepMark mark) {
  for (const auto& [of, name] : kMarks) {
    if (of == std::pair(kind, mark)) return name;
  }
  switch (mark) {
    case StepMark::chosen:
      return "the ball";
    case StepMark::kept:
      return "kept";
    case StepMark::dropped:
      return "dropped";
    case StepMark::undecided:
      break;
  }
  return "undecided";
}

const char* step_box_name(StepKind kind, StepMark mark) {
  if (kind == StepKind::grid) return "its cell";
  if (kind == StepKind::cube) {
    return mark == StepMark::kept ? "the cube" : "cells that the cube meets";
  }
  return mark == StepMark::chosen ? "its box" : "box";
}

}  // namespace alphascope
