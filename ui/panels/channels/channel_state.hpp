// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the page of channels between frames. Plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/document/reference/reference.hpp"
#include "core/geometry/principal_axes.hpp"

namespace alphascope {

struct FoundChannel;
struct Layer;

// The start of a channel. For `ways` both ends are outside, so there is no other end to choose.
enum class ChannelFrom : std::uint8_t { cavity, mouth, atoms, middle, point, ways };
enum class ChannelTo : std::uint8_t { out, along, both_ways, mouth, point };
enum class ChannelAxis : std::uint8_t { main, x, y, z, view };

struct ChannelState {
  std::string molecule;  // SHA-256 of its file
  ChannelFrom from = ChannelFrom::ways;
  ChannelTo to = ChannelTo::both_ways;
  std::size_t way = 1;  // number in the list, from 1; a larger number means the last way
  int from_mouth = 1, to_mouth = 1;  // mouths of the chosen cavity, from 1
  RealPoint from_point, to_point;    // Å, as typed
  ChannelAxis axis = ChannelAxis::main;
  bool backwards = false;        // against the axis; for one way along only
  RealPoint view_axis{0, 0, 1};  // the direction into the view when the user chose it
  RefSet cavities;               // the cavities chosen in the last frame
  RealPoint last_from;           // Å, start of the last channel
  std::uint64_t asked_for = 0;   // key of the large computation that the user started

  // The balls without solvent.
  std::shared_ptr<const PreparedBalls> prepared;
  std::shared_ptr<const BallReferences> atoms;
  std::uint64_t balls_key = 0;  // changes with the balls
  MainAxis main_axis;

  // The last answer. It is grey unless it answers the present question.
  std::shared_ptr<const FoundChannel> shown;
  std::string touching, covering;  // names of atoms
  std::vector<std::shared_ptr<const Layer>> layers;
  std::shared_ptr<const BallSet> layers_of;
  int cursor = -1;  // the sample under the mouse; −1: none
  std::shared_ptr<const Layer> cursor_layer;
};

}  // namespace alphascope
