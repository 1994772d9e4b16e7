// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
// An OSMesa that gives no context, to be preloaded: what a broken Mesa looks like to the program.
void* OSMesaCreateContextAttribs(const int* attributes, void* share) {
  (void)attributes;
  (void)share;
  return 0;
}
