// What tests do to the emulated device, and what they ask it; cuda_runtime.h is what the program
// sees of it. Faults are on purpose, and nothing fails unless a test says so.
#pragma once

#include <cstddef>
#include <functional>

namespace emulated {

// The memory is full when the n-th reservation of it is asked for, counted from 0: device memory or
// pinned memory. Attempts that follow at once are refused, too; when anything else has been asked
// of the device, there is room again.
void be_full_at(int reservation);
// The device is lost at the n-th call, counted from 0: that one and all later ones fail. Calls that
// give something back do not count and always succeed.
void be_lost_at(int call);
// How many calls have met with what one of the two said.
int faults_met();
// All is well again, and faults_met() is 0.
void be_sound();

// Calls change(data, bytes) for what arrives with each copy to the host, until be_sound().
using ToHost = std::function<void(void*, std::size_t)>;
void change_copies_to_host(ToHost change);

// Pinned memory that there is now; of it, pages of the program that it registered.
std::size_t pinned_bytes();
std::size_t registered_bytes();

}  // namespace emulated
