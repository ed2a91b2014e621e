// SPDX-License-Identifier: GPL-3.0-or-later
// A few balls set by hand in place of a file's atoms: their centres and radii on the lattice.
// core/chart/flat_drawing.hpp draws flat ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/lattice.hpp"
#include "core/geometry/lattice_point.hpp"

namespace alphascope {

struct BallSet;
struct Molecule;

struct SandboxBall {
  LatticePoint centre;
  std::int32_t radius = 1;  // lattice units, > 0
  friend bool operator==(const SandboxBall&, const SandboxBall&) = default;
};

struct Sandbox {
  Lattice lattice;
  // All centres are, and stay, exactly in the plane z = 0.
  bool flat = false;
  std::vector<SandboxBall> balls;
  friend bool operator==(const Sandbox&, const Sandbox&) = default;
};

inline constexpr std::size_t kMostSandboxBalls = 500;
// Å. A sandbox is viewed as a whole, so it stays small.
inline constexpr double kSandboxReach = 1000, kMostSandboxRadius = 50;
// Bounds in Å: those above, or the bounds of the lattice where these are smaller.
double sandbox_reach(const Lattice& lattice);  // of coordinates, in each direction
double most_sandbox_radius(const Lattice& lattice);
double least_sandbox_radius(const Lattice& lattice);  // one unit

// The reason why so many balls cannot be changed by hand, with the remedy; empty: they can.
std::string why_no_sandbox(std::size_t balls);

// A sandbox with these balls. It is flat if all centres are in the plane z = 0 and there is at
// least one.
Sandbox sandbox_of(const BallSet& balls);

// Lengths are in Å. They are rounded to the lattice and moved into its bounds. In a flat sandbox z
// is set to 0. These functions throw std::invalid_argument for NaN and for a ball that does not
// exist. The first also throws it if there are kMostSandboxBalls.
using SandboxPlace = std::array<double, 3>;
std::size_t add_ball(Sandbox& sandbox, const SandboxPlace& centre,
                     double radius_angstrom);  // returns its index
void move_ball(Sandbox& sandbox, std::size_t ball, const SandboxPlace& centre);
void resize_ball(Sandbox& sandbox, std::size_t ball, double radius_angstrom);
void remove_ball(Sandbox& sandbox, std::size_t ball);
SandboxPlace centre_of(const Sandbox& sandbox, std::size_t ball);
double radius_of(const Sandbox& sandbox, std::size_t ball);
// Moves all centres straight into the plane z = 0.
void flatten(Sandbox& sandbox);

// A molecule with these balls as atoms, in their order and with their radii. Source, format, title
// and SHA-256 are those of `file`.
Molecule sandbox_molecule(const Molecule& file, const Sandbox& sandbox);

}  // namespace alphascope
