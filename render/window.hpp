// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "image.hpp"

/// \file VTK's render window on a context without a display.
namespace planescope::draw {

class GlContext;

/// An offscreen render window. What was uploaded to it stays as long as it lives, so one window
/// draws many pictures.
class Window {
 public:
  /// \throws Error{Kind::Rendering} no OpenGL context (make_gl_context()).
  Window();
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  vtkRenderWindow* vtk() { return window_; }
  /// [pixel] Largest side of what it draws.
  int max_size() const { return max_size_; }
  /// GL_RENDERER.
  const std::string& renderer() const { return renderer_; }

  /// Takes the memory for pictures of that size now: half as long as such a picture takes to draw.
  void prepare(int width, int height);

  /// Draws `scale` times (1 to 4) as large as the given size [pixel], and reads the picture back
  /// at that size.
  /// \throws Error{Kind::Rendering} VTK reports an error.
  Image draw(int width, int height, int scale = 1);

 private:
  void bind_context();

  std::unique_ptr<GlContext> context_;  // outlives the window
  vtkSmartPointer<vtkRenderWindow> window_;
  std::string renderer_;
  int max_size_ = 0;
};

}  // namespace planescope::draw
