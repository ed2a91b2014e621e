// SPDX-License-Identifier: GPL-3.0-or-later
// The columns of a comparison of cavities: variants, cavities side by side, and their counterparts.
#pragma once

#include <cstddef>
#include <span>

#include "app/cli/cavities/cavity_comparison.hpp"
#include "core/document/tables/column.hpp"

namespace alphascope::cli {

// An answer of the comparison.
struct ComparedVariant {
  const CavityComparison& all;
  std::size_t answer = 0;
};
std::span<const Column<ComparedVariant>> variant_columns();

// A cavity of the first answer.
struct ComparedCavity {
  const CavityComparison& all;
  std::size_t first_row = 0;
};
std::span<const Column<ComparedCavity>> compared_cavity_columns();

// The match of a first answer's cavity in another answer. These columns are the list "in" of the
// JSON.
struct ComparedCounterpart {
  const CavityComparison& all;
  std::size_t answer = 0, first_row = 0;
};
std::span<const Column<ComparedCounterpart>> counterpart_columns();

}  // namespace alphascope::cli
