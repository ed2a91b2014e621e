// SPDX-License-Identifier: GPL-3.0-or-later
// The middle line is made of cubic Hermite curves. With tangents of length c / cos²(f / 4), where c
// is the length of a chord and f the angle between two of them, such a curve follows a circle
// through equal chords: it touches the arc at its middle. So helices are as round as the radius of
// their CA. Around the line lie rings of points; an ellipse for tubes and helices, a rectangle for
// strands.
#include "ui/scene/objects/cartoon_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/run/parallel.hpp"

namespace alphascope {
namespace {

// Half widths and thicknesses, Å.
constexpr double kTube = 0.3, kNucleicTube = 0.5;
constexpr double kHelixWidth = 1.25, kStrandWidth = 1.05, kThickness = 0.22;
constexpr double kArrowWidth = 1.9, kArrowTip = 0.1;
constexpr double kArrowLength = 1;    // residues
constexpr double kHelixBegins = 0.8;  // residues in which a helix reaches its width

// The outline at one place of the line. growth: of the width, Å for each residue.
struct Profile {
  double width = kTube, thickness = kTube, growth = 0;
  bool box = false;
};

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Runs of points of one shape: [first, last].
struct Run {
  std::size_t first = 0, last = 0;
  TraceShape shape = TraceShape::coil;
};

std::vector<Run> runs_of(const Trace& trace) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (runs.empty() || runs.back().shape != trace[i].shape) runs.push_back({i, i, trace[i].shape});
    runs.back().last = i;
  }
  return runs;
}

// Places along the line are in residues: 0 at the first point. A run reaches half a residue beyond
// its points.
double begin_of(const Run& run) {
  return run.first == 0 ? 0 : static_cast<double>(run.first) - 0.5;
}
double end_of(const Run& run, std::size_t points) {
  const auto last = static_cast<double>(run.last);
  return run.last + 1 == points ? last : last + 0.5;
}

Profile profile_at(const Run& run, double place, std::size_t points) {
  switch (run.shape) {
    case TraceShape::coil:
      return {};
    case TraceShape::nucleic:
      return {kNucleicTube, kNucleicTube};
    case TraceShape::helix: {
      const double inside = std::min(place - begin_of(run), end_of(run, points) - place);
      const double share = smooth_step(inside / kHelixBegins);
      return {kTube + share * (kHelixWidth - kTube), kTube + share * (kThickness - kTube)};
    }
    case TraceShape::strand: {
      const double left = end_of(run, points) - place;
      if (left > kArrowLength) return {kStrandWidth, kThickness, 0, true};
      const double share = left / kArrowLength;
      return {kArrowTip + share * (kArrowWidth - kArrowTip), kThickness,
              -(kArrowWidth - kArrowTip) / kArrowLength, true};
    }
  }
  return {};
}

// The middle line of a trace.
class Line {
 public:
  explicit Line(const Trace& trace) : trace_(trace) {
    const std::size_t n = trace.size();
    for (std::size_t i = 0; i < n; ++i) {
      const RealPoint behind = unit_vector(chord(i > 0 ? i - 1 : 0));
      const RealPoint ahead = unit_vector(chord(std::min(i, n - 2)));
      RealPoint tangent =
          unit_vector(trace[std::min(i + 1, n - 1)].at - trace[i > 0 ? i - 1 : 0].at);
      if (length(tangent) == 0) tangent = ahead;
      tangents_.push_back(tangent);
      const double cosine = std::clamp(dot(behind, ahead), -1.0, 1.0);
      // cos²(f / 4) by half angles, and at most what a turn of 120° needs: sharper ones are faults.
      const double half = std::sqrt((1 + std::max(cosine, -0.5)) / 2);
      stretch_.push_back(2 / (1 + half));
    }
  }

