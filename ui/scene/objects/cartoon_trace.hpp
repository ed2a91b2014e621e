// SPDX-License-Identifier: GPL-3.0-or-later
// The line that a cartoon follows: a point for each residue of a chain without gaps. Pure C++; no
// VTK.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/molecule/rgb8.hpp"
#include "core/secondary/nucleotides.hpp"
#include "core/secondary/secondary.hpp"
#include "ui/scene/objects/base_plate.hpp"

namespace alphascope {

enum class TraceShape : std::uint8_t { coil, helix, strand, nucleic };

struct TracePoint {
  RealPoint at;    // Å, relative to BallGeometry::origin
  RealPoint side;  // of length 1: the direction of a ribbon's width
  TraceShape shape = TraceShape::coil;
  std::uint32_t atom = 0;  // index in Molecule::atoms: CA, or the nucleotide's backbone
  Rgb8 colour;
};
using Trace = std::vector<TracePoint>;  // at least two points

// A rung of a ladder. It reaches the base's plate, or without one the base's middle.
struct TraceRung {
  RealPoint from, to;  // Å, relative to BallGeometry::origin
  std::uint32_t atom = 0;
  Rgb8 colour;
};

struct CartoonTraces {
  std::vector<Trace> traces;
  std::vector<TraceRung> rungs;
  std::vector<BasePlate> plates;
  std::size_t points = 0;  // of all traces
};

// Residues and nucleotides whose atoms are `wanted` (a value for each atom of the molecule) get a
// point; a residue without any of them, or without neighbours, gets none. A strand's points are
// means with their neighbours, since a strand's CA lie left and right of its middle in turn.
// `colours` has one for each atom that is a TracePoint::atom.
CartoonTraces make_traces(const Molecule& molecule, const std::array<double, 3>& origin,
                          const SecondaryModel& secondary,
                          const std::vector<Nucleotide>& nucleotides,
                          const std::vector<bool>& wanted, const std::vector<Rgb8>& colours);

}  // namespace alphascope
