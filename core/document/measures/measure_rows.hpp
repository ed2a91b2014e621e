// SPDX-License-Identifier: GPL-3.0-or-later
// Areas and volumes as rows of a table, by component, chain, residue or atom. The window, CSV and
// JSON use the same rows.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/document/measures/measure_query.hpp"
#include "core/document/measures/measure_results.hpp"

namespace alphascope {

struct Answer;

struct MeasureRow {
  std::string name;  // "A:HIS 87"; a component has the name of its first atom
  std::uint32_t group = 0, first_ball = 0, atoms = 0;
  PerQuantity<double> of = {};                    // Å to power_of_length()
  double exposed_share = 0;                       // share of the area of its whole spheres, 0 to 1
  double share_of_area = 0, share_of_volume = 0;  // shares of the total
};

struct MeasureRows {
  MeasureQuery query;
  std::vector<MeasureRow> rows;
  std::size_t all = 0;                                  // number of rows without the filter
  std::vector<std::uint32_t> group_of_ball;             // MeasureRow::group, or kNoGroup
  std::shared_ptr<const UnionDerivatives> derivatives;  // null unless asked for
};

// `atom_of_ball` as in PreparedBalls. Throws Cancelled.
MeasureRows make_measure_rows(const MeasureQuery& query, const Molecule& molecule,
                              const std::vector<std::uint32_t>& atom_of_ball,
                              const MeasuredComplex& measured,
                              std::shared_ptr<const UnionDerivatives> derivatives,
                              const RunContext& context = {});

// Rows for the complex of `answer`, which must be the one on screen.
Definition<MeasureRows> measure_rows(const MeasureQuery& query,
                                     const std::shared_ptr<const Answer>& answer);

}  // namespace alphascope
