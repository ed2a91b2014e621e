// Sorts lives of cavities by length, and writes them as text and CSV.
#include "core/document/cavities/cavity_bars.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/chart/readable_number.hpp"
#include "core/document/cavities/cavity_names.hpp"
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

CsvRow csv_row(const CavityBar& bar, const std::string& name) {
  return {{"born_alpha_angstrom2", finite_digits(bar.born_angstrom2)},
          {"closed_alpha_angstrom2", bar.is_ever_void() ? finite_digits(bar.closed_angstrom2) : ""},
          {"gone_alpha_angstrom2", finite_digits(bar.gone_angstrom2)},
          {"name", name}};
}

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

std::string bars_csv(const std::vector<CavityBar>& bars, const Triangulation& triangulation,
                     const BallReferences& references, const std::vector<std::string>& comments) {
  std::string text = csv_comments(comments) + csv_names(csv_row({}, {}));
  for (const CavityBar& bar : bars) {
    text += csv_values(csv_row(bar, sink_name(references, triangulation.tetrahedra[bar.sink])));
  }
  return text;
}

}  // namespace alphascope
