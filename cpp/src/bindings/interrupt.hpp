// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C in a long call: asked by the core now and then, raised when it has returned.
#pragma once

#include <pybind11/pybind11.h>

/// Whether a signal's handler has raised in the meantime. Called without the GIL.
inline bool signal_pending() {
  const pybind11::gil_scoped_acquire acquire;
  return PyErr_CheckSignals() != 0;
}

/// Raises what the handler raised, if it did. Called with the GIL.
inline void raise_pending_signal() {
  if (PyErr_Occurred() != nullptr) throw pybind11::error_already_set();
}
