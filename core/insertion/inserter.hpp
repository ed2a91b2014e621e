// SPDX-License-Identifier: GPL-3.0-or-later
// Adds balls to a triangulation, one after another (Bowyer, Watson): the cells that are in conflict
// with the new ball are replaced by those that join it with the faces around them.
//
// Several inserters may work on one triangulation at the same time, each for one part of the balls.
// A cell belongs to a part if at least three of its balls do; infinity belongs to no part. An
// inserter replaces cells of its own part only. Each face of these has two balls of the part or
// more. So a new cell, which has the new ball besides, is of this part again. The inserter also
// reads the cells next to those, and sets their neighbour on its own side. Such a cell has two
// balls of this part, so it is of no other one, and nobody else changes that side of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/insertion/cell.hpp"
#include "core/insertion/cell_store.hpp"

namespace alphascope {

enum class Insertion : std::uint8_t {
  added,
  hidden,
  // Nothing has changed:
  out_of_reach,  // the walk to the ball would leave the part
  foreign,       // the ball is in conflict with cells of other parts
  no_room        // the store is full
};

// Aligned, so that two threads do not write to one cache line.
class alignas(128) Inserter {
 public:
  // The balls and the store outlive the inserter.
  Inserter(std::span<const InsertedBall> balls, CellStore& store)
      : balls_(balls.data()), store_(store), number_of_(balls.size() + 1, 0) {}

  // From now on the inserter uses the cells of one part. `part_of` has the part of each ball in the
  // triangulation and of each to come; null: all are of the same part.
  void use_part(const std::uint8_t* part_of, std::uint8_t part) {
    part_of_ = part_of;
    part_ = part;
  }

  // Makes the first tetrahedron, of four balls that are not in a plane, and the cells around it.
  // Returns a cell.
  std::uint32_t begin(std::array<std::uint32_t, 4> balls);

  // Adds a ball. `cell` is one of this part near it, and becomes another one.
  Insertion insert(std::uint32_t ball, std::uint32_t& cell);

  // A cell of any part, found by a walk from another one. Only while nobody changes cells.
  std::uint32_t cell_near(std::uint32_t ball, std::uint32_t cell);
  bool is_used(std::uint32_t cell) const { return store_.data()[cell].state == Cell::kUsed; }
  bool is_of_part(std::uint32_t cell) const { return is_mine(store_.data()[cell]); }

 private:
  // A face around the cavity: with the new ball first, its balls make a cell.
  struct Face {
    std::uint32_t balls[3];
    std::uint32_t outside;  // as in Cell::across
  };
  enum class Walk : std::uint8_t { conflict, no_conflict, foreign };

  bool is_mine(const Cell& cell) const {
    if (part_of_ == nullptr) return true;
    int mine = 0;
    for (const std::uint32_t ball : cell.ball)
      mine += ball != Cell::kInfinity && part_of_[ball] == part_;
    return mine >= 3;
  }
  // By how much a ball is in conflict with a cell, and the error of that.
  struct Conflict {
    double value, error;
    bool is_certain() const { return value > error || value < -error; }
  };
  Conflict conflict(const Cell& cell, const InsertedBall& m) const;
  bool in_conflict(const Cell& cell, const InsertedBall& m) const;
  bool exactly_in_conflict(const Cell& cell, const InsertedBall& m) const;
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
  const std::uint8_t* part_of_ = nullptr;
  std::uint8_t part_ = 0;

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
