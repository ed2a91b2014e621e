// SPDX-License-Identifier: GPL-3.0-or-later
// The same cavities with several radii sets and solvent radii, side by side, and their spread.
#pragma once

#include <optional>
#include <vector>

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/report_json.hpp"

namespace alphascope::cli {

// The counterpart of the first answer's cavity in another answer.
struct Counterpart {
  std::optional<std::size_t> row;  // row in the other answer; none: the cavity is gone
  bool same = false;               // false: `row` is a cavity that mostly comes from another one
  std::size_t parts = 1;           // 2 or more: it has split, and `row` is its largest part
};

class CavityComparison {
 public:
  // All answers have the same atoms. The others are compared with the first. Throws Cancelled.
  CavityComparison(std::vector<CavityAnswer> answers, const RunContext& context);

  const std::vector<CavityAnswer>& answers() const { return answers_; }
  Counterpart counterpart(std::size_t answer, std::size_t first_row) const;
  // Id of the first answer's cavity that matches a row of another answer; 0: none.
  std::size_t first_id(std::size_t answer, std::size_t row) const;
  // Spread of a cavity's SA volume in per cent: (largest - smallest) / largest. Only answers in
  // which the cavity is the same count. None if it is in the first answer only.
  std::optional<double> spread_percent(std::size_t first_row) const;

 private:
  struct Match {
    std::vector<Counterpart> of_first;   // by row
    std::vector<std::size_t> first_ids;  // by row
  };
  static Match match(const CavityAnswer& first, const CavityAnswer& other,
                     const CancelToken& cancel);

  std::vector<CavityAnswer> answers_;
  std::vector<Match> matches_;  // of each answer
};

// Radii set and solvent radius, such as "castp 1.4".
std::string variant_text(const CavityAnswer& answer);

void print_comparison(const CavityComparison& comparison, const CavitiesOptions& options);
Json comparison_json(const CavityComparison& comparison, const CavitiesOptions& options);

}  // namespace alphascope::cli
