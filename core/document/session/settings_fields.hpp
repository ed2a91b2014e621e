// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of all settings in session files: name and bounds of each. Writer and reader
// (json_fields.hpp) visit these lists, so a new setting needs one line here. Settings of the
// display have theirs in display_fields.cpp.
#pragma once

#include <type_traits>
#include <variant>

#include "core/document/commands/number_input.hpp"
#include "core/document/session/session_file.hpp"
#include "core/document/settings/display_fields.hpp"
#include "core/document/settings/drawn_object.hpp"
#include "core/document/settings/settings.hpp"

namespace alphascope {

inline constexpr NumberRule kThreadsRule{"The number of threads", 0, 1024, "", true};
inline constexpr NumberRule kStreamsRule{"The number of streams", 1, 8, "", true};
inline constexpr NumberRule kBatchRule{"The number of tuples", 0, 2e9, "", true};
inline constexpr NumberRule kObjectOpacityRule{"The opacity", kLeastOpacity, 1};
inline constexpr NumberRule kPlaceRule{"A coordinate", -1e9, 1e9, "Å"};
inline constexpr NumberRule kAspectRule{"The aspect", 0, 1e6};
inline constexpr NumberRule kPageHeightRule{"The height", 0, 1e5};

template <class Visitor>
void visit_fields(Visitor& v, OpenOptions& o) {
  BallOptions& b = o.balls;
  v("format", o.read.format);
  v("assembly", o.assembly);
  v.model("model", b.model);
  v("altlocs", b.altlocs);
  v("hydrogens", b.hydrogens);
  v("polymers", b.polymers);
  v("ligands", b.ligands);
  v("ions", b.ions);
  v("waters", b.waters);
  v("dummies", b.dummies);
  v("chains", b.chains);
  v("without_chains", b.without_chains);
  v("selection", b.selection);
  v("radii", b.radii);
  v("radius_edits", b.overrides);
  v.formerly("treat", "treatments");
  v("treatments", b.treated);
  v("sandbox", o.sandbox);
}

template <class Visitor>
void visit_fields(Visitor& v, TupleOptions& t) {
  v("grid", t.grid);
  v("edge_optimisation", t.edge_optimisation);
  v("alpha_optimisation", t.alpha_optimisation);
  v("pinned", t.pinned);
  v("streams", t.streams, kStreamsRule);
  v("texture", t.texture);
  v("tuples_per_batch", t.tuples_per_batch, kBatchRule);
}

template <class Visitor>
void visit_fields(Visitor& v, Request& r) {
  v("alpha_angstrom2", r.alpha_angstrom2, kAlphaRule);
  v("solvent_radius_angstrom", r.solvent_radius_angstrom, kSolventRule);
  v("tetrahedra_only", r.tetrahedra_only);
  v("engine", r.engine);
  v("threads", r.threads, kThreadsRule);
  v.object("tuples", r.tuples);
}

template <class Visitor>
void visit_fields(Visitor& v, AtomsBesideBody& b) {
  for (const BesideKind& kind : kBesideKinds) v(kind.id, b.*kind.member);
}

template <class Visitor>
void visit_fields(Visitor& v, DisplaySettings& d) {
  for (const DisplayField& field : display_fields()) {
    if (field.former_key[0] != '\0') v.formerly(field.former_key, field.key);
    std::visit(
        [&](auto member) {
          using Value = std::remove_cvref_t<decltype(d.*member)>;
          if constexpr (std::is_same_v<Value, bool>) {
            v(field.key, d.*member);
          } else if constexpr (std::is_same_v<Value, Paint>) {
            v(field.key, d.*member, field.painted);
          } else {
            v(field.key, d.*member, field.rule);
          }
        },
        field.member);
  }
  v.object("beside", d.beside);
}

template <class Visitor>
void visit_fields(Visitor& v, DrawnObject& o) {
  v("kind", o.kind);
  v("atoms", o.atoms);
  v("colour", o.colour);
  v("own_colour", o.own);
  v("shown", o.shown);
  v("opacity", o.opacity, kObjectOpacityRule);
}

template <class Visitor>
void visit_fields(Visitor& v, NamedView& n) {
  v("name", n.name);
  v("position_angstrom", n.position, kPlaceRule);
  v("target_angstrom", n.focal_point, kPlaceRule);
  v("up", n.up, kPlaceRule);
  v("least_aspect", n.least_aspect, kAspectRule);
  v("orthographic", n.orthographic);
}

template <class Visitor>
void visit_fields(Visitor& v, NamedClip& n) {
  v("name", n.name);
  v("clip", n.clip);
}

template <class Visitor>
void visit_fields(Visitor& v, OwnColour& o) {
  v("colour", o.colour);
  v("atoms", o.atoms);
}

template <class Visitor>
void visit_fields(Visitor& v, Appearance& a) {
  v("hidden", a.hidden);
  v.objects("colours", a.colours);
}

template <class Visitor>
void visit_fields(Visitor& v, AtomLabels& l) {
  v("text", l.text);
  v("atoms", l.atoms);
}

template <class Visitor>
void visit_fields(Visitor& v, Measurement& m) {
  v("atoms", m.atoms);
}

template <class Visitor>
void visit_fields(Visitor& v, PlacedMark& m) {
  v("from_angstrom", m.from, kPlaceRule);
  v("to_angstrom", m.to, kPlaceRule);
  v("text", m.text);
}

template <class Visitor>
void visit_fields(Visitor& v, Annotations& a) {
  v.objects("labels", a.labels);
  v.objects("measurements", a.measurements);
  v.objects("marks", a.marks);
  v("power_diagram", a.power_diagram);
}

template <class Visitor>
void visit_fields(Visitor& v, CavitySettings& c) {
  v("split_networks", c.split_networks);
}

template <class Visitor>
void visit_fields(Visitor& v, Settings& s) {
  v.object("open", s.open);
  v.formerly("compute", "request");
  v.object("request", s.request);
  v.object("display", s.display);
  v.objects("objects", s.objects);
  v("selection", s.selection.items);
  v("cavities", s.selection.cavities);
  v("clip", s.clip);
  v.objects("clips", s.clips);
  v.objects("views", s.views);
  v.object("appearance", s.appearance);
  v.object("annotations", s.annotations);
  v.formerly("cavity_table", "cavity_settings");
  v.object("cavity_settings", s.cavity_settings);
}

// From here on: state of the window, which is not in the history.
template <class Visitor>
void visit_fields(Visitor& v, CameraPlace& c) {
  v("origin_angstrom", c.origin, kPlaceRule);
  v("position_angstrom", c.position, kPlaceRule);
  v("target_angstrom", c.target, kPlaceRule);
  v("up", c.up, kPlaceRule);
  v("least_aspect", c.least_aspect, kAspectRule);
}

template <class Visitor>
void visit_fields(Visitor& v, AlphaSlider& a) {
  v("scale", a.scaling);
  v("low_angstrom2", a.low, kAlphaRule);
  v("high_angstrom2", a.high, kAlphaRule);
  v("loop", a.loop);
  v("speed", a.speed, kPlaySpeedRule);
}

template <class Visitor>
void visit_fields(Visitor& v, PanelLayout& p) {
  v("page", p.page);
  v("page_height", p.page_height, kPageHeightRule);
  v("closed_sections", p.closed_sections);
  v.object("alpha_slider", p.alpha_slider);
}

template <class Visitor>
void visit_fields(Visitor& v, CaptionParts& c) {
  for (const CaptionPartInfo& part : caption_parts()) {
    bool wanted = c.has(part.part);
    v(part.id, wanted);
    c.set(part.part, wanted);
  }
}

template <class Visitor>
void visit_fields(Visitor& v, PictureOptions& p) {
  v("width", p.width, kPictureSizeRule);
  v("height", p.height, kPictureSizeRule);
  v("dpi", p.dpi, kDpiRule);
  v.formerly("transparent", "background");
  v("background", p.background);
  v("letters", p.letters, kLettersRule);
  v("legend", p.legend);
  v("scale_bar", p.scale_bar);
  v.object("caption", p.caption);
}

template <class Visitor>
void visit_fields(Visitor& v, Recording& r) {
  v("kind", r.kind);
  v("scale", r.scaling);
  v("low_angstrom2", r.low, kAlphaRule);
  v("high_angstrom2", r.high, kAlphaRule);
  v("degrees", r.degrees, kTurnRule);
  v("axis", r.axis);
  v("frames", r.frames, kFramesRule);
  v("there_and_back", r.there_and_back);
  v("frames_per_second", r.frames_per_second, kFrameRateRule);
}

template <class Visitor>
void visit_fields(Visitor& v, RecordSettings& r) {
  v.object("content", r.recording);
  v("lesson", r.of_lesson);
  v("lesson_seconds", r.lesson_seconds, kHoldRule);
  v.object("picture", r.options);
}

template <class Visitor>
void visit_fields(Visitor& v, SessionView& w) {
  v("light_theme", w.light_theme);
  v.object("camera", w.camera);
  v.object("panels", w.panels);
  v.object("picture", w.picture);
  v.object("recording", w.recording);
}

}  // namespace alphascope
