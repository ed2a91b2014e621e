// Which engine computes, on what, with which of the thesis' optimisations, and whether CGAL is
// asked to agree.
#include <algorithm>

#include "ui/panels/format.hpp"
#include "ui/panels/panels.hpp"

namespace alphascope {
namespace {

struct EngineEntry {
  EngineOption option;
  bool needs_gpu;
  const char* name;  // of the widget
  const char* label;
  const char* help;
};

constexpr EngineEntry kEngines[] = {
    {EngineOption::automatic, false, "engine.Automatic", "Automatic",
     "The GPU when it can be used, else the CPU."},
    {EngineOption::gpu, true, "engine.GPU", "GPU", "The facet engine on the graphics processor."},
    {EngineOption::cpu, false, "engine.CPU", "CPU", "The facet engine on all cores."},
    {EngineOption::tuples_gpu, true, "engine.tuples-gpu", "Thesis' tuples, GPU",
     "The thesis' own pipeline on the graphics processor: all 4-tuples of neighbours are made, "
     "then tested. Slow at large alpha; Esc cancels."},
    {EngineOption::tuples_cpu, false, "engine.tuples-cpu", "Thesis' tuples, CPU",
     "The thesis' own pipeline on all cores: all 4-tuples of neighbours are made, then tested. "
     "Slow at large alpha; Esc cancels."},
    {EngineOption::cgal, false, "engine.CGAL", "CGAL",
     "CGAL's regular triangulation of all balls, then alpha: the reference that the other engines "
     "are compared with."},
};

const char* why_no_gpu(const GpuInfo& gpu) {
  return gpu.known ? gpu.why_not.c_str() : "Looking for a graphics processor…";
}

void engine_entry(PanelContext& ctx, const EngineEntry& e) {
  ViewState& s = ctx.state;
  const bool usable = !e.needs_gpu || s.gpu.usable;
  ImGui::BeginDisabled(!usable);
  if (ImGui::Selectable(e.label, e.option == s.compute.engine)) s.compute.engine = e.option;
  ImGui::EndDisabled();
  record(ctx, e.name);
  tooltip(ctx, usable ? e.help : why_no_gpu(s.gpu));
}

void engine_choice(PanelContext& ctx) {
  const auto chosen =
      std::find_if(std::begin(kEngines), std::end(kEngines),
                   [&](const EngineEntry& e) { return e.option == ctx.state.compute.engine; });
  row_label(ctx, "Engine");
  const bool open = ImGui::BeginCombo("##engine", chosen->label);
  record(ctx, "engine.choice");
  if (!open) {
    tooltip(ctx, chosen->help);
    return;
  }
  close_on_escape();
  for (const EngineEntry& e : kEngines) engine_entry(ctx, e);
  ImGui::EndCombo();
}

// "NVIDIA H200, 139 GB, CUDA driver 13.0, compute capability 9.0".
std::string gpu_text(const GpuInfo& gpu) {
  if (!gpu.usable) return std::string("No GPU in use. ") + why_no_gpu(gpu);
  return "GPU: " + gpu.name + ", " + bytes_text(gpu.memory_bytes) + ", " + gpu.driver +
         ", compute capability " + gpu.capability;
}

void device(PanelContext& ctx) {
  const ViewState& s = ctx.state;
  ImGui::PushFont(ctx.fonts.small);
  if (!s.device_text.empty()) muted_wrapped(ctx, s.device_text);
  record(ctx, "engine.device");
  muted_wrapped(ctx, s.gpu.known ? gpu_text(s.gpu) : why_no_gpu(s.gpu));
  record(ctx, "engine.gpu");
  if (!s.engine_note.empty() && s.engine_note != s.gpu.why_not) {
    muted_wrapped(ctx, s.engine_note);
  }
  ImGui::PopFont();
}

struct Switch {
  const char* name;
  const char* label;
  bool TupleControls::*value;
  bool of_gpu;
  const char* help;
};

constexpr Switch kSwitches[] = {
    {"tuples.grid", "Grid suited to the molecule", &TupleControls::suited_grid, false,
     "Off: the thesis' 100 × 100 × 100 cells, whatever the molecule's size."},
    {"tuples.edge", "Edge optimisation", &TupleControls::edge_optimisation, false,
     "Only tuples whose six pairs of grown balls all meet. Off: every 4-tuple of neighbours."},
    {"tuples.alpha", "Alpha optimisation", &TupleControls::alpha_optimisation, false,
     "Drops tuples with an ortho-radius above alpha before kernel II."},
    {"tuples.pinned", "Pinned memory", &TupleControls::pinned, true,
     "Page-locked host memory, which the GPU copies from and to directly."},
    {"tuples.streams", "Streams", &TupleControls::streams, true,
     "Two batches of tuples side by side, so that copies and kernels overlap."},
    {"tuples.texture", "Textures", &TupleControls::texture, true,
     "Kernels read balls through the texture cache instead of plain memory."},
};

void tuple_switches(PanelContext& ctx) {
  ComputeControls& c = ctx.state.compute;
  if (!is_tuple_engine(c.engine)) return;
  muted_text(ctx, "The thesis' optimisations (same result)");
  for (const Switch& s : kSwitches) {
    const bool applies = !s.of_gpu || c.engine == EngineOption::tuples_gpu;
    ImGui::BeginDisabled(!applies);
    checkbox(ctx, s.name, s.label, c.tuples.*s.value);
    ImGui::EndDisabled();
    const std::string help = applies ? s.help : std::string(s.help) + "\nHas no effect on the CPU.";
    tooltip(ctx, help.c_str());
  }
}

void auto_compare(PanelContext& ctx) {
  ViewState& s = ctx.state;
  const bool possible = s.molecule.balls <= kMostBallsToCompareUnasked;
  bool on = s.auto_compare && possible;
  ImGui::BeginDisabled(!possible);
  if (checkbox(ctx, "engine.auto_compare", "Compare with CGAL every time", on)) s.auto_compare = on;
  ImGui::EndDisabled();
  const std::string most =
      with_separators(static_cast<long long>(kMostBallsToCompareUnasked)) + " balls";
  const std::string help =
      possible
          ? "After each change CGAL computes the same complex in the background, and both are "
            "compared simplex by simplex."
          : "This molecule has more than " + most +
                ": CGAL would take too long to follow each change. “Compare” in the timings, or "
                "the key C, compares once.";
  tooltip(ctx, help.c_str());
}

}  // namespace

void draw_engine_panel(PanelContext& ctx) {
  if (!section(ctx, "engine", "Engine")) return;
  ViewState& s = ctx.state;
  engine_choice(ctx);
  checkbox(ctx, "engine.tetrahedra_only", "Tetrahedra only (faster)", s.compute.tetrahedra_only);
  tooltip(ctx,
          "Computes the tetrahedra of the complex without its triangles, edges and vertices: the "
          "thesis' sub-complex.");
  auto_compare(ctx);
  // Last what comes and goes: nothing that one clicks is below it.
  tuple_switches(ctx);
  device(ctx);
}

}  // namespace alphascope
