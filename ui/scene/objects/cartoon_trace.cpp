// SPDX-License-Identifier: GPL-3.0-or-later
// Places the points of traces and their ribbons' directions.
#include "ui/scene/objects/cartoon_trace.hpp"

#include <algorithm>
#include <utility>

namespace alphascope {
namespace {

constexpr int kStrandPasses = 2;  // means with neighbours

TraceShape shape_of(SecondaryStructure kind) {
  if (is_helix(kind)) return TraceShape::helix;
  return kind == SecondaryStructure::strand ? TraceShape::strand : TraceShape::coil;
}

// Neighbouring ribbons' directions differ by less than a right angle afterwards. A ribbon has no
// front, so a direction may be turned around.
void turn_alike(Trace& trace) {
  for (std::size_t i = 1; i < trace.size(); ++i) {
    if (dot(trace[i - 1].side, trace[i].side) < 0) trace[i].side = -1 * trace[i].side;
  }
}

// Sets directions that are not known (length 0), from the bend of the line: in helices and in
// strands alike the normal of the bend lies in the ribbon.
void add_sides(Trace& trace) {
  for (std::size_t i = 0; i < trace.size(); ++i) {
    if (length(trace[i].side) > 0) continue;
    const std::size_t k = std::min(std::max<std::size_t>(i, 1), trace.size() - 1);
    const RealPoint before = trace[k].at - trace[k - 1].at;
    const RealPoint after = k + 1 < trace.size() ? trace[k + 1].at - trace[k].at : before;
    trace[i].side = unit_vector(cross(before, after));
    if (length(trace[i].side) > 0) continue;
    RealPoint other;
    normals_of(unit_vector(before), trace[i].side, other);
  }
}

void straighten_strands(Trace& trace) {
  for (int pass = 0; pass < kStrandPasses; ++pass) {
    const Trace old = trace;
    for (std::size_t i = 1; i + 1 < trace.size(); ++i) {
      if (old[i].shape != TraceShape::strand) continue;
      trace[i].at = 0.5 * old[i].at + 0.25 * (old[i - 1].at + old[i + 1].at);
      RealPoint side = old[i].side;
      if (old[i - 1].shape == TraceShape::strand) side = side + 0.5 * old[i - 1].side;
      if (old[i + 1].shape == TraceShape::strand) side = side + 0.5 * old[i + 1].side;
      if (length(unit_vector(side)) > 0) trace[i].side = unit_vector(side);
    }
  }
}

class TraceMaker {
 public:
  TraceMaker(const Molecule& molecule, const std::array<double, 3>& origin,
             const std::vector<bool>& wanted, const std::vector<Rgb8>& colours)
      : molecule_(molecule),
        origin_{origin[0], origin[1], origin[2]},
        wanted_(wanted),
        colours_(colours) {}

  void add_protein(const SecondaryModel& secondary) {
    const auto& residues = secondary.residues;
    for (std::size_t i = 0; i < residues.size(); ++i) {
      const BackboneResidue& r = residues[i];
      if (wanted_[r.ca]) {
        TracePoint point = point_at(r.ca, shape_of(secondary.kinds[i]));
        if (r.c != kNoAtom && r.o != kNoAtom) point.side = unit_vector(place(r.o) - place(r.c));
        open_.push_back(point);
      }
      if (!wanted_[r.ca] || !r.bound_to_next) close();
    }
    close();
  }

  void add_nucleotides(const std::vector<Nucleotide>& nucleotides) {
    for (const Nucleotide& n : nucleotides) {
      if (wanted_[n.backbone]) {
        TracePoint point = point_at(n.backbone, TraceShape::nucleic);
        if (n.base != kNoAtom) {
          point.side = unit_vector(place(n.base) - place(n.backbone));
          made_.rungs.push_back({point.at, place(n.base), n.base, point.colour});
          if (n.corners > 0) add_plate(n, point);
        }
        open_.push_back(point);
      }
      if (!wanted_[n.backbone] || !n.bound_to_next) close();
    }
    close();
  }

  CartoonTraces take() { return std::move(made_); }

 private:
  RealPoint place(std::uint32_t atom) const { return position_angstrom(molecule_, atom) - origin_; }
  TracePoint point_at(std::uint32_t atom, TraceShape shape) const {
    return {place(atom), {}, shape, atom, colours_[atom]};
  }

  // The rung ends at the ring's atom that is bound to the sugar, which is the nearest one.
  void add_plate(const Nucleotide& n, const TracePoint& point) {
    BasePlate plate;
    plate.corners = n.corners;
    plate.atom = n.base;
    plate.colour = point.colour;
    const RealPoint sugar = n.sugar != kNoAtom ? place(n.sugar) : point.at;
    RealPoint& end = made_.rungs.back().to;
    for (std::size_t k = 0; k < plate.corners; ++k) {
      const RealPoint& at = plate.outline[k] = place(n.outline[k]);
      if (k == 0 || length(at - sugar) < length(end - sugar)) end = at;
    }
    made_.plates.push_back(plate);
  }

  void close() {
    const Trace open = std::exchange(open_, {});
    Trace trace;
    for (const TracePoint& point : open) {
      // Two residues at one place have no direction between them.
      if (trace.empty() || !(trace.back().at == point.at)) trace.push_back(point);
    }
    if (trace.size() < 2) return;
    add_sides(trace);
    turn_alike(trace);
    straighten_strands(trace);
    made_.points += trace.size();
    made_.traces.push_back(std::move(trace));
  }

  const Molecule& molecule_;
  const RealPoint origin_;
  const std::vector<bool>& wanted_;
  const std::vector<Rgb8>& colours_;
  Trace open_;
  CartoonTraces made_;
};

}  // namespace

CartoonTraces make_traces(const Molecule& molecule, const std::array<double, 3>& origin,
                          const SecondaryModel& secondary,
                          const std::vector<Nucleotide>& nucleotides,
                          const std::vector<bool>& wanted, const std::vector<Rgb8>& colours) {
  TraceMaker maker(molecule, origin, wanted, colours);
  maker.add_protein(secondary);
  maker.add_nucleotides(nucleotides);
  return maker.take();
}

}  // namespace alphascope
