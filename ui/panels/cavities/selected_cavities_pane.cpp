// SPDX-License-Identifier: GPL-3.0-or-later
// The pane on the chosen cavities: how rows are chosen, how cavities are drawn, and their lining
// residues.
#include <algorithm>
#include <string>

#include "core/cavity_identity/cavity_numbers.hpp"
#include "core/chart/colour_map.hpp"
#include "core/document/cavities/cavity_names.hpp"
#include "core/document/reference/reference.hpp"
#include "core/molecule/molecule.hpp"
#include "ui/calls.hpp"
#include "ui/panels/cavities/cavity_parts.hpp"
#include "ui/panels/complex/display_rows.hpp"
#include "ui/rgb8.hpp"
#include "ui/widgets/format.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_shape/filling_spheres.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/cavities/selected_cavities.hpp"
#include "core/document/store/inputs.hpp"
#include "ui/layer.hpp"
#include "ui/panels/cavities/cavity_columns.hpp"
#include "ui/panels/cavities/cavity_page.hpp"
#include "core/molecule/atom_colours.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/panels/view_state.hpp"
#include "core/cavity/cavity_ground.hpp"
#include "core/document/store/store.hpp"
#include "core/document/store/answer.hpp"
#include "core/document/reference/appearance.hpp"

namespace alphascope {
namespace {

// Most cavities that can be chosen at once. With more, picture and list of residues would be
// unreadable.
constexpr std::size_t kMostChosen = 1000;

std::string count_text(std::size_t n, const char* one, const char* many) {
  return with_separators(static_cast<long long>(n)) + " " + (n == 1 ? one : many);
}

// --- choosing

// Chooses these rows. The atoms that line them become the selection, in the same entry of the
// history.
void select_rows(PanelContext& ctx, CavityPage& page, std::vector<std::size_t> rows) {
  if (rows.size() > kMostChosen) {
    ctx.state.notice =
        "No more than " + with_separators(kMostChosen) +
        " cavities can be selected at once. The first ones of the list are selected.";
    rows.resize(kMostChosen);
  }
  const CavityTable& table = page.rows.table();
  const BallReferences& atoms = *page.rows.lines->atoms;
  std::vector<Ref> sinks;
  for (const std::size_t row : rows) sinks.emplace_back(cavity_sink(atoms, table, row));
  ctx.state.settings.selection.cavities = RefSet(std::move(sinks));
  ctx.state.settings.selection.items = lining_of(page, rows);
  if (!rows.empty()) ctx.calls.view.zoom_to_selection();
}

// Returns the rows from the anchor to `row`, in the order shown.
std::vector<std::size_t> range_to(const CavityPage& page, std::size_t row) {
  auto from = std::find(page.order.begin(), page.order.end(), page.anchor.value_or(row));
  auto to = std::find(page.order.begin(), page.order.end(), row);
  if (from == page.order.end()) from = to;  // the filter hides the anchor
  if (to < from) std::swap(from, to);
  return {from, to + 1};
}

// --- layers

// Returns the balls to which layers belong. A picture of another solvent radius has other balls,
// but the same atoms at the same places.
std::shared_ptr<const BallSet> balls_of_layers(const PanelContext& ctx, const CavityPage& page) {
  const auto& shown = ctx.state.result;
  const bool same_atoms = shown && shown->prepared.get() == &page.rows.lines->atoms->prepared();
  return same_atoms ? shown->balls : page.drawn->table->ground->balls;
}

void add_layers(PanelContext& ctx, CavityPage& page, const SelectedCavity& cavity) {
  const auto add = [&](const char* kind, const Colour& colour) -> Layer& {
    auto layer = std::make_shared<Layer>();
    layer->id = std::string("cavities.") + kind + "." + std::to_string(cavity.row);
    layer->balls = page.layers_of;
    layer->key = page.layers_key;
    layer->colour = colour;
    page.layers.push_back(layer);
    return *layer;
  };
  const Colour colour = cavity_colour(page, cavity.row);
  if (!cavity.surface.empty() || !cavity.tetrahedra.empty() || !cavity.spheres.empty()) {
    Layer& body = add("body", colour);
    body.body = body.translucent = true;
    body.fades_rest = page.fades_rest;
    body.triangles = cavity.surface;
    body.tetrahedra = cavity.tetrahedra;
    for (const FillingSphere& sphere : cavity.spheres) {
      body.spheres.push_back({sphere.centre_angstrom, sphere.radius_angstrom});
    }
  }
  if (!cavity.rims.empty()) {
    Layer& rims = add("mouths", ctx.palette.text);
    rims.edges = cavity.rims;
    rims.body = true;  // else rims of the far side would show through
    rims.fades_rest = page.fades_rest;
  }
  if (page.choice.parts.numbers) {
    add("number", ctx.palette.text)
        .labels.push_back({cavity.place_angstrom, std::to_string(cavity.row + 1)});
  }
}

// Returns the radius in which held atoms are drawn, Å.
double held_radius(DropReason kind) {
  return kind == DropReason::ion ? 0.7 : 0.45;
}

// Draws the contents of the cavities once more, if they are drawn beside the body. Otherwise cavity
// and molecule would hide them. If the rest does not fade, they stay where they are.
void add_held(CavityPage& page) {
  if (!page.fades_rest) return;
  const BallReferences& references = *page.rows.lines->atoms;
  const Molecule& molecule = references.molecule();
  auto layer = std::make_shared<Layer>();
  layer->id = "cavities.held";
  layer->balls = page.layers_of;
  layer->key = page.layers_key;
  for (const ContainedAtom& held : page.drawn->held) {
    const Atom& atom = molecule.atoms[held.atom];
    const bool shown = held.in_body || shows(page.beside, held.kind, atom.element);
    if (!shown || page.hidden.contains(references.atom_of_molecule(held.atom))) continue;
    const auto angstrom = [&](std::int64_t units) { return molecule.lattice.angstrom(units); };
    layer->atoms.push_back(
        {{angstrom(atom.position.x), angstrom(atom.position.y), angstrom(atom.position.z)},
         held_radius(held.kind),
         to_colour(element_colour(atom.element)),
         held.atom});
  }
  if (!layer->atoms.empty()) page.layers.push_back(std::move(layer));
}

void make_layers(PanelContext& ctx, CavityPage& page) {
  bool old = std::exchange(page.layers_are_old, false);
  old |= std::exchange(page.beside, ctx.state.settings.display.beside) !=
         ctx.state.settings.display.beside;
  old |= !(std::exchange(page.hidden, ctx.state.settings.appearance.hidden) ==
           ctx.state.settings.appearance.hidden);
  old |= std::exchange(page.theme, ctx.state.theme()) != ctx.state.theme();
  const auto balls = page.drawn ? balls_of_layers(ctx, page) : nullptr;
  old |= std::exchange(page.layers_of, balls) != balls;
  if (!old) return;
  ++page.layers_key;
  page.layers.clear();
  if (!page.drawn) return;
  for (const SelectedCavity& cavity : page.drawn->of) add_layers(ctx, page, cavity);
  add_held(page);
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

Colour cavity_colour(const CavityPage& page, std::size_t row) {
  const CavityNumbers& numbers = *page.rows.lines->numbers;
  return to_colour(cavity_colour(numbers.of[page.rows.table().order[row]]));
}

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

void select_cavity(PanelContext& ctx, CavityPage& page, std::size_t row, HowSelected how) {
  if (how == HowSelected::range) return select_rows(ctx, page, range_to(page, row));
  page.anchor = row;
  if (how == HowSelected::alone) return select_rows(ctx, page, {row});
  std::vector<std::size_t> rows = page.selected_rows;
  const auto at = std::lower_bound(rows.begin(), rows.end(), row);
  if (at != rows.end() && *at == row) {
    rows.erase(at);
  } else {
    rows.insert(at, row);
  }
  select_rows(ctx, page, rows);
}

void select_all_cavities(PanelContext& ctx, CavityPage& page) {
  select_rows(ctx, page, page.order);
}

void clear_cavity_selection(PanelContext& ctx) {
  ctx.state.settings.selection.clear();
}

void draw_layers_of_cavities(PanelContext& ctx, CavityPage& page, bool current) {
  if (page.selected_rows.empty()) {
    page.layers_are_old |= page.drawn != nullptr;
    page.drawn = nullptr;
  } else if (current) {
    const auto drawn = ctx.store.want(
        selected_cavities(page.choice.sinks, page.choice.parts, page.choice.key), ctx.inputs);
    if (drawn.ready() && drawn.value != page.drawn) {
      page.drawn = drawn.value;
      page.layers_are_old = true;
    }
  }
  make_layers(ctx, page);
  for (const auto& layer : page.layers) ctx.state.layers.push_back(layer);
}

void draw_selected_cavities(PanelContext& ctx, CavityPage& page) {
  ImGui::BeginChild("chosen", {0, 0});
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

void cavity_parts_button(PanelContext& ctx, CavityPage& page) {
  if (button(ctx, "cavities.draw", "Draw")) ImGui::OpenPopup("cavities.draw");
  tooltip(ctx, "Chooses the parts of selected cavities that are drawn.");
  if (!ImGui::BeginPopup("cavities.draw")) return;
  close_on_escape();
  DrawnCavityParts& parts = page.parts;
  checkbox(ctx, "cavities.draw.surfaces", "surface", parts.surfaces);
  checkbox(ctx, "cavities.draw.tetrahedra", "tetrahedra", parts.tetrahedra);
  checkbox(ctx, "cavities.draw.spheres", "filling spheres", parts.spheres);
  tooltip(ctx,
          "Spheres that fill the cavity and touch the atoms around it, without the solvent "
          "radius.");
  checkbox(ctx, "cavities.draw.rims", "rims of mouths", parts.rims);
  checkbox(ctx, "cavities.draw.numbers", "numbers", parts.numbers);
  ImGui::Separator();
  if (checkbox(ctx, "cavities.draw.fade", "fade the rest", page.fades_rest)) {
    page.layers_are_old = true;
  }
  tooltip(ctx, ("Balls and simplices are at most " + percent_text(kFadedOpacity) +
                " opaque, whatever the section Display says, so that they do not hide the cavity. "
                "Its contents are drawn in front of everything else.")
                   .c_str());
  ImGui::Dummy({ctx.px(240), 0});  // a width, since the slider takes all there is
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Opacity");
  ImGui::SameLine(0, ctx.px(10));
  display_slider(ctx, display_field(&DisplaySettings::cavity_opacity), "cavities.draw.opacity");
  ImGui::EndPopup();
}

}  // namespace alphascope
