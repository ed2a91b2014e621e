// SPDX-License-Identifier: GPL-3.0-or-later
// Writes complexes in the layouts of Alphascope and ParallelAC.
#include "core/write/write_complex.hpp"

#include <cstdio>

#include "core/complex/alpha_complex.hpp"
#include "core/complex/face_class.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/ball_index.hpp"
#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/write/text_writer.hpp"

namespace alphascope {
namespace {

const char* class_letter(SimplexClass c) {
  switch (c) {
    case SimplexClass::singular:
      return "s";
    case SimplexClass::regular:
      return "r";
    case SimplexClass::interior:
      return "i";
  }
  return "?";
}

template <int N>
void write_list(const char* name, const SimplexList<N>& list, const AlphaComplex& complex,
                TextWriter& text) {
  text << name << " " << list.size();
  text.end_line();
  for (std::size_t s = 0; s < list.size(); ++s) {
    for (const BallIndex vertex : list.simplices[s]) text << std::size_t{vertex} << " ";
    text << complex.lattice.square_angstrom(list.alpha_values[s]);
    if (!complex.tetrahedra_only) text << " " << class_letter(list.classes[s]);
    text.end_line();
  }
}

}  // namespace

void write_header_and_balls(std::string_view format, const ComplexHeader& header,
                            const BallSet& balls, TextWriter& text) {
  text << format;
  text.end_line();
  for (const auto& [key, value] : header) {
    text << key << " ";
    for (const char c : value) text << (c == '\n' || c == '\r' ? " " : std::string_view(&c, 1));
    text.end_line();
  }
  text << "balls " << balls.size();
  text.end_line();
  const int digits = balls.lattice.digits;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    text.lattice(p.x, digits) << " ";
    text.lattice(p.y, digits) << " ";
    text.lattice(p.z, digits) << " ";
    text.lattice(balls.radii[i], digits);
    text.end_line();
  }
}

void write_complex_text(const BallSet& balls, const AlphaComplex& complex,
                        const ComplexHeader& header, AtomicFile& file, const RunContext& context) {
  TextWriter text(file, context.cancel);
  write_header_and_balls("alphascope-complex 1", header, balls, text);
  const auto section = [&](const char* name, const auto& list, double share) {
    context.report("writing", share);
    write_list(name, list, complex, text);
  };
  section("vertices", complex.vertices, 0.1);
  section("edges", complex.edges, 0.2);
  section("triangles", complex.triangles, 0.4);
  section("tetrahedra", complex.tetrahedra, 0.8);
  text << "end";
  text.end_line();
  text.flush();
}

void write_parallelac_text(const BallSet& balls, const AlphaComplex& complex, AtomicFile& file,
                           const RunContext& context) {
  TextWriter text(file, context.cancel);
  text << balls.size() << " " << complex.edges.size() << " " << complex.triangles.size() << " "
       << complex.tetrahedra.size();
  text.end_line();
  char buffer[400];
  const auto place = [&](std::int32_t units) { return balls.lattice.angstrom(units); };
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const LatticePoint& p = balls.centres[i];
    std::snprintf(buffer, sizeof buffer, "%9.5f %9.5f %9.5f %9.5f", place(p.x), place(p.y),
                  place(p.z), place(balls.radii[i]));
    text << buffer;
    text.end_line();
  }
  const auto section = [&](const auto& list, double share) {
    context.report("writing", share);
    for (const auto& simplex : list.simplices) {
      for (std::size_t n = 0; n < simplex.size(); ++n) {
        std::snprintf(buffer, sizeof buffer, n == 0 ? "%9u" : " %9u", simplex[n]);
        text << buffer;
      }
      text.end_line();
    }
  };
  section(complex.edges, 0.2);
  section(complex.triangles, 0.4);
  section(complex.tetrahedra, 0.8);
  text.flush();
}

}  // namespace alphascope
