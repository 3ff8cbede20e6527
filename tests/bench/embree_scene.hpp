// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The LiDAR's peer, Embree 3: a mesh, and packets of 16 rays cast at it.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "ltp/geometry/types.hpp"

namespace ltp::bench {

inline constexpr int kPacket = 16;

struct Triangles {
  /// Two triangles: corner, corner + u, corner + u + v, corner + v.
  void quad(const Point& corner, const Point& u, const Point& v) {
    const auto first = static_cast<unsigned>(vertices.size());
    for (const Point& p : {corner, Point(corner + u), Point(corner + u + v), Point(corner + v)}) {
      vertices.push_back(p.cast<float>());
    }
    indices.push_back({first, first + 1, first + 2});
    indices.push_back({first, first + 2, first + 3});
  }
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<unsigned, 3>> indices;
};

class EmbreeScene {
 public:
  explicit EmbreeScene(const Triangles& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices.size()));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.indices.size()));
    for (const Eigen::Vector3f& v : mesh.vertices) vertices = std::copy_n(v.data(), 3, vertices);
    for (const auto& triangle : mesh.indices) {
      indices = std::copy(triangle.begin(), triangle.end(), indices);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  /// Ranges of rays from one origin [m]; inf: no hit. Directions by component, a multiple of 16.
  void cast(const Point& origin, const Eigen::Array<float, Eigen::Dynamic, 3>& directions,
            float max_range, std::vector<float>& ranges) const {
    alignas(64) RTCRayHit16 packet;
    alignas(64) std::array<int, kPacket> valid;
    valid.fill(-1);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRay16& ray = packet.ray;
    for (Eigen::Index first = 0; first < directions.rows(); first += kPacket) {
      for (int n = 0; n < kPacket; ++n) {
        ray.org_x[n] = static_cast<float>(origin.x());
        ray.org_y[n] = static_cast<float>(origin.y());
        ray.org_z[n] = static_cast<float>(origin.z());
        ray.dir_x[n] = directions(first + n, 0);
        ray.dir_y[n] = directions(first + n, 1);
        ray.dir_z[n] = directions(first + n, 2);
        ray.tnear[n] = 0.0F;
        ray.tfar[n] = max_range;
        ray.time[n] = 0.0F;
        ray.mask[n] = ~0U;
        ray.flags[n] = 0;
        packet.hit.geomID[n] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][n] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect16(valid.data(), scene_, &context, &packet);
      for (int n = 0; n < kPacket; ++n) {
        ranges[first + n] = packet.hit.geomID[n] == RTC_INVALID_GEOMETRY_ID
                                ? std::numeric_limits<float>::infinity()
                                : ray.tfar[n];
      }
    }
  }

 private:
  RTCDevice device_ = rtcNewDevice("threads=1");
  RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace ltp::bench
