// Areas and volumes as the rows of a table, by component, chain, residue or atom: the same in the
// window, in CSV and in JSON.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/document/measures/measure_names.hpp"
#include "core/document/measures/measure_results.hpp"
#include "core/document/store/answer.hpp"

namespace alphascope {

// The last four are of atoms with derivatives.
enum class MeasureColumn : std::uint8_t {
  number,  // in the order of the molecule
  name,
  atoms,
  area,
  area_share,
  volume,
  volume_share,
  exposed,
  area_gradient,
  area_by_radius,
  volume_gradient,
  volume_by_radius
};
inline constexpr int kMeasureColumns = 12;

// Which rows, and in which order.
struct MeasureQuery {
  MeasuredPer per = MeasuredPer::residue;
  std::string filter = {};  // a part of the name, in small or large letters; empty: all rows
  MeasureColumn column = MeasureColumn::number;  // to sort by
  bool descending = false;
  bool derivatives = false;  // with MeasuredPer::atom only
  friend bool operator==(const MeasureQuery&, const MeasureQuery&) = default;
};

struct MeasureRow {
  std::string name;  // "A:HIS 87"; a component has the name of its first atom
  std::uint32_t group = 0, first_ball = 0, atoms = 0;
  double area_angstrom2 = 0, volume_angstrom3 = 0;
  double exposed_share = 0;                       // of the area of its whole spheres, 0 to 1
  double share_of_area = 0, share_of_volume = 0;  // of the total
};

struct MeasureRows {
  MeasureQuery query;
  std::vector<MeasureRow> rows;
  std::size_t all = 0;                                  // how many there are without the filter
  std::vector<std::uint32_t> group_of_ball;             // MeasureRow::group, or kNoGroup
  std::shared_ptr<const UnionDerivatives> derivatives;  // null unless asked for

  // By which a row is sorted; 0 for its name. Gradients: their lengths.
  double value(const MeasureRow& row, MeasureColumn column) const;
};

// Atoms of `molecule` by ball, as in PreparedBalls. Throws Cancelled.
MeasureRows make_measure_rows(const MeasureQuery& query, const Molecule& molecule,
                              const std::vector<std::uint32_t>& atom_of_ball,
                              const MeasuredComplex& measured,
                              std::shared_ptr<const UnionDerivatives> derivatives,
                              const RunContext& context = {});

// The numbers of a row under the names that CSV and JSON give them (docs/output-files.md).
std::vector<std::pair<std::string, double>> measure_values(const MeasureRows& rows,
                                                           const MeasureRow& row);

// Of the complex that an answer has, while it is the one on screen.
Definition<MeasureRows> measure_rows(const MeasureQuery& query,
                                     const std::shared_ptr<const Answer>& answer);

}  // namespace alphascope
