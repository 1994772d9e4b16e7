// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <vtkLogger.h>
#include <vtkObject.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace planescope::draw {

/// Listens to a VTK object's errors while it lives, so that they become ours instead of text on
/// stderr (VTK prints an error only where nobody listens).
class VtkErrors {
 public:
  explicit VtkErrors(vtkObject* object);
  ~VtkErrors();
  VtkErrors(const VtkErrors&) = delete;
  VtkErrors& operator=(const VtkErrors&) = delete;

  bool any() const noexcept { return !first_.empty(); }
  /// The first error's text, on one line; empty if there was none.
  const std::string& first() const noexcept { return first_; }

 private:
  void listen(vtkObject* caller, unsigned long event, void* text);

  vtkObject* object_;
  unsigned long error_ = 0, warning_ = 0;
  std::string first_;
};

/// While it lives, nothing that VTK says of anything goes to stderr: readers and framebuffers have
/// objects inside that nobody can listen to. The first error is kept instead.
class VtkSilence {
 public:
  VtkSilence();
  ~VtkSilence();
  VtkSilence(const VtkSilence&) = delete;
  VtkSilence& operator=(const VtkSilence&) = delete;

  bool any() const noexcept { return !first().empty(); }
  /// The first error's text, on one line; empty if there was none.
  const std::string& first() const noexcept;

 private:
  vtkSmartPointer<vtkOutputWindow> ours_, before_;
  vtkLogger::Verbosity verbosity_;
};

}  // namespace planescope::draw
