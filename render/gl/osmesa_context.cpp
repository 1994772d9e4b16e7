// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <GL/osmesa.h>

#include <algorithm>
#include <array>

#include "gl/context.hpp"
#include "planescope/error.hpp"

namespace planescope::draw {
namespace {

constexpr int kSide = 16;  // [pixel] of the context's own buffer, which nothing is drawn in

class OsmesaContext final : public GlContext {
 public:
  explicit OsmesaContext(GlVersion version) {
    // No forward-compatible flag: VTK's wide lines would be refused. Stencil: VTK asks for it.
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              version.major,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              version.minor,
                              0,
                              0};
    handle_ = OSMesaCreateContextAttribs(attributes, nullptr);
  }
  ~OsmesaContext() override {
    if (handle_ != nullptr) OSMesaDestroyContext(handle_);
  }

  bool make_current() override {
    return handle_ != nullptr &&
           OSMesaMakeCurrent(handle_, pixels_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE;
  }
  bool is_current() const override {
    return handle_ != nullptr && OSMesaGetCurrentContext() == handle_;
  }
  std::string renderer() override {
    const GLubyte* name = make_current() ? glGetString(GL_RENDERER) : nullptr;
    return name != nullptr ? reinterpret_cast<const char*>(name) : "unknown";
  }
  int max_size() override {
    GLint texture = 0;
    GLint viewport[2] = {0, 0};
    if (make_current()) {
      glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
      glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    }
    return std::min({texture, viewport[0], viewport[1]});
  }

 private:
  OSMesaContext handle_ = nullptr;
  std::array<unsigned char, static_cast<std::size_t>(kSide) * kSide * 4> pixels_{};
};

}  // namespace

std::unique_ptr<GlContext> make_gl_context(GlVersion version) {
  const auto fail = [](const std::string& what) {
    throw Error(Error::Kind::Rendering, "cannot draw: " + what);
  };
  auto context = std::make_unique<OsmesaContext>(version);
  if (!context->make_current()) {
    fail("OSMesa gives no OpenGL " + std::to_string(version.major) + "." +
         std::to_string(version.minor) +
         " core context; is Mesa's libOSMesa whole, and are MESA_* and GALLIUM_DRIVER unset?");
  }
  if (glGetString(GL_VERSION) == nullptr) {
    fail(
        "OpenGL's functions are not those of OSMesa; link the program by "
        "planescope_enable_offscreen(), which puts OSMesa before VTK");
  }
  if (!bridge_is_visible()) {
    fail(
        "the program does not export the bridge to OSMesa; link it by "
        "planescope_enable_offscreen(), which sets ENABLE_EXPORTS");
  }
  glEnable(GL_PROGRAM_POINT_SIZE);
  return context;
}

}  // namespace planescope::draw
