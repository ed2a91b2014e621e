// Which engine computes, on what, and whether CGAL is asked to agree.
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

struct EngineEntry {
  EngineOption option;
  const char* label;
  const char* help;
};

constexpr EngineEntry kEngines[] = {
    {EngineOption::automatic, "Automatic", "The GPU when it can be used, else the CPU."},
    {EngineOption::gpu, "GPU", "The facet engine on the graphics processor."},
    {EngineOption::cpu, "CPU", "The facet engine on all cores."},
    {EngineOption::cgal, "CGAL",
     "CGAL's regular triangulation of all balls, then alpha: the "
     "reference that the other engines are compared with."},
};

}  // namespace

void draw_engine_panel(PanelContext& ctx) {
  if (!section(ctx, "engine", "Engine")) return;
  ViewState& s = ctx.state;
  const char* current = "";
  for (const EngineEntry& e : kEngines) {
    if (e.option == s.compute.engine) current = e.label;
  }
  row_label(ctx, "Engine");
  const bool open = ImGui::BeginCombo("##engine", current);
  record(ctx, "engine.choice");
  if (open) {
    close_on_escape();
    for (const EngineEntry& e : kEngines) {
      const bool usable = e.option != EngineOption::gpu || s.gpu_available;
      if (ImGui::Selectable(e.label, e.option == s.compute.engine,
                            usable ? 0 : ImGuiSelectableFlags_Disabled)) {
        s.compute.engine = e.option;
      }
      record(ctx, (std::string("engine.") + e.label).c_str());
      tooltip(ctx, e.help);
    }
    ImGui::EndCombo();
  }
  ImGui::PushFont(ctx.fonts.small);
  if (!s.device_text.empty()) muted_wrapped(ctx, s.device_text);
  record(ctx, "engine.device");
  if (!s.gpu_text.empty()) muted_wrapped(ctx, s.gpu_text);
  ImGui::PopFont();
  checkbox(ctx, "engine.tetrahedra_only", "Tetrahedra only (faster)", s.compute.tetrahedra_only);
  tooltip(ctx,
          "Computes the tetrahedra of the complex without its triangles, edges and vertices: the "
          "thesis' sub-complex.");
  checkbox(ctx, "engine.auto_compare", "Compare with CGAL every time", s.auto_compare);
  tooltip(
      ctx,
      "After each change CGAL computes the same complex in the background, and both are compared "
      "simplex by simplex.");
}

}  // namespace alphascope
