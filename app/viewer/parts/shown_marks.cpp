// SPDX-License-Identifier: GPL-3.0-or-later
// Draws marks of the selection, labels, distances and angles, and keeps cameras by name. All follow
// the picture on screen, not settings whose picture is still being made.
#include "app/viewer/parts/shown_marks.hpp"

#include <algorithm>
#include <utility>

#include "app/viewer/mouse/hit_text.hpp"
#include "ui/annotation_layer.hpp"
#include "ui/panels/window_settings.hpp"

namespace alphascope {

// Takes the references of the new balls, if the picture shows other balls.
void ShownMarks::follow_picture() {
  const DrawnMolecule* drawn = scene_.drawn().molecule.get();
  if (drawn == nullptr) {
    state_.references = nullptr;
  } else if (!state_.references || &state_.references->prepared() != drawn->prepared.get()) {
    state_.references =
        std::make_shared<const BallReferences>(drawn->molecule, drawn->prepared, drawn->secondary);
  }
}

std::shared_ptr<const BallReferences> ShownMarks::references_of(const Answer& answer) const {
  const auto& shown = state_.references;
  if (shown && &shown->prepared() == answer.prepared.get()) return shown;
  return std::make_shared<const BallReferences>(answer.molecule, answer.prepared);
}

// Marks the balls of the selected items, and makes a layer of the selected simplices. Items that
// the picture lacks stay unmarked.
void ShownMarks::mark_selection() {
  follow_picture();
  const auto& answer = scene_.drawn().answer;
  Marked& m = marked_;
  // The lining of a selected cavity is marked by rims: whole balls would hide the cavity and its
  // ligand.
  const bool outlines = !state_.settings.selection.cavities.empty();
  const bool same = m.items == state_.settings.selection.items &&
                    m.references == state_.references && m.answer == answer &&
                    m.beside == scene_.shown().beside_body().mesh &&
                    m.theme == state_.window.theme && m.drawn.outlines == outlines;
  if (!same) {
    m = {state_.settings.selection.items,
         state_.references,
         answer,
         scene_.shown().beside_body().mesh,
         state_.window.theme,
         {},
         nullptr,
         m.key + 1};
    m.drawn.outlines = outlines;
    find_marks();
  }
  scene_.shown().set_selected(m.drawn);
  if (m.layer) state_.layers.push_back(m.layer);
}

// The place of an atom in the list of atoms that are drawn beside the body.
std::optional<std::size_t> ShownMarks::place_beside(const Ref& item) const {
  const AtomRef* ref = std::get_if<AtomRef>(&item);
  if (ref == nullptr || !state_.references) return std::nullopt;
  const auto atom = find_atom(state_.references->molecule(), {ref->atom, ref->copy});
  const auto& atoms = scene_.shown().beside_body().atoms;
  const auto at = std::lower_bound(atoms.begin(), atoms.end(), atom.value_or(0),
                                   [](const LeftOutAtom& a, std::size_t i) { return a.atom < i; });
  if (!atom || at == atoms.end() || at->atom != *atom) return std::nullopt;
  return static_cast<std::size_t>(at - atoms.begin());
}

void ShownMarks::find_marks() {
  auto layer = std::make_shared<Layer>();
  std::size_t missing = 0;
  for (const Ref& item : marked_.items.items()) {
    if (const auto beside = place_beside(item)) {
      marked_.drawn.beside.push_back(*beside);
      continue;
    }
    const auto balls = marked_.references ? marked_.references->balls(item) : std::nullopt;
    const bool there = balls && (balls->size() == 1 ||
                                 (marked_.answer && has_simplex(marked_.answer->complex, *balls)));
    missing += !there;
    if (!there) continue;
    if (balls->size() == 1) marked_.drawn.balls.push_back(balls->front());
    for (std::size_t i = 0; i < balls->size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) layer->edges.push_back({(*balls)[k], (*balls)[i]});
    }
  }
  std::sort(marked_.drawn.balls.begin(), marked_.drawn.balls.end());
  std::sort(marked_.drawn.beside.begin(), marked_.drawn.beside.end());
  state_.selected_missing = missing;
  state_.selected_count_text = selected_text(marked_.items.size(), missing);
  if (layer->edges.empty()) return;
  layer->id = "selection";
  layer->in_pictures = false;
  layer->key = marked_.key;
  layer->balls = marked_.answer->balls;
  layer->colour = palette(marked_.theme).selected;
  marked_.layer = std::move(layer);
}

void ShownMarks::save_view(const std::string& name) {
  NamedView view = scene_.cameras().named(name);
  for (NamedView& old : state_.settings.views) {
    if (old.name != name) continue;
    old = view;
    return;
  }
  state_.settings.views.push_back(std::move(view));
  state_.notice = "Saved camera: " + name;
}

void ShownMarks::go_to_view(const std::string& name) {
  for (const NamedView& view : state_.settings.views) {
    if (view.name != name) continue;
    state_.settings.display.orthographic = view.orthographic;
    scene_.cameras().go_to(view);
  }
}

SelectedItems ShownMarks::drawn_of(const RefSet& items) const {
  SelectedItems all;
  if (!state_.references) return all;
  for (const Ref& item : items.items()) {
    const auto balls = state_.references->balls(item);
    if (balls) all.balls.insert(all.balls.end(), balls->begin(), balls->end());
    if (const auto beside = place_beside(item)) all.beside.push_back(*beside);
  }
  return all;
}

void ShownMarks::zoom_to(const RefSet& items) {
  scene_.shown().zoom_to(drawn_of(items));
}

void ShownMarks::centre_on(const RefSet& items) {
  scene_.shown().centre_on(drawn_of(items));
}

// True if the atom is drawn: as a ball that is not hidden, or beside the body.
bool ShownMarks::is_drawn(std::size_t atom) const {
  const std::vector<std::uint32_t>& atoms = state_.references->prepared().atom_of_ball;
  const auto at = std::lower_bound(atoms.begin(), atoms.end(), atom);
  if (at != atoms.end() && *at == atom) {
    const auto& looks = annotated_.looks;
    return !looks || !looks->hides(static_cast<BallIndex>(at - atoms.begin()));
  }
  const std::vector<LeftOutAtom>& beside = scene_.shown().beside_body().atoms;
  const auto left =
      std::lower_bound(beside.begin(), beside.end(), atom,
                       [](const LeftOutAtom& a, std::size_t i) { return a.atom < i; });
  return left != beside.end() && left->atom == atom;
}

void ShownMarks::draw_annotations() {
  follow_picture();
  const auto& answer = scene_.drawn().answer;
  const std::shared_ptr<const BallSet> balls = answer ? answer->balls : nullptr;
  Annotated& a = annotated_;
  const bool same = a.annotations == state_.settings.annotations &&
                    a.references == state_.references && a.balls == balls &&
                    a.looks == scene_.drawn().parts.looks &&
                    a.beside == scene_.shown().beside_body().mesh && a.theme == state_.window.theme;
  if (!same) {
    a = {
        state_.settings.annotations,       state_.references,   balls,   scene_.drawn().parts.looks,
        scene_.shown().beside_body().mesh, state_.window.theme, nullptr, a.key + 1};
    if (a.references && a.balls) {
      a.layer =
          make_annotation_layer(a.annotations, {*a.references, a.balls,
                                                [this](std::size_t atom) { return is_drawn(atom); },
                                                palette(a.theme).warning, a.key});
    }
  }
  if (a.layer) state_.layers.push_back(a.layer);
}

}  // namespace alphascope
