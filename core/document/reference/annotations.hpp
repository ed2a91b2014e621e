// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations of a picture: labels of atoms, distances and angles between atoms, and marks at
// points in space. They are a setting, so undo and session files include them.
#pragma once

#include "core/document/reference/atom_labels.hpp"
#include "core/document/reference/atom_measurements.hpp"
#include "core/document/reference/placed_marks.hpp"

namespace alphascope {

struct Annotations {
  LabelGroups labels;
  Measurements measurements;
  PlacedMarks marks;
  bool power_diagram = false;  // the borders between the power cells of all balls (core/explain)
  bool empty() const {
    return labels.empty() && measurements.empty() && marks.empty() && !power_diagram;
  }
  friend bool operator==(const Annotations&, const Annotations&) = default;
};

// Words of a command line: `labels` such as "resn HEM=residue; name CA=name", and measurements for
// read_measurement(). Throws SelectionError. Throws std::invalid_argument for an unknown label,
// missing atoms, or more than can be drawn.
struct AnnotationWords {
  std::string labels;
  std::vector<std::string> measurements;
};
Annotations read_annotations(const BallReferences& atoms, const AnnotationWords& words);

}  // namespace alphascope