  struct Frame {
    RealPoint at, along, side, up;
    double step = 1;  // Å for each residue
  };
  Frame at(double place) const {
    const std::size_t i =
        std::min(static_cast<std::size_t>(std::max(place, 0.0)), trace_.size() - 2);
    const double t = place - static_cast<double>(i), s = 1 - t;
    const TracePoint &a = trace_[i], &b = trace_[i + 1];
    const double size = length(chord(i)) * 0.5 * (stretch_[i] + stretch_[i + 1]);
    const RealPoint u = size * tangents_[i], v = size * tangents_[i + 1];
    Frame frame;
    frame.at = (s * s * (1 + 2 * t)) * a.at + (t * t * (3 - 2 * t)) * b.at + (t * s * s) * u +
               (-t * t * s) * v;
    const RealPoint slope =
        (6 * t * s) * (b.at - a.at) + (s * (1 - 3 * t)) * u + (t * (3 * t - 2)) * v;
    frame.step = length(slope);
    frame.along = frame.step > 0 ? unit_vector(slope) : unit_vector(chord(i));
    const RealPoint mixed = s * a.side + t * b.side;
    frame.side = unit_vector(mixed - dot(mixed, frame.along) * frame.along);
    if (length(frame.side) == 0) normals_of(frame.along, frame.side, frame.up);
    frame.up = cross(frame.along, frame.side);
    return frame;
  }

 private:
  RealPoint chord(std::size_t i) const { return trace_[i + 1].at - trace_[i].at; }

  const Trace& trace_;
  std::vector<RealPoint> tangents_;
  std::vector<double> stretch_;
};

class Surface {
 public:
  Surface(const Trace& trace, const CartoonDetail& detail)
      : trace_(trace), line_(trace), detail_(detail) {}

