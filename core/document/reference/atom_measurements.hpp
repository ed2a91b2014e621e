// Distances and angles that somebody measures between atoms: a list that outlives other options,
// since it holds references.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/reference/ref_set.hpp"

namespace alphascope {

class BallReferences;
struct Molecule;

// Of two atoms their distance, of three the angle at the second, of four the dihedral angle about
// the line from the second to the third. The order counts, and an atom may be there twice.
struct Measurement {
  std::vector<AtomRef> atoms;  // 2 to 4
  friend bool operator==(const Measurement&, const Measurement&) = default;
};
using Measurements = std::vector<Measurement>;  // in the order of measuring
inline constexpr std::size_t kMostMeasurements = 1000;

const char* measurement_name(const Measurement& m);  // "distance", "angle", "dihedral angle"
const char* measurement_unit(const Measurement& m);  // "Å", "°"

struct Measured {
  std::vector<std::size_t> atoms;  // of the molecule, by index
  // Å or degrees (core/measure/angles.hpp); none: undefined, since points coincide or are on a
  // line.
  std::optional<double> value;
};
// None: the molecule lacks one of the atoms, since it is another assembly.
std::optional<Measured> measured(const Molecule& molecule, const Measurement& m);

// From addresses with semicolons between them, "A:HIS 87:NE2; A:HEM 142:FE", each of one atom.
// Throws std::invalid_argument with a sentence, SelectionError for an address that cannot be read.
Measurement read_measurement(const BallReferences& atoms, std::string_view text);

// Two to four atoms, or a sentence that says why there are none.
struct AskedMeasurement {
  std::optional<Measurement> measurement;
  std::string why_not;
};
// What a selection asks for: an edge, or atoms in the order in which they were selected.
AskedMeasurement asked_measurement(const Selection& selection);

// A table with all digits: number, kind, value, unit and the addresses of the atoms. A value that
// is undefined, or of atoms that the molecule lacks, is left empty.
std::string measurements_csv(const Molecule& molecule, const Measurements& measurements);

}  // namespace alphascope
