// SPDX-License-Identifier: GPL-3.0-or-later
// Writes surfaces, spheres and scripts of cavities.
#include "core/document/cavities/cavity_export.hpp"

#include <array>
#include <stdexcept>

#include "core/cavity/cavity_ground.hpp"
#include "core/cavity/cavity_table.hpp"
#include "core/cavity_shape/cavity_mesh.hpp"
#include "core/cavity_shape/filling_spheres.hpp"
#include "core/chart/colour_map.hpp"
#include "core/clearance/clearance.hpp"
#include "core/document/cavities/cavity_results.hpp"
#include "core/document/reference/reference.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/molecule/rgb8.hpp"
#include "core/selection/prepare_balls.hpp"
#include "core/text/printable.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/write/viewer_script.hpp"
#include "core/write/write_mesh.hpp"
#include "core/write/write_spheres.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr std::array kCavityExports{
    ShapeExportInfo{ShapeExport::ply, ".ply", "PLY: surfaces",
                    "surfaces with colours, binary: MeshLab, CloudCompare", "cavities.ply"},
    ShapeExportInfo{ShapeExport::glb, ".glb", "GLB: surfaces",
                    "surfaces with colours: ChimeraX, web pages, Blender", "cavities.glb"},
    ShapeExportInfo{ShapeExport::spheres, ".pqr", "PQR: spheres",
                    "spheres that fill them, as atoms: programs for molecules", "cavities.pqr"},
    ShapeExportInfo{ShapeExport::chimerax, ".cxc", "ChimeraX script",
                    "opens the molecule, colours what lines them; with spheres and surfaces",
                    "cavities.cxc"},
    ShapeExportInfo{ShapeExport::pymol, ".pml", "PyMOL script",
                    "opens the molecule, colours what lines them; with spheres", "cavities.pml"}};

std::array<std::uint8_t, 3> colour_of_row(std::size_t row) {
  const Rgb8 c = cavity_colour(row);
  return {c.r, c.g, c.b};
}

void write_cavities(ShapeExport format, const CavityExportSource& source, const fs::path& path,
                    const std::vector<AtomicFile*>& files, const RunContext& context) {
  if (format == ShapeExport::spheres) {
    return write_cavity_spheres(source, *files.at(0), context.cancel);
  }
  if (!is_script(format)) {
    return write_cavity_surfaces(source, format == ShapeExport::glb, *files.at(0));
  }
  const std::string why = why_no_script(*source.facts.source.molecule);
  if (!why.empty()) throw std::invalid_argument(why);
  files.at(0)->write(cavity_script(source, format, script_files(format, path)));
  write_cavity_spheres(source, *files.at(1), context.cancel);
  if (format == ShapeExport::chimerax) write_cavity_surfaces(source, true, *files.at(2));
}

}  // namespace

std::span<const ShapeExportInfo> cavity_exports() {
  return kCavityExports;
}

void write_cavity_surfaces(const CavityExportSource& source, bool as_glb, AtomicFile& file) {
  const CavityFacts& facts = source.facts;
  std::vector<Mesh> meshes;
  for (const std::size_t row : facts.rows) {
    CavityMesh mesh =
        cavity_mesh(*facts.table().ground, facts.table().found, facts.table().order[row]);
    meshes.push_back(
        {"cavity " + std::to_string(row + 1) + " (" + facts.kind(row) + ") " + facts.name(row),
         std::move(mesh.points), std::move(mesh.triangles), colour_of_row(row)});
  }
  (as_glb ? write_glb : write_ply)(meshes, source.header, file, {});
}

void write_cavity_spheres(const CavityExportSource& source, AtomicFile& file,
                          const CancelToken& cancel) {
  const CavityFacts& facts = source.facts;
  const CavityTable& table = facts.table();
  std::vector<SphereGroup> all;
  if (!facts.rows.empty()) {
    const Clearance clearance(*facts.source.prepared->balls);
    for (const std::size_t row : facts.rows) {
      all.push_back({row + 1, filling_spheres(*table.ground, table.cavity(row), clearance,
                                              kMostFillingSpheres, cancel)});
    }
  }
  write_spheres_pqr(all, source.header, table.ground->balls->lattice.digits, file);
}

std::string cavity_script(const CavityExportSource& source, ShapeExport format,
                          const ShapeScriptFiles& files) {
  const CavityFacts& facts = source.facts;
  const Molecule& molecule = *facts.source.molecule;
  ViewerScript script{&molecule,    fs::absolute(molecule.source), files.spheres, files.surface, {},
                      source.header};
  const auto& atom_of_ball = facts.source.prepared->atom_of_ball;
  for (const std::size_t row : facts.rows) {
    ScriptCavity cavity{row + 1, colour_of_row(row), {}};
    for (const BallIndex ball : facts.table().measure(row).lining) {
      cavity.lining.push_back(atom_of_ball[ball]);
    }
    script.cavities.push_back(std::move(cavity));
  }
  return format == ShapeExport::chimerax ? chimerax_script(script) : pymol_script(script);
}

Definition<FileWriter> cavity_export(const ShapeExportInfo& format, const CavityRowsWanted& rows,
                                     const RecordSource& source) {
  return {{.id = format.id,
           .title = "Cavities for another program",
           .made_of = {&cavity_table()},
           .key = [rows, prepared = source.prepared](
                      const Inputs& in) { return key_of_cavity_file(in, rows, *prepared); },
           .memory =
               [](const Inputs&) {
                 return MemoryNeed{0, 0};  // uses the table, which exists already
               },
           .keep_stale = false},
          [rows, source, format = format.format](const Inputs& in, const RunContext&) {
            const auto facts =
                std::make_shared<const CavityFacts>(facts_without_volumes(in, rows, source));
            auto header = cavity_header(*facts);
            for (const std::string& note : source.molecule->notes) {
              header.emplace_back("note", note);
            }
            return std::make_shared<const FileWriter>(FileWriter{
                [facts, header, format](const fs::path& path, const std::vector<AtomicFile*>& files,
                                        const RunContext& context) {
                  write_cavities(format, {*facts, header}, path, files, context);
                }});
          }};
}

}  // namespace alphascope
