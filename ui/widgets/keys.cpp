// SPDX-License-Identifier: GPL-3.0-or-later
// Reads key names and chords, and asks ImGui for them.
#include "ui/widgets/keys.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/text/letter_case.hpp"

namespace alphascope::key {
namespace {

constexpr std::pair<std::string_view, int> kNames[] = {
    {"esc", kEscape},    {"escape", kEscape},       {"enter", kEnter},
    {"tab", kTab},       {"backspace", kBackspace}, {"insert", kInsert},
    {"delete", kDelete}, {"pageup", kPageUp},       {"pagedown", kPageDown},
    {"right", kRight},   {"left", kLeft},           {"down", kDown},
    {"up", kUp},         {"home", kHome},           {"end", kEnd},
    {"space", kSpace},   {"alt", kLeftAlt},         {"menu", kMenu}};

bool take(std::string& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.erase(0, start.size());
  return true;
}

int code_of(const std::string& name) {
  for (const auto& [known, code] : kNames) {
    if (name == known) return code;
  }
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z') return kA + name[0] - 'a';
  if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return k0 + name[0] - '0';
  for (int n = 1; n <= 12; ++n) {
    if (name == "f" + std::to_string(n)) return kF1 + n - 1;
  }
  return 0;
}

}  // namespace

std::optional<Chord> read_chord(std::string_view text) {
  std::string name = lower_case(text);
  Chord chord;
  chord.control = take(name, "ctrl+");
  chord.shift = take(name, "shift+");
  chord.code = code_of(name);
  return chord.code == 0 ? std::nullopt : std::optional(chord);
}

bool pressed(const Chord& chord) {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl == chord.control && io.KeyShift == chord.shift &&
         ImGui::IsKeyPressed(chord.code, chord.arrow());
}

}  // namespace alphascope::key
