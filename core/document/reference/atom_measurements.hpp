// SPDX-License-Identifier: GPL-3.0-or-later
// Distances and angles between atoms that the user measures. The list keeps references, so it stays
// valid under other options.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/reference/ref_set.hpp"

namespace alphascope {

class BallReferences;
struct Molecule;

// Two atoms have a distance, three an angle at the second. Four have a dihedral angle about the
// line from the second to the third. Their order counts, and an atom may occur twice.
struct Measurement {
  std::vector<AtomRef> atoms;  // 2 to 4
  friend bool operator==(const Measurement&, const Measurement&) = default;
};
using Measurements = std::vector<Measurement>;  // in the order in which they were made
inline constexpr std::size_t kMostMeasurements = 1000;

const char* measurement_name(const Measurement& m);  // "distance", "angle", "dihedral angle"
const char* measurement_unit(const Measurement& m);  // "Å", "°"

struct Measured {
  std::vector<std::size_t> atoms;  // indices into the molecule's atoms
  // Å or degrees (core/measure/angles.hpp). Empty if undefined, because points coincide or lie on a
  // line.
  std::optional<double> value;
};
// Empty if this molecule lacks one of the atoms, since it is another assembly.
std::optional<Measured> measured(const Molecule& molecule, const Measurement& m);

// Reads addresses with semicolons between them, "A:HIS 87:NE2; A:HEM 142:FE". Each must name one
// atom. Throws std::invalid_argument with a sentence, and SelectionError for an invalid address.
Measurement read_measurement(const BallReferences& atoms, std::string_view text);

// Two to four atoms, or a sentence with the reason why there are none.
struct SelectedMeasurement {
  std::optional<Measurement> measurement;
  std::string why_not;
};
// The measurement for a selection: an edge, or atoms in the order of their selection.
SelectedMeasurement selected_measurement(const Selection& selection);

}  // namespace alphascope
