// SPDX-License-Identifier: GPL-3.0-or-later
// A program that uses the installed library: the complex of a file, its areas and its volumes.
//   user FILE ALPHA    (ALPHA in Å²)
#include <alphascope/engine/engine.hpp>
#include <alphascope/measure/union_measures.hpp>
#include <alphascope/read/read_molecule.hpp>
#include <alphascope/selection/prepare_balls.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int count, char** words) {
  if (count != 3) {
    std::fprintf(stderr, "usage: user FILE ALPHA\n");
    return 1;
  }
  try {
    const auto balls = alphascope::prepare_balls(alphascope::read_molecule(words[1])).balls;
    const auto engine = alphascope::make_cpu_engine(balls);
    const alphascope::AlphaComplex complex = engine->compute({std::atof(words[2])}, {});
    const alphascope::UnionMeasures measures = alphascope::measure_union(*balls, complex);
    std::printf("tetrahedra  %zu\n", complex.tetrahedra.size());
    std::printf("hash        %016llx\n", static_cast<unsigned long long>(complex.hash));
    std::printf("area        %.4f\n", measures.area_angstrom2());
    std::printf("volume      %.4f\n", measures.volume_angstrom3());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
