// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

/// \file The OpenGL context that VTK draws in, and the seam behind which it is made: OSMesa today;
/// EGL would be one more file here. No VTK and no OpenGL type crosses this header.
namespace planescope::draw {

/// An OpenGL core profile context without a window. VTK draws in framebuffers of its own, so the
/// context's own buffer is as small as it may be, whatever the picture's size.
class GlContext {
 public:
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Binds the context to the calling thread. \returns false if the system refuses.
  virtual bool make_current() = 0;
  /// True if it is bound to the calling thread.
  virtual bool is_current() const = 0;
  /// GL_RENDERER, such as `llvmpipe (LLVM 15.0.6, 256 bits)`.
  virtual std::string renderer() = 0;
  /// Largest width and height [pixel] of what is drawn: the smaller of the limits on textures and
  /// viewports.
  virtual int max_size() = 0;

 protected:
  GlContext() = default;
};

/// Version of OpenGL that is asked for; VTK 9 needs 3.2.
struct GlVersion {
  int major = 3, minor = 3;
};

/// Makes a context, and checks all that VTK would crash on before VTK touches it: that there is a
/// context, that gl* are its functions, and that the bridge is what GLEW will find. Vertex shaders
/// say how large points are (GL_PROGRAM_POINT_SIZE is on). The context is left current.
/// \throws Error{Kind::Rendering} if one of these is not so, with what to do.
std::unique_ptr<GlContext> make_gl_context(GlVersion version = {});

/// True if the glX symbols that the dynamic linker finds first are the bridge's: GLEW will ask
/// OSMesa, not an X server.
bool bridge_is_visible();

}  // namespace planescope::draw