  CartoonMesh build() {
    const std::size_t n = trace_.size();
    const auto runs = runs_of(trace_);
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const Run& run = runs[r];
      const double begin = begin_of(run), end = end_of(run, n);
      r == 0 ? close(run, begin, -1) : step(runs[r - 1], run, begin);
      double from = begin;
      if (run.shape == TraceShape::strand && end - begin > kArrowLength) {
        sweep(run, from, end - kArrowLength - kNothing);
        from = end - kArrowLength;
        cap(line_.at(from), profile_at(run, from - kNothing, n), profile_at(run, from, n), from);
      }
      sweep(run, from, end);
      if (r + 1 == runs.size()) close(run, end, 1);
    }
    mesh_.triangles_of_band = 2 * static_cast<std::size_t>(detail_.around);
    return std::move(mesh_);
  }

 private:
  static constexpr double kNothing = 1e-6;  // residues

  // Rings from one place to another, on the grid of steps between.
  void sweep(const Run& run, double from, double to) {
    std::int32_t before = ring_of(run, from, from + kNothing);
    double place = from;
    const double step = 1.0 / detail_.steps;
    while (place < to) {
      const double next = std::min(to, std::floor(place / step + 1.5) * step);
      // A residue ends half way to the next one, where the colour changes.
      const double change = std::floor(place + 0.5) + 0.5;
      const std::int32_t now = ring_of(run, next);
      join(before, now, 0.5 * (place + next));
      before = now;
      if (next >= change && next < to) before = ring_of(run, next, next + kNothing);
      place = next;
    }
  }

  std::int32_t ring_of(const Run& run, double place) {
    return ring_of(run, place, place - kNothing);
  }
  // `coloured`: the place whose residue gives the colour.
  std::int32_t ring_of(const Run& run, double place, double coloured) {
    const Line::Frame frame = line_.at(place);
    return ring(frame, profile_at(run, place, trace_.size()), coloured, 0);
  }

  std::size_t residue_at(double place) const {
    const double nearest = std::floor(std::max(place, 0.0) + 0.5);
    return std::min(static_cast<std::size_t>(nearest), trace_.size() - 1);
  }

  // Points around; facing: 0 for normals outwards, else along the line or against it.
  std::int32_t ring(const Line::Frame& frame, const Profile& profile, double coloured, int facing) {
    SmoothMesh& to = mesh_.surface;
    const auto first = static_cast<std::int32_t>(to.points());
    const Rgb8 colour = trace_[residue_at(coloured)].colour;
    const double w = profile.width, h = profile.thickness;
    const int quarter = detail_.around / 4;
    for (int k = 0; k < detail_.around; ++k) {
      double x = 0, y = 0, nx = 0, ny = 0;
      if (profile.box) {
        const double along = 2.0 * (k % quarter) / (quarter - 1) - 1;
        const std::array<std::array<double, 4>, 4> sides{{{w, along * h, 1, 0},
                                                          {-along * w, h, 0, 1},
                                                          {-w, -along * h, -1, 0},
                                                          {along * w, -h, 0, -1}}};
        const auto& s = sides[static_cast<std::size_t>(k / quarter)];
        x = s[0], y = s[1], nx = s[2], ny = s[3];
      } else {
        const double angle = 2 * M_PI * k / detail_.around;
        x = w * std::cos(angle), y = h * std::sin(angle);
        nx = std::cos(angle) / w, ny = std::sin(angle) / h;
      }
      RealPoint normal = nx * frame.side + ny * frame.up;
      if (profile.box && nx != 0 && frame.step > 0) {
        normal = normal - (profile.growth / frame.step) * frame.along;
      }
      if (facing != 0) normal = facing * frame.along;
      to.add_point(frame.at + x * frame.side + y * frame.up, unit_vector(normal), colour);
    }
    return first;
  }

  // A band of triangles between two rings, which face outwards.
  void join(std::int32_t a, std::int32_t b, double place) {
    auto& corners = mesh_.surface.corners;
    for (int k = 0; k < detail_.around; ++k) {
      const std::int32_t i = k, j = (k + 1) % detail_.around;
      corners.insert(corners.end(), {a + i, a + j, b + j, a + i, b + j, b + i});
    }
    mesh_.atom_of_band.push_back(trace_[residue_at(place)].atom);
  }

  // A flat ring between two outlines at one place.
  void cap(const Line::Frame& frame, const Profile& before, const Profile& after, double place) {
    const int facing = after.width > before.width ? -1 : 1;
    const std::int32_t a = ring(frame, before, place, facing);
    join(a, ring(frame, after, place, facing), place);
  }

  void step(const Run& before, const Run& after, double place) {
    const std::size_t n = trace_.size();
    const Profile old = profile_at(before, place, n), now = profile_at(after, place, n);
    if (old.width == now.width && old.thickness == now.thickness && old.box == now.box) return;
    cap(line_.at(place), old, now, place);
  }

  // The end of a chain: a disc, and for tubes half an ellipsoid.
  void close(const Run& run, double place, int facing) {
    const Line::Frame frame = line_.at(place);
    const Profile profile = profile_at(run, place, trace_.size());
    if (profile.box) {
      Profile point = profile;
      point.width = point.thickness = 0;
      facing < 0 ? cap_facing(frame, point, profile, place, facing)
                 : cap_facing(frame, profile, point, place, facing);
      return;
    }
    constexpr int kRings = 4;
    std::vector<std::int32_t> rings;
    for (int k = 0; k <= kRings; ++k) {
      const double angle = M_PI / 2 * k / kRings;  // from the rim to the tip
      rings.push_back(round_ring(frame, profile, angle, facing, place));
    }
    if (facing < 0) std::reverse(rings.begin(), rings.end());
    for (int k = 0; k < kRings; ++k) {
      const auto i = static_cast<std::size_t>(k);
      join(rings[i], rings[i + 1], place);
    }
  }

  void cap_facing(const Line::Frame& frame, const Profile& a, const Profile& b, double place,
                  int facing) {
    const std::int32_t first = ring(frame, a, place, facing);
    join(first, ring(frame, b, place, facing), place);
  }

  std::int32_t round_ring(const Line::Frame& frame, const Profile& profile, double angle,
                          int facing, double place) {
    const auto first = static_cast<std::int32_t>(mesh_.surface.points());
    const Rgb8 colour = trace_[residue_at(place)].colour;
    const double out = std::cos(angle), ahead = std::sin(angle);
    for (int k = 0; k < detail_.around; ++k) {
      const double turn = 2 * M_PI * k / detail_.around;
      const RealPoint outwards = std::cos(turn) * frame.side + std::sin(turn) * frame.up;
      const RealPoint at = frame.at + (out * profile.width * std::cos(turn)) * frame.side +
                           (out * profile.thickness * std::sin(turn)) * frame.up +
                           (facing * ahead * profile.thickness) * frame.along;
      mesh_.surface.add_point(at, unit_vector(out * outwards + (facing * ahead) * frame.along),
                              colour);
    }
    return first;
  }

  const Trace& trace_;
  const Line line_;
  const CartoonDetail detail_;
  CartoonMesh mesh_;
};

