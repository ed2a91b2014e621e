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

}  // namespace alphascope
