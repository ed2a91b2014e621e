// One colour a ball: by element or by chain (core/molecule/atom_colours.hpp), or by a share. No
// VTK.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/document/display.hpp"
#include "core/document/measure_results.hpp"
#include "core/molecule/atom_colours.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/picture_marks.hpp"
#include "ui/scene/ball_geometry.hpp"
#include "ui/theme.hpp"

namespace alphascope {

// By a number from 0 to 1 for each ball, along the map of colour_map.hpp. The square root spreads
// small shares, which nearly all are.
std::vector<Rgb8> colours_by_share(const std::vector<float>& shares);
ColourLegend share_legend(const std::string& quantity);  // in percent

// By exposed area, of atoms or of residues, of a complex of these balls; with their legend.
struct ExposureColours {
  ColourBy colour;  // exposed or exposed_residue
  const UnionMeasures& measures;
  const BallSet& balls;  // with the solvent radius
  double alpha_on_lattice;
};
std::vector<Rgb8> colours_by_exposure(const ExposureColours& of, const Molecule& molecule,
                                      const std::vector<std::uint32_t>& atom_of_ball);
ColourLegend exposure_legend(ColourBy colour);

// Of balls in one colour: carbon's.
inline constexpr Rgb8 kPlainBall = {148, 156, 166};

Rgb8 to_rgb8(const Colour& colour);

}  // namespace alphascope
