// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the simplices of a filtration in their order, with the alphas of their classes.
#include "core/write/write_filtration.hpp"

#include <cmath>
#include <vector>

#include "core/complex/alpha_complex.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/triangulation/filtration.hpp"
#include "core/triangulation/filtration_order.hpp"
#include "core/write/text_writer.hpp"

namespace alphascope {
namespace {

class FiltrationText {
 public:
  FiltrationText(const AlphaComplex& complex, const ClassLevelsByDimension& levels,
                 TextWriter& text)
      : complex_(complex), levels_(levels), text_(text) {}

  void write(const SimplexPlace& place) {
    text_ << std::size_t{place.dimension};
    switch (place.dimension) {
      case 0:
        return write_simplex(complex_.vertices, levels_of(levels_.vertices, place.index), place);
      case 1:
        return write_simplex(complex_.edges, levels_of(levels_.edges, place.index), place);
      case 2:
        return write_simplex(complex_.triangles, levels_of(levels_.triangles, place.index), place);
      default: {
        const float value = complex_.tetrahedra.alpha_values[place.index];
        return write_simplex(complex_.tetrahedra, {value, value}, place);
      }
    }
  }

 private:
  static FaceLevels levels_of(const ClassLevels& levels, std::size_t n) {
    return {levels.regular_from[n], levels.interior_from[n]};
  }
  template <int N>
  void write_simplex(const SimplexList<N>& list, const FaceLevels& levels,
                     const SimplexPlace& place) {
    for (const BallIndex vertex : list.simplices[place.index]) text_ << " " << std::size_t{vertex};
    write_level(list.alpha_values[place.index]);
    write_level(levels.regular_from);
    write_level(levels.interior_from);
    text_.end_line();
  }
  void write_level(float value) {
    text_ << " ";
    if (std::isnan(value)) {
      text_ << "-";
    } else {
      text_ << complex_.lattice.square_angstrom(value);
    }
  }

  const AlphaComplex& complex_;
  const ClassLevelsByDimension& levels_;
  TextWriter& text_;
};

}  // namespace

void write_filtration_text(const std::shared_ptr<const BallSet>& balls, const AlphaComplex& complex,
                           const ComplexHeader& header, AtomicFile& file,
                           const RunContext& context) {
  const std::vector<SimplexPlace> order = filtration_order(*balls, complex, context.cancel);
  // The caller keeps the complex.
  const Filtration filtration(balls, {std::shared_ptr<const void>(), &complex}, context);
  TextWriter text(file, context.cancel);
  write_header_and_balls("alphascope-filtration 1", header, *balls, text);
  text << "simplices " << order.size();
  text.end_line();
  FiltrationText simplices(complex, filtration.levels(), text);
  for (std::size_t n = 0; n < order.size(); ++n) {
    if (n % (1 << 16) == 0)
      context.report("writing", static_cast<double>(n) / static_cast<double>(order.size()));
    simplices.write(order[n]);
  }
  text << "end";
  text.end_line();
  text.flush();
}

}  // namespace alphascope
