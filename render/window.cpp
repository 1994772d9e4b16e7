// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "window.hpp"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
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

void Window::prepare(int width, int height) {
  const VtkSilence errors;
  window_->SetSize(width, height);
  window_->MakeCurrent();
  vtkOpenGLRenderWindow::SafeDownCast(window_)->OpenGLInit();
  window_->Start();
}

Image Window::draw(int width, int height, int scale) {
  const VtkSilence errors;
  const int across = width * scale, down = height * scale;
  window_->SetSize(across, down);
  window_->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int back_buffer = 0;
  window_->GetPixelData(0, 0, across - 1, down - 1, back_buffer, pixels);
  const std::ptrdiff_t row = std::ptrdiff_t{3} * across;
  if (errors.any() || pixels->GetNumberOfValues() != row * down)
    throw Error(Error::Kind::Rendering, "cannot draw: " + errors.first());
  // OpenGL's rows go from the bottom up.
  return downsample({pixels->GetPointer(row * (down - 1)), -row, across, down}, scale);
}

}  // namespace planescope::draw
