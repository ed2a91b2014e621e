// The clip in the picture. A worker makes the caps that close cut tetrahedra. Plane and caps change
// together, so that no picture shows open tetrahedra.
#include <utility>

#include "app/viewer/scene/scene_controller.hpp"
#include "ui/scene/mesh/visible_mesh.hpp"

namespace alphascope {

Cut SceneController::cut_of(const Clip& clip) const {
  return drawn_molecule_ ? Cut(clip, drawn_molecule_->geometry->origin) : Cut();
}

void SceneController::set_clip(const Clip& clip) {
  if (std::exchange(clip_, clip) == clip) return;
  submit_caps();
}

// `mesh` is null if the clip cuts nothing that has caps.
SceneController::DrawnCaps SceneController::make_caps(const CapTask& task, const Clip& clip,
                                                      const CancelToken& cancel) {
  DrawnCaps caps{clip, nullptr, {}};
  if (!clip.on() || !task.answer || !task.mesh || !has_caps(task.options)) return caps;
  const DrawnMolecule& m = *task.molecule;
  const Cut cut(clip, m.geometry->origin);
  const BallAppearance* const looks = task.looks.get();
  caps.mesh = std::make_shared<const CapMesh>(
      build_visible_caps(task.answer->complex, hidden_of(looks), [&](const AlphaComplex& part) {
        return build_cap_mesh(*m.geometry, *task.colours, part, task.options, task.mesh->scale, cut,
                              cancel);
      }));
  caps.pick = cap_layer(caps.mesh);
  return caps;
}

void SceneController::submit_caps() {
  const CapTask task{drawn_molecule_, drawn_answer_,          drawn_mesh_,
                     drawn_options_,  drawn_simplex_colours_, drawn_looks_};
  if (!clip_.on() || !task.mesh || !has_caps(task.options)) {
    cap_worker_.cancel();
    return show_caps({clip_, nullptr, {}}, nullptr);
  }
  cap_worker_.submit(
      [this, task, clip = clip_](const RunContext& context) -> Worker::Delivery {
        DrawnCaps caps = make_caps(task, clip, context.cancel);
        auto data = make_cap_data(caps.mesh);
        return [this, mesh = task.mesh, caps = std::move(caps), data = std::move(data)] {
          // A newer mesh comes with its own caps, or has requested them.
          if (mesh == drawn_mesh_ && clip_.on()) show_caps(caps, data);
        };
      },
      [this](const Worker::Failure& failure) {
        if (!failure.cancelled) show_caps({clip_, nullptr, {}}, nullptr);
      });
}

void SceneController::show_caps(DrawnCaps caps, std::shared_ptr<CapData> data) {
  const bool same_clip = caps.clip == drawn_caps_.clip;
  drawn_caps_ = std::move(caps);
  scene_.set_caps(std::move(data));
  if (!same_clip || drawn_caps_.clip.on()) scene_.set_style(scene_style());
  dirty_ = true;
}

ClipHandle SceneController::clip_handle(const Clip& clip, const std::array<double, 3>& pivot,
                                        double size) const {
  if (!clip.on() || !drawn_molecule_ || width_ == 0 || draws_nothing()) return {};
  const Sight sight = scene_.sight();
  HandleView view{sight.right, sight.up, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) view.towards_viewer[k] = -sight.forward[k];
  view.seen = [sight, origin = drawn_molecule_->geometry->origin, width = width_,
               height = height_](const std::array<double, 3>& place) {
    return seen_at(sight, {place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]}, width,
                   height);
  };
  return make_clip_handle(clip, pivot, view, size);
}

}  // namespace alphascope
