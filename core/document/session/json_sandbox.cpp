// SPDX-License-Identifier: GPL-3.0-or-later
// Sandbox balls in session files. Their numbers are whole lattice units, so that nothing is
// rounded.
#include <array>
#include <cstdint>

#include "core/document/session/json_fields.hpp"
#include "core/geometry/lattice_alpha.hpp"

namespace alphascope {
namespace {

constexpr NumberRule kDigitsRule{"The digits", -9, kMaxLatticeDigits, "", true};

// Reads a list of x, y, z and r.
bool read_ball(const ReadJson& json, bool flat, SandboxBall& ball) {
  if (!json.is_array() || json.size() != 4) return false;
  std::array<std::int64_t, 4> units{};
  for (std::size_t k = 0; k < 4; ++k) {
    if (!json[k].is_number_integer()) return false;
    units[k] = json[k].get<std::int64_t>();
    const std::int64_t most = k < 3 ? kMaxLatticeCoordinate : kMaxLatticeRadius;
    if (units[k] < (k < 3 ? -most : 1) || units[k] > most) return false;
  }
  if (flat && units[2] != 0) return false;
  const auto unit = [&](std::size_t k) { return static_cast<std::int32_t>(units[k]); };
  ball = {{unit(0), unit(1), unit(2)}, unit(3)};
  return true;
}

}  // namespace

void FieldWriter::operator()(const char* name, const std::optional<Sandbox>& value) {
  if (!value) return;
  WrittenJson& json = to_[name] = WrittenJson::object();
  json["unit_digits"] = value->lattice.digits;
  json["flat"] = value->flat;
  WrittenJson& balls = json["balls"] = WrittenJson::array();
  for (const SandboxBall& b : value->balls) {
    balls.push_back({b.centre.x, b.centre.y, b.centre.z, b.radius});
  }
}

void FieldReader::operator()(const char* name, std::optional<Sandbox>& value) {
  const ReadJson* const found = take_object(name);
  if (found == nullptr) return;
  const std::size_t faults = findings_.wrong.size();
  FieldReader inner(*found, below(name), findings_);
  Sandbox read;
  inner("unit_digits", read.lattice.digits, kDigitsRule);
  inner("flat", read.flat);
  if (const ReadJson* const balls = inner.take_list("balls", kMostSandboxBalls)) {
    for (const ReadJson& json : *balls) {
      SandboxBall ball;
      if (!read_ball(json, read.flat, ball)) {
        JsonPlace place = inner.below("balls");
        place.push_back(std::to_string(read.balls.size()));
        wrong(place, json,
              "a list of four whole numbers of the unit: x, y, z (0 where \"flat\" is true) and "
              "the radius, which is at least 1");
        break;
      }
      read.balls.push_back(ball);
    }
  }
  inner.finish();
  if (findings_.wrong.size() == faults) value = std::move(read);
}

}  // namespace alphascope
