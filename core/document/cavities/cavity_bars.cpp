// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts lives of cavities by length, and writes them as text and CSV.
#include "core/document/cavities/cavity_bars.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/cavity/cavity_lives.hpp"
#include "core/chart/readable_number.hpp"
#include "core/complex/triangulation.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/write/csv.hpp"

namespace alphascope {
namespace {

CavityBar bar_of(std::uint32_t sink, const CavityLife& life, const Lattice& lattice) {
  return {sink, lattice.square_angstrom(life.born), lattice.square_angstrom(life.closed),
          lattice.square_angstrom(life.gone)};
}

std::string angstrom2_text(double value) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.2f", value);
  return readable_number(digits) + " Å²";
}

const Column<CavityLifeRow> kColumns[] = {
    {.id = "born_alpha_angstrom2",
     .title = "born at",
     .unit = "Å²",
     .help = "The α from which on it is a cavity of its own. It is empty if it is one at every "
             "lower α.",
     .value = [](const CavityLifeRow& r) -> CellValue { return r.bar.born_angstrom2; },
     .files = InFiles::csv},
    {.id = "closed_alpha_angstrom2",
     .title = "closed at",
     .unit = "Å²",
     .help = "The α from which on it is a void. It is empty if the cavity never closes.",
     .value =
         [](const CavityLifeRow& r) {
           return r.bar.is_ever_void() ? CellValue(r.bar.closed_angstrom2) : CellValue();
         },
     .files = InFiles::csv},
    {.id = "gone_alpha_angstrom2",
     .title = "gone at",
     .unit = "Å²",
     .help = "The α at which its deepest point is filled, and it is gone.",
     .value = [](const CavityLifeRow& r) -> CellValue { return r.bar.gone_angstrom2; },
     .files = InFiles::csv},
    {.id = "name",
     .title = "name",
     .help = "The four atoms around the deepest point, as in the table of cavities.",
     .value = [](const CavityLifeRow& r) -> CellValue {
       return sink_name(r.references, r.triangulation.tetrahedra[r.bar.sink]);
     },
     .files = InFiles::csv}};

}  // namespace

CavityBars longest_bars(const CavityLives& lives, const Lattice& lattice, double from_angstrom2,
                        std::size_t most) {
  // Only bars that are kept are converted; there may be hundreds of thousands.
  struct Length {
    double square_units;
    std::size_t life;
  };
  const double from = lattice.alpha_on_lattice(from_angstrom2).nearest();
  std::vector<Length> lengths;
  CavityBars bars;
  for (std::size_t k = 0; k < lives.lives.size(); ++k) {
    const CavityLife& life = lives.lives[k];
    if (life.born < life.gone) ++bars.all;
    const double length = life.gone - std::max<double>(life.born, from);
    if (length > 0) lengths.push_back({length, k});
  }
  const std::size_t kept = std::min(most, lengths.size());
  std::partial_sort(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(kept),
                    lengths.end(), [&](const Length& a, const Length& b) {
                      return a.square_units != b.square_units
                                 ? a.square_units > b.square_units
                                 : lives.places[a.life] < lives.places[b.life];
                    });
  for (std::size_t n = 0; n < kept; ++n) {
    const std::size_t k = lengths[n].life;
    bars.longest.push_back(bar_of(lives.sinks[k], lives.lives[k], lattice));
  }
  return bars;
}

double alpha_within(const CavityBar& bar, double from_angstrom2) {
  const double from = std::max(bar.born_angstrom2, from_angstrom2);
  const double middle = from + (bar.gone_angstrom2 - from) / 2;
  const double rounded = std::round(middle * 100) / 100;
  return bar.is_at(rounded) && rounded >= from ? rounded : middle;
}

std::string bar_text(const CavityBar& bar) {
  const bool closes = bar.is_ever_void();
  std::string text;
  if (bar.born_angstrom2 < bar.closed_angstrom2) {
    text = "a pocket ";
    text += std::isfinite(bar.born_angstrom2) ? "from " + angstrom2_text(bar.born_angstrom2)
                                              : std::string("at every smaller alpha");
  }
  if (closes)
    text += (text.empty() ? "" : ", ") + ("a void from " + angstrom2_text(bar.closed_angstrom2));
  return text + ", filled at " + angstrom2_text(bar.gone_angstrom2);
}

std::span<const Column<CavityLifeRow>> life_columns() {
  return kColumns;
}

std::string bars_csv(const std::vector<CavityBar>& bars, const Triangulation& triangulation,
                     const BallReferences& references, const std::vector<std::string>& comments) {
  std::string text = csv_comments(comments) + csv_heading(life_columns());
  for (const CavityBar& bar : bars) {
    text += csv_values(csv_row_of(life_columns(), {bar, triangulation, references}));
  }
  return text;
}

}  // namespace alphascope
