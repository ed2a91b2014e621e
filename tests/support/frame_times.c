// SPDX-License-Identifier: GPL-3.0-or-later
// Preloaded into the window (LD_PRELOAD), writes when each frame came to the screen: a line for each
// of the first hundred frames, with the milliseconds since the time FRAME_TIMES_FROM (seconds since
// 1970), into the file FRAME_TIMES_FILE.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

void glfwSwapBuffers(void* window) {
  static void (*swap)(void*);
  static int frames;
  if (swap == NULL) swap = (void (*)(void*))dlsym(RTLD_NEXT, "glfwSwapBuffers");
  swap(window);
  const char* from = getenv("FRAME_TIMES_FROM");
  const char* name = getenv("FRAME_TIMES_FILE");
  if (from == NULL || name == NULL || ++frames > 100) return;
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  FILE* file = fopen(name, "a");
  if (file == NULL) return;
  fprintf(file, "%.1f\n", ((double)now.tv_sec - atof(from)) * 1e3 + (double)now.tv_nsec / 1e6);
  fclose(file);
}
