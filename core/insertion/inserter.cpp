// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the cells in conflict with a ball and replaces them.
#include "core/insertion/inserter.hpp"

#include <algorithm>

#include "core/run/internal_error.hpp"

namespace alphascope {
namespace {

LiftedInt exactly_seen_from(const InsertedBall& i, const InsertedBall& m) {
  const auto whole = [](double v) { return static_cast<std::int64_t>(v); };
  const std::int64_t x = whole(m.x - i.x), y = whole(m.y - i.y), z = whole(m.z - i.z);
  return {x, y, z, x * x + y * y + z * z + whole(i.weight - m.weight)};
}

bool is_small(const LiftedInt& v) {
  const auto within = [](std::int64_t value, std::int64_t limit) {
    return value < limit && value > -limit;
  };
  return within(v.x, kSmallOffset) && within(v.y, kSmallOffset) && within(v.z, kSmallOffset) &&
         within(v.c, kSmallPower);
}

// The balls of a cell with a new ball in place of one of them, the new one first. The orientation
// stays.
constexpr int kOthers[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {1, 0, 2}};

}  // namespace

std::uint32_t Inserter::begin(std::array<std::uint32_t, 4> balls) {
  cells_ = store_.data();
  const InsertedBall& first = balls_[balls[0]];
  if (orientation(exactly_seen_from(first, balls_[balls[1]]),
                  exactly_seen_from(first, balls_[balls[2]]),
                  exactly_seen_from(first, balls_[balls[3]])) < 0)
    std::swap(balls[2], balls[3]);
  if (!have_room(5)) throw InternalError("There is no room for the first cells.");
  const std::uint32_t inner = take_cell();
  std::copy(balls.begin(), balls.end(), cells_[inner].ball);
  std::uint32_t outer[4];
  for (int k = 0; k < 4; ++k) {
    outer[k] = take_cell();
    Cell& cell = cells_[outer[k]];
    for (int n = 0; n < 3; ++n) cell.ball[n] = balls[static_cast<std::size_t>(kOthers[k][n])];
    cell.ball[3] = Cell::kInfinity;
    cell.across[3] = 4 * inner + static_cast<std::uint32_t>(k);
    cells_[inner].across[k] = 4 * outer[k] + 3;
  }
  for (int k = 0; k < 4; ++k) {
    Cell& cell = cells_[outer[k]];
    for (int corner = 0; corner < 3; ++corner) {
      // Across an edge of the facet lies the facet without this ball.
      const auto other = static_cast<std::uint32_t>(
          std::find(balls.begin(), balls.end(), cell.ball[corner]) - balls.begin());
      const Cell& next = cells_[outer[other]];
      const auto there = static_cast<std::uint32_t>(
          std::find(next.ball, next.ball + 3, balls[static_cast<std::size_t>(k)]) - next.ball);
      cell.across[corner] = 4 * outer[other] + there;
    }
    const InsertedBall& apex = balls_[cell.ball[0]];
    certify_cell_at_infinity(CornerBall(seen_from(apex, balls_[cell.ball[1]])),
                             CornerBall(seen_from(apex, balls_[cell.ball[2]])), cell);
    cell.state = Cell::kUsed;
  }
  Cell& cell = cells_[inner];
  certify_cell(CornerBall(seen_from(first, balls_[balls[1]])),
               CornerBall(seen_from(first, balls_[balls[2]])),
               CornerBall(seen_from(first, balls_[balls[3]])), cell);
  cell.state = Cell::kUsed;
  return inner;
}

bool Inserter::exactly_in_conflict(const Cell& cell, const InsertedBall& ball) const {
  const InsertedBall& i = balls_[cell.ball[0]];
  const LiftedInt j = exactly_seen_from(i, balls_[cell.ball[1]]),
                  k = exactly_seen_from(i, balls_[cell.ball[2]]), m = exactly_seen_from(i, ball);
  if (cell.at_infinity()) {
    const int side = orientation(j, k, m);
    // In the plane of the facet the power decides, as it does for the tetrahedron behind it: the
    // powers of its other ball and that ball's perturbation have no share in this plane.
    return side != 0 ? side > 0 : in_conflict(cells_[cell.across[3] / 4], ball);
  }
  const LiftedInt l = exactly_seen_from(i, balls_[cell.ball[3]]);
  const int cut = is_small(j) && is_small(k) && is_small(l) && is_small(m)
                      ? orthocentre_cut<Int128>(j, k, {0, l}, m)
                      : orthocentre_cut<WideInt<4>>(j, k, {0, l}, m);
  return cut > 0;
}

// Without a branch, as find_cavity() computes several at the same time.
inline Inserter::Conflict Inserter::conflict(const Cell& cell, const InsertedBall& m) const {
  const SeenBall seen = seen_from(balls_[cell.ball[0]], m);
  const double along = seen.x * cell.x + seen.y * cell.y + seen.z * cell.z;
  const double error = cell.error * (std::fabs(seen.x) + std::fabs(seen.y) + std::fabs(seen.z));
  const double power = cell.at_infinity() ? 0.0 : 1.0;
  return {along - power * seen.c, error + power * (6 * kUnitRoundoff * seen.size)};
}

inline bool Inserter::in_conflict(const Cell& cell, const InsertedBall& m) const {
  const Conflict found = conflict(cell, m);
  return found.is_certain() ? found.value > 0 : exactly_in_conflict(cell, m);
}

// Goes from cell to cell, each time through a face that has the ball in front of it, to the cell
// that holds the ball or to one in conflict with it. In a regular triangulation no such walk comes
// back to a cell.
Inserter::Walk Inserter::walk(const InsertedBall& m, std::uint32_t& at) {
  if (cells_[at].at_infinity() && !in_conflict(cells_[at], m)) {
    at = cells_[at].across[3] / 4;
  }
  int from = 4;  // the corner opposite the face that was crossed
  while (true) {
    const Cell& cell = cells_[at];
    if (in_conflict(cell, m)) return Walk::conflict;
    Vector3<double> seen[4];
    double length = 0;
    for (int n = 0; n < 4; ++n) {
      const InsertedBall& p = balls_[cell.ball[n]];
      seen[n] = {p.x - m.x, p.y - m.y, p.z - m.z};
      length = std::max({length, std::fabs(seen[n].x), std::fabs(seen[n].y), std::fabs(seen[n].z)});
    }
    const auto first = cross(seen[0], seen[1]), second = cross(seen[2], seen[3]);
    const double side[4] = {dot(second, seen[1]), -dot(second, seen[0]), dot(first, seen[3]),
                            -dot(first, seen[2])};
    const double error = 32 * kUnitRoundoff * length * length * length;
    int way = 4;
    bool ends = true;  // the ball is in this cell
    for (int step = 0; step < 4 && way == 4; ++step) {
      const int n = static_cast<int>((turn_ + static_cast<std::uint32_t>(step)) % 4);
      if (n == from || side[n] > error) continue;
      if (!(side[n] < -error)) {
        const int(&face)[3] = kOthers[n];
        if (orientation(exactly_seen_from(m, balls_[cell.ball[face[0]]]),
                        exactly_seen_from(m, balls_[cell.ball[face[1]]]),
                        exactly_seen_from(m, balls_[cell.ball[face[2]]])) >= 0)
          continue;
      }
      ends = false;
      if (hold(cell, 2, n)) way = n;
    }
    if (ends) return Walk::no_conflict;
    if (way == 4) return Walk::in_use;
    ++turn_;
    from = static_cast<int>(cell.across[way] % 4);
    at = cell.across[way] / 4;
    if (held_.size() > kMostHeld) release_all_but(at);
  }
}

// Collects the cells in conflict and the faces around them. False, and no mark is left, when others
// hold balls of these cells.
bool Inserter::find_cavity(const InsertedBall& m, std::uint32_t first) {
  Cell* const cells = cells_;
  // The cells next to it are looked at later, when they have come from memory.
  const auto take = [&](std::uint32_t entry) {
    cells[entry / 4].state = Cell::kInCavity;
    cavity_.push_back(entry);
    for (const std::uint32_t across : cells[entry / 4].across)
      __builtin_prefetch(&cells[across / 4]);
  };
  cavity_.clear();
  faces_.clear();
  if (!hold(cells[first], 3)) return false;
  take(4 * first);
  for (std::size_t n = 0; n < cavity_.size(); ++n) {
    // Each cell but the first was entered across the face opposite one of its corners.
    const Cell& cell = cells[cavity_[n] / 4];
    const std::uint32_t entry = cavity_[n] % 4, others = n == 0 ? 4 : 3;
    Conflict found[4];
    for (std::uint32_t k = 0; k < others; ++k)
      found[k] = conflict(cells[cell.across[(entry + 1 + k) % 4] / 4], m);
    for (std::uint32_t k = 0; k < others; ++k) {
      const std::uint32_t corner = (entry + 1 + k) % 4, across = cell.across[corner];
      const Cell& next = cells[across / 4];
      if (next.state == Cell::kInCavity) continue;
      if (found[k].is_certain() ? found[k].value > 0 : exactly_in_conflict(next, m)) {
        if (!hold(next, 3)) {
          for (const std::uint32_t c : cavity_) cells[c / 4].state = Cell::kUsed;
          return false;
        }
        take(across);
        continue;
      }
      const int(&face)[3] = kOthers[corner];
      std::uint32_t a = cell.ball[face[0]], b = cell.ball[face[1]], c = cell.ball[face[2]];
      while (a == Cell::kInfinity || b == Cell::kInfinity) {  // it goes last
        const std::uint32_t moved = a;
        a = b;
        b = c;
        c = moved;
      }
      faces_.push_back({{a, b, c}, across});
    }
  }
  for (std::uint32_t& c : cavity_) c /= 4;
  return true;
}

bool Inserter::have_room(std::size_t cells) {
  while (cavity_.size() + free_.size() + (fresh_.end - fresh_.begin) < cells) {
    const CellBlock block = store_.take_block();
    if (block.begin == block.end) return false;
    for (; fresh_.begin != fresh_.end; ++fresh_.begin) free_.push_back(fresh_.begin);
    fresh_ = block;
  }
  return true;
}

std::uint32_t Inserter::take_cell() {
  if (fresh_.begin != fresh_.end) return fresh_.begin++;
  const std::uint32_t cell = free_.back();
  free_.pop_back();
  return cell;
}

// Numbers the balls of all faces. False if they are too many.
bool Inserter::number_corners() {
  const auto infinity = static_cast<std::uint32_t>(number_of_.size() - 1);
  bool all = true;
  corner_balls_.clear();
  for (std::size_t f = 0; f < faces_.size() && all; ++f) {
    for (int n = 0; n < 3 && all; ++n) {
      const std::uint32_t ball = faces_[f].balls[n];
      std::uint8_t& number = number_of_[std::min(ball, infinity)];
      if (number == 0) {
        all = corner_balls_.size() < kMostNumbered;
        if (!all) break;
        corner_balls_.push_back(ball);
        number = static_cast<std::uint8_t>(corner_balls_.size());
      }
      places_[f][static_cast<std::size_t>(n)] = number - 1u;
    }
  }
  for (const std::uint32_t ball : corner_balls_) number_of_[std::min(ball, infinity)] = 0;
  return all;
}

void Inserter::number_corners_by_sorting() {
  corner_balls_.clear();
  for (const Face& face : faces_)
    corner_balls_.insert(corner_balls_.end(), face.balls, face.balls + 3);
  std::sort(corner_balls_.begin(), corner_balls_.end());
  corner_balls_.erase(std::unique(corner_balls_.begin(), corner_balls_.end()), corner_balls_.end());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (std::size_t n = 0; n < 3; ++n) {
      const auto at =
          std::lower_bound(corner_balls_.begin(), corner_balls_.end(), faces_[f].balls[n]);
      places_[f][n] = static_cast<std::uint32_t>(at - corner_balls_.begin());
    }
  }
}

