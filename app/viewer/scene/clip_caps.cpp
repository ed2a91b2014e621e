// SPDX-License-Identifier: GPL-3.0-or-later
// Makes caps when only the clip moves. Caps of a new mesh come with it.
#include "app/viewer/scene/clip_caps.hpp"

#include <utility>

namespace alphascope {

ReadyCaps ready_caps(const Clip& clip, std::shared_ptr<const CapMesh> mesh) {
  ReadyCaps caps{clip, std::move(mesh), {}, nullptr};
  if (!caps.mesh) return caps;
  caps.pick = cap_layer(caps.mesh);
  caps.data = make_cap_data(caps.mesh);
  return caps;
}

void ClipCaps::set(const Clip& clip) {
  if (std::exchange(wanted_, clip) == clip) return;
  submit();
}

void ClipCaps::show_new(ReadyCaps caps) {
  const Clip clip = caps.clip;
  show(std::move(caps));
  if (clip != wanted_) submit();
}

void ClipCaps::submit() {
  const DrawnParts& shown = picture_.parts;
  if (!wanted_.on() || !shown.mesh || !has_caps(shown.options)) {
    worker_.cancel();
    return show(ready_caps(wanted_, nullptr));
  }
  // The inputs of the caps are those of the mesh that they close.
  DrawnParts parts;
  parts.looks = shown.looks;
  parts.mesh = shown.mesh;
  parts.options = shown.options;
  parts.simplex_colours = shown.simplex_colours;
  worker_.submit(
      [this, parts, molecule = picture_.molecule, answer = picture_.answer,
       clip = wanted_](const RunContext& context) -> Worker::Delivery {
        const ReadyCaps caps =
            ready_caps(clip, make_caps(*molecule, answer.get(), parts, clip, context.cancel));
        return [this, mesh = parts.mesh, caps] {
          // A newer mesh comes with its own caps, or has requested them.
          if (mesh == picture_.parts.mesh && wanted_.on()) show(caps);
        };
      },
      [this](const Worker::Failure& failure) {
        if (!failure.cancelled) show(ready_caps(wanted_, nullptr));
      });
}

void ClipCaps::show(ReadyCaps caps) {
  DrawnParts& parts = picture_.parts;
  const bool same_clip = caps.clip == parts.clip;
  parts.clip = caps.clip;
  parts.caps = std::move(caps.mesh);
  pick_ = std::move(caps.pick);
  canvas_.change().set_caps(std::move(caps.data));
  if (same_clip && !parts.clip.on()) return;
  SceneStyle style = canvas_.style();
  style.cut = picture_.cut();
  canvas_.set_style(style);
}

void ClipCaps::forget() {
  picture_.parts.caps = nullptr;
  pick_.reset();
}

}  // namespace alphascope
