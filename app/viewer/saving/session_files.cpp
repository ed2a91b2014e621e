// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that read and write sessions, and messages about their missing or changed files.
#include "app/viewer/saving/session_files.hpp"

#include <utility>

#include "core/files/file_hash.hpp"
#include "ui/panels/failure_kind.hpp"

namespace alphascope {
namespace {

namespace fs = std::filesystem;

using State = FoundFile::State;

FoundSession find_files(FoundSession session, const RunContext& context) {
  const SessionDocument& document = session.read.session;
  const fs::path folder = session.file.parent_path();
  session.molecule = find_file(document.molecule, folder, context);
  if (!document.radii_table.empty()) {
    session.radii_table = find_file(document.radii_table, folder, context);
  }
  return session;
}

FoundSession with_molecule(FoundSession session, const fs::path& molecule,
                           const RunContext& context) {
  FileReference chosen = session.read.session.molecule;
  chosen.relative.clear();
  chosen.absolute = molecule;
  session.molecule = find_file(chosen, {}, context);
  return session;
}

}  // namespace

bool FoundSession::complete() const {
  return molecule.state == State::same && (!radii_table || radii_table->state == State::same);
}

bool FoundSession::can_open() const {
  return molecule.state != State::missing && (!radii_table || radii_table->state != State::missing);
}

std::string FoundSession::problem() const {
  const SessionDocument& document = read.session;
  std::string text;
  if (molecule.state != State::same) {
    text = "The molecule of this session: " + why_not_found(document.molecule, molecule);
  }
  if (radii_table && radii_table->state != State::same) {
    text += (text.empty() ? "" : "\n\n") + std::string("Its table of radii: ") +
            why_not_found(document.radii_table, *radii_table);
  }
  return text;
}

void SessionFiles::open(const fs::path& file) {
  std::error_code ignored;
  const fs::path absolute = fs::absolute(file, ignored).lexically_normal();
  reader_.submit(
      [this, absolute](const RunContext& context) -> Worker::Delivery {
        context.report("session", 0);
        FoundSession session;
        session.file = absolute;
        session.read = read_session(absolute, context);
        auto found = std::make_shared<const FoundSession>(find_files(std::move(session), context));
        return [this, found] { outcome_.read = found; };
      },
      [this](const Worker::Failure& failure) {
        if (failure.cancelled) return;
        outcome_.error_title = "The session cannot be opened";
        outcome_.error = failure.message;
        outcome_.error_kind = kind_of(failure.cause, ErrorKind::input);
      });
}

void SessionFiles::open_with(std::shared_ptr<const FoundSession> session,
                             const fs::path& molecule) {
  reader_.submit(
      [this, session, molecule](const RunContext& context) -> Worker::Delivery {
        auto found =
            std::make_shared<const FoundSession>(with_molecule(*session, molecule, context));
        return [this, found] { outcome_.read = found; };
      },
      [this](const Worker::Failure& failure) {
        if (failure.cancelled) return;
        outcome_.error_title = "The session cannot be opened";
        outcome_.error = failure.message;
        outcome_.error_kind = kind_of(failure.cause, ErrorKind::input);
      });
}

void SessionFiles::save(const SessionDocument& session, const fs::path& file,
                        std::function<void()> when_saved) {
  const auto write = [session, file](const RunContext& context) {
    SessionDocument whole = session;
    const fs::path& table = session.settings.open.radii_table;
    if (session.settings.open.balls.radii == RadiiSet::user && !table.empty()) {
      whole.radii_table = refer_to(table, hash_of_file(table, context), file.parent_path());
    }
    write_session(whole, file);
    return std::string();
  };
  writer_.start({file, "Saving " + file.filename().string(), "The session cannot be saved", write,
                 std::move(when_saved)});
}

SessionFiles::Outcome SessionFiles::poll() {
  reader_.poll();
  return std::exchange(outcome_, {});
}

}  // namespace alphascope
