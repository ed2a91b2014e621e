// SPDX-License-Identifier: GPL-3.0-or-later
// The kind of a failure, by its exception.
#pragma once

#include <exception>
#include <new>

#include "core/files/atomic_file.hpp"
#include "core/files/read_error.hpp"
#include "ui/panels/error_kind.hpp"

namespace alphascope {

// `otherwise`: the kind if the exception does not say.
inline ErrorKind kind_of(const std::exception& error, ErrorKind otherwise) {
  if (dynamic_cast<const ReplacesInput*>(&error) != nullptr) return ErrorKind::request;
  if (dynamic_cast<const WriteError*>(&error) != nullptr) return ErrorKind::output;
  if (dynamic_cast<const ReadError*>(&error) != nullptr) return ErrorKind::input;
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return ErrorKind::computing;
  return otherwise;
}

// The same for an exception that was caught in another thread. Null: it does not say.
inline ErrorKind kind_of(const std::exception_ptr& cause, ErrorKind otherwise) {
  if (!cause) return otherwise;
  try {
    std::rethrow_exception(cause);
  } catch (const std::exception& error) {
    return kind_of(error, otherwise);
  } catch (...) {
    return otherwise;
  }
}

}  // namespace alphascope
