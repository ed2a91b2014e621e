// SPDX-License-Identifier: GPL-3.0-or-later
// Writes surfaces, spheres and scripts of channels.
#include "core/document/channels/channel_export.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include "core/channel/channel_tube.hpp"
#include "core/clearance/clearance.hpp"
#include "core/document/channels/channel_records.hpp"
#include "core/document/channels/channel_text.hpp"
#include "core/document/store/definition.hpp"
#include "core/document/store/inputs.hpp"
#include "core/geometry/lattice_alpha.hpp"
#include "core/radii/radii_set.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/write/viewer_script.hpp"
#include "core/write/write_mesh.hpp"
#include "core/write/write_spheres.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

constexpr std::array kChannelExports{
    ShapeExportInfo{ShapeExport::ply, ".ply", "PLY: surface",
                    "its surface in the colours of the profile, binary: MeshLab, CloudCompare",
                    "channel.ply"},
    ShapeExportInfo{ShapeExport::glb, ".glb", "GLB: surface",
                    "its surface in the colours of the profile: ChimeraX, web pages, Blender",
                    "channel.glb"},
    ShapeExportInfo{ShapeExport::spheres, ".pqr", "PQR: spheres",
                    "spheres along its line, as atoms: programs for molecules", "channel.pqr"},
    ShapeExportInfo{ShapeExport::chimerax, ".cxc", "ChimeraX script",
                    "opens the molecule, colours what is at the bottleneck; with spheres and a "
                    "surface",
                    "channel.cxc"},
    ShapeExportInfo{ShapeExport::pymol, ".pml", "PyMOL script",
                    "opens the molecule, colours what is at the bottleneck; with spheres",
                    "channel.pml"}};

Mesh::Colour colour_of(double radius_angstrom) {
  const Rgb8 c = water_band_colour(water_band(radius_angstrom));
  return {c.r, c.g, c.b};
}

void write_files(ShapeExport format, const FoundChannel& found, const RecordSource& source,
                 const fs::path& path, const std::vector<AtomicFile*>& files) {
  if (format == ShapeExport::spheres) return write_channel_spheres(found, source, *files.at(0));
  if (!is_script(format)) {
    return write_channel_surface(found, source, format == ShapeExport::glb, *files.at(0));
  }
  const std::string why = why_no_script(*source.molecule);
  if (!why.empty()) throw std::invalid_argument(why);
  files.at(0)->write(channel_script(found, source, format, script_files(format, path)));
  write_channel_spheres(found, source, *files.at(1));
  if (format == ShapeExport::chimerax) write_channel_surface(found, source, true, *files.at(2));
}

}  // namespace

std::span<const ShapeExportInfo> channel_exports() {
  return kChannelExports;
}

ShapeHeader channel_header(const FoundChannel& found, const RecordSource& source) {
  ShapeHeader header{{"program", source.program.text()}};
  for (auto& line : source.provenance()) header.push_back(std::move(line));
  header.emplace_back("widest_angstrom", all_digits(found.channel->widest_angstrom));
  if (found.way) header.emplace_back("through", found.way->through);
  if (found.cover) header.emplace_back("covers", cover_text(*found.cover));
  for (const std::string& note : source.molecule->notes) header.emplace_back("note", note);
  return header;
}

void write_channel_surface(const FoundChannel& found, const RecordSource& source, bool glb,
                           AtomicFile& file) {
  ChannelTube tube = channel_tube(*found.channel);
  Mesh mesh{"channel", std::move(tube.points), std::move(tube.triangles), {}};
  for (const double radius : tube.radii_angstrom) mesh.colours.push_back(colour_of(radius));
  (glb ? write_glb : write_ply)({mesh}, channel_header(found, source), file, {});
}

void write_channel_spheres(const FoundChannel& found, const RecordSource& source,
                           AtomicFile& file) {
  const Lattice lattice = source.lattice();
  const auto nearest = [&](double x) { return lattice.angstrom(lattice.nearest_units(x)); };
  SphereGroup group{1, {}, "CHN"};
  for (const ChannelSample& sample : found.channel->samples) {
    const RealPoint& p = sample.position_angstrom;
    const RealPoint written{nearest(p.x), nearest(p.y), nearest(p.z)};
    // The sphere's centre is rounded, so its radius is reduced by the shift to stay inside the
    // channel.
    const double radius = sample.radius_angstrom - length(written - p);
    if (radius >= lattice.unit_angstrom()) group.spheres.push_back({written, radius});
  }
  write_spheres_pqr({group}, channel_header(found, source), lattice.digits, file);
}

std::string channel_script(const FoundChannel& found, const RecordSource& source,
                           ShapeExport format, const ShapeScriptFiles& files) {
  const Channel& channel = *found.channel;
  ScriptCavity one{1, colour_of(channel.narrowest().radius_angstrom), {}};
  for (const BallIndex ball : channel.touching) {
    one.lining.push_back(source.prepared->atom_of_ball[ball]);
  }
  const ViewerScript script{source.molecule.get(),
                            fs::absolute(source.molecule->source),
                            files.spheres,
                            files.surface,
                            {one},
                            channel_header(found, source),
                            "channel"};
  return format == ShapeExport::chimerax ? chimerax_script(script) : pymol_script(script);
}

Definition<FileWriter> channel_export(const ShapeExportInfo& format,
                                      const std::shared_ptr<const FoundChannel>& found,
                                      const RecordSource& source) {
  return {{.id = format.id,
           .title = "A channel for another program",
           .key = [found](const Inputs&) { return key_of_channel(*found); },
           .memory =
               [](const Inputs&) {
                 return MemoryNeed{0, 0};  // uses the channel, which exists already
               },
           .keep_stale = false},
          [found, source, format = format.format](const Inputs&, const RunContext&) {
            return std::make_shared<const FileWriter>(FileWriter{
                [found, source, format](const fs::path& path, const std::vector<AtomicFile*>& files,
                                        const RunContext&) {
                  write_files(format, *found, source, path, files);
                }});
          }};
}

}  // namespace alphascope
