// What somebody writes into the picture: labels of atoms, distances and angles between them, and
// marks at places of space. A setting: undo, and a session file, know it.
#pragma once

#include "core/document/reference/atom_labels.hpp"
#include "core/document/reference/atom_measurements.hpp"
#include "core/document/reference/placed_marks.hpp"

namespace alphascope {

struct Annotations {
  LabelGroups labels;
  Measurements measurements;
  PlacedMarks marks;
  bool power_diagram = false;  // the borders between the cells of all balls (core/explain)
  bool empty() const {
    return labels.empty() && measurements.empty() && marks.empty() && !power_diagram;
  }
  friend bool operator==(const Annotations&, const Annotations&) = default;
};

// The words of a command line: `labels` as "resn HEM=residue; name CA=name", and measurements as
// read_measurement() takes them. Throws SelectionError, and std::invalid_argument for a label that
// is none, atoms that are not there, or more than is drawn.
struct AnnotationWords {
  std::string labels;
  std::vector<std::string> measurements;
};
Annotations read_annotations(const BallReferences& atoms, const AnnotationWords& words);

}  // namespace alphascope
