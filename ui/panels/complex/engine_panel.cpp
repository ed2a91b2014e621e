// SPDX-License-Identifier: GPL-3.0-or-later
// The section on the engine: the choice of engine, its device, the thesis' optimisations, and
// whether CGAL compares each result.
#include <algorithm>

#include "core/document/reference/appearance.hpp"
#include "core/document/settings/request.hpp"
#include "core/engine/engine_choice.hpp"
#include "core/engine/gpu_device.hpp"
#include "core/tuples/tuple_options.hpp"
#include "ui/panels/panel.hpp"
#include "ui/panels/panels.hpp"
#include "ui/panels/view_info.hpp"
#include "ui/panels/view_state.hpp"
#include "ui/panels/window_settings.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/style.hpp"
#include "ui/widgets/widgets.hpp"

namespace alphascope {
namespace {

const char* why_no_gpu(const std::optional<GpuDevice>& gpu) {
  return gpu ? gpu->why_not.c_str() : "Looking for a graphics processor…";
}

void engine_line(PanelContext& ctx, const EngineEntry& engine) {
  ViewState& s = ctx.state;
  const bool usable = !engine.needs_gpu || has_gpu(s);
  ImGui::BeginDisabled(!usable);
  if (ImGui::Selectable(engine.title.data(), engine.choice == s.settings.request.engine)) {
    s.settings.request.engine = engine.choice;
  }
  ImGui::EndDisabled();
  record(ctx, ("engine." + std::string(engine.id)).c_str());
  tooltip(ctx, usable ? engine.help : why_no_gpu(s.gpu));
}

void engine_choice(PanelContext& ctx) {
  const EngineEntry& chosen = engine_entry(ctx.state.settings.request.engine);
  row_label(ctx, "Engine");
  const bool open = list_field(ctx, "engine.choice", chosen.title.data());
  if (!open) {
    tooltip(ctx, chosen.help);
    return;
  }
  for (const EngineEntry& engine : engine_table()) engine_line(ctx, engine);
  ImGui::EndCombo();
}

// Returns a text such as "GPU: NVIDIA H200, 139 GB, CUDA driver 13.0, compute capability 9.0".
std::string gpu_text(const GpuDevice& gpu) {
  if (!gpu.usable) return "No GPU in use. " + gpu.why_not;
  return "GPU: " + gpu.name + ", " + bytes_text(gpu.memory_bytes) + ", " + gpu.driver +
         ", compute capability " + gpu.capability_text();
}

void device(PanelContext& ctx) {
  const ViewState& s = ctx.state;
  ImGui::PushFont(ctx.fonts.small);
  if (!s.device_text.empty()) muted_wrapped(ctx, s.device_text);
  record(ctx, "engine.device");
  muted_wrapped(ctx, s.gpu ? gpu_text(*s.gpu) : why_no_gpu(s.gpu));
  record(ctx, "engine.gpu");
  if (!s.engine_note.empty() && (!s.gpu || s.engine_note != s.gpu->why_not)) {
    muted_wrapped(ctx, s.engine_note);
  }
  ImGui::PopFont();
}

struct Switch {
  const char* name;
  const char* label;
  bool of_gpu;
  bool (*is_on)(const TupleOptions&);
  void (*turn)(TupleOptions&, bool on);
  const char* help;
};

template <bool TupleOptions::*kValue>
constexpr Switch plain(const char* name, const char* label, bool of_gpu, const char* help) {
  return {name,
          label,
          of_gpu,
          [](const TupleOptions& t) { return t.*kValue; },
          [](TupleOptions& t, bool on) { t.*kValue = on; },
          help};
}

constexpr Switch kSwitches[] = {
    {"tuples.grid", "Grid suited to the molecule", false,
     [](const TupleOptions& t) { return t.grid == TupleGridKind::automatic; },
     [](TupleOptions& t, bool on) {
       t.grid = on ? TupleGridKind::automatic : TupleGridKind::thesis;
     },
     "Off: the thesis' 100 × 100 × 100 cells, whatever the molecule's size."},
    plain<&TupleOptions::edge_optimisation>("tuples.edge", "Edge optimisation", false,
                                            "Tests only tuples whose six pairs of grown balls all "
                                            "meet. Off: every 4-tuple of neighbours."),
    plain<&TupleOptions::alpha_optimisation>(
        "tuples.alpha", "Alpha optimisation", false,
        "Drops tuples with an ortho-radius above alpha before kernel II."),
    plain<&TupleOptions::pinned>(
        "tuples.pinned", "Pinned memory", true,
        "Uses page-locked host memory, to and from which the GPU copies directly."),
    {"tuples.streams", "Streams", true, [](const TupleOptions& t) { return t.streams > 1; },
     [](TupleOptions& t, bool on) { t.streams = on ? TupleOptions().streams : 1; },
     "Two batches of tuples side by side, so that copies and kernels overlap."},
    plain<&TupleOptions::texture>(
        "tuples.texture", "Textures", true,
        "Kernels read balls through the texture cache instead of plain memory."),
};

void tuple_switches(PanelContext& ctx) {
  Request& request = ctx.state.settings.request;
  if (!is_tuple_engine(request.engine)) return;
  muted_text(ctx, "The thesis' optimisations (same result)");
  for (const Switch& s : kSwitches) {
    const bool applies = !s.of_gpu || needs_gpu(request.engine);
    bool on = s.is_on(request.tuples);
    ImGui::BeginDisabled(!applies);
    if (checkbox(ctx, s.name, s.label, on)) s.turn(request.tuples, on);
    ImGui::EndDisabled();
    const std::string help = applies ? s.help : std::string(s.help) + "\nHas no effect on the CPU.";
    tooltip(ctx, help.c_str());
  }
}

void auto_compare(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const bool possible = s.molecule.balls <= kMostBallsToCompareUnasked;
  bool on = s.window.auto_compare && possible;
  ImGui::BeginDisabled(!possible);
  if (checkbox(ctx, "engine.auto_compare", "Compare with CGAL every time", on))
    s.window.auto_compare = on;
  ImGui::EndDisabled();
  const std::string most =
      with_separators(static_cast<long long>(kMostBallsToCompareUnasked)) + " balls";
  const std::string help =
      possible ? "After each change CGAL computes the same complex in the background, and both are "
                 "compared simplex by simplex."
               : "This molecule has more than " + most +
                     ". CGAL is too slow to follow each change. Press C, or “Compare” in the "
                     "timings, to compare once.";
  tooltip(ctx, help.c_str());
}

void draw_engine(PanelContext& ctx) {
  if (!section(ctx, "engine", "Engine")) return;
  ViewState& s = ctx.state;
  engine_choice(ctx);
  checkbox(ctx, "engine.tetrahedra_only", "Tetrahedra only (faster)",
           s.settings.request.tetrahedra_only);
  tooltip(ctx,
          "Computes the tetrahedra of the complex without its triangles, edges and vertices: the "
          "thesis' sub-complex.");
  auto_compare(ctx);
  // Rows that come and go are last, so no control below them moves.
  tuple_switches(ctx);
  device(ctx);
}

}  // namespace

std::unique_ptr<Panel> engine_panel() {
  return panel_of(draw_engine);
}

}  // namespace alphascope
