// Saving pictures, tables and exports: started here, done elsewhere.
#include "app/viewer/viewer.hpp"

namespace alphascope {

void Viewer::save_picture(const ScreenshotRequest& request) {
  try {
    saver_.start(picture_job(scene_.picture(request)));
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell("The picture cannot be saved", error.what());
  }
  frames_due_ = kSettlingFrames;
}

// Of what is on screen: molecule, radii, display and view; a sweep says alpha itself.
void Viewer::record(const RecordRequest& request) {
  try {
    if (request.lesson_seconds) {
      lesson_recorder_.start(request, state_.theme);
    } else {
      saver_.start(recording_job(request, scene_.frames(request), scene_.texts()));
    }
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell("The recording cannot be made", error.what());
  }
  frames_due_ = kSettlingFrames;
}

void Viewer::record_lesson() {
  if (!lesson_recorder_.busy()) return;
  const std::string given_up = lesson_recorder_.step(!all_but_saving() && !store_.busy());
  if (!given_up.empty()) state_.tell("The lesson was not recorded", given_up);
  frames_due_ = kSettlingFrames;
}

void Viewer::save_table(const SaveTableRequest& request) {
  try {
    table_saver_.start(request);
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell("The table cannot be saved", error.what());
  }
  frames_due_ = kSettlingFrames;
}

// Of the complex on screen, not of one that is being computed.
void Viewer::export_complex(const ExportRequest& request) {
  try {
    if (!scene_.drawn_answer()) throw std::runtime_error("There is no complex yet.");
    complex_saver_.start(scene_.drawn_answer(), scene_.header(), request);
    state_.notice.clear();
  } catch (const std::exception& error) {
    state_.tell("The complex cannot be exported", error.what());
  }
  frames_due_ = kSettlingFrames;
}

// The one whose line is shown.
void Viewer::cancel_saving() {
  if (saver_.busy()) return saver_.cancel();
  if (table_saver_.busy()) return table_saver_.cancel(store_);
  complex_saver_.cancel();
}

void Viewer::take_saved() {
  const PictureSaver::Outcome outcome = saver_.poll();
  const ComplexSaver::Outcome exported = complex_saver_.poll();
  if (!outcome.notice.empty()) state_.notice = outcome.notice;
  if (!exported.notice.empty()) state_.notice = exported.notice;
  if (!outcome.error.empty()) state_.tell("The picture cannot be saved", outcome.error);
  if (!exported.error.empty()) state_.tell("The complex cannot be exported", exported.error);
  saver_.describe(state_.saving);
  if (!state_.saving.active) table_saver_.describe(state_.saving);
  if (!state_.saving.active) complex_saver_.describe(state_.saving);
  if (!outcome.any() && !exported.any()) return;
  frames_due_ = kSettlingFrames;
  memory_to_give_back_ = true;
}

}  // namespace alphascope
