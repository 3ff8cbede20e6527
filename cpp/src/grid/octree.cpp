// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/octree.hpp"

#include <octomap/OcTree.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <ostream>
#include <utility>

#include "octree_bytes.hpp"

namespace ltp {
namespace {

using Node = octomap::OcTreeNode;

constexpr int kDepth = octree::kDepth;
static_assert(Octree::kLevels == kDepth && Octree::kReach == octree::kCentreKey);

octomap::OcTreeKey key_of(const Cell& voxel) {
  const auto key = [](int index) {
    return static_cast<octomap::key_type>(index + octree::kCentreKey);
  };
  return octomap::OcTreeKey(key(voxel.x()), key(voxel.y()), key(voxel.z()));
}

/// The lowest corner of a node's child, whose cube has 2^level voxels along each edge.
Cell child_corner(const Cell& corner, int child, int level) {
  const int edge = 1 << level;
  return corner + edge * Cell(child & 1, child >> 1 & 1, child >> 2 & 1);
}

/// The number of the child that holds a voxel.
int child_with(const Cell& corner, const Cell& voxel, int level) {
  const Cell offset = voxel - corner;
  return (offset.x() >> level & 1) | (offset.y() >> level & 1) << 1 |
         (offset.z() >> level & 1) << 2;
}

}  // namespace

/// OctoMap's tree, and what its interface lacks: leaves of any size, a walk that allocates nothing.
class Octree::Tree : public octomap::OcTree {
 public:
  explicit Tree(double voxel) : OcTree(voxel) {
    // Values are stored as they are; clamping is the map's business.
    setClampingThresMin(0.0);
    setClampingThresMax(1.0);
  }

  void merge(const Cell& low, int level, float log_odds) {
    const bool created = root == nullptr;
    if (created) {
      root = new Node();
      ++tree_size;
    }
    merge(root, created, Cell::Constant(-kReach), kLevels, low, level, log_odds);
  }

  void walk(const Cell& low, const Cell& high, bool occupied_only, Call call, void* visitor) const {
    if (root == nullptr) return;
    visit(root, Cell::Constant(-kReach), kLevels, low, high, occupied_only, call, visitor);
  }

  /// Leaves to OctoMap's two values, alike ones together.
  void to_binary() {
    if (root == nullptr) return;
    to_binary(root);
    if (!nodeHasChildren(root)) expandNode(root);  // the file has no bits for a lone root
  }

  std::int64_t nodes() const { return static_cast<std::int64_t>(tree_size); }

  /// As OctoMap does. Its own function reports to stderr, and prints six digits of the resolution,
  /// which would move far voxels by metres.
  void write_file(std::ostream& stream, bool binary) const {
    stream << (binary ? octree::kBinaryMagic : octree::kFullMagic) << "\n"
           << "# (feel free to add / change comments, but leave the first line as it is!)\n#\n"
           << "id OcTree\n"
           << "size " << size() << "\n"
           << "res " << std::setprecision(std::numeric_limits<double>::max_digits10)
           << getResolution() << "\n"
           << "data\n";
    if (root == nullptr) return;
    if (binary) {
      writeBinaryNode(stream, root);
    } else {
      writeData(stream);
    }
  }

 private:
  Node* child_of(Node* node, int child, bool& created) {
    created = !nodeChildExists(node, child);
    return created ? createNodeChild(node, child) : getNodeChild(node, child);
  }

  void merge(Node* node, bool created, const Cell& corner, int node_level, const Cell& low,
             int level, float log_odds) {
    const bool leaf = !nodeHasChildren(node);
    const bool inside = node_level <= level;
    if (leaf && !created) {
      const bool raised = log_odds >= 0.0f && log_odds > node->getLogOdds();
      if (!raised) return;
      if (!inside) expandNode(node);
    }
    if (leaf && inside) {
      node->setLogOdds(log_odds);
      return;
    }
    const int below = node_level - 1;
    const int only = inside ? -1 : child_with(corner, low, below);
    for (int child = 0; child < 8; ++child) {
      if (!inside && child != only) continue;
      bool made = false;
      Node* next = child_of(node, child, made);
      merge(next, made, child_corner(corner, child, below), below, low, level, log_odds);
    }
    if (!pruneNode(node)) node->updateOccupancyChildren();
  }

  void visit(const Node* node, const Cell& corner, int level, const Cell& low, const Cell& high,
             bool occupied_only, Call call, void* visitor) const {
    // An inner node has the highest log-odds of its children.
    if (occupied_only && !isNodeOccupied(node)) return;
    if (!nodeHasChildren(node)) {
      const Cell end = corner.array() + (1 << level);
      call(visitor, corner.cwiseMax(low), end.cwiseMin(high), node->getLogOdds());
      return;
    }
    const int below = level - 1;
    for (int child = 0; child < 8; ++child) {
      if (!nodeChildExists(node, child)) continue;
      const Cell begin = child_corner(corner, child, below);
      const bool apart = (begin.array() >= high.array()).any() ||
                         (begin.array() + (1 << below) <= low.array()).any();
      if (apart) continue;
      visit(getNodeChild(node, child), begin, below, low, high, occupied_only, call, visitor);
    }
  }

  void to_binary(Node* node) {
    if (!nodeHasChildren(node)) {
      node->setLogOdds(isNodeOccupied(node) ? octree::kOccupied : octree::kFree);
      return;
    }
    for (int child = 0; child < 8; ++child) {
      if (nodeChildExists(node, child)) to_binary(getNodeChild(node, child));
    }
    if (!pruneNode(node)) node->updateOccupancyChildren();
  }
};

Octree::Octree(double resolution) : tree_(std::make_unique<Tree>(resolution)) {}
Octree::Octree(const Octree& other) : tree_(std::make_unique<Tree>(*other.tree_)) {}
Octree::Octree(Octree&&) noexcept = default;
Octree::~Octree() = default;

Octree& Octree::operator=(Octree other) noexcept {
  tree_ = std::move(other.tree_);
  return *this;
}

double Octree::resolution() const { return tree_->getResolution(); }

std::optional<float> Octree::find(const Cell& voxel) const {
  if (!holds(voxel)) return std::nullopt;
  const Node* node = tree_->search(key_of(voxel));
  if (node == nullptr) return std::nullopt;
  return node->getLogOdds();
}

void Octree::set(const Cell& voxel, float log_odds) {
  if (find(voxel) == log_odds) return;  // OctoMap would cut up the leaf that has them, and allocate
  tree_->setNodeValue(key_of(voxel), log_odds);
}

void Octree::merge(const Cell& low, int level, float log_odds) {
  tree_->merge(low, level, log_odds);
}

void Octree::clear() { tree_->clear(); }

std::int64_t Octree::nodes() const { return tree_->nodes(); }

std::int64_t Octree::bytes() const { return static_cast<std::int64_t>(tree_->memoryUsage()); }

void Octree::walk(const Cell& low, const Cell& high, bool occupied_only, Call call,
                  void* visitor) const {
  if ((low.array() >= high.array()).any()) return;
  const Cell all = Cell::Constant(kReach);
  if ((low.array() >= all.array()).any() || (high.array() <= -all.array()).any()) return;
  tree_->walk(low, high, occupied_only, call, visitor);
}

void Octree::write(std::ostream& stream, bool binary) const {
  if (!binary) return tree_->write_file(stream, false);
  Octree copy(*this);
  copy.tree_->to_binary();
  copy.tree_->write_file(stream, true);
}

}  // namespace ltp
