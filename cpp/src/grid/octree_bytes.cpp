// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "octree_bytes.hpp"

#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ltp::octree {
namespace {

constexpr std::size_t kLongestHeader = 65536;

template <typename... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw std::invalid_argument(text.str());
}

/// A word of a hostile file, fit for an error message.
std::string quoted(std::string_view word) {
  std::string text;
  for (const char c : word.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return "\"" + text + "\"";
}

template <typename Number>
Number number(std::string_view field, std::string_view word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    refuse(field, " = ", quoted(word), " in its header: expected a number");
  }
  return value;
}

/// Bytes of a node's value in a `.ot` file.
int node_bytes(std::string_view id) {
  if (id == "OcTree" || id == "1" || id == "OcTreeStamped") return 4;
  if (id == "ColorOcTree") return 7;  // and three of colour
  refuse("id = ", quoted(id), " in its header: expected OcTree, ColorOcTree or OcTreeStamped");
}

/// Takes bytes from the front, never past the end.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes), size_(bytes.size()) {}

  const char* take(std::size_t count) {
    if (bytes_.size() < count) refuse("it ends after ", size_, " bytes of data, inside the tree");
    const char* begin = bytes_.data();
    bytes_.remove_prefix(count);
    return begin;
  }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t size_;
};

/// A node whose bytes are still to come.
struct Pending {
  std::array<int, 3> key;
  int depth;
};

Pending child_of(const Pending& node, int child) {
  Pending below{node.key, node.depth + 1};
  const int edge = 1 << (kDepth - below.depth);
  for (int axis = 0; axis < 3; ++axis) {
    if (child >> axis & 1) below.key[axis] += edge;
  }
  return below;
}

using Visitor = std::function<void(const Leaf&)>;

/// `.bt`: an inner node is two bytes, two bits a child (1: free, 2: occupied, 3: inner); then come
/// its inner children. Returns the number of nodes.
std::uint64_t walk_binary(Reader& reader, const Visitor& visit) {
  std::uint64_t nodes = 1;
  std::vector<Pending> pending = {{{0, 0, 0}, 0}};  // never more than 7 a level and one
  while (!pending.empty()) {
    const Pending node = pending.back();
    pending.pop_back();
    const char* bytes = reader.take(2);
    const unsigned codes = static_cast<unsigned char>(bytes[0]) |
                           static_cast<unsigned>(static_cast<unsigned char>(bytes[1])) << 8;
    if (codes == 0) refuse("a node at depth ", node.depth, " has no children");
    for (int child = 7; child >= 0; --child) {  // the first child must end on top of the stack
      const unsigned code = codes >> (2 * child) & 3u;
      if (code == 0) continue;
      ++nodes;
      const Pending below = child_of(node, child);
      if (code == 3) {
        if (below.depth == kDepth) refuse("it goes deeper than ", kDepth, " levels");
        pending.push_back(below);
      } else {
        visit({below.key, below.depth, code == 2 ? kOccupied : kFree});
      }
    }
  }
  return nodes;
}

/// `.ot`: every node is its value and one bit a child; then come its children.
std::uint64_t walk_full(Reader& reader, int value_bytes, const Visitor& visit) {
  std::uint64_t nodes = 0;
  std::vector<Pending> pending = {{{0, 0, 0}, 0}};
  while (!pending.empty()) {
    const Pending node = pending.back();
    pending.pop_back();
    const char* bytes = reader.take(value_bytes + 1);
    ++nodes;
    float log_odds;
    std::memcpy(&log_odds, bytes, sizeof(log_odds));
    if (!std::isfinite(log_odds)) {
      refuse("node ", nodes, " has log-odds ", log_odds, ": expected a finite number");
    }
    const unsigned children = static_cast<unsigned char>(bytes[value_bytes]);
    if (children == 0) {
      visit({node.key, node.depth, log_odds});
      continue;
    }
    if (node.depth == kDepth) refuse("it goes deeper than ", kDepth, " levels");
    for (int child = 7; child >= 0; --child) {
      if (children >> child & 1u) pending.push_back(child_of(node, child));
    }
  }
  return nodes;
}

}  // namespace

Header read_header(std::string_view bytes) {
  Header header;
  header.binary = bytes.substr(0, kBinaryMagic.size()) == kBinaryMagic;
  if (!header.binary && bytes.substr(0, kFullMagic.size()) != kFullMagic) {
    refuse("its first line is not \"", kBinaryMagic, "\" or \"", kFullMagic, "\"");
  }
  bool has_id = false;
  bool has_size = false;
  bool has_resolution = false;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = bytes.find('\n', begin);
    if (end == std::string_view::npos || end > kLongestHeader) {
      refuse("its header has no \"data\" line");
    }
    std::string_view line = bytes.substr(begin, end - begin);
    begin = end + 1;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::string_view key = line.substr(0, line.find(' '));
    const std::string_view word = line.substr(std::min(line.size(), key.size() + 1));
    if (key == "data") break;
    if (key == "id") {
      header.node_bytes = node_bytes(word);
      has_id = true;
    } else if (key == "size") {
      header.nodes = number<std::uint64_t>(key, word);
      has_size = true;
    } else if (key == "res") {
      header.resolution = number<double>(key, word);
      has_resolution = true;
    }  // comments and, as OctoMap does, unknown words are skipped
  }
  if (!has_id) refuse("its header has no \"id\" line");
  if (!has_size) refuse("its header has no \"size\" line");
  if (!has_resolution) refuse("its header has no \"res\" line");
  // The upper limit keeps every coordinate finite.
  if (!(header.resolution > 0.0 && header.resolution <= 1e9)) {
    refuse("res = ", header.resolution, " in its header: expected a positive number of metres");
  }
  header.data = begin;
  return header;
}

void walk(const Header& header, std::string_view bytes, const Visitor& visit) {
  Reader reader(bytes.substr(header.data));
  std::uint64_t nodes = 0;
  if (header.nodes > 0) {
    nodes =
        header.binary ? walk_binary(reader, visit) : walk_full(reader, header.node_bytes, visit);
  }
  if (nodes != header.nodes) {
    refuse("size = ", header.nodes, " in its header, but the tree has ", nodes, " nodes");
  }
  if (reader.left() > 0) refuse("there are ", reader.left(), " bytes after the tree");
}

}  // namespace ltp::octree