void Inserter::see_corners(const InsertedBall& from) {
  places_.resize(faces_.size());
  if (!number_corners()) number_corners_by_sorting();
  corners_.resize(corner_balls_.size());
  for (std::size_t n = 0; n < corners_.size(); ++n) {
    if (corner_balls_[n] != Cell::kInfinity)
      corners_[n] = CornerBall(seen_from(from, balls_[corner_balls_[n]]));
  }
}

// Joins the new cells of faces with many corners: sorts their edges.
void Inserter::find_neighbours_by_sorting() {
  struct Edge {
    std::uint32_t low, high, own;
    bool operator<(const Edge& e) const { return low != e.low ? low < e.low : high < e.high; }
  };
  std::vector<Edge> edges;
  edges.reserve(3 * faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (std::uint32_t n = 0; n < 3; ++n) {
      const auto [low, high] = std::minmax(places_[f][(n + 1) % 3], places_[f][(n + 2) % 3]);
      edges.push_back({low, high, 4 * new_cells_[f] + n + 1});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t e = 0; e < edges.size(); e += 2) {
    const std::uint32_t a = edges[e].own, b = edges[e + 1].own;
    cells_[a / 4].across[a % 4] = b;
    cells_[b / 4].across[b % 4] = a;
  }
}

void Inserter::fill_cavity(std::uint32_t ball) {
  see_corners(balls_[ball]);
  new_cells_.assign(cavity_.begin(), cavity_.end());
  new_cells_.resize(std::min(cavity_.size(), faces_.size()));
  for (std::size_t n = new_cells_.size(); n < cavity_.size(); ++n) {
    cells_[cavity_[n]].state = Cell::kFree;
    free_.push_back(cavity_[n]);
  }
  while (new_cells_.size() < faces_.size()) new_cells_.push_back(take_cell());

  // Two faces meet at each edge, which their corners pass in opposite directions.
  const std::size_t count = corners_.size();
  const bool in_table = count <= kMostInTable;
  if (in_table) {
    if (at_edge_.size() < count * count) at_edge_.resize(count * count);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const auto [a, b, c] = places_[f];
      const std::uint32_t own = 4 * new_cells_[f];
      at_edge_[b * count + c] = own + 1;  // the edge opposite corner 1
      at_edge_[c * count + a] = own + 2;
      at_edge_[a * count + b] = own + 3;
    }
  }
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    const auto [a, b, c] = places_[f];
    Cell& cell = cells_[new_cells_[f]];
    if (face.balls[2] == Cell::kInfinity) {
      certify_cell_at_infinity(corners_[a], corners_[b], cell);
    } else {
      certify_cell(corners_[a], corners_[b], corners_[c], cell);
    }
    cell.state = Cell::kUsed;
    cell.ball[0] = ball;
    std::copy(face.balls, face.balls + 3, cell.ball + 1);
    cell.across[0] = face.outside;
    cells_[face.outside / 4].across[face.outside % 4] = 4 * new_cells_[f];
    if (!in_table) continue;
    cell.across[1] = at_edge_[c * count + b];
    cell.across[2] = at_edge_[a * count + c];
    cell.across[3] = at_edge_[b * count + a];
  }
  if (!in_table) find_neighbours_by_sorting();
}

