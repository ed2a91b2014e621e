// SPDX-License-Identifier: GPL-3.0-or-later
// Controls of the emulated device for tests. The program sees it through cuda_runtime.h only.
// Faults are deliberate, and nothing fails unless a test says so.
#pragma once

#include <cstddef>
#include <functional>

namespace emulated {

// Memory is full at the n-th reservation of device or pinned memory, counted from 0. Attempts that
// follow at once fail, too. After any other call to the device there is room again.
void be_full_at(int reservation);
// The device is lost at the n-th call, counted from 0. This call and all later ones fail. Calls
// that free resources do not count and always succeed.
void be_lost_at(int call);
// The number of calls that failed by one of the two faults.
int faults_met();
// Ends all faults, and sets faults_met() to 0.
void be_sound();

// Calls change(data, bytes) for each copy to the host, until be_sound().
using ToHost = std::function<void(void*, std::size_t)>;
void change_copies_to_host(ToHost change);

// Bytes of pinned memory at present, and those of them in registered pages of the program.
std::size_t pinned_bytes();
std::size_t registered_bytes();

}  // namespace emulated
