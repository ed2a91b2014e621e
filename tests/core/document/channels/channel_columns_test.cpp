// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the columns of samples and of ways.
#include "core/document/channels/channel_columns.hpp"
#include "core/channel/channel.hpp"
#include "core/document/channels/channel_results.hpp"
#include "core/document/tables/column.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/write/csv.hpp"

#include <gtest/gtest.h>

namespace alphascope {
namespace {

FoundChannel way() {
  FoundChannel found;
  found.channel.emplace();
  ChannelSample wide, narrow;
  wide.radius_angstrom = 3;
  narrow.position_angstrom = {1.25, -2, 30};
  narrow.radius_angstrom = 1.50390625;
  narrow.along_angstrom = 4;
  found.channel->samples = {wide, narrow};
  found.channel->bottleneck = 1;
  found.channel->widest_angstrom = 1.5;
  found.channel->length_angstrom = 12.345;
  found.way = WayFacts{.number = 2, .through = "chain A", .axis = {}, .lining_chains = {}};
  return found;
}

std::string text(const char* id) {
  return column_of(way_columns(), id).shown_text(way());
}

TEST(ChannelColumns, WaysHaveTheBottleneckAndItsPlace) {
  EXPECT_EQ(text("number"), "2");
  EXPECT_EQ(text("through"), "chain A");
  EXPECT_EQ(text("widest_angstrom"), "1.500") << "not the clearance at the sample";
  EXPECT_EQ(text("position"), "1.2, −2.0, 30.0");
  EXPECT_EQ(text("length_angstrom"), "12.3");
}

TEST(ChannelColumns, SamplesHaveTheirPlacesInCsv) {
  const CsvRow cells = csv_row_of(sample_columns(), way().channel->samples[1]);
  EXPECT_EQ(csv_names(cells), "along_angstrom,radius_angstrom,x_angstrom,y_angstrom,z_angstrom\n");
  EXPECT_EQ(csv_values(cells), "4,1.50390625,1.25,-2,30\n");
}

}  // namespace
}  // namespace alphascope
