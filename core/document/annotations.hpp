// What somebody writes into the picture: labels of atoms, and distances and angles between them. A
// setting: undo, and a session file, know it.
#pragma once

#include "core/document/atom_labels.hpp"
#include "core/document/atom_measurements.hpp"

namespace alphascope {

struct Annotations {
  LabelGroups labels;
  Measurements measurements;
  bool empty() const { return labels.empty() && measurements.empty(); }
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
