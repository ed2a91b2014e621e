// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the layers of a step: spheres, tubes, lines, faces and labels, each in the colour of its
// mark.
#include "ui/panels/explain/steps_layer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/geometry/ball_set.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/text/grouped_number.hpp"

namespace alphascope {
namespace {

constexpr double kBall = 0.32, kChosenBall = 0.5, kTube = 0.05, kUndecidedTube = 0.07;  // Å, radii
constexpr double kBoxTube = 0.03;         // Å, radius
constexpr std::size_t kMostTubes = 3000;  // more edges are drawn as lines
constexpr std::size_t kFewLines = 40;     // with more, kept edges are drawn over all

constexpr Colour rgb(std::uint32_t hex) {
  return {static_cast<float>(hex >> 16 & 0xff) / 255.0f,
          static_cast<float>(hex >> 8 & 0xff) / 255.0f, static_cast<float>(hex & 0xff) / 255.0f, 1};
}

const char* layer_id(StepMark mark) {
  static constexpr const char* kIds[] = {"steps.chosen", "steps.kept", "steps.dropped",
                                         "steps.undecided"};
  return kIds[static_cast<std::size_t>(mark)];
}

// Whether the step's simplices are still to be tested. Such simplices overlap, so their faces would
// hide one another.
bool is_of_candidates(StepKind kind) {
  return kind == StepKind::pairs || kind == StepKind::triples || kind == StepKind::tuples ||
         kind == StepKind::alpha || kind == StepKind::places || kind == StepKind::triangles ||
         kind == StepKind::clipping;
}

using Edges = Simplices<2>;

template <int N>
void add_edges(const Simplices<N>& simplices, Edges& edges) {
  for (const auto& s : simplices) {
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (std::size_t k = i + 1; k < s.size(); ++k) {
        edges.push_back({std::min(s[i], s[k]), std::max(s[i], s[k])});
      }
    }
  }
}

void sort_once(Edges& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

class StepPainter {
 public:
  StepPainter(const StepScene& scene, std::uint64_t key) : scene_(scene), key_(key) {}

  Layers layers() {
    // Marks are drawn in order, and each edge once. So an edge of a kept simplex is not drawn as
    // dropped.
    Edges drawn;
    for (const StepMark mark :
         {StepMark::chosen, StepMark::kept, StepMark::undecided, StepMark::dropped}) {
      Layer& layer = of(mark);
      Edges edges;
      for (const MarkedSimplices& marked : scene_.step.marks) {
        if (marked.mark == mark) add(marked, layer, edges);
      }
      sort_once(edges);
      draw_edges(edges, drawn, mark, layer);
    }
    if (of(StepMark::dropped).edges.size() > kFewLines) show_through(of(StepMark::kept));
    for (const StepBox& box : scene_.step.boxes) add_box(box);
    for (const StepSphere& sphere : scene_.step.spheres) add_circles(sphere);
    add_segments();
    add_chosen();
    add_remover();
    Layers all;
    for (auto& layer : layers_) all.push_back(std::move(layer));
    return all;
  }

 private:
  Layer& of(StepMark mark) {
    auto& layer = layers_[static_cast<std::size_t>(mark)];
    if (layer) return *layer;
    layer = std::make_shared<Layer>();
    layer->id = layer_id(mark);
    layer->key = key_;
    layer->balls = scene_.balls;
    layer->colour = step_colour(mark, scene_.theme);
    layer->body = true;
    return *layer;
  }
  RealPoint centre_of(BallIndex ball) const {
    const BallSet& balls = *scene_.balls;
    return balls.lattice.unit_angstrom() * real_point(balls.centres[ball]);
  }

  void add(const MarkedSimplices& marked, Layer& layer, Edges& edges) const {
    for (const auto& vertex : marked.vertices) {
      if (vertex[0] != scene_.steps.ball) {
        layer.spheres.push_back({centre_of(vertex[0]), kBall, {}});
      }
    }
    add_edges<2>(marked.edges, edges);
    if (marked.mark == StepMark::kept && !is_of_candidates(scene_.step.kind)) {
      std::copy(marked.triangles.begin(), marked.triangles.end(),
                std::back_inserter(layer.triangles));
      std::copy(marked.tetrahedra.begin(), marked.tetrahedra.end(),
                std::back_inserter(layer.tetrahedra));
      return;
    }
    add_edges<3>(marked.triangles, edges);
    add_edges<4>(marked.tetrahedra, edges);
  }

  void draw_edges(const Edges& edges, Edges& drawn, StepMark mark, Layer& layer) const {
    Edges left;
    std::set_difference(edges.begin(), edges.end(), drawn.begin(), drawn.end(),
                        std::back_inserter(left));
    if (mark == StepMark::dropped || left.size() > kMostTubes) {
      std::copy(left.begin(), left.end(), std::back_inserter(layer.edges));
    } else {
      const double radius = mark == StepMark::undecided ? kUndecidedTube : kTube;
      for (const auto& [a, b] : left) {
        layer.tubes.push_back({{centre_of(a), radius, {}}, {centre_of(b), radius, {}}});
      }
    }
    std::copy(left.begin(), left.end(), std::back_inserter(drawn));
    std::sort(drawn.begin(), drawn.end());
  }

  // Draws the layer's edges once more as lines over everything, since many dropped lines would hide
  // them.
  void show_through(Layer& layer) const {
    Edges edges;
    add_edges<3>(layer.triangles, edges);
    add_edges<4>(layer.tetrahedra, edges);
    sort_once(edges);
    for (const auto& [a, b] : edges) layer.lines.push_back({centre_of(a), centre_of(b)});
    for (const auto& tube : layer.tubes) {
      layer.lines.push_back({tube.front().centre_angstrom, tube.back().centre_angstrom});
    }
  }

  void add_box(const StepBox& box) {
    Layer& layer = of(box.mark);
    const auto corner = [&](int bits) {
      const RealPoint &low = box.low_angstrom, &high = box.high_angstrom;
      return RealPoint{bits & 1 ? high.x : low.x, bits & 2 ? high.y : low.y,
                       bits & 4 ? high.z : low.z};
    };
    for (int from = 0; from < 8; ++from) {
      for (int axis = 1; axis < 8; axis *= 2) {
        if (from & axis) continue;
        layer.tubes.push_back({{corner(from), kBoxTube, {}}, {corner(from | axis), kBoxTube, {}}});
      }
    }
  }

  // Draws three circles on the sphere, since a whole ball would hide the things inside.
  void add_circles(const StepSphere& sphere) {
    constexpr int kCorners = 48;
    Layer& layer = of(sphere.mark);
    const RealPoint& c = sphere.centre_angstrom;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<LayerSphere> circle;
      for (int corner = 0; corner <= kCorners; ++corner) {
        const double turn = 2 * M_PI * corner / kCorners;
        const double a = sphere.radius_angstrom * std::cos(turn);
        const double b = sphere.radius_angstrom * std::sin(turn);
        const RealPoint at = axis == 0   ? RealPoint{c.x, c.y + a, c.z + b}
                             : axis == 1 ? RealPoint{c.x + b, c.y, c.z + a}
                                         : RealPoint{c.x + a, c.y + b, c.z};
        circle.push_back({at, kBoxTube, {}});
      }
      layer.tubes.push_back(std::move(circle));
    }
  }

  void add_segments() {
    const auto& segments = scene_.step.segments;
    for (const StepSegment& s : segments) {
      Layer& layer = of(s.mark);
      if (segments.size() > kMostTubes) {
        layer.lines.push_back({s.from_angstrom, s.to_angstrom});
      } else {
        layer.tubes.push_back({{s.from_angstrom, kTube, {}}, {s.to_angstrom, kTube, {}}});
      }
    }
  }

  void add_chosen() {
    Layer& layer = of(StepMark::chosen);
    const RealPoint centre = centre_of(scene_.steps.ball);
    layer.spheres.push_back({centre, kChosenBall, {}});
    layer.labels.push_back({centre, scene_.ball_name});
  }

  void add_remover() {
    if (scene_.step.removers.empty()) return;
    const StepConflict& most = scene_.step.removers.front();
    Layer& layer = of(StepMark::dropped);
    layer.spheres.push_back({centre_of(most.ball), kBall, {}});
    layer.labels.push_back({centre_of(most.ball), "ends " + grouped(most.simplices)});
  }

  const StepScene& scene_;
  std::uint64_t key_;
  std::array<std::shared_ptr<Layer>, 4> layers_;
};

}  // namespace

Colour step_colour(StepMark mark, Theme theme) {
  const bool light = theme == Theme::light;
  switch (mark) {
    case StepMark::chosen:
      return palette(theme).selected;
    case StepMark::kept:
      return light ? rgb(0x0072b2) : rgb(0x56b4e9);
    case StepMark::dropped:
      return light ? rgb(0xd55e00) : rgb(0xe8702a);
    case StepMark::undecided:
      break;
  }
  return light ? rgb(0x26282c) : rgb(0xf0e442);
}

Layers make_steps_layers(const StepScene& scene, std::uint64_t key) {
  return StepPainter(scene, key).layers();
}

}  // namespace alphascope
