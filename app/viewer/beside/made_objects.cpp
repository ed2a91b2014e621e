// SPDX-License-Identifier: GPL-3.0-or-later
// Makes drawings of objects in the background, and hands them to the scene.
#include "app/viewer/beside/made_objects.hpp"

#include <algorithm>
#include <iterator>

#include "core/selection/selection_error.hpp"
#include "ui/scene/mesh/drawing_memory.hpp"
#include "ui/scene/scene_data.hpp"

namespace alphascope {
namespace {

DrawnObjects shown_of(const DrawnObjects& objects) {
  DrawnObjects shown;
  std::copy_if(objects.begin(), objects.end(), std::back_inserter(shown),
               [](const DrawnObject& o) { return o.shown; });
  return shown;
}

}  // namespace

bool MadeObjects::same_drawing(const Drawn& drawn, const DrawnObject& object,
                               const Appearance& appearance) {
  DrawnObject as_opaque = object;
  as_opaque.opacity = drawn.object.opacity;
  return as_opaque == drawn.object && drawn.appearance == appearance;
}

void MadeObjects::follow(const SceneControls& controls) {
  if (!picture_.molecule) {
    worker_.cancel();
    return;
  }
  const DrawnObjects wanted = shown_of(controls.objects);
  const bool same_molecule = of_ == picture_.molecule;
  if (wanted.empty() && drawn_.empty()) {
    not_drawn_.clear();  // of an object that was removed since
    return worker_.cancel();
  }
  if (same_molecule && set_opacities(controls)) return worker_.cancel();
  Made from;
  from.molecule = picture_.molecule;
  if (same_molecule) from.objects = drawn_;
  worker_.submit(
      [this, from, wanted,
       appearance = controls.appearance](const RunContext& c) -> Worker::Delivery {
        Made made = make(from, wanted, appearance, c);
        return [this, made] { show(made); };
      },
      [this](const Worker::Failure& failure) {
        if (!failure.cancelled) not_drawn_ = "Objects cannot be drawn: " + failure.message;
      });
}

// Returns false if drawings have to be made.
bool MadeObjects::set_opacities(const SceneControls& controls) {
  const DrawnObjects wanted = shown_of(controls.objects);
  if (wanted.size() != drawn_.size() || !not_drawn_.empty()) return false;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (!same_drawing(drawn_[i], wanted[i], controls.appearance)) return false;
  }
  std::vector<SceneObject> objects;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    drawn_[i].object.opacity = wanted[i].opacity;
    objects.push_back({drawn_[i].data, wanted[i].opacity});
  }
  canvas_.change().set_objects(ObjectGroup::settings, std::move(objects));
  return true;
}

MadeObjects::Made MadeObjects::make(Made from, const DrawnObjects& wanted,
                                    const Appearance& appearance, const RunContext& context) const {
  Made made;
  made.molecule = from.molecule;
  if (wanted.empty()) return made;
  const std::shared_ptr<const ObjectFacts> facts = facts_.of(*from.molecule, context);
  for (const DrawnObject& object : wanted) {
    const auto before = std::find_if(from.objects.begin(), from.objects.end(), [&](const Drawn& d) {
      return same_drawing(d, object, appearance);
    });
    if (before != from.objects.end()) {
      made.objects.push_back(*before);
      made.objects.back().object = object;
      continue;
    }
    try {
      auto mesh = std::make_shared<const ObjectMesh>(
          build_object(*from.molecule, *facts, object, appearance, context.cancel));
      const auto free = free_memory_();
      if (free && object_bytes(*mesh) > drawing_budget(*free)) {
        made.not_drawn = object_title(object) +
                         " is not drawn: there is too little memory. Choose" +
                         std::string(kShowLess);
        continue;
      }
      made.objects.push_back(
          {object, appearance, mesh, make_object_data(mesh), object_layers(mesh)});
    } catch (const SelectionError& fault) {
      made.not_drawn = object_title(object) + " cannot be drawn: " + fault.what();
    }
  }
  return made;
}

void MadeObjects::show(Made made) {
  if (made.molecule != picture_.molecule) return;
  of_ = made.molecule;
  not_drawn_ = made.not_drawn;
  std::vector<SceneObject> objects;
  picks_.clear();
  for (const Drawn& d : made.objects) {
    objects.push_back({d.data, d.object.opacity});
    picks_.insert(picks_.end(), d.picks.begin(), d.picks.end());
  }
  canvas_.change().set_objects(ObjectGroup::settings, std::move(objects));
  drawn_ = std::move(made.objects);  // after the scene has let go of the old arrays
}

void MadeObjects::forget() {
  worker_.cancel();
  drawn_.clear();
  picks_.clear();
  of_ = nullptr;
  not_drawn_.clear();
}

PicturedObjects MadeObjects::pictured() const {
  PicturedObjects objects;
  for (const Drawn& d : drawn_) objects.push_back({d.mesh, d.object.opacity});
  return objects;
}

std::uint64_t MadeObjects::bytes() const {
  std::uint64_t sum = 0;
  for (const Drawn& d : drawn_) sum += object_bytes(*d.mesh);
  return sum;
}

}  // namespace alphascope
