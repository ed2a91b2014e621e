// SPDX-License-Identifier: GPL-3.0-or-later
// Draws measurements, marks, labels and the power diagram into a Layer, and writes measured
// numbers.
#include "ui/annotation_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/document/reference/reference.hpp"
#include "core/explain/power_diagram.hpp"
#include "core/geometry/alpha.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/radii/amber_radii.hpp"
#include "core/selection/atom_address.hpp"
#include "ui/number_text.hpp"

namespace alphascope {
namespace {

constexpr double kDash = 0.18;           // Å: length of a dash, and of the gap after it
constexpr double kMostDashes = 60;       // longer lines have longer dashes
constexpr double kLongestArc = 1.0;      // Å: radius of the arc at an angle
constexpr double kShareOfArc = 0.4;      // same radius, as a share of the angle's shorter side
constexpr double kLeastCross = 0.12;     // Å: half the length of a line of a marked point's cross
constexpr double kShareOfCross = 0.006;  // same length, as a share of the diagonal of a large
                                         // molecule
constexpr double kBorder = 0.03;         // Å: radius of the tubes around a border between power
                                         // cells

// Returns half the length of a cross' lines, Å. The cross is just large enough to be seen in a
// picture of the whole molecule.
double half_of_cross(const BallSet& balls) {
  if (balls.size() == 0) return kLeastCross;
  LatticePoint low = balls.centres[0], high = low;
  for (const LatticePoint& p : balls.centres) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double diagonal = length(real_point(high) - real_point(low));
  return std::max(kLeastCross, kShareOfCross * balls.lattice.angstrom(diagonal));
}

class Drawing {
 public:
  Drawing(Layer& layer, const Molecule& molecule, double cross)
      : layer_(layer), molecule_(molecule), cross_(cross) {}

  void add(const Measurement& m, const Measured& of) {
    const std::string text = measured_text(m, of);
    std::vector<RealPoint> at;
    for (const std::size_t atom : of.atoms) {
      at.push_back(molecule_.lattice.unit_angstrom() * real_point(molecule_.atoms[atom].position));
    }
    for (std::size_t n = 0; n + 1 < at.size(); ++n) add_dashes(at[n], at[n + 1]);
    if (at.size() == 3) return add_angle(at, text);
    const std::size_t half = at.size() / 2;  // four atoms: the middle bond
    layer_.labels.push_back({0.5 * (at[half - 1] + at[half]), text});
  }

  void add(const PlacedMark& m) {
    const RealPoint from{m.from[0], m.from[1], m.from[2]}, to{m.to[0], m.to[1], m.to[2]};
    if (m.is_point()) {
      for (const RealPoint& arm :
           {RealPoint{cross_, 0, 0}, RealPoint{0, cross_, 0}, RealPoint{0, 0, cross_}}) {
        layer_.lines.push_back({from - arm, from + arm});
      }
    } else {
      layer_.lines.push_back({from, to});
    }
    // The text stands beside the cross of a point, which it would otherwise hide.
    const RealPoint aside = m.is_point() ? 2.5 * RealPoint{0, cross_, cross_} : RealPoint{};
    if (!m.text.empty()) layer_.labels.push_back({0.5 * (from + to) + aside, m.text});
  }

  void add_borders(const BallSet& balls) {
    for (const PowerFace& face : power_diagram(balls)) {
      std::vector<LayerSphere> around;
      for (const RealPoint& corner : face.corners_angstrom) {
        around.push_back({corner, kBorder, kDualColour});
      }
      around.push_back(around.front());
      layer_.tubes.push_back(std::move(around));
    }
  }

 private:
  // Adds a dashed line that begins and ends with a dash.
  void add_dashes(const RealPoint& from, const RealPoint& to) {
    const RealPoint along = to - from;
    const double dashes = std::clamp(std::round(length(along) / (2 * kDash)), 1.0, kMostDashes);
    const double step = 1 / (dashes - 0.5);
    for (double n = 0; n < dashes; ++n) {
      const double begin = n * step, end = std::min(1.0, begin + step / 2);
      layer_.lines.push_back({from + begin * along, from + end * along});
    }
  }

  // Draws an arc between both sides of the angle, with the number on it.
  void add_angle(const std::vector<RealPoint>& at, const std::string& text) {
    const RealPoint corner = at[1], u = at[0] - corner, v = at[2] - corner;
    const double radius = std::min(kLongestArc, kShareOfArc * std::min(length(u), length(v)));
    const RealPoint first = unit_vector(u);
    const RealPoint across = unit_vector(unit_vector(v) - dot(unit_vector(v), first) * first);
    const double turn = std::atan2(dot(v, across), dot(v, first));
    constexpr int kPieces = 16;
    const auto point = [&](double share) {
      return corner + radius * (std::cos(share * turn) * first + std::sin(share * turn) * across);
    };
    for (int n = 0; n < kPieces && radius > 0 && turn > 0; ++n) {
      layer_.lines.push_back({point(double(n) / kPieces), point(double(n + 1) / kPieces)});
    }
    layer_.labels.push_back({point(0.5), text});
  }

  Layer& layer_;
  const Molecule& molecule_;
  const double cross_;  // Å
};

}  // namespace

std::string measured_text(const Measurement& m, const std::optional<Measured>& of) {
  if (!of) return "not in this molecule";
  if (!of->value) return "undefined";
  if (m.atoms.size() == 2) return number_text(*of->value, 3) + " Å";
  std::string text = number_text(*of->value, 1);
  if (text == "−180.0") text = "180.0";  // dihedral angles are above −180°; only rounding gives it
  return text + "°";
}

std::string measurement_text(const Molecule& molecule, const Measurement& m) {
  const auto of = measured(molecule, m);
  std::string text = measurement_name(m);
  text.front() = static_cast<char>(text.front() - 'a' + 'A');
  for (std::size_t n = 0; of && n < of->atoms.size(); ++n) {
    text += (n == 0 ? " " : " – ") + atom_address(molecule, of->atoms[n]);
  }
  return text + ": " + measured_text(m, of);
}

std::shared_ptr<const Layer> make_annotation_layer(const Annotations& annotations,
                                                   const AnnotatedPicture& picture) {
  if (annotations.empty()) return nullptr;
  auto layer = std::make_shared<Layer>();
  layer->id = "annotations";
  layer->key = picture.key;
  layer->balls = picture.balls;
  layer->colour = picture.colour;
  const Molecule& molecule = picture.atoms.molecule();
  const double cross = annotations.marks.empty() ? kLeastCross : half_of_cross(*picture.balls);
  Drawing drawing(*layer, molecule, cross);
  std::size_t drawn = 0;
  for (const Measurement& m : annotations.measurements) {
    const auto of = measured(molecule, m);
    if (!of || !std::all_of(of->atoms.begin(), of->atoms.end(), picture.is_drawn)) continue;
    if (++drawn > kMostMeasurements) break;
    drawing.add(m, *of);
  }
  const std::size_t marks = std::min(annotations.marks.size(), kMostMarks);
  for (std::size_t n = 0; n < marks; ++n) drawing.add(annotations.marks[n]);
  if (annotations.power_diagram) {
    drawing.add_borders(picture.grown ? *picture.grown : *picture.balls);
  }
  for (PlacedText& label : placed_labels(picture.atoms, annotations.labels, picture.is_drawn)) {
    layer->labels.push_back({label.at_angstrom, std::move(label.text)});
  }
  return layer;
}

}  // namespace alphascope
