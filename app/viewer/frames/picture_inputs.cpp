// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the picture on screen as the inputs of derived results.
#include "app/viewer/frames/picture_inputs.hpp"

#include <utility>

#include "app/session/gpu_engines.hpp"
#include "app/viewer/mouse/gestures.hpp"
#include "core/document/cavities/cavity_curve_results.hpp"
#include "core/document/store/derived.hpp"
#include "core/triangulation/memory_need.hpp"
#include "core/triangulation/triangulation_maker.hpp"

namespace alphascope {

PictureInputs::PictureInputs(const ViewState& state, const Session& session,
                             const SceneController& scene, const ShownMarks& marks, Store& store,
                             DueFrames& due)
    : state_(state),
      session_(session),
      scene_(scene),
      marks_(marks),
      store_(store),
      due_(due),
      on_cpu_(std::make_shared<TriangulationMaker>(nullptr)) {}

// Whether derived results may take the balls of the new picture as inputs. While the solvent radius
// is dragged, results that panels wait for are finished first. Otherwise each new picture would
// cancel the work for the last one, and panels would stay empty.
bool PictureInputs::may_take(const Answer& shown) const {
  if (shown.balls == inputs_.balls) return false;
  const bool same_atoms = source_ && source_->prepared == shown.prepared;
  return !same_atoms || !interacting(state_) || !store_.busy(Lane::interactive);
}

void PictureInputs::take(const std::shared_ptr<const Answer>& shown) {
  source_ = shown;
  taken_at_ = Clock::now();
  took_ = true;
  inputs_ = {};
  inputs_.balls = shown->balls;
  inputs_.balls_key = ++balls_seen_;
  inputs_.solvent_radius_angstrom = shown->request.solvent_radius_angstrom;
  inputs_.atoms = marks_.references_of(*shown);
  if (std::exchange(body_, shown->prepared) != shown->prepared) {
    ++bodies_seen_;
    frames_key_ = key_of_frames(*inputs_.atoms);
  }
  inputs_.body_key = bodies_seen_;
  inputs_.frames_key = frames_key_;
}

// Takes balls and complex on screen as inputs. Without a picture there are no inputs.
void PictureInputs::follow_picture() {
  const SessionState& s = session_.state();
  const auto& shown = state_.result;
  if (!s.ours || !shown || shown->prepared != s.prepared) {
    inputs_ = {};
    source_ = nullptr;
  } else if (may_take(*shown)) {
    take(shown);
  }
  if (inputs_.balls) {
    inputs_.triangulation_maker =
        computes_on_gpu() ? GpuEngines::of_program().triangulations() : on_cpu_;
    inputs_.split_networks = state_.settings.cavity_settings.split_networks;
    inputs_.complex = nullptr;
    inputs_.measures = nullptr;
    if (shown->balls == inputs_.balls) {
      inputs_.alpha_angstrom2 = shown->request.alpha_angstrom2;
      inputs_.complex = {shown, &shown->complex};
      inputs_.measures = shown->measures ? shown->measures : scene_.drawn().measures();
      give_results_for_all_alphas(store_, inputs_, std::exchange(*shown->made, {}));
    }
  }
  note_large_objects();
  poll_store();
}

bool PictureInputs::computes_on_gpu() const {
  const EngineChoice engine = state_.settings.request.engine;
  return needs_gpu(engine) || (engine == EngineChoice::automatic && has_gpu(state_));
}

// Whether to make the filtration unasked. A GPU computes each alpha anew and needs none. For many
// balls it is large (0.6 GB for a million), and open panels ask for it themselves.
bool PictureInputs::needs_filtration() const {
  constexpr std::size_t kSmall = 100'000;  // balls
  return !computes_on_gpu() || inputs_.balls->size() <= kSmall;
}

void PictureInputs::want_results_for_all_alphas() {
  if (inputs_.balls) {
    if (needs_filtration()) store_.want(whole_filtration(), inputs_, Priority::background);
    store_.want(whole_triangulation(), inputs_, Priority::background);
  }
  // Background work for balls that change in each frame would never be finished.
  constexpr std::chrono::milliseconds kSettled{300};
  store_.hold_background(interacting(state_) && Clock::now() - taken_at_ < kSettled);
  poll_store();
}

void PictureInputs::poll_store() {
  if (!store_.poll()) return;
  due_.ask_for_news();
}

// Reports large objects to the store's budget. The complex on screen may be older than the
// session's, and then both count.
void PictureInputs::note_large_objects() {
  const SessionState& s = session_.state();
  const auto& shown = state_.result;
  std::uint64_t complexes = session_.held_bytes();
  const bool older = shown && shown != s.ours && !(s.agreement && s.agreement->ours == shown);
  if (older) complexes += bytes_of(shown->complex);
  store_.set_held_bytes("complexes", complexes);
  store_.set_held_bytes("meshes", scene_.held_bytes());
}

}  // namespace alphascope
