// SPDX-License-Identifier: GPL-3.0-or-later
// The pane on the chosen cavities: sentences on them, and their lining residues.
#include <algorithm>
#include <string>

#include "core/cavity/cavity_table.hpp"
#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "ui/panels/cavities/cavity_columns.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

std::string count_text(std::size_t n, const char* one, const char* many) {
  return with_separators(static_cast<long long>(n)) + " " + (n == 1 ? one : many);
}

// --- the pane

std::string title_of(const CavityPage& page) {
  if (page.selected_rows.size() == 1) {
    return "Cavity " + std::to_string(page.selected_rows.front() + 1);
  }
  if (page.selected_rows.empty())
    return "The selection does not exist at this alpha or solvent radius";
  return count_text(page.selected_rows.size(), "cavity", "cavities") + " selected";
}

std::string chain_names(const SelectedCavities& drawn) {
  std::string names;
  for (std::size_t k = 0; k < drawn.residues.size(); ++k) {
    const bool last = k + 1 == drawn.residues.size();
    names += (k == 0 ? "" : last ? " and " : ", ") + drawn.residues[k].chain;
  }
  return names;
}

void mouths_sentences(PanelContext& ctx, const CavityPage& page, std::size_t row) {
  const CavityLine& line = page.rows.lines->of[row];
  const std::string text = line.is_part ? part_text(line) : mouths_text(line.mouths);
  if (text.empty()) return;
  muted_wrapped(ctx, text);
  record(ctx, "cavities.mouths");
  network_end_sentences(ctx, page, row);
}

void sentences(PanelContext& ctx, const CavityPage& page) {
  const std::string merged = merged_text(page);
  if (!merged.empty()) {
    wrapped_text(merged);
    record(ctx, "cavities.merged");
  }
  if (page.selected_rows.size() != 1) return;
  const std::size_t row = page.selected_rows.front();
  const CavityLine& line = page.rows.lines->of[row];
  const std::string holds = cavity_text(page.rows, "holds", row);
  if (page.rows.contents && !holds.empty()) wrapped_text("Holds " + holds);
  muted_wrapped(ctx, "Name, of the four atoms around its deepest point: " +
                         cavity_name(*page.rows.lines->atoms, page.rows.table(), row));
  record(ctx, "cavities.name");
  tooltip(ctx, "Unlike the rank, the name does not change with alpha. Use the name in a paper.");
  const std::string between = between_text(line, chain_names(*page.drawn));
  if (!between.empty()) muted_wrapped(ctx, between);
  const std::string change = change_text(page, row);
  if (!change.empty()) muted_wrapped(ctx, change);
  mouths_sentences(ctx, page, row);
}

std::string lining_text(const SelectedCavities& drawn) {
  std::string text;
  for (const ChainLining& chain : drawn.residues) {
    text += (text.empty() ? "" : "\n") + chain.chain + (chain.chain.empty() ? "" : ": ") +
            chain.residues;
  }
  return text;
}

void lining(PanelContext& ctx, const SelectedCavities& drawn) {
  std::size_t count = 0;
  for (const ChainLining& chain : drawn.residues) count += chain.count;
  ImGui::AlignTextToFramePadding();
  muted_text(ctx, "lined by " + count_text(count, "residue", "residues"));
  ImGui::SameLine(0, ctx.px(8));
  if (button(ctx, "cavities.copy", "Copy", {0, 0}, ButtonKind::quiet)) {
    ImGui::SetClipboardText(lining_text(drawn).c_str());
    ctx.state.notice = "The list of residues is in the clipboard.";
  }
  tooltip(ctx, "Copies the list of residues.");
  wrapped_text(lining_text(drawn));
  record(ctx, "cavities.lining");
}

}  // namespace

std::string between_text(const CavityLine& line, const std::string& chains) {
  if (line.bodies > 1) {
    return "It lies between " + count_text(line.bodies, "separate body", "separate bodies") +
           ", not within one.";
  }
  if (!line.lining.at_interface()) return {};
  return chains.empty() ? "It lies between two chains, and no other chain lines it."
                        : "It lies at the interface of chains " + chains + ".";
}

std::string change_text(const CavityPage& page, std::size_t row) {
  const CavityTable& table = page.rows.table();
  const CavityNumbers& numbers = *page.rows.lines->numbers;
  const auto at = page.changes.find(numbers.of[table.order[row]]);
  if (at == page.changes.end()) return {};
  std::string text;
  if (at->second.merged > 0) {
    text = count_text(at->second.merged, "other cavity has", "other cavities have") +
           " merged into it in the last movement.";
  }
  if (at->second.parted_from == CavityMatch::kNone) return text;
  const std::uint32_t from = numbers.cavity(at->second.parted_from);
  const auto place = std::find(table.order.begin(), table.order.end(), from);
  text +=
      (text.empty() ? "" : " ") + std::string("It has split off from ") +
      (place == table.order.end() ? "a cavity that no longer exists"
                                  : "cavity " + std::to_string(place - table.order.begin() + 1)) +
      " in the last movement.";
  return text;
}

void draw_selected_cavities(PanelContext& ctx, CavityPage& page, float height) {
  ImGui::BeginChild("chosen", {0, height});
  if (page.chosen.empty()) {
    muted_wrapped(ctx,
                  "Click a row to see the cavity and its lining. Ctrl+click adds one; "
                  "Shift+click selects a range.");
    return ImGui::EndChild();
  }
  ImGui::AlignTextToFramePadding();
  strong_text(ctx, title_of(page));
  record(ctx, "cavities.chosen");
  if (page.drawn && !page.selected_rows.empty()) {
    sentences(ctx, page);
    lining(ctx, *page.drawn);
  }
  ImGui::EndChild();
}

}  // namespace alphascope
