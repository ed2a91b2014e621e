// SPDX-License-Identifier: GPL-3.0-or-later
// Makes OpenGL contexts without X or Wayland, by EGL_MESA_platform_surfaceless.
#include "ui/window/egl_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace alphascope {

struct EglContext::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

namespace {

[[noreturn]] void fail(const char* step) {
  char code[32];
  std::snprintf(code, sizeof code, "EGL error 0x%04x", static_cast<unsigned>(eglGetError()));
  throw std::runtime_error(std::string("cannot draw without a display: ") + step + " failed (" +
                           code + "); install Mesa's EGL (Debian: libegl1 libegl-mesa0)");
}

EGLDisplay surfaceless_display() {
  const auto get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_platform_display == nullptr) fail("eglGetPlatformDisplayEXT");
  EGLDisplay display =
      get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("opening Mesa's surfaceless platform");
  return display;
}

}  // namespace

EglContext::EglContext() : handles_(std::make_unique<Handles>()) {
  handles_->display = surfaceless_display();
  if (!eglInitialize(handles_->display, nullptr, nullptr)) fail("eglInitialize");
  if (!eglBindAPI(EGL_OPENGL_API)) fail("eglBindAPI");
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                      EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(handles_->display, config_attributes, &config, 1, &count) || count == 0) {
    fail("eglChooseConfig");
  }
  const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                       3,
                                       EGL_CONTEXT_MINOR_VERSION,
                                       2,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                       EGL_NONE};
  handles_->context =
      eglCreateContext(handles_->display, config, EGL_NO_CONTEXT, context_attributes);
  if (handles_->context == EGL_NO_CONTEXT) fail("eglCreateContext (OpenGL 3.2 core)");
  make_current();
}

EglContext::~EglContext() {
  if (eglGetCurrentContext() == handles_->context) release();
  eglDestroyContext(handles_->display, handles_->context);
  // The display is not terminated, because all contexts of the process share it.
}

void EglContext::make_current() {
  if (!eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context)) {
    fail("eglMakeCurrent");
  }
}

void EglContext::release() {
  eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

bool draws_in_software() {
  const auto* text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view name = text != nullptr ? text : "";
  return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

}  // namespace alphascope
