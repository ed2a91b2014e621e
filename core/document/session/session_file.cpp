// SPDX-License-Identifier: GPL-3.0-or-later
// Writes, reads and checks session files.
#include "core/document/session/session_file.hpp"

#include <algorithm>
#include <stdexcept>

#include "core/document/session/json_fields.hpp"
#include "core/document/session/settings_fields.hpp"
#include "core/files/atomic_file.hpp"
#include "core/files/read_error.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/molecule/molecule.hpp"
#include "core/molecule/name_table.hpp"
#include "core/selection/selection_expression.hpp"
#include "core/selection/treatments.hpp"
#include "core/text/letter_case.hpp"
#include "core/text_files/text_file.hpp"

namespace alphascope {

namespace fs = std::filesystem;

namespace {

// The first member, so that the beginning of a file shows its kind.
constexpr const char* kVersionName = "alphascope_session";
constexpr int kVersion = 1;
// Limit on the size of a session file; the largest selection takes about 2 MB.
constexpr std::uint64_t kMostBytes = 8 << 20;
constexpr const char* kRemedy =
    "Choose a file that “Save session” has written, or save the session anew";

// All members after the version.
template <class Visitor>
void visit_fields(Visitor& v, SessionDocument& s) {
  v("written_by", s.written_by);
  v("molecule", s.molecule);
  v("radii_table", s.radii_table);
  visit_fields(v, s.settings);
  visit_fields(v, s.view);
}

void check_version(const fs::path& path, std::string_view text, const ReadJson& json) {
  const auto version = json.find(kVersionName);
  if (version == json.end()) {
    throw ReadError(
        path, 0, std::string("this is not a session: it has no \"") + kVersionName + "\"", kRemedy);
  }
  if (version->is_number() && *version == kVersion) return;
  const std::size_t line = line_of(text, {kVersionName});
  if (version->is_number() && *version > kVersion) {
    throw ReadError(path, line, "this session was written by a newer version of the program",
                    "Open it with that one, or save it anew with this one");
  }
  throw ReadError(path, line,
                  "the version of this session is unknown; this program reads version 1", kRemedy);
}

bool is_direction(const std::array<double, 3>& v) {
  return v[0] * v[0] + v[1] * v[1] + v[2] * v[2] > 1e-12;
}

// Checks values that are valid alone but not together.
void check_together(FieldReader& reader, const ReadJson& json, const SessionDocument& s) {
  if (s.molecule.empty() && !json.contains("molecule")) {
    reader.wrong({}, json, "an object with a \"molecule\"");
  }
  if (s.settings.open.balls.radii == RadiiSet::user && s.radii_table.empty()) {
    reader.wrong({"open", "radii"}, json["open"]["radii"],
                 "another set where there is no \"radii_table\"");
  }
  if (const auto fault = fault_of_selection(s.settings.open.balls.selection)) {
    reader.fault({"open", "selection"}, std::string("cannot be understood, ") + fault->what());
  }
  const std::vector<std::string>& treated = s.settings.open.balls.treated;
  for (std::size_t i = 0; i < treated.size(); ++i) {
    try {
      static_cast<void>(parse_treatment(treated[i]));
    } catch (const std::invalid_argument& error) {
      const char* const name = json["open"].contains("treatments") ? "treatments" : "treat";
      reader.fault({"open", name, std::to_string(i)},
                   std::string("cannot be understood: ") + error.what());
    }
  }
  const AlphaSlider& a = s.view.panels.alpha_slider;
  if (!(a.low < a.high)) {
    reader.wrong({"panels", "alpha_slider"}, json["panels"]["alpha_slider"],
                 "one whose low end is below its high end");
  }
  const CameraPlace& c = s.view.camera;
  if (!c.any()) return;
  const std::array<double, 3> ahead{c.target[0] - c.position[0], c.target[1] - c.position[1],
                                    c.target[2] - c.position[2]};
  const std::array<double, 3> right{ahead[1] * c.up[2] - ahead[2] * c.up[1],
                                    ahead[2] * c.up[0] - ahead[0] * c.up[2],
                                    ahead[0] * c.up[1] - ahead[1] * c.up[0]};
  if (!is_direction(ahead) || !is_direction(right)) {
    reader.wrong({"camera"}, json["camera"],
                 "a camera whose \"up\" is not parallel to its direction of view");
  }
}

// Throws with the fault of the lowest line, and the number of the others.
[[noreturn]] void refuse(const fs::path& path, std::string_view text,
                         const JsonFindings& findings) {
  std::vector<std::pair<std::size_t, std::string>> faults;
  for (const JsonFindings::Wrong& wrong : findings.wrong) {
    const std::string place = place_text(wrong.place);
    faults.emplace_back(line_of(text, wrong.place),
                        (place.empty() ? "the file " : "\"" + place + "\" ") + wrong.reason);
  }
  std::stable_sort(faults.begin(), faults.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string reason = faults.front().second;
  if (faults.size() > 1) {
    reason += "; " + std::to_string(faults.size() - 1) + " more of its values are invalid";
  }
  throw ReadError(path, faults.front().first, reason,
                  "Write such a value, or remove it to get that of a new window");
}

// Sentences on former names, and on members that this program does not know.
std::vector<std::string> notes_on(const JsonFindings& findings, std::string_view text) {
  std::vector<std::string> notes;
  const auto note = [&](const JsonPlace& place, const auto& said) {
    notes.push_back("Line " + std::to_string(line_of(text, place)) + ": " +
                    said("\"" + printable(place_text(place)) + "\""));
  };
  for (const JsonFindings::Renamed& renamed : findings.renamed) {
    note(renamed.place, [&](const std::string& name) { return name + renamed.note; });
  }
  constexpr std::size_t kMostTold = 8;
  for (const JsonPlace& place : findings.unknown) {
    if (notes.size() >= kMostTold + findings.renamed.size()) {
      notes.push_back("… and " + std::to_string(findings.unknown.size() - kMostTold) + " more.");
      break;
    }
    note(place, [](const std::string& name) {
      return "this program does not know " + name + ", and leaves it out.";
    });
  }
  return notes;
}

}  // namespace

std::string session_text(const SessionDocument& session) {
  WrittenJson json;
  json[kVersionName] = kVersion;
  FieldWriter writer(json);
  SessionDocument copy = session;  // a copy, because visit_fields() takes a mutable argument for
                                   // reading
  visit_fields(writer, copy);
  return json_file_text(json);
}

void write_session(const SessionDocument& session, const fs::path& path) {
  AtomicFile file(path, FileKind::session);
  file.write(session_text(session));
  file.commit();
}

ReadSession read_session(const fs::path& path, const RunContext& context) {
  const LoadedText loaded = load_text(path, kMostBytes, context, {}, FileKind::session);
  return parse_session(path, loaded.text);
}

ReadSession parse_session(const fs::path& path, std::string_view text) {
  const ReadJson json = parse_json_object(path, text, "session", kRemedy);
  check_version(path, text, json);
  ReadSession read;
  JsonFindings findings;
  FieldReader reader(json, {}, findings);
  static_cast<void>(reader.take(kVersionName));
  visit_fields(reader, read.session);
  reader.finish();
  if (findings.wrong.empty()) check_together(reader, json, read.session);
  if (!findings.wrong.empty()) refuse(path, text, findings);
  read.notes = notes_on(findings, text);
  return read;
}

bool looks_like_session(const fs::path& path) {
  return lower_case(path.extension().string()) == ".json";
}

}  // namespace alphascope
