// What the page of channels remembers between frames. Plain data.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/document/channels/channel_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/geometry/principal_axes.hpp"
#include "ui/layer.hpp"

namespace alphascope {

// `ways`: from outside to outside; then there is no other end.
enum class ChannelFrom : std::uint8_t { cavity, mouth, atoms, middle, point, ways };
enum class ChannelTo : std::uint8_t { out, along, both_ways, mouth, point };
enum class ChannelAxis : std::uint8_t { main, x, y, z, view };

struct ChannelMemory {
  std::string molecule;  // SHA-256 of its file
  ChannelFrom from = ChannelFrom::ways;
  ChannelTo to = ChannelTo::both_ways;
  std::size_t way = 1;               // of the list, from 1; of a shorter list, the last
  int from_mouth = 1, to_mouth = 1;  // of the chosen cavity
  RealPoint from_point, to_point;    // Å, typed
  ChannelAxis axis = ChannelAxis::main;
  bool backwards = false;        // against the axis; one way only
  RealPoint view_axis{0, 0, 1};  // into the view when that was chosen
  RefSet cavities;               // that were chosen in the last frame
  RealPoint last_from;           // Å, where the last channel began
  std::uint64_t asked_for = 0;   // the large question that was begun by hand

  // Of the balls without solvent.
  std::shared_ptr<const PreparedBalls> prepared;
  std::shared_ptr<const BallReferences> atoms;
  std::uint64_t balls_key = 0;  // another one for other balls
  MainAxis main_axis;

  // The last answer; grey while it is not that of the present question.
  std::shared_ptr<const FoundChannel> shown;
  std::string touching, covering;  // atoms by name
  std::vector<std::shared_ptr<const Layer>> layers;
  std::shared_ptr<const BallSet> layers_of;
  int cursor = -1;  // sample under the mouse
  std::shared_ptr<const Layer> cursor_layer;
};

}  // namespace alphascope