// Where a part begins in the whole surface.
struct PartStart {
  std::size_t point = 0, corner = 0, band = 0;
};

template <class T>
void copy_to(const std::vector<T>& from, std::vector<T>& to, std::size_t begin) {
  std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(begin));
}

void copy_part(const CartoonMesh& part, const PartStart& start, CartoonMesh& whole) {
  copy_to(part.surface.xyz, whole.surface.xyz, 3 * start.point);
  copy_to(part.surface.normals, whole.surface.normals, 3 * start.point);
  copy_to(part.surface.rgb, whole.surface.rgb, 3 * start.point);
  copy_to(part.atom_of_band, whole.atom_of_band, start.band);
  const auto first = static_cast<std::int32_t>(start.point);
  std::transform(part.surface.corners.begin(), part.surface.corners.end(),
                 whole.surface.corners.begin() + static_cast<std::ptrdiff_t>(start.corner),
                 [first](std::int32_t corner) { return first + corner; });
}

}  // namespace

CartoonDetail cartoon_detail(std::size_t residues) {
  constexpr std::size_t kSome = 200, kMany = 1000, kVeryMany = 4000;
  if (residues > kVeryMany) return {4, 8};
  if (residues > kMany) return {4, 12};
  return residues > kSome ? CartoonDetail{8, 12} : CartoonDetail{};
}

CartoonMesh build_cartoon(const std::vector<Trace>& traces, const CartoonDetail& detail,
                          const CancelToken& cancel) {
  std::vector<CartoonMesh> parts(traces.size());
  parallel_each(0, traces.size(), [&](std::size_t k) {
    if (!cancel.cancelled()) parts[k] = Surface(traces[k], detail).build();
  });
  cancel.throw_if_cancelled();
  std::vector<PartStart> starts;
  PartStart end;
  for (const CartoonMesh& part : parts) {
    starts.push_back(end);
    end.point += part.surface.points();
    end.corner += part.surface.corners.size();
    end.band += part.atom_of_band.size();
  }
  CartoonMesh whole;
  whole.triangles_of_band = 2 * static_cast<std::size_t>(detail.around);
  whole.surface.xyz.resize(3 * end.point);
  whole.surface.normals.resize(3 * end.point);
  whole.surface.rgb.resize(3 * end.point);
  whole.surface.corners.resize(end.corner);
  whole.atom_of_band.resize(end.band);
  parallel_each(0, parts.size(), [&](std::size_t k) {
    copy_part(parts[k], starts[k], whole);
    parts[k] = {};
  });
  return whole;
}

void add_plates(const std::vector<BasePlate>& plates, CartoonMesh& mesh) {
  for (const BasePlate& plate : plates) {
    add_plate(plate, mesh.surface);
    mesh.atom_of_plate_triangle.resize(
        mesh.triangles() - mesh.atom_of_band.size() * mesh.triangles_of_band, plate.atom);
  }
}

std::size_t cartoon_points(const std::vector<Trace>& traces, const CartoonDetail& detail) {
  std::size_t rings = 0;
  for (const Trace& trace : traces) {
    // At each residue a ring more for its colour; up to five where a run begins, or at an end.
    const auto steps = static_cast<std::size_t>(detail.steps);
    rings += trace.size() * (steps + 2) + 5 * (runs_of(trace).size() + 2);
  }
  return rings * static_cast<std::size_t>(detail.around);
}

}  // namespace alphascope
