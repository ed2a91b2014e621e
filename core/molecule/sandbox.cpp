// SPDX-License-Identifier: GPL-3.0-or-later
// Edits the balls of a sandbox and keeps them on the lattice and within its bounds.
#include "core/molecule/sandbox.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_point.hpp"
#include "core/molecule/molecule.hpp"

namespace alphascope {
namespace {

std::int32_t units_within(const Lattice& lattice, double length, double least, double most) {
  if (std::isnan(length)) throw std::invalid_argument("a coordinate or radius is not a number");
  return static_cast<std::int32_t>(lattice.nearest_units(std::clamp(length, least, most)));
}

LatticePoint place_on(const Sandbox& sandbox, const SandboxPlace& centre) {
  const double reach = sandbox_reach(sandbox.lattice);
  const auto units = [&](double x) { return units_within(sandbox.lattice, x, -reach, reach); };
  const std::int32_t z = units(centre[2]);
  return {units(centre[0]), units(centre[1]), sandbox.flat ? 0 : z};
}

std::int32_t radius_on(const Lattice& lattice, double angstrom) {
  return units_within(lattice, angstrom, least_sandbox_radius(lattice),
                      most_sandbox_radius(lattice));
}

template <class AnySandbox>
auto& ball_at(AnySandbox& sandbox, std::size_t ball) {
  if (ball >= sandbox.balls.size()) {
    throw std::invalid_argument("there is no ball " + std::to_string(ball + 1) + ": there are " +
                                std::to_string(sandbox.balls.size()));
  }
  return sandbox.balls[ball];
}

}  // namespace

// The bounds are whole lattice units, so rounding cannot exceed them.
double sandbox_reach(const Lattice& lattice) {
  return std::min(kSandboxReach, lattice.angstrom(kMaxLatticeCoordinate));
}

double most_sandbox_radius(const Lattice& lattice) {
  return std::min(kMostSandboxRadius, lattice.angstrom(kMaxLatticeRadius));
}

double least_sandbox_radius(const Lattice& lattice) {
  return lattice.unit_angstrom();
}

std::string why_no_sandbox(std::size_t balls) {
  if (balls <= kMostSandboxBalls) return {};
  return "At most " + std::to_string(kMostSandboxBalls) + " balls can be changed by hand, and " +
         std::to_string(balls) + " are open. Select fewer atoms, or open a preset.";
}

Sandbox sandbox_of(const BallSet& balls) {
  const std::string reason = why_no_sandbox(balls.size());
  if (!reason.empty()) throw std::invalid_argument(reason);
  Sandbox sandbox{balls.lattice, balls.size() > 0, {}};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    sandbox.balls.push_back({balls.centres[i], balls.radii[i]});
    sandbox.flat = sandbox.flat && balls.centres[i].z == 0;
  }
  return sandbox;
}

std::size_t add_ball(Sandbox& sandbox, const SandboxPlace& centre, double radius_angstrom) {
  if (sandbox.balls.size() >= kMostSandboxBalls) {
    throw std::invalid_argument(why_no_sandbox(sandbox.balls.size() + 1));
  }
  sandbox.balls.push_back({place_on(sandbox, centre), radius_on(sandbox.lattice, radius_angstrom)});
  return sandbox.balls.size() - 1;
}

void move_ball(Sandbox& sandbox, std::size_t ball, const SandboxPlace& centre) {
  ball_at(sandbox, ball).centre = place_on(sandbox, centre);
}

void resize_ball(Sandbox& sandbox, std::size_t ball, double radius_angstrom) {
  ball_at(sandbox, ball).radius = radius_on(sandbox.lattice, radius_angstrom);
}

void remove_ball(Sandbox& sandbox, std::size_t ball) {
  static_cast<void>(ball_at(sandbox, ball));
  sandbox.balls.erase(sandbox.balls.begin() + static_cast<std::ptrdiff_t>(ball));
}

SandboxPlace centre_of(const Sandbox& sandbox, std::size_t ball) {
  const LatticePoint& p = ball_at(sandbox, ball).centre;
  const Lattice& l = sandbox.lattice;
  return {l.angstrom(p.x), l.angstrom(p.y), l.angstrom(p.z)};
}

double radius_of(const Sandbox& sandbox, std::size_t ball) {
  return sandbox.lattice.angstrom(ball_at(sandbox, ball).radius);
}

void flatten(Sandbox& sandbox) {
  sandbox.flat = true;
  for (SandboxBall& ball : sandbox.balls) ball.centre.z = 0;
}

Molecule sandbox_molecule(const Molecule& file, const Sandbox& sandbox) {
  Molecule molecule;
  molecule.source = file.source;
  molecule.format = file.format;
  molecule.title = file.title;
  molecule.sha256 = file.sha256;
  molecule.lattice = sandbox.lattice;
  molecule.has_file_radii = true;
  for (const SandboxBall& ball : sandbox.balls) {
    Atom atom;
    atom.position = ball.centre;
    atom.file_radius = ball.radius;
    atom.serial = static_cast<std::int32_t>(molecule.atoms.size()) + 1;
    molecule.atoms.push_back(atom);
  }
  molecule.models.push_back({1, 0, molecule.atoms.size()});
  molecule.notes.push_back("The balls are set by hand (Sandbox), in place of the file's.");
  return molecule;
}

}  // namespace alphascope
