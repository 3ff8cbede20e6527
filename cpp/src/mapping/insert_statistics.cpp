// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/mapping/insert_statistics.hpp"

#include <sstream>

namespace ltp {
namespace {

/// Shares of the hits from which on a loss is worth a word. A hit a hair inside its solid may lie a
/// hair beyond the range.
constexpr double kFarLoss = 0.001;
constexpr double kBodyLoss = 0.1;

}  // namespace

InsertStatistics& InsertStatistics::operator+=(const InsertStatistics& other) {
  marked += other.marked;
  too_near += other.too_near;
  in_body += other.in_body;
  outside += other.outside;
  out_of_range += other.out_of_range;
  invalid += other.invalid;
  new_cells += other.new_cells;
  erased_cells += other.erased_cells;
  return *this;
}

std::vector<std::string> InsertStatistics::warnings(const ObstacleMapOptions& options) const {
  const std::int64_t hits = marked + too_near + in_body + outside + out_of_range;
  std::vector<std::string> sentences;
  const auto warn = [&](std::int64_t lost, double share, const auto&... words) {
    if (lost == 0 || static_cast<double>(lost) < share * static_cast<double>(hits)) return;
    std::ostringstream text;
    text << lost << " of " << hits << " hits ";
    (text << ... << words);
    sentences.push_back(text.str());
  };
  warn(out_of_range, kFarLoss, "lie at or beyond the map's max_range of ", options.max_range,
       " m and were not mapped: raise it to that of the sensor");
  const Point extent =
      Point(options.dims[0], options.dims[1], options.dims[2]).cwiseProduct(options.cell);
  warn(options.keeps_hits_beyond() ? 0 : outside, kFarLoss, "lie outside the map's window of ",
       extent.x(), " m x ", extent.y(), " m x ", extent.z(),
       " m and were not mapped: give it more cells (dims)");
  warn(too_near, 0.0, "are nearer than the map's blind_distance of ", options.blind_distance,
       " m and were not mapped");
  warn(
      in_body, kBodyLoss,
      "lie in the map's body box (body_min, body_max) and were not mapped: make it as small as the "
      "aircraft");
  return sentences;
}

}  // namespace ltp
