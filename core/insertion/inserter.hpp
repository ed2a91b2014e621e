// SPDX-License-Identifier: GPL-3.0-or-later
// Adds balls to a triangulation, one after another (Bowyer, Watson): the cells that are in conflict
// with the new ball are replaced by those that join it with the faces around them.
//
// Several inserters may work on one triangulation at the same time. Each claims balls, and nobody
// can claim infinity. An inserter reads a cell only while it holds two of the cell's balls, and
// replaces it only while it holds three. So nobody replaces a cell that another one reads. It
// crosses a face only while it holds two of the face's balls, and sets the neighbour there only
// then. No two inserters can hold two balls of one face. Each face of a replaced cell has two balls
// that are held. So a new cell, which has the new ball besides, has three. Whoever changed a cell
// or a neighbour before has held one of the same balls, so a claim on that makes the change
// visible.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/insertion/cell.hpp"
#include "core/insertion/cell_store.hpp"
#include "core/insertion/claims.hpp"

namespace alphascope {

enum class Insertion : std::uint8_t {
  added,
  hidden,
  // Nothing has changed:
  in_use,  // another inserter holds balls that are needed
  no_room  // the store is full
};

// Aligned, so that two threads do not write to one cache line.
class alignas(128) Inserter {
 public:
  // The balls and the store outlive the inserter.
  Inserter(std::span<const InsertedBall> balls, CellStore& store)
      : balls_(balls.data()), store_(store), number_of_(balls.size() + 1, 0) {}

  // Makes the first tetrahedron, of four balls that are not in a plane, and the cells around it.
  // Returns a cell.
  std::uint32_t begin(std::array<std::uint32_t, 4> balls);

  // A cell near a ball, found by a walk from another one. Only while no inserter has claims.
  std::uint32_t cell_near(std::uint32_t ball, std::uint32_t cell);

  // From now on others may change the triangulation, too. The next ball is inserted from this cell,
  // of which the inserter claims balls; false if it cannot. Numbers are those of Claims.
  bool begin_sharing(Claims& claims, std::uint8_t number, std::uint32_t cell);
  // Gives claims back, but not those on balls of a cell, from which it can go on.
  void release_all_but(std::uint32_t cell);
  // Gives all claims back. The inserter is the only one from now on.
  void end_sharing();

  // Adds a ball. `cell` is one near it, and becomes another one. While the triangulation is shared,
  // it is the one from the call before. The inserter holds two of its balls.
  Insertion insert(std::uint32_t ball, std::uint32_t& cell);

 private:
  // A face around the cavity: with the new ball first, its balls make a cell.
  struct Face {
    std::uint32_t balls[3];
    std::uint32_t outside;  // as in Cell::across
  };
  enum class Walk : std::uint8_t { conflict, no_conflict, in_use };

  // Whether the inserter holds so many balls of a cell. If not, it claims more first. The ball at
  // one corner may be left out.
  bool hold(const Cell& cell, int count, int but = 4);
  bool claim(std::uint32_t ball);
  // By how much a ball is in conflict with a cell, and the error of that.
  struct Conflict {
    double value, error;
    bool is_certain() const { return value > error || value < -error; }
  };
  Conflict conflict(const Cell& cell, const InsertedBall& m) const;
  bool in_conflict(const Cell& cell, const InsertedBall& m) const;
  bool exactly_in_conflict(const Cell& cell, const InsertedBall& m) const;
  Insertion insert_from(std::uint32_t ball, std::uint32_t& cell);
  Walk walk(const InsertedBall& m, std::uint32_t& cell);
  bool find_cavity(const InsertedBall& m, std::uint32_t first);
  bool have_room(std::size_t cells);
  std::uint32_t take_cell();
  void see_corners(const InsertedBall& from);
  bool number_corners();
  void number_corners_by_sorting();
  void fill_cavity(std::uint32_t ball);
  void find_neighbours_by_sorting();

  const InsertedBall* const balls_;
  CellStore& store_;
  Cell* cells_ = nullptr;
  Claims* claims_ = nullptr;  // null: there is no other inserter
  std::uint8_t number_ = 0;
  static constexpr std::size_t kMostHeld = 64;  // of claims that may be needed no more
  std::vector<std::uint32_t> held_;             // balls

  std::vector<std::uint32_t> free_;
  CellBlock fresh_;
  std::uint32_t turn_ = 0;  // varies the way of a walk

  // Of one insertion.
  std::vector<std::uint32_t> cavity_;  // cells; while it is searched, 4 times as in Cell::across
  std::vector<Face> faces_;
  // The balls of faces, seen from the new one.
  static constexpr std::size_t kMostNumbered = 255;
  std::vector<CornerBall> corners_;
  std::vector<std::uint32_t> corner_balls_;
  // Of each ball, and of infinity as the last: its number among those, from 1. All are 0 between
  // insertions.
  std::vector<std::uint8_t> number_of_;
  std::vector<std::array<std::uint32_t, 3>> places_;  // of each face: its balls among the corners
  std::vector<std::uint32_t> new_cells_;              // of each face
  // By two corners of a face in their order: the face of its new cell there.
  static constexpr std::size_t kMostInTable = 64;  // corners
  std::vector<std::uint32_t> at_edge_;
};

}  // namespace alphascope
