// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON result of one answer, and its header.
#include "app/cli/cavities/cavity_records.hpp"

#include "app/cli/text/text.hpp"
#include "core/document/cavities/cavity_json.hpp"

namespace alphascope::cli {

Json result_json(const CavityAnswer& answer, const CavitiesOptions& options) {
  Json stages = Json::array();
  for (const StageTime& s : answer.times.stages) {
    stages.push_back({{"stage", s.label}, {"ms", s.milliseconds}, {"setup", s.setup}});
  }
  Json json = cavities_json(answer);
  const Json request = json["request"], input = json["input"];
  for (const char* last : {"request", "input"}) json.erase(last);
  json["notes"] = notes_of(answer, options);
  json["timings_ms"] = {
      {"wall", answer.times.wall_milliseconds}, {"device", answer.device}, {"stages", stages}};
  json["request"] = request;
  json["input"] = input;
  return json;
}

std::vector<std::pair<std::string, std::string>> noted_header(const CavityAnswer& answer) {
  auto header = cavity_header(answer);
  for (const std::string& note : input_notes(answer.input)) header.emplace_back("note", note);
  return header;
}

}  // namespace alphascope::cli
