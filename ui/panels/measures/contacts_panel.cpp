// SPDX-License-Identifier: GPL-3.0-or-later
// The page of contacts: the pairs of chains that touch in the complex on screen. A click selects
// the atoms of a contact.
#include <imgui.h>

#include <algorithm>

#include "core/document/commands/commands.hpp"
#include "core/document/measures/contact_results.hpp"
#include "core/document/reference/atom_set.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/settings/request.hpp"
#include "core/document/store/inputs.hpp"
#include "core/document/store/store.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/theme.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/table_cells.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

constexpr const char* kPage = "contacts";

struct ContactMemory {
  // Two chains whose contact a command wants to select, as soon as the contacts are known.
  std::string first, second;
  bool asked = false;
};

bool is_of(const ChainContact& contact, const ContactMemory& memory) {
  return (contact.first == memory.first && contact.second == memory.second) ||
         (contact.first == memory.second && contact.second == memory.first);
}

RefSet atoms_of(const ChainContact& contact, const BallReferences& atoms) {
  std::vector<Ref> refs;
  for (const std::vector<BallIndex>* const side : {&contact.of_first, &contact.of_second}) {
    for (const BallIndex ball : *side) refs.emplace_back(atoms.atom(ball));
  }
  return RefSet(std::move(refs));
}

void select_asked(PanelContext& ctx, const ChainContacts& contacts, ContactMemory& memory) {
  if (!std::exchange(memory.asked, false)) return;
  const auto at = std::find_if(contacts.pairs.begin(), contacts.pairs.end(),
                               [&](const ChainContact& c) { return is_of(c, memory); });
  if (at == contacts.pairs.end()) {
    return ctx.state.refuse_late("Chains " + memory.first + " and " + memory.second +
                                 " do not touch in this complex. A larger alpha or solvent radius "
                                 "may join them.");
  }
  ctx.state.settings.selection.items = atoms_of(*at, *ctx.inputs.atoms);
}

void draw_row(PanelContext& ctx, const ChainContact& contact, std::size_t row, bool current) {
  const auto number = [](std::size_t n) { return with_separators(static_cast<long long>(n)); };
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(row));
  const std::string name = contact.first + " – " + contact.second;
  if (ImGui::Selectable(name.c_str(), false, ImGuiSelectableFlags_SpanAllColumns) && current) {
    ctx.state.settings.selection.items = atoms_of(contact, *ctx.inputs.atoms);
  }
  record(ctx, ("contacts.row." + std::to_string(row + 1)).c_str());
  tooltip(ctx, "A click selects the atoms of this contact; Z looks at them.");
  ImGui::PopID();
  number_cell(number(contact.edges));
  number_cell(number(contact.of_first.size()));
  number_cell(number(contact.of_second.size()));
}

void draw_table(PanelContext& ctx, const ChainContacts& contacts, bool current) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("contacts", 4, kFlags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("chains", ImGuiTableColumnFlags_WidthStretch);
  for (const char* const title : {"edges", "atoms of the first", "atoms of the second"}) {
    ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed,
                            std::max(ctx.px(90), title_width(title)));
  }
  ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(ctx.palette.text_muted));
  ImGui::TableHeadersRow();
  ImGui::PopStyleColor();
  if (!current) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f * ImGui::GetStyle().Alpha);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(contacts.pairs.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto row = static_cast<std::size_t>(i);
      draw_row(ctx, contacts.pairs[row], row, current);
    }
  }
  if (!current) ImGui::PopStyleVar();
  ImGui::EndTable();
}

// Says why there is no table; empty: there can be one.
std::string why_no_table(const PanelContext& ctx) {
  if (!ctx.state.has_molecule()) return "Open a molecule: contacts of its chains appear here.";
  if (ctx.state.settings.request.tetrahedra_only) {
    return "Only tetrahedra are computed. Contacts are edges: compute all simplices in Engine.";
  }
  return "";
}

void draw_contacts(PanelContext& ctx, ContactMemory& memory) {
  if (const std::string why = why_no_table(ctx); !why.empty()) {
    memory.asked = false;
    muted_wrapped(ctx, why);
    return record(ctx, "contacts.waiting");
  }
  const Derived<ChainContacts> contacts = ctx.store.want(chain_contacts(), ctx.inputs);
  if (contacts.ready()) select_asked(ctx, *contacts.value, memory);
  if (!contacts.value) {
    muted_wrapped(ctx, contacts.why.empty() ? "The contacts are being found." : contacts.why);
    return record(ctx, "contacts.waiting");
  }
  muted_wrapped(ctx,
                contacts.value->pairs.empty()
                    ? "No two chains touch in this complex. A larger alpha or solvent radius may "
                      "join them."
                    : "Atoms touch if an edge of the complex joins them. A solvent radius of 1.4 Å "
                      "counts atoms between which no water fits.");
  record(ctx, "contacts.text");
  if (!contacts.value->pairs.empty()) draw_table(ctx, *contacts.value, contacts.ready());
}

void add_contact_commands(Commands& commands, ViewState& state, ContactMemory& memory) {
  const auto chain = [](const char* name, const char* which) {
    return Parameter{.name = name, .help = std::string("The ") + which + " chain", .example = "A"};
  };
  commands.add({.id = "contacts.select",
                .title = "Select a contact of two chains",
                .help = "Selects the atoms of two chains that edges of the complex join",
                .synonyms = {{"interface chains touch"}},
                .parameters = {chain("first", "first"), chain("second", "second")},
                .why_not = [&state] { return state.result ? "" : "There is no complex yet."; },
                .run =
                    [&state, &memory](const Arguments& arguments) {
                      memory.first = arguments.text("first");
                      memory.second = arguments.text("second");
                      memory.asked = true;
                      state.show_page(kPage);
                      return Outcome();
                    }});
}

}  // namespace

std::unique_ptr<Panel> contacts_panel() {
  return panel_of(draw_contacts, add_contact_commands);
}

}  // namespace alphascope
