// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C in a long call: asked by the core now and then, raised when it has returned.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>

/// Whether a signal's handler has raised since the watch was made. Called without the GIL, which it
/// takes only now and then: a busy Python thread hands it over after 5 ms at the earliest.
class SignalWatch {
 public:
  bool operator()() {
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_ < kPatience) return false;
    asked_ = now;
    const pybind11::gil_scoped_acquire acquire;
    return PyErr_CheckSignals() != 0;
  }

 private:
  static constexpr std::chrono::milliseconds kPatience{50};
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
};

/// Raises what the handler raised, if it did. Called with the GIL.
inline void raise_pending_signal() {
  if (PyErr_Occurred() != nullptr) throw pybind11::error_already_set();
}
