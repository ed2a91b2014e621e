// SPDX-License-Identifier: GPL-3.0-or-later
// Writes channels as CSV and JSON; also the functions of channel_json.hpp.
#include "core/document/channels/channel_records.hpp"

#include "core/document/channels/channel_columns.hpp"
#include "core/document/channels/channel_json.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/key.hpp"
#include "core/document/tables/column_json.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/selection/provenance.hpp"
#include "core/triangulation/memory_need.hpp"

namespace alphascope {
namespace {

Json point_json(const RealPoint& p) {
  return {p.x, p.y, p.z};
}

const char* kind_id(ChannelEnds::Kind kind) {
  switch (kind) {
    case ChannelEnds::Kind::between:
      return "between";
    case ChannelEnds::Kind::out:
      return "out";
    case ChannelEnds::Kind::out_along:
      return "out_along";
    case ChannelEnds::Kind::through:
      break;
  }
  return "through";
}

using Written = std::string (*)(const FoundChannel& found, const RecordSource& source);
Definition<std::string> written(const std::shared_ptr<const FoundChannel>& found,
                                const RecordSource& source, std::string_view id, Written write) {
  return {{.id = id,
           .title = "A channel as a table",
           .key = [found](const Inputs&) { return key_of_channel(*found); },
           .memory =
               [found](const Inputs&) {
                 const std::uint64_t bytes = 2000 * found->channel->samples.size();
                 return MemoryNeed{bytes, bytes};
               },
           .keep_stale = false},
          [found, source, write](const Inputs&, const RunContext&) {
            return std::make_shared<const std::string>(write(*found, source));
          }};
}

}  // namespace

Key key_of_channel(const FoundChannel& found) {
  return {1, 0, std::hash<const void*>()(&found) | 1};
}

CsvRow channel_csv_row(const ChannelSample& sample, const RecordSource& source,
                       const Provenance& provenance) {
  CsvRow row = csv_row_of(sample_columns(), sample);
  row.insert(row.end(), provenance.begin(), provenance.end());
  row.emplace_back("program", source.program.text());
  return row;
}

std::string channel_csv_text(const Channel& channel, const RecordSource& source) {
  const Provenance provenance = source.provenance();
  std::string text;
  for (const ChannelSample& sample : channel.samples) {
    const CsvRow row = channel_csv_row(sample, source, provenance);
    text += (text.empty() ? csv_names(row) : "") + csv_values(row);
  }
  return text;
}

Json channel_json(const BallReferences& atoms, const Channel& channel) {
  Json touching = Json::array(), samples = Json::array();
  for (const BallIndex ball : channel.touching) {
    touching.push_back({{"ball", ball}, {"atom", atom_text(atoms, ball)}});
  }
  for (const ChannelSample& sample : channel.samples) {
    Json& json = samples.emplace_back(Json::object());
    add_keys_up_to(json, sample_columns(), sample);
    json["position_angstrom"] = point_json(sample.position_angstrom);
  }
  return {{"widest_angstrom", channel.widest_angstrom},
          {"step_angstrom", channel.step_angstrom},
          {"open", channel.is_open()},
          {"limit", channel_limit_id(channel.limit)},
          {"bottleneck",
           {{"position_angstrom", point_json(channel.narrowest().position_angstrom)},
            {"radius_angstrom", channel.narrowest().radius_angstrom},
            {"along_angstrom", channel.narrowest().along_angstrom},
            {"touching", touching}}},
          {"length_angstrom", channel.length_angstrom},
          {"samples", samples}};
}

Json channel_request_json(const ChannelEnds& ends) {
  using Kind = ChannelEnds::Kind;
  Json request{{"kind", kind_id(ends.kind)}, {"point_angstrom", point_json(ends.from)}};
  if (ends.kind == Kind::between) request["to_angstrom"] = point_json(ends.to);
  if (ends.kind == Kind::out_along || ends.kind == Kind::through) {
    request["along"] = point_json(ends.along);
  }
  request["end_radius_angstrom"] = ends.end_radius_angstrom;
  return request;
}

Json channel_request_json(const FoundChannel& found) {
  if (!found.way) return channel_request_json(found.ends);
  return {{"kind", "way"}, {"way", found.way->number}};
}

void add_cover_json(const FoundChannel& found, Json& json) {
  json["way"] = nullptr;
  if (found.way) {
    const WayFacts& way = *found.way;
    json["way"] = {{"number", way.number},
                   {"through", way.through},
                   {"axis", point_json(way.axis)},
                   {"part_angstrom", way.part_angstrom},
                   {"lining_chains", way.lining_chains},
                   {"not_counted",
                    {{"ions", way.ions},
                     {"ligand_atoms", way.ligand_atoms},
                     {"other_atoms", way.other_atoms}}}};
  }
  if (found.cover) {
    json["covered_angstrom"] = found.cover->covered_angstrom;
    json["whole_angstrom"] = found.cover->whole_angstrom;
  }
  json["is_whole"] = found.is_whole();
}

Json ways_json(const FoundWays& ways) {
  Json list = Json::array();
  for (const auto& found : ways.ways) {
    Json way;
    add_cover_json(*found, way);
    add_keys(way, way_columns(), *found, {"widest_angstrom"});
    way["position_angstrom"] = point_json(found->channel->narrowest().position_angstrom);
    add_keys_up_to(way, way_columns(), *found);
    list.push_back(std::move(way));
  }
  return list;
}

Definition<std::string> channel_csv(const std::shared_ptr<const FoundChannel>& found,
                                    const RecordSource& source) {
  return written(found, source, "channel.csv", [](const FoundChannel& of, const RecordSource& by) {
    return channel_csv_text(*of.channel, by);
  });
}

Definition<std::string> channel_as_json(const std::shared_ptr<const FoundChannel>& found,
                                        const RecordSource& source) {
  return written(found, source, "channel.json", [](const FoundChannel& of, const RecordSource& by) {
    Json json = channel_json(BallReferences(by.molecule, by.prepared), *of.channel);
    add_cover_json(of, json);
    json["request"] = channel_request_json(of);
    json["input"] = input_json(by);
    json["program"] = program_json(by.program);
    return json_text(json);
  });
}

}  // namespace alphascope
