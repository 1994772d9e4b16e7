// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstring>

#include "gl/context.hpp"

/// \file Stock VTK's GLEW asks GLX for OpenGL's functions. These four stand before libGLX in the
/// dynamic linker's order, because the program exports them (ENABLE_EXPORTS), and hand it OSMesa's.
extern "C" {

using GlFunction = void (*)();

void* glXGetCurrentDisplay();
GlFunction glXGetProcAddressARB(const unsigned char* name);
int glXQueryVersion(void* display, int* major, int* minor);
const char* glXGetClientString(void* display, int name);

/// Anything but null: GLEW only wants to know that there is a display.
void* glXGetCurrentDisplay() {
  static int display;
  return &display;
}

GlFunction glXGetProcAddressARB(const unsigned char* name) {
  const char* text = reinterpret_cast<const char*>(name);
  // GLEW takes this one through the same door, and OSMesa does not have it.
  if (std::strcmp(text, "glXGetCurrentDisplay") == 0)
    return reinterpret_cast<GlFunction>(glXGetCurrentDisplay);
  return reinterpret_cast<GlFunction>(OSMesaGetProcAddress(text));
}

/// 1.4, where glXGetProcAddress is core.
int glXQueryVersion(void*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

/// No extensions: GLEW then leaves all of GLX alone.
const char* glXGetClientString(void*, int) { return ""; }

}  // extern "C"

namespace planescope::draw {

bool bridge_is_visible() {
  return dlsym(RTLD_DEFAULT, "glXGetProcAddressARB") ==
         reinterpret_cast<void*>(&glXGetProcAddressARB);
}

}  // namespace planescope::draw