std::uint32_t Inserter::cell_near(std::uint32_t ball, std::uint32_t cell) {
  cells_ = store_.data();
  walk(balls_[ball], cell);
  return cell;
}

bool Inserter::begin_sharing(Claims& claims, std::uint8_t number, std::uint32_t cell) {
  cells_ = store_.data();
  claims_ = &claims;
  number_ = number;
  return hold(cells_[cell], 2);
}

void Inserter::end_sharing() {
  for (const std::uint32_t ball : held_) claims_->release(ball);
  held_.clear();
  claims_ = nullptr;
}

bool Inserter::hold(const Cell& cell, int count, int but) {
  if (claims_ == nullptr) return true;
  for (int k = 0; k < 4; ++k) {
    if (k != but && cell.ball[k] != Cell::kInfinity) count -= claims_->has(number_, cell.ball[k]);
  }
  for (int k = 0; k < 4 && count > 0; ++k) {
    if (k != but && cell.ball[k] != Cell::kInfinity) count -= claim(cell.ball[k]);
  }
  return count <= 0;
}

bool Inserter::claim(std::uint32_t ball) {
  if (!claims_->claim(number_, ball)) return false;
  held_.push_back(ball);
  return true;
}

void Inserter::release_all_but(std::uint32_t cell) {
  const std::uint32_t(&kept)[4] = cells_[cell].ball;
  std::erase_if(held_, [&](std::uint32_t ball) {
    if (std::find(kept, kept + 4, ball) != kept + 4) return false;
    claims_->release(ball);
    return true;
  });
}

Insertion Inserter::insert(std::uint32_t ball, std::uint32_t& cell) {
  cells_ = store_.data();
  const Insertion result = insert_from(ball, cell);
  // The next ball needs many of the same claims.
  if (result == Insertion::in_use || held_.size() > kMostHeld) release_all_but(cell);
  return result;
}

Insertion Inserter::insert_from(std::uint32_t ball, std::uint32_t& cell) {
  const InsertedBall& m = balls_[ball];
  switch (walk(m, cell)) {
    case Walk::in_use:
      return Insertion::in_use;
    case Walk::no_conflict:
      return Insertion::hidden;
    case Walk::conflict:
      break;
  }
  if (!find_cavity(m, cell)) return Insertion::in_use;
  if (!have_room(faces_.size())) {
    for (const std::uint32_t c : cavity_) cells_[c].state = Cell::kUsed;
    return Insertion::no_room;
  }
  if (claims_ != nullptr && !claim(ball)) throw InternalError("A new ball is held already.");
  fill_cavity(ball);
  cell = new_cells_[0];
  cavity_.clear();
  return Insertion::added;
}

}  // namespace alphascope
