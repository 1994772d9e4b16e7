// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "window.hpp"

#include <cstring>

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>
#ifdef PLANESCOPE_VTK_OFFSCREEN
#include <GL/gl.h>
#include <vtkOSOpenGLRenderWindow.h>
#endif

#include "gl/context.hpp"
#include "planescope/error.hpp"
#include "vtk_errors.hpp"

namespace planescope::draw {

#ifdef PLANESCOPE_VTK_OFFSCREEN

class GlContext {};

Window::Window() : window_(vtkSmartPointer<vtkOSOpenGLRenderWindow>::New()) {
  VtkErrors errors(window_);
  window_->SetMultiSamples(0);
  window_->SetOffScreenRendering(1);
  if (window_->SupportsOpenGL() == 0 || errors.any())
    throw Error(Error::Kind::Rendering, "cannot draw: no OpenGL 3.2 context " + errors.first());
  window_->MakeCurrent();
  glEnable(0x8642);  // GL_PROGRAM_POINT_SIZE
  renderer_ = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  max_size_ = 16384;
}

#else

Window::Window() : context_(make_gl_context()) {
  renderer_ = context_->renderer();
  max_size_ = context_->max_size();
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &Window::bind_context);
  window->SetIsCurrent(true);
  window->SetSupportsOpenGL(1);
  window->SetReadyForRendering(true);
  window->SetMultiSamples(0);  // multisampling with depth peeling draws nothing on Mesa
  window->SetFrameBlitModeToNoBlit();
  window_ = window;
}

#endif

void Window::bind_context() {
#ifndef PLANESCOPE_VTK_OFFSCREEN
  context_->make_current();
#endif
}

Window::~Window() {
  const VtkSilence errors;
  bind_context();
  window_->Finalize();
  window_->RemoveAllObservers();
}

Image Window::draw(int width, int height) {
  const VtkSilence errors;
  window_->SetSize(width, height);
  window_->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int back_buffer = 0;
  window_->GetPixelData(0, 0, width - 1, height - 1, back_buffer, pixels);
  Image image{width, height, {}};
  const std::size_t row = static_cast<std::size_t>(width) * 3;
  image.rgb.resize(row * static_cast<std::size_t>(height));
  if (errors.any() || static_cast<std::size_t>(pixels->GetNumberOfValues()) != image.rgb.size()) {
    throw Error(Error::Kind::Rendering, "cannot draw: " + errors.first());
  }
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {  // OpenGL's go bottom up
    const auto from = static_cast<vtkIdType>((static_cast<std::size_t>(height) - 1 - y) * row);
    std::memcpy(image.rgb.data() + y * row, pixels->GetPointer(from), row);
  }
  return image;
}

}  // namespace planescope::draw
