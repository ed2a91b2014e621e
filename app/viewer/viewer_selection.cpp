// What is under the mouse, what a click selects, and how it is marked. All of it belongs to the
// picture on screen, not to settings whose picture is still being made.
#include <algorithm>
#include <utility>

#include "app/viewer/hit_text.hpp"
#include "app/viewer/viewer.hpp"
#include "core/complex/own_dimension.hpp"

namespace alphascope {
namespace {

constexpr double kBesideALine = 4;  // pixels at scale 1 from which a line is still hit

}  // namespace

// Of other balls than before, when the picture shows such.
void Viewer::follow_picture() {
  const DrawnMolecule* drawn = scene_.drawn();
  if (drawn == nullptr) {
    state_.references = nullptr;
  } else if (!state_.references || &state_.references->prepared() != drawn->prepared.get()) {
    state_.references = std::make_shared<const BallReferences>(drawn->molecule, drawn->prepared);
  }
}

std::shared_ptr<const BallReferences> Viewer::references_of(const Answer& answer) const {
  const auto& shown = state_.references;
  if (shown && &shown->prepared() == answer.prepared.get()) return shown;
  return std::make_shared<const BallReferences>(answer.molecule, answer.prepared);
}

std::optional<Viewer::UnderMouse> Viewer::under(int x, int y) const {
  const BallReferences* references = state_.references.get();
  if (references == nullptr) return std::nullopt;
  const auto hit = scene_.pick(x, y, kBesideALine * frame_.scale());
  if (!hit) return std::nullopt;
  if (hit->corners == 0) return UnderMouse{};  // hides what is behind it
  if (hit->layer == kAtomInFront) return under_atom(hit->index);
  if (hit->layer == kBesideBody) {
    const LeftOutAtom& atom = scene_.beside_body().atoms.at(hit->index);
    return UnderMouse{references->atom_of_molecule(atom.atom),
                      describe_atom_beside(*references, atom)};
  }
  if (hit->corners == 1) {
    const auto ball = static_cast<BallIndex>(hit->index);
    const Answer* answer = scene_.drawn_answer().get();
    return UnderMouse{references->atom(ball),
                      describe_ball(*references, answer ? &answer->request : nullptr, ball)};
  }
  const Answer& drawn = *scene_.drawn_answer();
  const HitSimplex simplex =
      hit_simplex(*hit, InOwnDimension(*drawn.balls, drawn.complex).complex());
  return UnderMouse{references->reference(simplex.balls), describe_simplex(*references, simplex)};
}

// One that panels draw in front, whether or not it is a ball.
Viewer::UnderMouse Viewer::under_atom(std::size_t atom) const {
  const BallReferences& references = *state_.references;
  const AtomRef ref = references.atom_of_molecule(atom);
  if (const auto ball = references.ball(ref)) {
    const Answer* answer = scene_.drawn_answer().get();
    return {ref, describe_ball(references, answer ? &answer->request : nullptr, *ball)};
  }
  for (const LeftOutAtom& out : references.prepared().left_out) {
    if (out.atom == atom) return {ref, describe_atom_beside(references, out)};
  }
  return {};
}

void Viewer::describe_under_mouse() {
  ViewportInfo& v = state_.viewport;
  v.under_mouse = v.under_mouse_line = {};
  state_.hovered.reset();
  follow_picture();
  if (!v.hovered) return;
  if (auto found = under(v.mouse_x, v.mouse_y)) {
    v.under_mouse = std::move(found->text.tooltip);
    v.under_mouse_line = std::move(found->text.line);
    state_.hovered = std::move(found->what);
  }
}

void Viewer::open_context_menu() {
  const ViewportInfo& v = state_.viewport;
  const auto found = under(v.mouse_x, v.mouse_y);
  ContextMemory& menu = state_.context;
  menu.opens = true;
  menu.what = found ? found->what : std::nullopt;
  menu.title = menu.what ? name_of(state_.references->molecule(), *menu.what) : "";
  frames_due_ = kSettlingFrames;
}

void Viewer::click(const PointerEvent& event) {
  if (event.button == 1) return open_context_menu();
  const bool more = event.control || event.shift;
  RefSet& items = state_.settings.selection.items;
  const auto found = under(event.x, event.y);
  if (!found) {
    if (!more) state_.settings.selection.clear();
    return;
  }
  if (!found->what) return;
  const RefSet wanted = more ? items.toggled(*found->what) : RefSet({*found->what});
  if (wanted.size() > Selection::kMostItems) {
    state_.notice = "No more can be selected at once.";
  } else {
    items = wanted;
    state_.settings.selection.note_order();
  }
}

// The balls of what is selected, and a layer for simplices, as far as the picture has them.
void Viewer::mark_selection() {
  follow_picture();
  const auto& answer = scene_.drawn_answer();
  Marked& m = marked_;
  // What lines a cavity is marked by rims, for whole balls would hide cavity and ligand.
  const bool outlines = !state_.settings.selection.cavities.empty();
  const bool same = m.items == state_.settings.selection.items &&
                    m.references == state_.references && m.answer == answer &&
                    m.beside == scene_.beside_body().mesh && m.theme == state_.window.theme &&
                    m.drawn.outlines == outlines;
  if (!same) {
    m = {state_.settings.selection.items,
         state_.references,
         answer,
         scene_.beside_body().mesh,
         state_.window.theme,
         {},
         nullptr,
         m.key + 1};
    m.drawn.outlines = outlines;
    find_marks();
  }
  scene_.set_selected(m.drawn);
  if (m.layer) state_.layers.push_back(m.layer);
}

// Of an atom that is drawn beside the body, among these.
std::optional<std::size_t> Viewer::place_beside(const Ref& item) const {
  const AtomRef* ref = std::get_if<AtomRef>(&item);
  if (ref == nullptr || !state_.references) return std::nullopt;
  const auto atom = find_atom(state_.references->molecule(), {ref->atom, ref->copy});
  const auto& atoms = scene_.beside_body().atoms;
  const auto at = std::lower_bound(atoms.begin(), atoms.end(), atom.value_or(0),
                                   [](const LeftOutAtom& a, std::size_t i) { return a.atom < i; });
  if (!atom || at == atoms.end() || at->atom != *atom) return std::nullopt;
  return static_cast<std::size_t>(at - atoms.begin());
}

void Viewer::find_marks() {
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
  state_.picked_missing = missing;
  state_.picked_text = selected_text(marked_.items.size(), missing);
  if (layer->edges.empty()) return;
  layer->id = "selection";
  layer->in_pictures = false;
  layer->key = marked_.key;
  layer->balls = marked_.answer->balls;
  layer->colour = palette(marked_.theme).selected;
  marked_.layer = std::move(layer);
}

void Viewer::save_view(const std::string& name) {
  NamedView view = scene_.named_view(name);
  for (NamedView& old : state_.settings.views) {
    if (old.name != name) continue;
    old = view;
    return;
  }
  state_.settings.views.push_back(std::move(view));
  state_.notice = "Saved camera: " + name;
}

void Viewer::go_to_view(const std::string& name) {
  for (const NamedView& view : state_.settings.views) {
    if (view.name != name) continue;
    state_.settings.display.orthographic = view.orthographic;
    scene_.go_to(view);
  }
}

// While it is held, it turns about where it was taken.
void Viewer::place_clip_handle() {
  constexpr double kSize = 85;  // pixels at scale 1
  const auto pivot = pivot_near(state_.settings.clip, state_.viewport.box_middle);
  if (state_.memory.clip_part == HandlePart::none) clip_pivot_.reset();
  if (state_.memory.clip_part == HandlePart::turn && !clip_pivot_) {
    clip_pivot_ = state_.viewport.clip_handle.pivot;
  }
  state_.viewport.clip_handle =
      scene_.clip_handle(state_.settings.clip, clip_pivot_.value_or(pivot), kSize * frame_.scale());
}

SceneController::Selected Viewer::drawn_of(const RefSet& items) const {
  SceneController::Selected all;
  if (!state_.references) return all;
  for (const Ref& item : items.items()) {
    const auto balls = state_.references->balls(item);
    if (balls) all.balls.insert(all.balls.end(), balls->begin(), balls->end());
    if (const auto beside = place_beside(item)) all.beside.push_back(*beside);
  }
  return all;
}

void Viewer::zoom_to(const RefSet& items) {
  scene_.zoom_to(drawn_of(items));
}

void Viewer::centre_on(const RefSet& items) {
  scene_.centre_on(drawn_of(items));
}

// A preset of the sandbox is opened to be changed.
void Viewer::start_preset() {
  SandboxMemory& m = state_.memory.sandbox;
  m.pixels_per_angstrom = 0;
  const std::filesystem::path wanted = std::exchange(m.edit_when_open, {});
  const SessionState& s = session_.state();
  if (wanted.empty() || wanted != s.opened->deposited->source) return;
  if (!state_.settings.open.sandbox) state_.settings.open.sandbox = sandbox_of(*s.prepared->balls);
}

}  // namespace alphascope
