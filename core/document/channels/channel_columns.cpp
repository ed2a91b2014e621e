// SPDX-License-Identifier: GPL-3.0-or-later
// The lists of columns of a channel's samples and of ways, and how a row gives their values. Nested
// values of JSON are in channel_records.cpp.
#include "core/document/channels/channel_columns.hpp"

#include <cstdint>

#include "core/channel/channel.hpp"
#include "core/chart/readable_number.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/document/tables/cell_value.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/real_point.hpp"
#include "core/text/fixed_digits.hpp"

namespace alphascope {
namespace {

std::string decimals(double value, int number) {
  return readable_number(fixed_digits(value, number));
}

const Column<ChannelSample> kSamples[] = {
    {.id = "along_angstrom",
     .title = "along",
     .unit = "Å",
     .help = "The place of the sample on the centre line, from its start.",
     .value = [](const ChannelSample& s) -> CellValue { return s.along_angstrom; }},
    {.id = "radius_angstrom",
     .title = "radius",
     .unit = "Å",
     .help = "The clearance there: the radius of the largest ball that touches no atom.",
     .value = [](const ChannelSample& s) -> CellValue { return s.radius_angstrom; }},
    {.id = "x_angstrom",
     .title = "x",
     .unit = "Å",
     .help = "The position of the sample, x.",
     .value = [](const ChannelSample& s) -> CellValue { return s.position_angstrom.x; },
     .files = InFiles::csv},
    {.id = "y_angstrom",
     .title = "y",
     .unit = "Å",
     .help = "The position of the sample, y.",
     .value = [](const ChannelSample& s) -> CellValue { return s.position_angstrom.y; },
     .files = InFiles::csv},
    {.id = "z_angstrom",
     .title = "z",
     .unit = "Å",
     .help = "The position of the sample, z.",
     .value = [](const ChannelSample& s) -> CellValue { return s.position_angstrom.z; },
     .files = InFiles::csv}};

const Column<FoundChannel> kWays[] = {
    {.id = "number",
     .title = "#",
     .help = "The rank of the way: 1 is the best.",
     .value = [](const FoundChannel& f) -> CellValue { return std::uint64_t{f.way->number}; },
     .files = InFiles::none},
    {.id = "through",
     .title = "through",
     .help = "The part of the molecule that the way leads through.",
     .value = [](const FoundChannel& f) -> CellValue { return f.way->through; },
     .files = InFiles::none},
    {.id = "widest_angstrom",
     .title = "bottleneck",
     .unit = "Å",
     .help = "The radius of the largest ball that passes.",
     .value = [](const FoundChannel& f) -> CellValue { return f.channel->widest_angstrom; },
     .text = [](const FoundChannel& f) { return bottleneck_radius_text(*f.channel); },
     .files = InFiles::json},
    {.id = "position",
     .title = "at",
     .unit = "Å",
     .help = "The place of the bottleneck.",
     .value = [](const FoundChannel& f) -> CellValue { return bottleneck_place(*f.channel); },
     .files = InFiles::none},
    {.id = "length_angstrom",
     .title = "length",
     .unit = "Å",
     .help = "The length of the centre line.",
     .value = [](const FoundChannel& f) -> CellValue { return f.channel->length_angstrom; },
     .text = [](const FoundChannel& f) { return decimals(f.channel->length_angstrom, 1); },
     .files = InFiles::json}};

}  // namespace

std::span<const Column<ChannelSample>> sample_columns() {
  return kSamples;
}

std::span<const Column<FoundChannel>> way_columns() {
  return kWays;
}

std::string bottleneck_place(const Channel& channel) {
  const RealPoint& p = channel.narrowest().position_angstrom;
  return decimals(p.x, 1) + ", " + decimals(p.y, 1) + ", " + decimals(p.z, 1);
}

}  // namespace alphascope
