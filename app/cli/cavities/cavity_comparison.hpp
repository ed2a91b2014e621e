// The same cavities with several radii sets and solvent radii, side by side: how much each depends
// on them.
#pragma once

#include <optional>
#include <vector>

#include "app/cli/cavities/cavity_answer.hpp"
#include "app/cli/report_json.hpp"

namespace alphascope::cli {

// A cavity of the first answer in another one.
struct Counterpart {
  std::optional<std::size_t> row;  // of the other answer; none: it is gone
  bool same = false;               // false: it has joined one that is mostly another cavity
  std::size_t parts = 1;           // 2 or more: it has come apart, and this is the largest share
};

class CavityComparison {
 public:
  // All of the same atoms; the first is what the others are compared with. Throws Cancelled.
  CavityComparison(std::vector<CavityAnswer> answers, const RunContext& context);

  const std::vector<CavityAnswer>& answers() const { return answers_; }
  Counterpart counterpart(std::size_t answer, std::size_t first_row) const;
  // The id of the cavity of the first answer that a row of another one is; 0: none.
  std::size_t first_id(std::size_t answer, std::size_t row) const;
  // Of the SA volumes of a cavity where it is the same: largest less smallest, in the largest's per
  // cent; none where it is in the first answer only.
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

// "castp 1.4": radii set and solvent radius.
std::string variant_text(const CavityAnswer& answer);

void print_comparison(const CavityComparison& comparison, const CavitiesOptions& options);
Json comparison_json(const CavityComparison& comparison, const CavitiesOptions& options);

}  // namespace alphascope::cli
