// A handful of balls that somebody sets by hand, in place of the atoms of a file. Which ball is
// where and how large, on the lattice; not how it is shown.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/ball_set.hpp"

namespace alphascope {

struct Molecule;

struct SandboxBall {
  LatticePoint centre;
  std::int32_t radius = 1;  // lattice units, > 0
  friend bool operator==(const SandboxBall&, const SandboxBall&) = default;
};

struct Sandbox {
  Lattice lattice;
  // All centres are in the plane z = 0, exactly, and stay there.
  bool flat = false;
  std::vector<SandboxBall> balls;
  friend bool operator==(const Sandbox&, const Sandbox&) = default;
};

inline constexpr std::size_t kMostSandboxBalls = 500;
// Å: it is looked at as a whole.
inline constexpr double kSandboxReach = 1000, kMostSandboxRadius = 50;
// Å; less where the lattice is so fine that it ends before.
double sandbox_reach(const Lattice& lattice);  // of coordinates, each way
double most_sandbox_radius(const Lattice& lattice);
double least_sandbox_radius(const Lattice& lattice);  // one unit

// A sentence with the remedy; empty: these balls can be changed by hand.
std::string why_no_sandbox(std::size_t balls);

// These balls as they are; flat when all of them are in the plane z = 0 and there is one.
Sandbox sandbox_of(const BallSet& balls);

// Lengths in Å, rounded to the lattice, and into its bounds where they are beyond; z is 0 in a flat
// sandbox. Throw std::invalid_argument for a number that is none, and for a ball that is not there;
// add_ball() also when there are kMostSandboxBalls.
using SandboxPlace = std::array<double, 3>;
std::size_t add_ball(Sandbox& sandbox, const SandboxPlace& centre,
                     double radius_angstrom);  // its index
void move_ball(Sandbox& sandbox, std::size_t ball, const SandboxPlace& centre);
void resize_ball(Sandbox& sandbox, std::size_t ball, double radius_angstrom);
void remove_ball(Sandbox& sandbox, std::size_t ball);
SandboxPlace centre_of(const Sandbox& sandbox, std::size_t ball);
double radius_of(const Sandbox& sandbox, std::size_t ball);
// Into the plane z = 0, each straight up or down.
void flatten(Sandbox& sandbox);

// With these balls as its atoms, in their order and with their radii as the file's; everything else
// as in `file`.
Molecule sandbox_molecule(const Molecule& file, const Sandbox& sandbox);

}  // namespace alphascope
