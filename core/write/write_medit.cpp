// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Medit's sections: vertices, edges, triangles and tetrahedra.
#include "core/write/write_medit.hpp"

#include <tuple>
#include <vector>

#include "core/complex/outward_face.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/write/text_writer.hpp"

namespace alphascope {
namespace {

// The number of each ball among the written vertices, from 1; 0: it is in no simplex.
std::vector<std::uint32_t> numbers_of_vertices(const BallSet& balls, const AlphaComplex& complex) {
  std::vector<std::uint32_t> numbers(balls.size());
  const auto note = [&numbers](const auto& list) {
    for (const auto& simplex : list.simplices) {
      for (const BallIndex ball : simplex) numbers[ball] = 1;
    }
  };
  note(complex.vertices);
  note(complex.tetrahedra);
  std::uint32_t count = 0;
  for (std::uint32_t& number : numbers) {
    if (number != 0) number = ++count;
  }
  return numbers;
}

void write_vertices(const BallSet& balls, const std::vector<std::uint32_t>& numbers,
                    TextWriter& text) {
  std::size_t count = 0;
  for (const std::uint32_t number : numbers) count += number != 0;
  text << "Vertices\n" << count;
  text.end_line();
  const int digits = balls.lattice.digits;
  for (std::size_t ball = 0; ball < balls.size(); ++ball) {
    if (numbers[ball] == 0) continue;
    const LatticePoint& p = balls.centres[ball];
    text.lattice(p.x, digits) << " ";
    text.lattice(p.y, digits) << " ";
    text.lattice(p.z, digits) << " " << ball + 1;
    text.end_line();
  }
}

// The balls of a simplex, with those of a tetrahedron in an order that gives it a positive volume.
template <class Simplex>
Simplex oriented(const BallSet& balls, const Simplex& simplex) {
  if constexpr (std::tuple_size_v<Simplex> == 4) {
    const auto face = outward_face(balls, simplex, 0);
    return {simplex[0], face[0], face[1], face[2]};
  }
  return simplex;
}

template <int N>
void write_section(const char* name, const SimplexList<N>& list, const BallSet& balls,
                   const std::vector<std::uint32_t>& numbers, TextWriter& text) {
  if (list.size() == 0) return;
  text << name << "\n" << list.size();
  text.end_line();
  for (std::size_t s = 0; s < list.size(); ++s) {
    for (const BallIndex ball : oriented(balls, list.simplices[s])) {
      text << std::size_t{numbers[ball]} << " ";
    }
    text << (list.classes.empty() ? std::size_t{1} : static_cast<std::size_t>(list.classes[s]) + 1);
    text.end_line();
  }
}

}  // namespace

void write_medit(const BallSet& balls, const AlphaComplex& complex, const ComplexHeader& header,
                 AtomicFile& file, const RunContext& context) {
  TextWriter text(file, context.cancel);
  text << "MeshVersionFormatted 2";
  text.end_line();
  for (const auto& [key, value] : header) {
    text << "# " << key << " ";
    for (const char c : value) text << (c == '\n' || c == '\r' ? " " : std::string_view(&c, 1));
    text.end_line();
  }
  text << "Dimension 3";
  text.end_line();
  const std::vector<std::uint32_t> numbers = numbers_of_vertices(balls, complex);
  write_vertices(balls, numbers, text);
  context.report("writing", 0.3);
  write_section("Edges", complex.edges, balls, numbers, text);
  context.report("writing", 0.5);
  write_section("Triangles", complex.triangles, balls, numbers, text);
  context.report("writing", 0.7);
  write_section("Tetrahedra", complex.tetrahedra, balls, numbers, text);
  text << "End";
  text.end_line();
  text.flush();
}

}  // namespace alphascope
