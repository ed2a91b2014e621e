// See the header.
#include "core/run/background.hpp"

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

namespace alphascope {

void let_others_go_first() {
#ifdef __linux__
  const sched_param none{};
  pthread_setschedparam(pthread_self(), SCHED_IDLE, &none);  // refused: as before
#endif
}

}  // namespace alphascope
