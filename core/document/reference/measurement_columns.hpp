// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of measured distances and angles, for the window, CSV and docs.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/document/reference/atom_measurements.hpp"

namespace alphascope {

template <class Row>
struct Column;

struct MeasurementRow {
  const Molecule& molecule;
  const Measurement& measurement;
  std::size_t number = 1;  // in the list
  std::optional<Measured> of = measured(molecule, measurement);
};
std::span<const Column<MeasurementRow>> measurement_columns();

// A CSV table with all digits. A value is empty if it is undefined, or if the molecule lacks an
// atom. Without measurements the text is empty.
std::string measurements_csv(const Molecule& molecule, const Measurements& measurements);

}  // namespace alphascope
