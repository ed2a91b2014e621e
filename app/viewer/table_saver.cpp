// See the header.
#include "app/viewer/table_saver.hpp"

#include <stdexcept>
#include <utility>

#include "core/io/atomic_file.hpp"
#include "core/molecule/printable.hpp"

namespace alphascope {
namespace {

// Steps between which saving can be cancelled.
constexpr std::size_t kPiece = 1 << 20;  // bytes

void write_text(const std::filesystem::path& path, const std::string& text,
                const CancelToken& cancel) {
  AtomicFile file(path);
  for (std::size_t at = 0; at < text.size(); at += kPiece) {
    cancel.throw_if_cancelled();
    file.write(std::string_view(text).substr(at, kPiece));
  }
  cancel.throw_if_cancelled();
  file.commit();
}

}  // namespace

TableSaver::TableSaver(std::function<void()> wake) : worker_(std::move(wake)) {}

void TableSaver::start(SaveTableRequest request) {
  if (busy()) {
    throw std::runtime_error("Cannot save " + request.path.string() + ": " +
                             saving_->path.string() +
                             " is still being saved. Wait until it is finished, or cancel it.");
  }
  AtomicFile{request.path};  // that it cannot be written should not show after computing only
  saving_ = std::move(request);
  begun_ = writing_ = false;
  since_ = std::chrono::steady_clock::now();
}

void TableSaver::cancel(Store& store) {
  if (!busy()) return;
  if (writing_) return worker_.cancel();  // which tells how it ended
  store.cancel(definition().id);
  outcome_.notice = "Cancelled: " + saving_->path.string() + " was not written.";
  saving_.reset();
}

const Definition<std::string>& TableSaver::definition() const {
  const TableToSave& table = *saving_->table;
  return saving_->as_json ? *table.json : table.csv;
}

void TableSaver::fail(const std::string& why) {
  outcome_.error = why;
  saving_.reset();
  writing_ = false;
}

// What is on screen may change before all its numbers are there.
void TableSaver::want(Store& store, const Inputs& inputs) {
  const TableToSave& table = *saving_->table;
  const bool other = inputs.balls_key != table.inputs.balls_key ||
                     inputs.alpha_angstrom2 != table.inputs.alpha_angstrom2 || !inputs.complex;
  if (table.of_the_picture && other) {
    return fail(saving_->path.string() +
                " was not written: the picture has changed before all numbers were there. Save "
                "the table again.");
  }
  if (!std::exchange(begun_, true)) store.begin_again(definition().id);  // after cancel()
  const Derived<std::string> text =
      store.want(definition(), table.of_the_picture ? inputs : table.inputs);
  if (text.ready()) return write(text.value);
  if (text.state == DerivedState::waiting || text.state == DerivedState::running) return;
  fail("Cannot save " + saving_->path.string() + ": " +
       (text.why.empty() ? "its numbers are not there. Save it again." : text.why));
}

void TableSaver::write(const Text& text) {
  writing_ = true;
  worker_.submit(
      [this, path = saving_->path, text](const RunContext& context) -> Worker::Delivery {
        write_text(path, *text, context.cancel);
        return [this, path] {
          outcome_.notice = "Saved " + printable(path.string());
          saving_.reset();
        };
      },
      [this, path = saving_->path](const Worker::Failure& failure) {
        if (!failure.cancelled) return fail(failure.message);
        outcome_.notice = failure.too_late
                              ? "Saved " + printable(path.string())
                              : "Cancelled: " + printable(path.string()) + " was not written.";
        saving_.reset();
      });
}

TableSaver::Outcome TableSaver::poll(Store& store, const Inputs& inputs) {
  worker_.poll();
  if (busy() && !writing_) want(store, inputs);
  return std::exchange(outcome_, {});
}

void TableSaver::describe(BusyInfo& info) const {
  if (!busy()) return;
  info.active = true;
  info.what = "Saving " + saving_->path.filename().string();
  info.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
}

}  // namespace alphascope
